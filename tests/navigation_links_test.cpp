// Links are found where a simulated character gets over, and nowhere else.
#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>

#include <surefoot/navigation_links.hpp>
#include <surefoot/navigation_query.hpp>

#include "navigation_link_levels.hpp"

namespace surefoot::tests {
namespace {

using Kind = NavigationLinkKind;

/// How many jumps lead so much higher at least.
std::size_t jumps_up(const std::vector<NavigationLink>& links, double least) {
    return static_cast<std::size_t>(std::count_if(links.begin(), links.end(), [&](const NavigationLink& link) {
        return link.kind == Kind::jump && rise(link) >= least;
    }));
}

// Broken variants: no drops proposed; drops proposed upwards; links are not thinned out; the recorded inputs are those
// of a run with margins.
TEST(NavigationLinks, ATerraceIsDroppedOffAndNotJumpedOnto) {
    Level level = level_of(terrace(3));
    const auto links = level.links();
    EXPECT_GE(count(links, Kind::drop), 8U);
    for (const NavigationLink& link : links) {
        EXPECT_EQ(link.kind, Kind::drop);
        EXPECT_NEAR(rise(link), -3, 0.2);
    }
    EXPECT_EQ(level.report.kept[0], links.size());
    EXPECT_LT(links.size(), level.report.done[0]);
    for (const NavigationLink& link : links)
        for (const NavigationLink& other : links) {
            const dvec3 apart = link.takeoff - other.takeoff;
            EXPECT_TRUE(&link == &other || std::hypot(apart.x, apart.z) > 0.8 * level.options.spacing);
        }
    expect_replays(level, links);
}

// Broken variant: the option is not looked at.
TEST(NavigationLinks, ADropOverTheLimitIsNotThere) {
    Level level = level_of(terrace(3));
    level.options.deepest_drop = 2.8;
    EXPECT_TRUE(level.links().empty());
    level.options.deepest_drop = 3.2;
    EXPECT_FALSE(level.links().empty());
}

// Broken variant: proposals are kept without simulating them.
TEST(NavigationLinks, ARailingLetsNobodyDrop) {
    Scene scene = terrace(3);
    // Two bars, with nothing between them at the height of the body's middle.
    for (const auto& [low, high] : {std::pair{3.5, 3.6}, std::pair{4.4, 4.6}})
        for (const double side : {-1.0, 1.0})
            scene.block({-4, low, side > 0 ? 3.9 : -4.0}, {4, high, side > 0 ? 4.0 : -3.9})
                .block({side > 0 ? 3.9 : -4.0, low, -4}, {side > 0 ? 4.0 : -3.9, high, 4});
    Level level = level_of(scene);
    EXPECT_TRUE(level.links().empty());
    EXPECT_GT(level.report.tried[0], 0U) << "nothing was proposed, so this shows nothing";
}

// Broken variants: only one way is looked for; from one place there are links to all places of the other side.
TEST(NavigationLinks, AGapIsJumpedBothWays) {
    Level level = level_of(gap(2));
    const auto links = level.links();
    std::size_t there = 0;
    for (const NavigationLink& link : links) {
        EXPECT_EQ(link.kind, Kind::jump);
        EXPECT_LT(link.from.x * link.to.x, 0);
        there += link.to.x > 0 ? 1 : 0;
    }
    EXPECT_GE(there, 2U);
    EXPECT_LE(there, 5U) << "six metres of border, and a link in one and a half";
    EXPECT_GE(links.size() - there, 2U);
    EXPECT_LE(links.size() - there, 5U);
    expect_replays(level, links);
}

// Broken variant: proposals are kept without simulating them.
TEST(NavigationLinks, AGapThatIsALittleTooWideIsNotJumped) {
    // By the ballistics a jump at 6 m/s leads 4.16 m far, and feet may leave and land a little over an edge.
    EXPECT_FALSE(level_of(gap(3)).links().empty());
    EXPECT_TRUE(level_of(gap(5)).links().empty());
    Level lame = level_of(gap(3));
    lame.options.run_speed = 3;
    EXPECT_TRUE(lame.links().empty());
}

// Broken variant: margins are not tried.
TEST(NavigationLinks, AGapThatOnlyTheLuckyGetOverIsNotJumped) {
    bool lucky_found = false;
    for (double width = 3; width < 5; width += 0.1) {
        Level lucky = level_of(gap(width));
        lucky.options.margins = {.along = 0, .aside = 0, .speed = 0};
        Level careful = level_of(gap(width));
        if (!careful.links().empty()) continue;
        lucky_found = !lucky.links().empty();
        EXPECT_TRUE(lucky_found) << "at a width of " << width << " m";
        break;
    }
    EXPECT_TRUE(lucky_found);
}

// Broken variant: each margin left out by itself.
TEST(NavigationLinks, EachMarginRefusesLinks) {
    const auto narrowest_refused = [](const NavigationLinkMargins& margins) {
        double width = 3;
        for (; width < 6; width += 0.1) {
            Level level = level_of(gap(width));
            level.options.margins = margins;
            if (level.links().empty()) break;
        }
        return width;
    };
    const double lucky = narrowest_refused({.along = 0, .aside = 0, .speed = 0});
    EXPECT_LT(narrowest_refused({.along = 0.4, .aside = 0, .speed = 0}), lucky);
    EXPECT_LT(narrowest_refused({.along = 0, .aside = 0, .speed = 0.2}), lucky);
    // To the left and right of a beam there is nothing.
    Scene beam;
    beam.block({-6, 0, -0.15}, {-1, 20, 0.15}).block({1, 0, -0.15}, {6, 20, 0.15});
    Level level = level_of(beam);
    level.mesh_options.cell_size = 0.05;
    level.options.margins = {.along = 0, .aside = 0, .speed = 0};
    EXPECT_FALSE(level.links().empty());
    level.options.margins.aside = 1;
    EXPECT_TRUE(level.links().empty());
}

// Broken variants: jumps up are not proposed; the jump is let go at once.
TEST(NavigationLinks, ABlockIsJumpedOntoAsHighAsTheCharacterJumps) {
    Level level = level_of(terrace(1));
    const auto links = level.links();
    EXPECT_GE(jumps_up(links, 0.8), 8U);
    EXPECT_GE(count(links, Kind::drop), 8U);
    expect_replays(level, links);
    level.settings.jump_height = 0.6;
    EXPECT_EQ(jumps_up(level.links(), 0.8), 0U);
    EXPECT_EQ(jumps_up(level_of(terrace(1.7)).links(), 0.8), 0U);
}

// Broken variant: what is higher than a jump is not proposed to hands.
TEST(NavigationLinks, HandsHelpUpHigherBlocks) {
    Level level = level_of(terrace(2.2));
    EXPECT_EQ(jumps_up(level.links(), 2), 0U);
    level.settings.ledge_reach = 0.3;
    const auto links = level.links();
    EXPECT_GE(jumps_up(links, 2), 8U);
    expect_replays(level, links);
    Level too_high = level_of(terrace(3.5));
    too_high.settings.ledge_reach = 0.3;
    EXPECT_EQ(jumps_up(too_high.links(), 2), 0U);
}

// Broken variant: proposals are kept without simulating them.
TEST(NavigationLinks, ALowCeilingOverAGapLetsNobodyJump) {
    EXPECT_FALSE(level_of(gap(3)).links().empty());
    Level low = level_of(gap(3).block({-2, 22, -3}, {2, 23, 3}));
    EXPECT_EQ(count(low.links(), Kind::jump), 0U);
    EXPECT_GT(low.report.tried[1], 0U) << "nothing was proposed, so this shows nothing";
}

// Broken variants: steps are not proposed; they are taken for jumps.
TEST(NavigationLinks, AStepThatTheMeshIsTooCoarseForIsWalked) {
    Level level = level_of(terrace(0.38));
    const dvec3 low{-8, 0, 0};
    const dvec3 high{0, 0.38, 0};
    int too_coarse = 0;
    for (const double cell_height : {0.01, 0.0525, 0.075, 0.09, 0.11, 0.19}) {
        level.mesh_options.cell_height = cell_height;
        level.settings.step_up = 0.4;
        NavigationMesh mesh = level.mesh();
        const auto is_joined = [&] {
            const NavigationQuery query(mesh);
            const auto up = query.path(*query.nearest(low, 1, 0.3), *query.nearest(high, 1, 0.3));
            const auto down = query.path(*query.nearest(high, 1, 0.3), *query.nearest(low, 1, 0.3));
            return up && down && !up->partial && !down->partial;
        };
        const auto links = find_links(level.world, level.settings, mesh, level.options);
        if (is_joined()) {
            EXPECT_TRUE(links.empty()) << "the mesh has the step itself";
            continue;
        }
        ++too_coarse;
        EXPECT_GE(count(links, Kind::step_up), 8U);
        EXPECT_EQ(count(links, Kind::step_up), links.size());
        expect_replays(level, links);
        for (const NavigationLink& link : links)
            for (const NavigationInput& input : link.inputs) EXPECT_EQ(input.jump, 0);
        ASSERT_TRUE(mesh.set_links(links).has_value());
        EXPECT_TRUE(is_joined());
        // Whoever cannot step has to jump.
        level.settings.step_up = 0.2;
        const auto jumps = level.links();
        EXPECT_GE(jumps_up(jumps, 0.3), 8U);
        for (const NavigationLink& link : jumps) EXPECT_TRUE(link.kind != Kind::step_up || rise(link) < 0);
    }
    EXPECT_GT(too_coarse, 0) << "the mesh has become too good for this";
}

// Broken variant: regions are not looked at.
TEST(NavigationLinks, NobodyWalksThroughWhatIsForbidden) {
    Scene scene;
    Level level = level_of(scene.floor(-6, 6, -3, 3));
    const std::array<NavigationRegion, 1> lava{
        {{.name = "lava", .half_extents = {0.3, 1, 4}, .kind = NavigationRegion::Kind::forbid}}};
    level.mesh_options.regions = lava;
    const auto links = level.links();
    EXPECT_GE(count(links, Kind::step_up), 4U) << "feet know nothing of it";
    level.options.regions = lava;
    const auto over = level.links();
    EXPECT_EQ(count(over, Kind::step_up), 0U);
    EXPECT_GE(count(over, Kind::jump), 4U);
}

// Broken variant: the walk's length is not looked at.
TEST(NavigationLinks, ADropThatSavesNothingIsNotThere) {
    // A terrace of one metre with a ramp on to it, as wide as itself.
    Scene scene;
    scene.floor(-20, 20, -20, 20).block({0, 0, -2}, {4, 1, 2}).ramp(-4, 4, 14.0362, 2);
    Level level = level_of(scene);
    level.options.least_saving = 50;
    EXPECT_TRUE(level.links().empty());
    level.options.least_saving = 0;
    EXPECT_FALSE(level.links().empty());
}

// Broken variant: threads write into one list.
TEST(NavigationLinks, AreTheSameForAnyNumberOfThreads) {
    Level level = level_of(terrace(1));
    level.options.threads = 1;
    const auto alone = level.links();
    level.options.threads = 3;
    const auto shared = level.links();
    ASSERT_EQ(alone.size(), shared.size());
    for (std::size_t i = 0; i < alone.size(); ++i) {
        EXPECT_EQ(alone[i].from, shared[i].from);
        EXPECT_EQ(alone[i].end, shared[i].end);
        EXPECT_EQ(alone[i].inputs.size(), shared[i].inputs.size());
    }
}

TEST(NavigationLinks, TellHowFarTheyAre) {
    Level level = level_of(terrace(1));
    std::size_t last = 0;
    std::size_t whole = 0;
    const auto tell = [&](std::size_t done, std::size_t all) {
        EXPECT_EQ(done, last + 1);
        last = done;
        whole = all;
    };
    level.options.progress = NavigationProgress(tell);
    EXPECT_FALSE(level.links().empty());
    EXPECT_EQ(last, whole);
}

// Broken variant: a number that is no length goes into the search.
TEST(NavigationLinks, AreNoneForOptionsOutOfRange) {
    Level level = level_of(terrace(1));
    level.options.spacing = 0;
    EXPECT_TRUE(level.links().empty());
    level.options = {};
    level.options.run_speed = std::nan("");
    EXPECT_TRUE(level.links().empty());
}

// Broken variant: +Y is taken for up somewhere.
TEST(NavigationLinks, AreFoundWithAnyUp) {
    const Mesh mesh = terrace(1).mesh();
    const dvec3 up{0, 0, 1};
    Level level;
    const Pose on_its_back{.position = {3, 4, 5}, .orientation = {std::sqrt(0.5), std::sqrt(0.5), 0, 0}};
    ASSERT_TRUE(level.world.add(mesh, {.pose = on_its_back}).has_value());
    level.mesh_options.up = up;
    const auto links = level.links();
    EXPECT_GE(count(links, Kind::drop), 8U);
    EXPECT_GE(count(links, Kind::jump), 8U);
    for (const NavigationLink& link : links) {
        EXPECT_NEAR(std::abs(rise(link, up)), 1, 0.2);
        EXPECT_EQ(replayed(level, link, up), link.end);
    }
}

}  // namespace
}  // namespace surefoot::tests
