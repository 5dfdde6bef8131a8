// A link that fails is tried with care, then avoided.
#include <surefoot/navigation_follow.hpp>
#include <surefoot/navigation_walk.hpp>

#include "navigation_things.hpp"
#include "navigation_wrong_link.hpp"

namespace surefoot::tests {
namespace {

using Status = NavigationFollowStatus;
using Reason = NavigationFollowReason;

// Broken variants: a follower gives up when a link has failed; it plans over the same link again.
TEST(NavigationFollow, GoesAnotherWayWhenALinkFails) {
    Scene walls = chasm();
    const World before = walls.world();
    NavigationMesh mesh = built(before);
    const NavigationLink wrong = through_the_wall();
    ASSERT_EQ(mesh.set_links(std::span(&wrong, 1)).value_or(9), 0U);
    const World world = walled(walls).world();
    const NavigationQuery query(mesh);
    Walker walker{.world = world, .query = query};
    EXPECT_EQ(walker.at({-6, 0, 0}).to({6, 0, 0}).run(), Status::arrived);
    ASSERT_EQ(walker.follower.failed_links().size(), 1U);
    EXPECT_EQ(walker.follower.failed_links().front(), 0U);
    EXPECT_EQ(walker.follower.links(), 0U);
}

// Broken variant: a follower sent anew still holds what failed against the link.
TEST(NavigationFollow, GivesUpAtALinkThatIsTheOnlyWay) {
    Scene scene;
    scene.block({-8, -9, -8}, {-3, 0, 8}).block({3, -9, -8}, {8, 0, 8});
    NavigationMesh mesh = built(scene.world());
    const NavigationLink wrong = through_the_wall();
    ASSERT_EQ(mesh.set_links(std::span(&wrong, 1)).value_or(9), 0U);
    const World world = walled(scene, 8).world();
    const NavigationQuery query(mesh);
    Walker walker{.world = world, .query = query};
    EXPECT_EQ(walker.at({-6, 0, 0}).to({6, 0, 0}).run(120), Status::gave_up);
    EXPECT_EQ(walker.follower.reason(), Reason::link_failed);
    const WalkReport report = walk_path(world, {}, query, {-6, 0, 0}, {6, 0, 0});
    EXPECT_FALSE(report.arrived);
    EXPECT_EQ(report.failed_links, std::vector<std::uint32_t>{0});
    walker.follower.stop();
    EXPECT_EQ(walker.to({-6, 0, 4}).run(), Status::arrived);
    EXPECT_TRUE(walker.follower.failed_links().empty());
}

}  // namespace
}  // namespace surefoot::tests
