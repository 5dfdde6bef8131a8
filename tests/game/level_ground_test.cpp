// The ground of the platformer's own levels, for those who find their ways over it.
#include <gtest/gtest.h>

#include <surefoot/navigation_mesh.hpp>

#include "game/hero.hpp"
#include "game/level.hpp"

namespace surefoot::game {
namespace {

// Contours that Recast makes simple may cross themselves; polygons cut from those were not convex, and the mesh was
// refused when it was read again: one in ten of these levels' meshes, these among them.
TEST(GameGround, AMeshOfALevelIsReadAgain) {
    const auto level = read_level(SUREFOOT_LEVELS_DIR "/platformer/clockwork.glb");
    ASSERT_TRUE(level) << level.error().text;
    World world;
    ASSERT_TRUE(world.add(level->ground));
    const CharacterSettings settings = hero_settings(level->rules);
    const double usual = navigation_agent(settings).radius / 4;
    for (const double share : {1.0, 1.07}) {
        const auto mesh = NavigationMesh::build(world, settings, {.cell_size = usual * share});
        ASSERT_TRUE(mesh) << mesh.error().text;
        const auto again = NavigationMesh::read(mesh->to_bytes());
        EXPECT_TRUE(again) << share << ": " << again.error().text;
    }
}

}  // namespace
}  // namespace surefoot::game
