// Bodies with edges and corners: boxes, cylinders, and cones on their apex. Each case was a fault once.
#include "movement_scene.hpp"

namespace surefoot::tests {
namespace {

constexpr Box box{.half_extents = {0.4, 0.9, 0.4}};
constexpr Cylinder cylinder{.radius = 0.4, .half_height = 0.9};
constexpr Cone cone{.radius = 0.4, .height = 1.8};

Actor actor_of(const Volume& volume, const dvec3& place) {
    Actor actor;
    actor.settings.volume = volume;
    actor.settings.acceleration = actor.settings.braking = 1e9;
    actor.state.position = place;
    return actor;
}

// Blocks of a metre in a row along z, their fronts at x = 0, on a floor.
World wall_of_blocks() {
    World world;
    EXPECT_TRUE(world.add(Scene().floor(-20, 20, -20, 20, 0, 10).mesh()));
    const Mesh block = Scene().block({0, -0.5, 0}, {1, 4, 1}).mesh();
    for (int i = 0; i < 20; ++i) EXPECT_TRUE(world.add(block, {.pose = {.position = {0, 0, -10.0 + i}}}));
    return world;
}

TEST(MovementShapes, ABoxSlidesAlongAWallOfSeparateBlocksWhoseHiddenSidesStopNothing) {
    const World world = wall_of_blocks();
    for (const double into : {0.3, 1.0, 3.0}) {
        Actor actor = actor_of(box, {-0.6, 0.92, -8.5});
        actor.run(world, 0.5);
        actor.run(world, 0.5, {.wish = {into, 0, 0}});
        const double from = actor.state.position.z;
        actor.run(world, 3, {.wish = {into, 0, 2}});
        EXPECT_NEAR(actor.state.position.z - from, 6, 1e-6) << into;
    }
}

TEST(MovementShapes, ABoxIsStoppedByTheSideOfABlockThatStandsOutOfTheRow) {
    World world = wall_of_blocks();
    ASSERT_TRUE(world.add(Scene().block({-0.1, -0.5, 0}, {1, 4, 1}).mesh()));  // a tenth of a metre before the others
    Actor actor = actor_of(box, {-0.6, 0.92, -8.5});
    actor.run(world, 0.5);
    actor.run(world, 8, {.wish = {1, 0, 2}});
    EXPECT_NEAR(actor.state.position.z, -0.41, 1e-6);
}

TEST(MovementShapes, ABoxOnGroundThatLeadsDownStepsOverAKerbThatIsLowerThanWhereItCameFrom) {
    // A slope down of 2 in 100. The hind edge of a box carries it: 2.8 mm below the origin's height where its last free
    // tick begins, 3.6 mm where it meets the kerb, whose top is between.
    Scene scene;
    scene.quad({-10, 0.2, -5}, {-10, 0.2, 5}, {10, -0.2, 5}, {10, -0.2, -5});
    scene.block({1, -1, -5}, {10, -0.0033, 5});
    const World world = scene.world();
    Actor actor = actor_of(box, {-3, 1.1, 0});
    actor.run(world, 0.5);
    ASSERT_TRUE(actor.on_ground());
    const double from = actor.state.position.x;
    actor.run(world, 2, {.wish = {3, 0, 0}});
    EXPECT_NEAR(actor.state.position.x - from, 6, 1e-6);
}

TEST(MovementShapes, AConeWalksDownASlopeWhoseSeamsItsSideMeetsAtMoreThanARightAngle) {
    for (const double degrees : {15.0, 30.0, 45.0}) {
        Scene scene;
        const double c = std::cos(degrees * 0.017453292519943295), s = std::sin(degrees * 0.017453292519943295);
        for (int i = -20; i < 20; ++i) {
            const double u = 0.5 * i, v = u + 0.5;
            scene.quad({u * c, u * s, -3}, {u * c, u * s, 3}, {v * c, v * s, 3}, {v * c, v * s, -3});
        }
        const World world = scene.world();
        Actor actor = actor_of(cone, {0.3, 0.3 * s / c + 0.1, 0});
        actor.run(world, 0.5);
        const double from = actor.state.position.x;
        actor.run(world, 2, {.wish = {-2, 0, 0}});
        EXPECT_NEAR(actor.state.position.x - from, -4, 0.01) << degrees;
        EXPECT_TRUE(actor.on_ground()) << degrees;
    }
}

TEST(MovementShapes, AConeStandsOnAnEdgeThatIsHigherThanItsApexAndClimbsStairs) {
    const World world = Scene().floor(-10, 0, -3, 3).stairs(0, 5, 0.38, 0.4).world();
    Actor actor = actor_of(cone, {-1, 0.06, 0});
    actor.run(world, 0.3);
    actor.run(world, 2, {.wish = {2, 0, 0}});
    EXPECT_TRUE(actor.on_ground());
    EXPECT_FALSE(actor.did(CharacterEvent::left_ground));
    EXPECT_NEAR(actor.state.position.y, 5 * 0.38 + 0.046, 0.001);
}

TEST(MovementShapes, AConePutIntoTheFloorComesUpThoughItsApexIsBelow) {
    const World world = Scene().floor(-10, 10, -10, 10, 0, 20).world();
    for (const double deep : {0.1, 0.3, 0.7}) {
        Actor actor = actor_of(cone, {0.1, -deep, 0.2});
        actor.run(world, 1);
        EXPECT_NEAR(actor.state.position.y, 0.0345, 0.0116) << deep << ", half a skin off its sides or all of it";
        EXPECT_FALSE(actor.did(CharacterEvent::stuck)) << deep;
    }
}

TEST(MovementShapes, AConePutIntoACeilingIsNotLedIntoTheFloorOnItsWayOut) {
    const World world = Scene().floor(-10, 10, -10, 10, 0, 20).block({-3, 1.52, -3}, {0, 3, 3}).world();
    Actor actor = actor_of(cone, {-0.3, 0.056, 0});
    for (int tick = 0; tick < 60; ++tick) {
        actor.tick(world);
        EXPECT_GT(actor.state.position.y, -0.01) << tick;
    }
    EXPECT_GT(actor.state.position.x, 0.4);
    EXPECT_TRUE(actor.on_ground());
}

TEST(MovementShapes, ACylinderThatAWallPushesOverASeamOfTheFloorIsNotCrushed) {
    World world;
    const Mesh slab = Scene().block({0, -1, -5}, {1.5, 0, 5}).mesh();
    for (int i = -2; i < 8; ++i) ASSERT_TRUE(world.add(slab, {.pose = {.position = {1.5 * i, 0, 0}}}));
    const auto wall = world.add(Scene().block({-2, 0.05, -5}, {-1, 3, 5}).mesh());
    ASSERT_TRUE(wall);
    Actor actor = actor_of(cylinder, {0, 0.91, 0});
    actor.run(world, 0.2);
    for (int tick = 0; tick < 60; ++tick) {
        world.begin_tick();
        ASSERT_TRUE(world.move(*wall, {.position = {(tick + 1) / 6.0, 0, 0}}));
        actor.tick(world);
        EXPECT_GT(actor.state.position.x, (tick + 1) / 6.0 - 1 + 0.4) << tick;
    }
    EXPECT_FALSE(actor.did(CharacterEvent::crushed));
    EXPECT_FALSE(actor.did(CharacterEvent::recovered));
}

}  // namespace
}  // namespace surefoot::tests
