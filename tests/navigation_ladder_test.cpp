// Ladders are climbed up and down, and jumps in the air lead farther and higher.
#include <array>
#include <cmath>
#include <gtest/gtest.h>

#include <surefoot/navigation_links.hpp>

#include "navigation_link_levels.hpp"
#include "navigation_things.hpp"

namespace surefoot::tests {
namespace {

using Kind = NavigationLinkKind;
using Status = NavigationFollowStatus;

/// Two floors, the one `height` above the other, and between them a wall in the middle of which is a ladder.
Scene storeys(double height) {
    Scene scene;
    scene.floor(-6, 0, -3, 3).floor(0, 6, -3, 3, height);
    scene.quad({0, 0, -3}, {0, 0, -0.6}, {0, height, -0.6}, {0, height, -3});
    scene.quad({0, 0, 0.6}, {0, 0, 3}, {0, height, 3}, {0, height, 0.6});
    return scene.made_of(1).quad({0, 0, -0.6}, {0, 0, 0.6}, {0, height, 0.6}, {0, height, -0.6});
}

/// With a character that knows what a ladder is. No drop is so deep.
struct Ladder {
    std::array<SurfaceRule, 2> rules{};
    Level level;

    explicit Ladder(double height = 4) : level(level_of(storeys(height))) {
        rules[1].ladder = true;
        level.settings.surfaces = SurfaceRules(rules);
        level.options.deepest_drop = 3;
    }
    Ladder(const Ladder&) = delete;
    Ladder& operator=(const Ladder&) = delete;
};

// Broken variants: ladders are not proposed; only the way up is; `crouch` is not recorded.
TEST(NavigationLadders, AreClimbedUpAndDown) {
    Ladder ladder;
    const auto links = ladder.level.links();
    ASSERT_EQ(links.size(), 2U);
    EXPECT_EQ(count(links, Kind::ladder), 2U);
    EXPECT_NEAR(rise(links[0]) + rise(links[1]), 0, 0.01) << "one up, one down";
    for (const NavigationLink& link : links) {
        EXPECT_NEAR(std::abs(rise(link)), 4, 0.2);
        EXPECT_NEAR(link.from.z, 0, 0.6);
        bool crouches = false;
        for (const NavigationInput& input : link.inputs) crouches = crouches || input.crouch != 0;
        EXPECT_EQ(crouches, rise(link) < 0);
    }
    expect_replays(ladder.level, links);
}

// Broken variants: every wall is a ladder; whoever climbs none is sent up; the wall beside it is one.
TEST(NavigationLadders, AreNoneToWhoeverCannotClimb) {
    Ladder ladder;
    ladder.level.settings.ladder_speed = 0;
    EXPECT_TRUE(ladder.level.links().empty());
    Ladder wall;
    wall.rules[1].ladder = false;
    EXPECT_TRUE(wall.level.links().empty());
}

// Broken variants: the driver does not let go of `crouch` at the foot; it runs off the edge and falls.
TEST(NavigationLadders, LeadAFollowerUpAndDown) {
    Ladder ladder;
    NavigationMesh mesh = ladder.level.mesh();
    ASSERT_EQ(mesh.set_links(ladder.level.links()).value_or(9), 0U);
    const NavigationQuery query(mesh);
    Walker walker{.world = ladder.level.world, .query = query, .settings = ladder.level.settings};
    const dvec3 low{-4, 0, 2};
    const dvec3 high{4, 4, -2};
    EXPECT_EQ(walker.at(low).to(high).run(), Status::arrived);
    EXPECT_NEAR(walker.feet().y, 4, 0.05);
    EXPECT_EQ(walker.follower.links(), 1U);
    double fastest_fall = 0;
    walker.to(low);
    while (walker.follower.status() == Status::following && walker.seconds < 60) {
        walker.tick();
        fastest_fall = std::min(fastest_fall, walker.state.velocity.y);
    }
    EXPECT_EQ(walker.follower.status(), Status::arrived);
    EXPECT_NEAR(walker.feet().y, 0, 0.05);
    EXPECT_EQ(walker.follower.links(), 1U);
    EXPECT_GT(fastest_fall, -6) << "it climbed, and did not fall the four metres";
    EXPECT_TRUE(walker.follower.failed_links().empty());
}

// Broken variants: the reach of one jump is that of all; the second jump is pressed while the first still rises.
TEST(NavigationAirJumps, LeadOverGapsThatOneJumpDoesNot) {
    Level level = level_of(gap(6));
    EXPECT_TRUE(level.links().empty());
    level.settings.air_jumps = 1;
    const auto links = level.links();
    EXPECT_GE(count(links, Kind::jump), 4U);
    for (const NavigationLink& link : links) EXPECT_EQ(link.air_jumps, 1U);
    expect_replays(level, links);
    EXPECT_TRUE([] {
        Level wide = level_of(gap(9));
        wide.settings.air_jumps = 1;
        return wide.links();
    }()
                    .empty());
    // Where one jump gets over, one it is.
    Level narrow = level_of(gap(2));
    narrow.settings.air_jumps = 1;
    const auto single = narrow.links();
    EXPECT_GE(count(single, Kind::jump), 4U);
    for (const NavigationLink& link : single) EXPECT_EQ(link.air_jumps, 0U);
}

// Broken variant: a wall that is higher than one jump is not proposed.
TEST(NavigationAirJumps, LeadUpBlocksThatOneJumpDoesNot) {
    Level level = level_of(terrace(2.2));
    const auto up = [&] {
        const auto links = level.links();
        expect_replays(level, links);
        return std::count_if(links.begin(), links.end(), [](const NavigationLink& link) { return rise(link) > 2; });
    };
    EXPECT_EQ(up(), 0);
    level.settings.air_jumps = 1;
    EXPECT_GE(up(), 8);
    level.settings.wall_jump_speed = 5;
    level.settings.wall_slide_speed = 3;
    EXPECT_GE(up(), 8) << "whoever can jump off walls, too, is not thrown back by the one that it jumps up";
    level = level_of(terrace(3.2));
    level.settings.air_jumps = 1;
    EXPECT_EQ(up(), 0);
}

// Broken variant: the follower's copy of a link forgets the jumps in the air.
TEST(NavigationAirJumps, AreMadeByAFollower) {
    Level level = level_of(gap(6));
    level.settings.air_jumps = 1;
    NavigationMesh mesh = level.mesh();
    ASSERT_EQ(mesh.set_links(level.links()).value_or(9), 0U);
    const auto bytes = mesh.to_bytes();
    const auto opened = NavigationMesh::read(bytes);
    ASSERT_TRUE(opened.has_value()) << opened.error().text;
    for (const NavigationMesh* const kept : {&std::as_const(mesh), &*opened}) {
        const NavigationQuery query(*kept);
        Walker walker{.world = level.world, .query = query, .settings = level.settings};
        EXPECT_EQ(walker.at({-5, 20, 2}).to({5, 20, -2}).run(), Status::arrived);
        EXPECT_EQ(walker.follower.links(), 1U);
        EXPECT_TRUE(walker.follower.failed_links().empty());
    }
}

}  // namespace
}  // namespace surefoot::tests
