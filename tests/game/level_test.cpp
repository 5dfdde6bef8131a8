// Levels of the platformer from files: what is read, and what is told to whoever made a mistake.
#include "game/level.hpp"

#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>

namespace surefoot::game {
namespace {

// A glTF of nodes that all show the same square of 2 m, lying flat, or nothing.
struct Gltf {
    std::string nodes;
    int count = 0;

    Gltf& node(const std::string& name, const std::string& place, const std::string& extras, bool mesh = false) {
        nodes += fmt::format(R"({}{{"name":"{}","translation":[{}]{}{}}})", count == 0 ? "" : ",", name, place,
                             mesh ? R"(,"mesh":0)" : "",
                             extras.empty() ? "" : fmt::format(R"(,"extras":{{"surefoot":{{{}}}}})", extras));
        ++count;
        return *this;
    }

    [[nodiscard]] std::string write(const char* name) const {
        std::string scene;
        for (int i = 0; i < count; ++i) scene += fmt::format("{}{}", i == 0 ? "" : ",", i);
        // Four corners and two triangles, as base64.
        const std::string text = fmt::format(
            R"({{"asset":{{"version":"2.0"}},"scene":0,"scenes":[{{"nodes":[{}]}}],"nodes":[{}],
"meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}},"indices":1}}]}}],
"accessors":[{{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","min":[-1,0,-1],"max":[1,0,1]}},
{{"bufferView":1,"componentType":5123,"count":6,"type":"SCALAR"}}],
"bufferViews":[{{"buffer":0,"byteOffset":0,"byteLength":48}},{{"buffer":0,"byteOffset":48,"byteLength":12}}],
"buffers":[{{"byteLength":60,"uri":"data:application/octet-stream;base64,AACAvwAAAAAAAIC/AACAPwAAAAAAAIC/AACAPwAAAAAAAIA/AACAvwAAAAAAAIA/AAACAAEAAAADAAIA"}}]}})",
            scene, nodes);
        const std::string path = (std::filesystem::path(testing::TempDir()) / name).string();
        std::ofstream(path) << text;
        return path;
    }
};

Gltf playable() {
    return Gltf{}
        .node("floor", "0,0,0", "", true)
        .node("start", "0,0,0", R"("kind":"spawn")")
        .node("end", "0.5,0,0", R"("kind":"goal","radius":2)");
}

TEST(GameLevel, ReadsWhatIsWritten) {
    const auto level = read_level(
        playable()
            .node("words", "0,0,0",
                  R"("kind":"level","title":"A Test","par":90,"stars_needed":3,"secret":true,"sky":"dusk")")
            .node("lift", "4,1,0", R"("kind":"platform","path":[[0,0,0],[0,3,0]],"speed":2,"starts":"ridden")", true)
            .node("c", "1,2,3", R"("kind":"coin")")
            .node("k", "1,2,3", R"("kind":"key","door":"red")")
            .node("d", "8,0,0", R"("kind":"door","door":"red")", true)
            .node("e", "0,0,0", R"("kind":"enemy","type":"jumper","route":[[2,0,0]],"sight":5)")
            .node("w", "0,-2,0", R"("kind":"water","size":[10,4,10])")
            .node("p2", "5,0,0", R"("kind":"checkpoint","order":2,"section":"after")")
            .node("p1", "3,0,0", R"("kind":"checkpoint","order":1,"section":"before")")
            .write("whole.gltf"));
    ASSERT_TRUE(level) << level.error().text;
    EXPECT_EQ(level->id, "whole");
    EXPECT_EQ(level->title, "A Test");
    EXPECT_EQ(level->medals.gold, 90);
    EXPECT_TRUE(level->secret);
    EXPECT_EQ(level->ground.triangle_count(), 2U);
    ASSERT_EQ(level->bodies.size(), 2U);
    EXPECT_EQ(level->bodies[0].route.stops.size(), 2U);
    EXPECT_TRUE(level->bodies[0].route.waits);
    EXPECT_EQ(level->bodies[0].mesh.triangle_count(), 2U);
    EXPECT_NEAR(level->bodies[0].mesh.bounds().max.x, 1, 1e-6) << "relative to its node";
    EXPECT_EQ(level->count(PickupKind::coin), 1);
    ASSERT_EQ(level->enemies.size(), 1U);
    EXPECT_EQ(level->enemies[0].kind, EnemyKind::jumper);
    EXPECT_EQ(level->enemies[0].route.size(), 2U);
    ASSERT_EQ(level->checkpoints.size(), 3U);
    EXPECT_EQ(level->checkpoints[1].section, "before");
    EXPECT_TRUE(level->waters[0].holds({4, -1, 4}));
    EXPECT_FALSE(level->waters[0].holds({4, 1, 4}));
    EXPECT_EQ(level->kill_y, -10);
}

// Each mistake, and words that have to be in the error.
TEST(GameLevel, NamesTheNodeAndTheCureOfAMistake) {
    const auto error = [](const Gltf& gltf) {
        const auto level = read_level(gltf.write("mistake.gltf"));
        return level ? std::string("no error") : level.error().text;
    };
    const auto has = [](const std::string& text, std::initializer_list<const char*> words) {
        for (const char* word : words) EXPECT_NE(text.find(word), std::string::npos) << word << " in: " << text;
    };
    has(error(Gltf{}.node("floor", "0,0,0", "", true)), {"mistake.gltf", "spawn", "needs one"});
    has(error(playable().node("again", "0,0,0", R"("kind":"goal")")), {"2 nodes", "goal"});
    has(error(playable().node("lift", "0,0,0", R"("kind":"platform")", true)), {"lift", "path"});
    has(error(playable().node("lift", "0,0,0", R"("kind":"platform","path":[[0,0,0],[0,3,0]])")),
        {"lift", "triangles of its own"});
    has(error(playable().node("lift", "0,0,0", R"("kind":"platform","path":[[0,0,0],[0,3,0]],"speed":0)", true)),
        {"lift", "speed", "0.01"});
    has(error(playable().node("d", "0,0,0", R"("kind":"door","door":"blue")", true)), {"no key", "blue"});
    has(error(playable().node("e", "0,0,0", R"("kind":"enemy","type":"dragon")")), {"dragon", "chaser"});
    has(error(playable().node("w", "0,0,0", R"("kind":"water","size":[1,2])")), {"w", "three numbers"});
    has(error(playable().node("r", "0,0,0", R"("kind":"way","how":"ride","by":"bus")")), {"bus", "no such platform"});
    has(error(playable().node("l", "0,0,0", R"("kind":"level","gold":50,"silver":40)")), {"gold", "shortest first"});
}

}  // namespace
}  // namespace surefoot::game
