// Whoever goes over links by the driver gets over.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include <surefoot/navigation_drive.hpp>
#include <surefoot/navigation_links.hpp>
#include <surefoot/navigation_query.hpp>

#include "navigation_link_levels.hpp"

namespace surefoot::tests {
namespace {

using Kind = NavigationLinkKind;

/// Walks along a path's corners and over its links; where it comes to a stand.
dvec3 followed(const Level& level, const NavigationMesh& mesh, const NavigationPath& path) {
    CharacterState state = stand_at(level.world, level.settings, path.corners.front().position);
    const double feet = mesh.agent().feet;
    for (std::size_t i = 0; i + 1 < path.corners.size(); ++i) {
        const NavigationCorner& corner = path.corners[i];
        NavigationDrive driver{.feet = feet};
        for (int ticks = 0; ticks < 600; ++ticks) {
            CharacterInput input;
            if (corner.link) {
                input = drive(mesh.links()[*corner.link], driver, state, level.settings, 1.0 / 60);
                EXPECT_NE(driver.status, NavigationDriveStatus::failed);
                if (driver.status == NavigationDriveStatus::arrived) break;
            } else {
                const dvec3 way = path.corners[i + 1].position - state.position;
                const double distance = std::hypot(way.x, way.z);
                if (distance < 0.1) break;
                input.wish = dvec3{way.x, 0, way.z} * (5 * std::min(1.0, 2 * distance) / distance);
            }
            state = step(level.world, level.settings, input, 1.0 / 60, state).state;
        }
    }
    return state.position - dvec3{0, feet, 0};
}

// Broken variants: `set_links` forgets a link's number; the driver takes off anywhere.
TEST(NavigationDrive, GetsOverTheLinkOfAPathAcrossAGap) {
    Level level = level_of(gap(3));
    NavigationMesh mesh = level.mesh();
    const dvec3 start{-5, 20, -2};
    const dvec3 goal{5, 20, 1.5};
    {
        const NavigationQuery query(mesh);
        EXPECT_TRUE(query.path(*query.nearest(start, 1, 1), *query.nearest(goal, 1, 1))->partial);
    }
    const auto left_out = mesh.set_links(level.links());
    ASSERT_TRUE(left_out.has_value());
    EXPECT_EQ(*left_out, 0U);
    const NavigationQuery query(mesh);
    const auto path = query.path(*query.nearest(start, 1, 1), *query.nearest(goal, 1, 1));
    ASSERT_TRUE(path && !path->partial);
    EXPECT_EQ(std::count_if(path->corners.begin(), path->corners.end(), [](const auto& at) { return !!at.link; }), 1);
    const dvec3 end = followed(level, mesh, *path);
    EXPECT_LT(std::hypot(end.x - goal.x, end.z - goal.z), 0.3);
    EXPECT_NEAR(end.y, goal.y, 0.1);
}

// Broken variant: a driver that waits for ever.
TEST(NavigationDrive, FailsWhenTheWayIsNotThere) {
    const Level level = level_of(gap(3));
    const NavigationLink link{.from = {-3, 20, 0}, .to = {3, 20, 0}, .takeoff = {-2.3, 20, 0}, .kind = Kind::drop};
    CharacterState state = stand_at(level.world, level.settings, link.from);
    NavigationDrive driver{.feet = navigation_agent(level.settings).feet};
    int ticks = 0;
    for (; ticks < 600 && driver.status != NavigationDriveStatus::failed; ++ticks)
        state = step(level.world, level.settings, drive(link, driver, state, level.settings, 1.0 / 60), 1.0 / 60, state)
                    .state;
    EXPECT_EQ(driver.status, NavigationDriveStatus::failed);
    EXPECT_LT(ticks, 120);
}

// Broken variant: a push is not steered against.
TEST(NavigationDrive, SteersBackWhoeverIsPushed) {
    const Level level = level_of(gap(2));
    const NavigationLink link{.from = {-3, 20, 0}, .to = {2, 20, 0}, .takeoff = {-1.1, 20, 0}, .kind = Kind::jump};
    CharacterState state = stand_at(level.world, level.settings, link.from);
    NavigationDrive driver{.feet = navigation_agent(level.settings).feet};
    double pushed = 0;
    for (int ticks = 0; ticks < 300 && driver.status != NavigationDriveStatus::arrived; ++ticks) {
        CharacterInput input = drive(link, driver, state, level.settings, 1.0 / 60);
        if (ticks == 2) input.impulse = {0, 0, 5};
        if (!driver.airborne) pushed = std::max(pushed, state.position.z);
        if (input.jump && state.footing == Footing::ground) {
            EXPECT_LT(state.position.z, pushed / 2);
        }
        state = step(level.world, level.settings, input, 1.0 / 60, state).state;
    }
    EXPECT_GT(pushed, 0.15);
    EXPECT_EQ(driver.status, NavigationDriveStatus::arrived);
}

/// Twelve stones with tilted tops, strewn over a floor.
Scene stones() {
    std::uint32_t random = 1013904226;
    const auto next = [&] {
        random = random * 1664525U + 1013904223U;
        return (random >> 8) / 16777216.0;
    };
    Scene scene;
    scene.floor(-3, 3, -3, 3);
    for (int i = 0; i < 12; ++i) {
        const double x = -2.5 + 5 * next();
        const double z = -2.5 + 5 * next();
        const double wide = 0.15 + 0.6 * next();
        const double deep = 0.15 + 0.6 * next();
        const double high = 0.3 + 1.2 * next();
        const double tilt = (next() - 0.5) * 1.2;
        const double rise = high - std::abs(tilt) * wide < 0.05 ? 0 : tilt * wide;
        const dvec3 a{x - wide, 0, z - deep}, b{x - wide, 0, z + deep}, c{x + wide, 0, z + deep},
            d{x + wide, 0, z - deep};
        const dvec3 up_low{0, high - rise, 0}, up_high{0, high + rise, 0};
        scene.quad(a + up_low, b + up_low, c + up_high, d + up_high);
        scene.quad(a, b, b + up_low, a + up_low).quad(b, c, c + up_high, b + up_low);
        scene.quad(c, d, d + up_high, c + up_high).quad(d, a, a + up_low, d + up_high);
    }
    return scene;
}

// Broken variant: a link is proved only for those who set out at rest from the very place where it begins; then some of
// these fail.
TEST(NavigationDrive, GetsOverWhoeverSetsOutBesideTheBeginningAndOnTheMove) {
    Level level = level_of(stones());
    const auto links = level.links();
    EXPECT_GT(links.size(), 50U);
    const double feet = navigation_agent(level.settings).feet;
    for (const NavigationLink& link : links) {
        dvec3 forward{link.to.x - link.from.x, 0, link.to.z - link.from.z};
        forward /= std::max(std::hypot(forward.x, forward.z), 1e-9);
        const dvec3 left{forward.z, 0, -forward.x};
        for (const dvec3& aside : {forward, -forward, left, -left}) {
            CharacterState state = stand_at(level.world, level.settings, link.from + aside * 0.14);
            if (state.footing != Footing::ground) continue;
            state.velocity = aside;
            NavigationDrive driver{.feet = feet};
            while (driver.status < NavigationDriveStatus::arrived) {
                const CharacterInput input = drive(link, driver, state, level.settings, 1.0 / 60);
                state = step(level.world, level.settings, input, 1.0 / 60, state).state;
            }
            EXPECT_EQ(driver.status, NavigationDriveStatus::arrived)
                << "from " << link.from.x << ' ' << link.from.y << ' ' << link.from.z;
        }
    }
}

// Broken variant: whoever is to be careful sets out on the run.
TEST(NavigationDrive, WithCareItComesToRestFirst) {
    Level level = level_of(gap(3));
    const auto links = level.links();
    ASSERT_FALSE(links.empty());
    const NavigationLink& link = links.front();
    for (const bool careful : {false, true}) {
        CharacterState state = stand_at(level.world, level.settings, link.from + dvec3{0, 0, 0.1});
        NavigationDrive driver{.feet = navigation_agent(level.settings).feet, .careful = careful};
        double off = 1;
        while (driver.status < NavigationDriveStatus::arrived) {
            const bool waits = driver.status == NavigationDriveStatus::approaching;
            const dvec3 at = state.position;
            const CharacterInput input = drive(link, driver, state, level.settings, 1.0 / 60);
            if (waits && driver.status == NavigationDriveStatus::under_way)
                off = std::hypot(at.x - link.from.x, at.z - link.from.z);
            state = step(level.world, level.settings, input, 1.0 / 60, state).state;
        }
        EXPECT_EQ(driver.status, NavigationDriveStatus::arrived);
        EXPECT_EQ(off < 0.05, careful) << off;
    }
}

}  // namespace
}  // namespace surefoot::tests
