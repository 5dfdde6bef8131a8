// The question, its world and its answer, as undo and drags change them.
#include "playground/debugger_room/investigation.hpp"

#include <array>
#include <cstring>
#include <gtest/gtest.h>
#include <memory>
#include <vector>

#include "debugger/worlds.hpp"

namespace surefoot::playground {
namespace {

LevelLoader::Loaded level_of(const std::string& file, const std::vector<vec3>& vertices,
                             const std::vector<std::uint32_t>& indices) {
    auto mesh = Mesh::build({.vertices = vertices, .indices = indices});
    EXPECT_TRUE(mesh);
    return std::make_shared<LoadedLevel>(LoadedLevel{
        tools::Level{.mesh = std::move(*mesh), .file = file, .surface_names = {}, .markers = {}, .notes = {}}, {}});
}

LevelLoader::Loaded floor_at(const std::string& file, float y) {
    return level_of(file, {{-9, y, -9}, {9, y, -9}, {9, y, 9}, {-9, y, 9}}, {0, 3, 2, 0, 2, 1});
}

void drop_onto_it(Investigation& asked) {
    asked.apply(debugger::MoveStart{{1, 8, 2}});
    asked.apply(debugger::MoveEnd{{1, -8, 2}});
}

TEST(Investigation, a_file_that_was_opened_again_and_has_changed_comes_back_as_it_was_by_undo) {
    Investigation asked;
    asked.show(floor_at("yard.obj", 0));
    drop_onto_it(asked);
    ASSERT_TRUE(asked.hit());
    const double low = asked.hit()->t;
    asked.show(floor_at("yard.obj", 4));
    drop_onto_it(asked);
    ASSERT_TRUE(asked.hit());
    const double high = asked.hit()->t;
    EXPECT_LT(high, low);
    for (int step = 0; step < 3; ++step) asked.undo();  // END, START, and the level
    ASSERT_TRUE(asked.hit());
    EXPECT_EQ(asked.hit()->t, low);
    EXPECT_EQ(asked.mesh()->bounds().max.y, 0);
    for (int step = 0; step < 3; ++step) asked.undo();
    EXPECT_FALSE(asked.level());
    EXPECT_EQ(asked.question().world, debugger::WorldKind::triangle);
    for (int step = 0; step < 6; ++step) asked.redo();
    ASSERT_TRUE(asked.hit());
    EXPECT_EQ(asked.hit()->t, high);
    EXPECT_EQ(asked.mesh()->bounds().max.y, 4);
}

LevelLoader::Loaded wide_floor(std::uint32_t n) {
    std::vector<vec3> vertices;
    std::vector<std::uint32_t> indices;
    for (std::uint32_t z = 0; z <= n; ++z)
        for (std::uint32_t x = 0; x <= n; ++x) vertices.emplace_back(float(x) - 1, 0.0F, float(z) - 1);
    for (std::uint32_t z = 0; z < n; ++z) {
        for (std::uint32_t x = 0; x < n; ++x) {
            const std::uint32_t a = z * (n + 1) + x;
            for (const std::uint32_t corner : {a, a + n + 1, a + 1, a + 1, a + n + 1, a + n + 2})
                indices.push_back(corner);
        }
    }
    return level_of("wide.obj", vertices, indices);
}

TEST(Investigation, every_triangle_of_a_very_large_level_is_asked_when_a_drag_is_over) {
    Investigation asked;
    const auto level = wide_floor(320);
    ASSERT_GT(level->level.mesh.triangle_count(), Investigation::most_asked_while_dragged);
    asked.show(level);
    drop_onto_it(asked);
    asked.choose_search(Search::brute_force);
    EXPECT_FALSE(asked.search_waits()) << "nothing is dragged";
    EXPECT_TRUE(asked.by_tree());
    asked.begin_drag();
    asked.apply(debugger::MoveEnd{{2, -8, 2}});
    EXPECT_TRUE(asked.search_waits());
    EXPECT_FALSE(asked.by_tree());
    ASSERT_TRUE(asked.hit()) << "the tree answers meanwhile";
    const double t = asked.hit()->t;
    asked.end_drag();
    EXPECT_FALSE(asked.search_waits());
    ASSERT_TRUE(asked.by_tree());
    EXPECT_EQ(asked.by_tree()->t, t);
    asked.begin_drag();
    asked.apply(debugger::MoveEnd{{3, -8, 2}});
    asked.undo();
    EXPECT_FALSE(asked.search_waits()) << "undo ends a drag";
    EXPECT_TRUE(asked.by_tree());
}

TEST(Investigation, a_small_level_is_asked_whole_while_it_is_dragged) {
    Investigation asked;
    asked.show(floor_at("yard.obj", 0));
    asked.choose_search(Search::brute_force);
    asked.begin_drag();
    drop_onto_it(asked);
    EXPECT_FALSE(asked.search_waits());
    EXPECT_TRUE(asked.by_tree());
}

TEST(Investigation, result_is_where_step_leaves_the_shape_whatever_is_edited) {
    Investigation asked;
    const auto expect_the_step = [&](const World& world) {
        const dvec3 way = asked.question().motion.to - asked.question().motion.from;
        CharacterSettings settings;
        settings.volume = asked.question().volume();
        settings.longest_tick = 1;
        CharacterState state;
        state.position = asked.question().motion.from;
        state.velocity = way;
        const StepResult by_hand = surefoot::step(world, settings, {.wish = way, .mode = CharacterMode::fly}, 1, state);
        EXPECT_EQ(hash(asked.step().result.state), hash(by_hand.state));
        EXPECT_EQ(std::memcmp(&asked.result(), &by_hand.state.position, sizeof(dvec3)), 0);
        EXPECT_NE(asked.result(), asked.place_at(asked.hit()->t)) << "it slides on";
        EXPECT_FALSE(asked.step().records.empty());
    };
    expect_the_step(asked.arena().world());
    asked.apply(debugger::MoveEnd{{5, -3, 6}});
    expect_the_step(asked.arena().world());
    asked.undo();
    expect_the_step(asked.arena().world());
    const auto level = wide_floor(8);
    asked.show(level);
    asked.apply(debugger::MoveStart{{1, 8, 2}});
    asked.apply(debugger::MoveEnd{{4, -8, 2}});
    World world;
    ASSERT_TRUE(world.add(level->level.mesh));
    expect_the_step(world);
}

}  // namespace
}  // namespace surefoot::playground
