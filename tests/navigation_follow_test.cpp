// Characters are sent over small levels and have to get there by their own feet.
#include <surefoot/navigation_follow.hpp>
#include <surefoot/navigation_walk.hpp>
#include <surefoot/visited_source.hpp>

#include "movement_scene.hpp"
#include "navigation_things.hpp"

namespace surefoot::tests {
namespace {

using Status = NavigationFollowStatus;
using Reason = NavigationFollowReason;

/// A floor of 20 by 20 m with a wall across it that leaves a way at z > 7.
Scene walled() {
    Scene scene;
    scene.floor(-10, 10, -10, 10).block({-0.25, 0, -10}, {0.25, 3, 7});
    return scene;
}

// Broken variant: heading for the farthest place without looking whether it can be seen.
TEST(NavigationFollow, GoesRoundAWallAndNeverLeavesTheMesh) {
    const World world = walled().world();
    const NavigationMesh mesh = built(world);
    const NavigationQuery query(mesh);
    Walker walker{.world = world, .query = query};
    const dvec3 goal{5, 0, -8};
    EXPECT_EQ(walker.at({-5, 0, -8}).to(goal).run(), Status::arrived);
    EXPECT_LT(walker.farthest_off_mesh, 0.05);
    EXPECT_EQ(walker.follower.plans(), 1U);
    EXPECT_GT(walker.slowest, 3) << "it may slow down at the two bends, not stop";
    // 2 * |(4.6, 15.4)| and 1.3 m between the bends, at 6 m/s, half a second to start and to stop.
    EXPECT_LT(walker.seconds, 33.5 / 6 + 0.5);
}

// Broken variants: no slowing down before the goal; arriving counted from farther away than was asked for.
TEST(NavigationFollow, ComesToStandAtTheGoal) {
    const World world = walled().world();
    const NavigationMesh mesh = built(world);
    const NavigationQuery query(mesh);
    for (const double arrival : {0.05, 0.2, 1.0}) {
        for (const double speed : {1.0, 6.0, 12.0}) {
            Walker walker{
                .world = world, .query = query, .follower = NavigationFollower({.speed = speed, .arrival = arrival})};
            const dvec3 goal{-8, 0, 6};
            EXPECT_EQ(walker.at({-5, 0, -8}).to(goal).run(), Status::arrived);
            EXPECT_LE(walker.from_goal(goal), arrival + 1e-9);
            for (int i = 0; i < 60; ++i) walker.tick();
            EXPECT_LE(walker.from_goal(goal), arrival + 0.01) << "speed " << speed << ": it ran past";
            EXPECT_LT(glm::length(walker.state.velocity), 1e-6);
        }
    }
}

// Broken variant: bends are taken at full speed.
TEST(NavigationFollow, SlowsDownOnIceSoThatItDoesNotSlideOffABridge) {
    // An L of 4 m width over nothing, of ice.
    Scene scene;
    scene.made_of(1).floor(-2, 2, -20, 2).floor(2, 20, -2, 2);
    const World world = scene.world();
    const std::array<SurfaceRule, 2> rules{SurfaceRule{}, SurfaceRule{.grip = 0.05}};
    const CharacterSettings settings{.surfaces = std::span<const SurfaceRule>(rules)};
    const NavigationMesh mesh = built(world, settings);
    const NavigationQuery query(mesh);
    Walker walker{.world = world, .query = query, .settings = settings};
    EXPECT_EQ(walker.at({0, 0, -18}).to({18, 0, 0}).run(), Status::arrived);
    EXPECT_GT(walker.lowest, -0.1) << "it fell";
}

TEST(NavigationFollow, ArrivesAtAnyTickRate) {
    const World world = walled().world();
    const NavigationMesh mesh = built(world);
    const NavigationQuery query(mesh);
    for (const double rate : {10.0, 30.0, 60.0, 144.0, 1000.0}) {
        Walker walker{.world = world, .query = query, .dt = 1 / rate};
        EXPECT_EQ(walker.at({-5, 0, -8}).to({5, 0, -8}).run(), Status::arrived) << rate;
        EXPECT_LT(walker.seconds, 33.5 / 6 + 1) << rate;
    }
}

// Broken variant: +Y taken for up anywhere in the follower.
TEST(NavigationFollow, WorksInAnyUp) {
    const dquat turn = glm::normalize(dquat(0.5, 0.7, -0.3, 0.4));
    World world;
    ASSERT_TRUE(world.add(walled().mesh(), {.pose = {.position = {100, -50, 30}, .orientation = turn}}));
    const NavigationMesh mesh = built(world, {}, {.up = turn * dvec3{0, 1, 0}});
    const NavigationQuery query(mesh);
    const auto placed = [&](const dvec3& place) { return dvec3{100, -50, 30} + turn * place; };
    Walker walker{.world = world, .query = query};
    EXPECT_EQ(walker.at(placed({-5, 0, -8})).to(placed({5, 0, -8})).run(), Status::arrived);
    EXPECT_LT(glm::distance(walker.feet(), placed({5, 0, -8})), 0.25);
    EXPECT_LT(walker.farthest_off_mesh, 0.05);
    EXPECT_EQ(walker.follower.plans(), 1U);
}

/// The wall with two doors in it, at z = -6 and at z = 6: areas 1 and 2.
struct Doors {
    World world = [] {
        Scene scene;
        scene.floor(-10, 10, -10, 10).block({-0.25, 0, -10}, {0.25, 3, -7}).block({-0.25, 0, -5}, {0.25, 3, 5});
        return scene.block({-0.25, 0, 7}, {0.25, 3, 10}).world();
    }();
    std::array<NavigationArea, 3> areas{NavigationArea{}, NavigationArea{.name = "near"},
                                        NavigationArea{.name = "far"}};
    std::array<NavigationRegion, 2> regions{NavigationRegion{.name = "near",
                                                             .pose = {.position = {0, 0.5, -6}},
                                                             .half_extents = {0.6, 1, 1.5},
                                                             .kind = NavigationRegion::Kind::area,
                                                             .area = 1},
                                            NavigationRegion{.name = "far",
                                                             .pose = {.position = {0, 0.5, 6}},
                                                             .half_extents = {0.6, 1, 1.5},
                                                             .kind = NavigationRegion::Kind::area,
                                                             .area = 2}};
    NavigationMesh mesh = built(world, {}, {.areas = areas, .regions = regions});
    NavigationQuery query{mesh};
};

// Broken variant: the path is not looked over for doors.
TEST(NavigationFollow, GoesAnotherWayWhenADoorShutsBeforeIt) {
    Doors doors;
    Walker walker{.world = doors.world, .query = doors.query};
    walker.at({-8, 0, -6}).to({8, 0, -6});
    for (int i = 0; i < 40; ++i) walker.tick();
    ASSERT_LT(walker.feet().x, -1);
    ASSERT_TRUE(doors.mesh.set_area(1, true));
    for (int i = 0; i < 30; ++i) walker.tick();
    EXPECT_LT(walker.feet().x, 0) << "it ran through a shut door";
    EXPECT_EQ(walker.run(), Status::arrived);
    EXPECT_EQ(walker.follower.plans(), 2U);
}

TEST(NavigationFollow, GivesUpInWordsWhenTheLastDoorShutsAndGoesOnOnceItOpens) {
    Doors doors;
    Walker walker{.world = doors.world, .query = doors.query};
    walker.at({-8, 0, -6}).to({8, 0, -6});
    for (int i = 0; i < 40; ++i) walker.tick();
    ASSERT_TRUE(doors.mesh.set_area(1, true) && doors.mesh.set_area(2, true));
    EXPECT_EQ(walker.run(), Status::gave_up);
    EXPECT_EQ(walker.follower.reason(), Reason::no_path);
    ASSERT_TRUE(doors.mesh.set_area(2, false));
    walker.follower.stop();
    EXPECT_EQ(walker.to({8, 0, -6}).run(), Status::arrived);
}

TEST(NavigationFollow, GoesAsNearAsItCanIfAskedTo) {
    Doors doors;
    ASSERT_TRUE(doors.mesh.set_area(1, true) && doors.mesh.set_area(2, true));
    Walker walker{.world = doors.world, .query = doors.query, .follower = NavigationFollower({.go_near = true})};
    EXPECT_EQ(walker.at({-8, 0, 0}).to({8, 0, -6}).run(), Status::gave_up);
    EXPECT_EQ(walker.follower.reason(), Reason::no_path);
    EXPECT_GT(walker.feet().x, -2);
}

// Broken variants: a plan for every move of the goal; none for any.
TEST(NavigationFollow, CatchesAGoalThatMovesWithFewPlans) {
    const World world = walled().world();
    const NavigationMesh mesh = built(world);
    const NavigationQuery query(mesh);
    Walker walker{.world = world, .query = query};
    walker.at({-5, 0, -8});
    dvec3 goal{5, 0, -8};
    int ticks = 0;
    for (; ticks < 1200; ++ticks) {
        goal.z = -8 + 14 * 0.5 * (1 - std::cos(ticks * 0.005));  // up to 2.1 m/s
        walker.follower.go(query, goal);
        if (walker.follower.status() == Status::arrived) break;
        walker.tick();
    }
    EXPECT_LT(ticks, 600);
    EXPECT_LT(walker.from_goal(goal), 0.3);
    EXPECT_GE(walker.follower.plans(), 2U);
    EXPECT_LE(walker.follower.plans(), 10U);
    EXPECT_LT(walker.farthest_off_mesh, 0.05);
}

// Broken variant: an old plan is kept from wherever it is now.
TEST(NavigationFollow, PlansAnewFromWhereItWasThrown) {
    const World world = walled().world();
    const NavigationMesh mesh = built(world);
    const NavigationQuery query(mesh);
    Walker walker{.world = world, .query = query};
    walker.at({-5, 0, -8}).to({5, 0, -8});
    for (int i = 0; i < 160; ++i) walker.tick();
    ASSERT_GT(walker.feet().x, -1);
    walker.tick({-10, 6, -14});
    for (int i = 0; i < 20; ++i) walker.tick();
    EXPECT_EQ(walker.follower.plans(), 2U) << "it is far from its path";
    EXPECT_EQ(walker.run(), Status::arrived);
    walker.at({-5, 0, 8});
    EXPECT_EQ(walker.to({5, 0, 5}).run(), Status::arrived) << "it was put somewhere else between two walks";
}

// Broken variant: a place on the floor below counts as one on the path above it.
TEST(NavigationFollow, PlansAnewFromTheFloorBelow) {
    Scene scene;
    scene.floor(-20, 12, -8, 8).quad({-4, 3, -2}, {-4, 3, 2}, {10, 3, 2}, {10, 3, -2});
    scene.quad({-12, 0, -2}, {-12, 0, 2}, {-4, 3, 2}, {-4, 3, -2});
    const World world = scene.world();
    const NavigationMesh mesh = built(world);
    const NavigationQuery query(mesh);
    Walker walker{.world = world, .query = query};
    walker.at({-10, 0.75, 0}).to({8, 3, 0});
    while (walker.feet().x < 0 && walker.seconds < 5) walker.tick();
    ASSERT_GT(walker.feet().y, 2.8);
    walker.at({1, 0, 0}).seconds = 0;
    EXPECT_EQ(walker.run(), Status::arrived);
    EXPECT_EQ(walker.follower.plans(), 2U);
    EXPECT_LT(walker.seconds, (2 * 14 + 8) / 6.0 + 0.6);
}

// Broken variant: on beside the mesh, towards the goal, without a way back to it.
TEST(NavigationFollow, LeavesForbiddenGroundByTheShortestWay) {
    const World world = walled().world();
    const NavigationRegion region{.name = "lawn",
                                  .pose = {.position = {-9, 0, 0}},
                                  .half_extents = {1, 1, 10},
                                  .kind = NavigationRegion::Kind::forbid};
    const NavigationMesh mesh = built(world, {}, {.regions = {&region, 1}});
    const NavigationQuery query(mesh);
    Walker walker{.world = world, .query = query};
    walker.at({-8.8, 0, -9}).to({-7.5, 0, 9});
    for (int i = 0; i < 25; ++i) walker.tick();
    walker.farthest_off_mesh = 0;
    EXPECT_EQ(walker.run(), Status::arrived);
    EXPECT_LT(walker.farthest_off_mesh, 0.1);
}

// Broken variant: at the end of the line the speed is zero, however far the goal is from the feet.
TEST(NavigationFollow, ComesBackToAGoalThatItWasPushedPast) {
    const World world = walled().world();
    const NavigationMesh mesh = built(world);
    const NavigationQuery query(mesh);
    Walker walker{.world = world, .query = query};
    const dvec3 goal{-5, 0, 0};
    walker.at({-5, 0, -6}).to(goal);
    while (walker.from_goal(goal) > 0.6) walker.tick();
    walker.tick({0, 3, 0});
    EXPECT_EQ(walker.run(4), Status::arrived);
    EXPECT_EQ(walker.follower.plans(), 1U);
}

// Broken variant: no clock on progress: it runs against the wall for ever.
TEST(NavigationFollow, GivesUpAgainstAWallThatTheMeshDoesNotKnow) {
    const NavigationMesh mesh = built(walled().world());
    const NavigationQuery query(mesh);
    Scene changed = walled();
    changed.block({-0.25, 0, 7}, {0.25, 3, 10});
    const World world = changed.world();
    const WalkReport report = walk_path(world, {}, query, {-5, 0, -8}, {5, 0, -8});
    EXPECT_FALSE(report.arrived);
    EXPECT_EQ(report.reason, Reason::stuck);
    EXPECT_LT(report.seconds, 20);
    EXPECT_LT(report.end.x, 0);
    ASSERT_TRUE(report.stuck);
    const StepResult again = step(world, {}, report.stuck->input, 1.0 / 60, report.stuck->before);
    EXPECT_TRUE(again.events.has(CharacterEvent::blocked)) << "the moment shows what was in the way";
}

/// Splinters on one spot, more than a step looks at; after some looks they are swept away.
struct Splinters {
    mutable int looks = 0;

    [[nodiscard]] Bounds bounds() const { return {{-2, 0, 8}, {-1.5, 0.1, 9}}; }
    void visit(const Bounds&, const TriangleSink& sink) const {
        if (looks == 0) return;
        --looks;
        for (std::uint32_t id = 0; id < 40'000; ++id) sink(triangle(id), id, 0);
    }
    [[nodiscard]] static Triangle triangle(std::uint32_t) { return {{-2, 0, 8}, {-2, 0, 9}, {-1.5, 0.1, 9}}; }
    [[nodiscard]] static std::uint32_t surface(std::uint32_t) { return 0; }
};

// Broken variants: the last tick in which anything kept it, whatever it was; the last that says `blocked`.
TEST(NavigationFollow, ShowsTheTickInWhichMoreWasNearThanAStepLooksAt) {
    const NavigationMesh mesh = built(walled().world());
    Scene changed = walled();
    changed.block({-0.25, 0, 7}, {0.25, 3, 10});
    World world = changed.world();
    const Splinters splinters{.looks = 40};
    const VisitedSource source(splinters);
    ASSERT_TRUE(world.add(source).has_value());
    const WalkReport report = walk_path(world, {}, mesh, {-5, 0, 8.5}, {5, 0, 8.5});
    EXPECT_EQ(splinters.looks, 0);
    EXPECT_GT(report.end.x, -1) << "it went on, and was stuck at the wall";
    EXPECT_EQ(report.reason, Reason::stuck);
    ASSERT_TRUE(report.stuck);
    EXPECT_LT(report.stuck->before.position.x, -1.5);
    splinters.looks = 40;
    const StepResult again = step(world, {}, report.stuck->input, 1.0 / 60, report.stuck->before);
    EXPECT_TRUE(again.events.has(CharacterEvent::overflow));
}

TEST(NavigationFollow, SaysWhereThereIsNoMesh) {
    const World world = walled().world();
    const NavigationMesh mesh = built(world);
    const NavigationQuery query(mesh);
    Walker walker{.world = world, .query = query};
    EXPECT_EQ(walker.at({-5, 0, 0}).to({100, 0, 0}).run(), Status::gave_up);
    EXPECT_EQ(walker.follower.reason(), Reason::goal_off_mesh);
    Scene wide = walled();
    const World wider = wide.floor(20, 40, -10, 10).world();
    Walker lost{.world = wider, .query = query};
    EXPECT_EQ(lost.at({30, 0, 0}).to({5, 0, 0}).run(), Status::gave_up);
    EXPECT_EQ(lost.follower.reason(), Reason::off_mesh);
    EXPECT_LT(lost.seconds, 3);
}

// Broken variant: the driver is never called, and it stops where the ground ends.
TEST(NavigationFollow, GoesOverLinks) {
    Scene scene;
    scene.block({-10, 0, -5}, {0, 2, 5}).floor(0, 12, -5, 5);
    const World world = scene.world();
    NavigationMesh mesh = built(world);
    const NavigationLink drop{.from = {-1, 2, 0}, .to = {1.5, 0, 0}, .takeoff = {-0.45, 2, 0}, .inputs = {}};
    const auto left_out = mesh.set_links({&drop, 1});
    ASSERT_TRUE(left_out.has_value());
    ASSERT_EQ(*left_out, 0U);
    const NavigationQuery query(mesh);
    const WalkReport report = walk_path(world, {}, query, {-8, 2, 3}, {10, 0, -3});
    EXPECT_TRUE(report.arrived) << sentence(report.reason);
    EXPECT_EQ(report.links, 1U);
    EXPECT_EQ(report.plans, 1U);
    const WalkReport back = walk_path(world, {}, query, {10, 0, -3}, {-8, 2, 3});
    EXPECT_EQ(back.reason, Reason::no_path) << "a drop is no way up";
}

TEST(NavigationFollow, GivesUpALinkThatDoesNotLeadToItsEnd) {
    Scene scene;
    scene.block({-10, 0, -5}, {0, 2, 5}).floor(0, 12, -5, 5);
    const World world = scene.world();
    NavigationMesh mesh = built(world);
    // It says that one can walk up a wall of two metres.
    const NavigationLink lie{.from = {1, 0, 0},
                             .to = {-1, 2, 0},
                             .takeoff = {1, 0, 0},
                             .kind = NavigationLinkKind::step_up,
                             .seconds = 0.5,
                             .inputs = {}};
    ASSERT_TRUE(mesh.set_links({&lie, 1}).has_value());
    const WalkReport report = walk_path(world, {}, mesh, {10, 0, -3}, {-8, 2, 3}, {.most_seconds = 100});
    EXPECT_FALSE(report.arrived);
    EXPECT_EQ(report.reason, Reason::link_failed);
}

TEST(NavigationFollow, SaysEachReasonInItsOwnWords) {
    std::vector<std::string_view> all;
    for (const Reason reason :
         {Reason::none, Reason::off_mesh, Reason::goal_off_mesh, Reason::no_path, Reason::stuck, Reason::link_failed}) {
        EXPECT_EQ(std::count(all.begin(), all.end(), sentence(reason)), 0);
        all.push_back(sentence(reason));
    }
}

}  // namespace
}  // namespace surefoot::tests
