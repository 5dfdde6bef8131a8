// A whole level: whoever is sent from one random place to another that can be got to, gets there.
#include <gtest/gtest.h>
#include <iostream>

#include <surefoot/import.hpp>
#include <surefoot/navigation_walk.hpp>

#include "navigation_things.hpp"

namespace surefoot::tests {
namespace {

// Broken variants: heading for places that are not seen; a body wider than the mesh was built for, as below.
TEST(NavigationFollow, EveryRandomWalkOverTheTrainingGroundArrives) {
    const auto level = import_level(SUREFOOT_LEVELS_DIR "/training-ground.glb");
    ASSERT_TRUE(level.has_value());
    const auto ground = build_mesh(*level);
    ASSERT_TRUE(ground.has_value());
    World world;
    ASSERT_TRUE(world.add(*ground).has_value());
    const NavigationMesh mesh = built(world);
    const NavigationQuery query(mesh);
    double planned = 0, walked = 0, seconds = 0;
    std::size_t arrived = 0, plans = 0;
    constexpr std::size_t pairs = 100;
    for (std::size_t i = 0; i < pairs; ++i) {
        const auto from = query.random(2 * i);
        ASSERT_TRUE(from);
        const auto to = query.random_reachable(*from, 2 * i + 1);
        ASSERT_TRUE(to);
        const WalkReport report = walk_path(world, {}, query, from->position, to->position);
        EXPECT_TRUE(report.arrived) << "pair " << i << ": " << sentence(report.reason);
        arrived += report.arrived ? 1 : 0;
        plans += report.plans;
        planned += report.planned;
        walked += report.walked;
        seconds += report.seconds;
    }
    std::cout << arrived << " of " << pairs << " arrived with " << plans << " plans; " << planned << " m planned, "
              << walked << " m walked in " << seconds << " s\n";
    EXPECT_LT(walked, 1.02 * planned);
    EXPECT_LT(seconds, planned / 6 + 0.7 * pairs);

    // The same paths under wider feet: somebody gets stuck.
    const CharacterSettings wide{.volume = Ellipsoid{{0.8, 0.9, 0.8}}};
    std::size_t failed = 0;
    for (std::size_t i = 0; i < pairs && failed == 0; ++i) {
        const auto from = query.random(2 * i);
        const auto to = query.random_reachable(*from, 2 * i + 1);
        if (!walk_path(world, wide, query, from->position, to->position).arrived) ++failed;
    }
    EXPECT_GT(failed, 0U) << "the walk does not see a body that is too wide";
}

}  // namespace
}  // namespace surefoot::tests
