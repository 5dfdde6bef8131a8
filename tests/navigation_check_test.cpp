// Mesh and feet are checked against each other, and a mesh for other feet is found out.
#include <gtest/gtest.h>
#include <vector>

#include <surefoot/character.hpp>
#include <surefoot/navigation_check.hpp>
#include <surefoot/navigation_query.hpp>
#include <surefoot/world.hpp>

#include "navigation_wrong_link.hpp"

namespace surefoot {
namespace {

/// Triangles of boxes and ramps.
class Bricks {
public:
    void box(const vec3& low, const vec3& high) {
        const auto corner = [&](int i) {
            return vec3{i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z};
        };
        quad(corner(2), corner(6), corner(7), corner(3));  // the top
        quad(corner(0), corner(1), corner(5), corner(4));
        quad(corner(0), corner(2), corner(3), corner(1));
        quad(corner(4), corner(5), corner(7), corner(6));
        quad(corner(0), corner(4), corner(6), corner(2));
        quad(corner(1), corner(3), corner(7), corner(5));
    }
    /// Rises with x from `low.y` at `low.x` to `high.y` at `high.x`.
    void ramp(const vec3& low, const vec3& high) {
        quad({low.x, low.y, low.z}, {low.x, low.y, high.z}, {high.x, high.y, high.z}, {high.x, high.y, low.z});
        quad({high.x, low.y, low.z}, {high.x, high.y, low.z}, {high.x, high.y, high.z}, {high.x, low.y, high.z});
    }
    [[nodiscard]] Mesh mesh() const { return Mesh::build({.vertices = vertices_, .indices = indices_}).value(); }

private:
    void quad(const vec3& a, const vec3& b, const vec3& c, const vec3& d) {
        const auto first = static_cast<std::uint32_t>(vertices_.size());
        vertices_.insert(vertices_.end(), {a, b, c, d});
        for (const std::uint32_t corner : {0U, 1U, 2U, 0U, 2U, 3U}) indices_.push_back(first + corner);
    }
    std::vector<vec3> vertices_;
    std::vector<std::uint32_t> indices_;
};

constexpr dvec3 start{-5, 0, 0};

NavigationCheckOptions quick(std::size_t walks) {
    NavigationCheckOptions options;
    options.walks = walks;
    options.rehearsals = 25;
    return options;
}

NavigationCheck check_of(const Bricks& bricks, const NavigationCheckOptions& options,
                         const CharacterSettings& settings = {}) {
    World world;
    EXPECT_TRUE(world.add(bricks.mesh()).has_value());
    auto check = check_navigation(world, settings, std::span(&start, 1), options);
    EXPECT_TRUE(check.has_value()) << (check ? "" : check.error().text);
    return check.value_or(NavigationCheck{});
}

/// The same level with a mesh for another agent than the feet's. Nobody jumps: jumps would get up steps and banks.
template <typename Change>
NavigationCheck check_wrong(const Bricks& bricks, std::size_t walks, const Change& change, std::size_t rehearsals = 0) {
    CharacterSettings settings;
    settings.jump_height = 0;
    NavigationCheckOptions options = quick(walks);
    options.rehearsals = rehearsals;
    NavigationAgent agent = navigation_agent(settings);
    change(agent);
    options.mesh.agent = agent;
    return check_of(bricks, options, settings);
}

/// Two rooms; the wall between them has a slit of half a metre in the middle and a door of a metre and a half at its
/// end.
Bricks slit() {
    Bricks bricks;
    bricks.box({-6, -1, -4}, {6, 0, 4});
    bricks.box({-0.2F, 0, -4}, {0.2F, 3, -0.25F});
    bricks.box({-0.2F, 0, 0.25F}, {0.2F, 3, 2.5F});
    return bricks;
}

/// A floor and a platform as high as a chair; a gentle ramp goes up at one end.
Bricks chair() {
    Bricks bricks;
    bricks.box({-6, -1, -4}, {1, 0, 4});
    bricks.box({1, -1, -4}, {6, 0.6F, 4});
    bricks.ramp({-1, 0, 2.5F}, {1, 0.6F, 4});
    return bricks;
}

/// A floor and a platform of ninety centimetres; a short ramp of 60 degrees in the middle and one of 24 at the side.
Bricks bank() {
    Bricks bricks;
    bricks.box({-6, -1, -4}, {2, 0, 4});
    bricks.box({2, -1, -4}, {6, 0.9F, 4});
    bricks.ramp({1.48F, 0, -4}, {2, 0.9F, 2});
    bricks.ramp({0, 0, 2.5F}, {2, 0.9F, 4});
    return bricks;
}

/// Stairs of thirty centimetres up to a platform.
Bricks stairs() {
    Bricks bricks;
    bricks.box({-6, -1, -4}, {0, 0, 4});
    bricks.box({0, -1, -4}, {0.5F, 0.3F, 4});
    bricks.box({0.5F, -1, -4}, {1, 0.6F, 4});
    bricks.box({1, -1, -4}, {6, 0.9F, 4});
    return bricks;
}

/// A floor with two walls on it; there is room everywhere.
Bricks walls() {
    Bricks bricks;
    bricks.box({-6, -1, -4}, {6, 0, 4});
    bricks.box({-2.2F, 0, -2}, {-1.8F, 3, 2});
    bricks.box({1.8F, 0, -2}, {2.2F, 3, 2});
    return bricks;
}

TEST(NavigationCheck, PassesWhereMeshAndFeetObeyOneRule) {
    for (const Bricks& bricks : {slit(), chair(), bank(), stairs(), walls()}) {
        const NavigationCheck check = check_of(bricks, quick(25));
        EXPECT_TRUE(check.all_arrived()) << check.arrived << " of " << check.walks;
        EXPECT_TRUE(check.is_covered()) << check.agreement.covered();
        EXPECT_FALSE(check.lost_a_kind());
        EXPECT_GT(check.agreement.kept, 60);
    }
}

TEST(NavigationCheck, AMeshForAThinnerBodyLosesTheSlitThroughWhichNoFeetGet) {
    const NavigationCheck right = check_of(slit(), quick(5));
    const NavigationCheck thin = check_wrong(slit(), 25, [](NavigationAgent& agent) { agent.radius = 0.15; });
    EXPECT_GT(thin.agreement.unreached, right.agreement.unreached + 0.05);
    EXPECT_TRUE(thin.all_arrived()) << "by the door";
}

TEST(NavigationCheck, AMeshForAWiderBodyDoesNotKnowWhatFeetReach) {
    const NavigationCheck check = check_wrong(slit(), 5, [](NavigationAgent& agent) { agent.radius = 1; });
    EXPECT_FALSE(check.is_covered()) << check.agreement.covered();
}

// Broken variant: ground counts as known if the mesh ends within a cell of the flood, as wide as what is lost.
TEST(NavigationCheck, AMeshForASomewhatWiderBodyDoesNotKnowTheGroundAlongWalls) {
    const NavigationCheck check = check_wrong(walls(), 5, [](NavigationAgent& agent) { agent.radius = 0.7; });
    EXPECT_FALSE(check.is_covered()) << check.agreement.covered();
}

TEST(NavigationCheck, AMeshForHigherStepsGetsWalksStuckBeforeAPlatform) {
    const auto change = [](double climb) { return [=](NavigationAgent& agent) { agent.climb = climb; }; };
    const NavigationCheck wrong = check_wrong(chair(), 25, change(0.8));
    EXPECT_FALSE(wrong.all_arrived());
    ASSERT_FALSE(wrong.failed.empty());
    EXPECT_TRUE(wrong.failed.front().report.stuck.has_value()) << "there is a step to look at";
    EXPECT_TRUE(check_wrong(chair(), 25, change(CharacterSettings{}.step_up)).all_arrived());
}

TEST(NavigationCheck, AMeshForLowerStepsDoesNotKnowWhatIsUpTheStairs) {
    const NavigationCheck check = check_wrong(stairs(), 5, [](NavigationAgent& agent) { agent.climb = 0.1; });
    EXPECT_FALSE(check.is_covered() && !check.lost_a_kind()) << check.agreement.covered();
}

TEST(NavigationCheck, AMeshForSteeperSlopesGetsWalksStuckOnABank) {
    EXPECT_FALSE(check_wrong(bank(), 25, [](NavigationAgent& agent) { agent.slope_limit_deg = 75; }).all_arrived());
}

TEST(NavigationCheck, AMeshForGentlerSlopesDoesNotKnowWhatIsUpTheRamp) {
    const NavigationCheck check = check_wrong(bank(), 5, [](NavigationAgent& agent) { agent.slope_limit_deg = 15; });
    EXPECT_FALSE(check.is_covered()) << check.agreement.covered();
}

TEST(NavigationCheck, TheFloodKnowsNothingOfTheMeshAndStopsAtWalls) {
    Bricks bricks;
    bricks.box({-6, -1, -4}, {6, 0, 4});
    bricks.box({-0.2F, 0, -4}, {0.2F, 3, 4});  // from side to side
    World world;
    ASSERT_TRUE(world.add(bricks.mesh()).has_value());
    auto mesh = NavigationMesh::build(world, {});
    ASSERT_TRUE(mesh.has_value());
    const NavigationFlood flood = flood_by_feet(world, {}, *mesh, std::span(&start, 1));
    EXPECT_GT(flood.area(), 35);
    for (const NavigationFloodCell& cell : flood.cells) EXPECT_LT(cell.feet.x, -0.6);
    const NavigationAgreement agreement = keep_reached(*mesh, flood, start);
    EXPECT_GT(agreement.unreached, 35) << "the other room";
    EXPECT_GT(agreement.covered(), 0.98);
    const NavigationQuery query(*mesh);
    EXPECT_FALSE(query.under({3, 0.5, 0}, 1, 1).has_value()) << "no path begins where no feet get";
}

TEST(NavigationCheck, APitIsTakenOutSinceNobodyComesBack) {
    Bricks bricks;
    bricks.box({-6, -1, -4}, {0, 0, 4});
    bricks.box({0, -4, -4}, {6, -3, 4});
    bricks.box({6, -4, -4}, {6.5F, 0, 4});
    World world;
    ASSERT_TRUE(world.add(bricks.mesh()).has_value());
    auto mesh = NavigationMesh::build(world, {});
    ASSERT_TRUE(mesh.has_value());
    NavigationCheck check;
    const NavigationAgreement agreement = prove_by_feet(*mesh, world, {}, start, quick(0), &check);
    EXPECT_GT(check.links.done[0], 0U) << "the feet can drop into it";
    EXPECT_GT(agreement.no_return, 30);
    EXPECT_LT(agreement.kept, 60);
}

TEST(NavigationCheck, SaysInWordsThatNobodyCanStandInALevel) {
    Bricks bricks;
    bricks.ramp({0, 0, 0}, {1, 10, 5});
    World world;
    ASSERT_TRUE(world.add(bricks.mesh()).has_value());
    const auto check = check_navigation(world, {}, {}, quick(1));
    ASSERT_FALSE(check.has_value());
    EXPECT_NE(check.error().text.find("nobody can stand"), std::string::npos) << check.error().text;
}

// Broken variant: a rehearsal takes out whatever fails, and a mesh that is wrong everywhere passes.
TEST(NavigationCheck, ARehearsalMendsSlipsAndNotAMeshForOtherFeet) {
    const auto higher = [](NavigationAgent& agent) { agent.climb = 0.8; };
    const NavigationCheck steps = check_wrong(chair(), 25, higher, 25);
    EXPECT_FALSE(steps.passes());
    EXPECT_LE(steps.agreement.failed_area, 0.01 * (steps.agreement.kept + steps.agreement.failed_area));
    const auto steeper = [](NavigationAgent& agent) { agent.slope_limit_deg = 75; };
    EXPECT_FALSE(check_wrong(bank(), 25, steeper, 25).passes());
}

// Broken variants: a failed link stays; a rehearsal is content after its first round; all links are dropped.
TEST(NavigationCheck, ALinkThatFailsInARehearsalIsDropped) {
    tests::Scene scene = tests::chasm();
    const World world = walled(scene).world();
    auto mesh = NavigationMesh::build(world, {});
    ASSERT_TRUE(mesh.has_value());
    const NavigationLink wrong = tests::through_the_wall();
    ASSERT_EQ(mesh->set_links(std::span(&wrong, 1)).value_or(9), 0U);
    const NavigationFlood flood = flood_by_feet(world, {}, *mesh, std::span(&start, 1));
    NavigationAgreement agreement = keep_reached(*mesh, flood, start);
    const double kept = agreement.kept;
    rehearse(*mesh, world, {}, flood, start, quick(0), agreement);
    EXPECT_EQ(agreement.failed_links, 1U);
    EXPECT_EQ(agreement.failed_polygons, 0U);
    EXPECT_EQ(agreement.rehearsed, 50U) << "the second round has no failure";
    EXPECT_TRUE(mesh->links().empty());
    EXPECT_DOUBLE_EQ(agreement.kept, kept) << "there is the bridge";
}

// Broken variant: tiles that are put in with other links hold ground that was taken out.
TEST(NavigationCheck, WhatIsTakenOutStaysSoWhateverLinksCome) {
    tests::Scene scene = tests::chasm();
    const World world = walled(scene).world();
    auto mesh = NavigationMesh::build(world, {});
    ASSERT_TRUE(mesh.has_value());
    const NavigationLink wrong = tests::through_the_wall();
    const NavigationPolygon bridge =
        NavigationQuery(*mesh).nearest({0, 0, 7}, 1, 1).value_or(NavigationPoint{}).polygon;
    mesh->take_out(std::span(&bridge, 1));
    for (const std::size_t links : {1U, 0U}) {
        ASSERT_EQ(mesh->set_links(std::span(&wrong, links)).value_or(9), 0U);
        EXPECT_FALSE(NavigationQuery(*mesh).nearest({0, 0, 7}, 0.1, 1).has_value());
    }
}

// Broken variant: it begins on whichever polygon comes first, which may be a niche that feet do not get back to.
TEST(NavigationCheck, WithoutSpawnPointsItBeginsOnTheLargestPolygonOfTheLargestPiece) {
    Bricks bricks;
    bricks.box({-9, -1, -0.5F}, {-5, 0, 0.5F});  // a tongue, which comes first
    bricks.box({-5, -1, -6}, {9, 0, 6});
    World world;
    ASSERT_TRUE(world.add(bricks.mesh()).has_value());
    const auto mesh = NavigationMesh::build(world, {});
    ASSERT_TRUE(mesh.has_value());
    const auto begin = best_start(*mesh, {});
    ASSERT_TRUE(begin.has_value());
    EXPECT_GT(begin->x, -5);
}

}  // namespace
}  // namespace surefoot
