#include "game/still_ground.hpp"

#include <algorithm>
#include <gtest/gtest.h>

#include <surefoot/import.hpp>

#include "game/level.hpp"

namespace surefoot::game {
namespace {

LevelNotes notes_of(const ImportedLevel& level) {
    LevelNotes notes;
    notes.parts = level.parts;
    notes.markers = level.markers;
    return notes;
}

TEST(StillGround, is_what_the_game_takes_for_it_in_each_of_its_levels) {
    for (const std::string& file : levels_in(std::string(SUREFOOT_LEVELS_DIR) + "/platformer")) {
        const auto imported = import_level(file);
        const auto level = read_level(file);
        ASSERT_TRUE(imported && level) << file;
        const StillGround still = still_ground(notes_of(*imported));
        EXPECT_EQ(still.moving, level->bodies.size()) << file;
        EXPECT_EQ(imported->triangle_count() - still.others.size(), level->ground.triangle_count()) << file;
        EXPECT_GT(still.decor, 0U) << file;
        EXPECT_TRUE(std::ranges::is_sorted(still.others));
    }
}

TEST(StillGround, is_all_where_no_node_says_otherwise) {
    LevelNotes notes;
    notes.parts = {{"floor", 0, 2}, {"box", 2, 12}};
    notes.markers.resize(2);
    notes.markers[0].name = "begin";
    notes.markers[0].kind = "spawn";
    notes.markers[1].name = "box";
    EXPECT_TRUE(still_ground(notes).is_all());
    notes.markers[1].kind = "somebody else's";
    EXPECT_TRUE(still_ground(notes).is_all());
    notes.markers[1].kind = "hazard";
    const StillGround still = still_ground(notes);
    EXPECT_EQ(still.others.size(), 12U);
    EXPECT_EQ(still.others.front(), 2U);
    EXPECT_EQ(still.moving, 1U);
}

}  // namespace
}  // namespace surefoot::game
