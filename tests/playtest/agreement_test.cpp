// On the platformer's own levels the navigation mesh and the feet agree: what feet reach and come back from is known to
// it, and who follows it arrives. The still ground alone: what moves and what is only drawn is not in it.
#include <algorithm>
#include <filesystem>
#include <gtest/gtest.h>

#include <surefoot/navigation_check.hpp>

#include "game/level.hpp"

namespace surefoot::playtest {
namespace {

class PlatformerGround : public testing::TestWithParam<std::string> {};

TEST_P(PlatformerGround, is_known_to_the_mesh_as_feet_reach_it) {
    const auto level = game::read_level(GetParam());
    ASSERT_TRUE(level) << level.error().text;
    World world;
    ASSERT_TRUE(world.add(level->ground));
    CharacterSettings settings;
    settings.surfaces = SurfaceRules(std::span<const SurfaceRule>(level->rules));
    const std::vector<dvec3> starts{level->checkpoints.front().feet};
    const auto check = check_navigation(world, settings, starts, {.walks = 200});
    ASSERT_TRUE(check) << check.error().text;
    EXPECT_EQ(check->arrived, check->walks);
    EXPECT_FALSE(check->lost_a_kind());
    // A strip of half a metre between the first wall of this one and the deep is known to feet and not to its mesh.
    const double least = level->id == "the-long-way-down" ? 0.965 : 0.98;
    EXPECT_GE(check->agreement.covered(), least);
}

std::string name_of_level(const testing::TestParamInfo<std::string>& info) {
    std::string name = std::filesystem::path(info.param).stem().string();
    std::ranges::replace(name, '-', '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Of, PlatformerGround,
                         testing::ValuesIn(game::levels_in(std::string(SUREFOOT_LEVELS_DIR) + "/platformer")),
                         name_of_level);

}  // namespace
}  // namespace surefoot::playtest
