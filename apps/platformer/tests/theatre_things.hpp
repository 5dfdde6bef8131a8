/// A theatre without a window, levels for it that are over in seconds, and hands.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>
#include <memory>
#include <string>

#include "platformer/play/theatre.hpp"

namespace surefoot::platformer {

/// A level as a .glb: a floor of 24 m by 24 m, the goal 6 m ahead of the spawn, a checkpoint half way, and 3 m behind
/// the spawn something deadly. `more` are further nodes, each with a comma before it.
inline void write_level(const std::string& path, const std::string& words, const std::string& more = {}) {
    std::filesystem::create_directories(std::filesystem::path(path).parent_path());
    const std::string nodes =
        R"({"name":"floor","mesh":0,"scale":[12,1,12]},)"
        R"({"name":"fire","mesh":1,"translation":[0,0.02,5],"scale":[12,1,2]},)"
        R"({"name":"start","extras":{"surefoot":{"kind":"spawn"}}},)"
        R"({"name":"half way","translation":[0,0,-3],"extras":{"surefoot":{"kind":"checkpoint","order":1,"section":"half way"}}},)"
        R"({"name":"flag","translation":[0,0,-6],"extras":{"surefoot":{"kind":"goal","radius":1}}},)"
        R"({"name":"words","extras":{"surefoot":{"kind":"level",)" +
        words + "}}}" + more;
    std::string scene;
    int count = 0;
    for (std::size_t at = nodes.find("\"name\""); at != std::string::npos; at = nodes.find("\"name\"", at + 1))
        scene += fmt::format("{}{}", count == 0 ? "" : ",", count), ++count;
    std::string json = fmt::format(
        R"({{"asset":{{"version":"2.0"}},"scene":0,"scenes":[{{"nodes":[{}]}}],"nodes":[{}],
"materials":[{{"name":"fire","extras":{{"surefoot":{{"deadly":true}}}}}}],
"meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}},"indices":1}}]}},
{{"primitives":[{{"attributes":{{"POSITION":0}},"indices":1,"material":0}}]}}],
"accessors":[{{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","min":[-1,0,-1],"max":[1,0,1]}},
{{"bufferView":1,"componentType":5123,"count":6,"type":"SCALAR"}}],
"bufferViews":[{{"buffer":0,"byteOffset":0,"byteLength":48}},{{"buffer":0,"byteOffset":48,"byteLength":12}}],
"buffers":[{{"byteLength":60}}]}})",
        scene, nodes);
    while (json.size() % 4 != 0) json += ' ';
    std::ofstream file(path, std::ios::binary);
    const auto word = [&](std::uint32_t number) { file.write(reinterpret_cast<const char*>(&number), 4); };
    word(0x46546C67);  // "glTF"
    word(2);
    constexpr float corners[12] = {-1, 0, -1, 1, 0, -1, 1, 0, 1, -1, 0, 1};
    constexpr std::uint16_t triangles[6] = {0, 2, 1, 0, 3, 2};
    word(std::uint32_t(28 + json.size() + sizeof(corners) + sizeof(triangles)));
    word(std::uint32_t(json.size()));
    word(0x4E4F534A);  // "JSON"
    file << json;
    word(sizeof(corners) + sizeof(triangles));
    word(0x004E4942);  // "BIN"
    file.write(reinterpret_cast<const char*>(corners), sizeof(corners));
    file.write(reinterpret_cast<const char*>(triangles), sizeof(triangles));
}

class TheatreTest : public testing::Test {
protected:
    static void SetUpTestSuite() {
        auto opened = view::Display::open({.size = {800, 600}, .headless = true});
        ASSERT_TRUE(opened) << opened.error().text;
        display = std::move(*opened);
        renderer = std::make_unique<view::Renderer>();
    }
    static void TearDownTestSuite() {
        renderer.reset();
        display.reset();
    }

    void SetUp() override {
        const auto* const info = testing::UnitTest::GetInstance()->current_test_info();
        root = testing::TempDir() + "surefoot_" + info->test_suite_name() + "_" + info->name();
        std::filesystem::remove_all(root);
        display->resize({800, 600});
        display->set_full_screen(false);
        write_level(root + "/levels/first.glb", R"("title":"First","order":1,"par":60)");
        write_level(root + "/levels/second.glb", R"("title":"Second","order":2)");
        std::ofstream(root + "/levels/campaign.txt") << "first\nsecond\n";
        options.level_folders = {root + "/levels"};
        options.settings = root + "/own/settings.json";
        options.progress = root + "/own/progress.json";
        options.recordings = root + "/own/runs";
        options.headless = true;
    }
    void TearDown() override {
        theatre.reset();
        std::filesystem::remove_all(root);
    }

    void open() {
        theatre = std::make_unique<Theatre>(*display, *renderer, options);
        tick();
    }

    void tick(int times = 1) {
        for (int i = 0; i < times; ++i) theatre->tick();
        for (std::string& notice : theatre->take_notices()) notices += notice + "\n";
    }
    void seconds(double time) { tick(int(time * 60 + 0.5)); }

    void key(view::Key key, bool down) { theatre->event(view::KeyPress{.key = key, .down = down}); }
    void tap(view::Key pressed) {
        key(pressed, true);
        key(pressed, false);
        tick();
    }
    void tap(view::PadButton button) {
        theatre->event(view::GamepadButton{button, true});
        theatre->event(view::GamepadButton{button, false});
        tick();
    }
    void type(const std::string& letters) {
        for (const char letter : letters) theatre->event(view::TextInput{std::string(1, letter)});
    }

    /// Holds a key for so long.
    void walk(view::Key pressed, double time) {
        key(pressed, true);
        seconds(time);
        key(pressed, false);
        tick();
    }

    /// Goes to the entry with this beginning by arrow keys, and presses it if it is one to be pressed.
    void choose(const std::string& label, bool press = true) {
        for (int i = 0; i < 40; ++i) {
            const Menu menu = theatre->screens().menu();
            if (menu.entries[theatre->screens().focus()].label.starts_with(label)) {
                if (press) tap(view::Key::enter);
                return;
            }
            tap(menu.columns > 1 ? view::Key::tab : view::Key::down);
        }
        ADD_FAILURE() << notices << "no entry " << label << " on screen " << int(theatre->screens().top());
    }

    /// The start form of a session, by keys.
    void fill_in() {
        type("Anna W.");
        for (const char letter : std::string("was")) key(view::key_named(std::string(1, letter)), true);
        tap(view::Key::down);
        tap(view::Key::right);
        tap(view::Key::down);
        tap(view::Key::left);
        choose("I agree");
        choose("Begin");
    }

    [[nodiscard]] const Screens& screens() const { return theatre->screens(); }
    [[nodiscard]] bool is_on(ScreenId id) const { return !screens().is_playing() && screens().top() == id; }
    [[nodiscard]] const game::Game& game() const { return theatre->run()->game(); }

    void play_first() {
        choose("Levels");
        choose("First");
        choose("Play");
        ASSERT_TRUE(screens().is_playing());
        ASSERT_NE(theatre->run(), nullptr);
    }
    /// From the spawn to the goal, and the dance.
    void win() {
        walk(view::Key::w, 2);
        ASSERT_EQ(game().outcome(), game::Outcome::won);
        seconds(3.5);
    }
    /// Over the checkpoint, and into the fire.
    void lose() {
        walk(view::Key::w, 0.6);
        key(view::Key::s, true);  // again and again, until no heart is left
        for (int i = 0; i < 1200 && game().outcome() == game::Outcome::playing; ++i) tick();
        key(view::Key::s, false);
        seconds(2.5);
    }

    inline static std::unique_ptr<view::Display> display;
    inline static std::unique_ptr<view::Renderer> renderer;
    std::string root;
    std::string notices;
    TheatreOptions options;
    std::unique_ptr<Theatre> theatre;
};

}  // namespace surefoot::platformer
