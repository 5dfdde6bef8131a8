// Characters on and between bodies that move.
#include "movement_scene.hpp"

namespace surefoot::tests {
namespace {

Pose at(double x, double y, double z) {
    return {.position = {x, y, z}};
}

TEST(MovementBodies, ALiftThatGoesUpAndDownKeepsItsRiderAtOneHeightAboveIt) {
    for (const double speed : {0.5, 3.0, 8.0}) {
        World world;
        const auto lift = world.add(Scene().floor(-2, 2, -2, 2).mesh());
        Actor actor;
        actor.state.position = {0.1, 1, 0.2};
        actor.run(world, 1);
        const double above = actor.state.position.y;
        double height = 0;
        for (int tick = 0; tick < 240; ++tick) {
            height += (tick < 120 ? speed : -speed) * actor.dt;
            world.begin_tick();
            ASSERT_TRUE(world.move(*lift, at(0, height, 0)));
            actor.tick(world);
            ASSERT_TRUE(actor.on_ground()) << speed << " " << tick;
            ASSERT_NEAR(actor.state.position.y - height, above, 0.1 * actor.settings.skin) << speed << " " << tick;
            ASSERT_NEAR(actor.state.ground_velocity.y, tick < 120 ? speed : -speed, 1e-9);
        }
    }
}

TEST(MovementBodies, ATrainTakesItsRiderAlongAndLeavesItItsSpeed) {
    World world;
    const auto train = world.add(Scene().floor(-3, 3, -2, 2).mesh());
    Actor actor;
    actor.state.position = {0.5, 1, 0.2};
    actor.run(world, 1);
    double x = 0;
    for (int tick = 0; tick < 120; ++tick) {
        x += 10 * actor.dt;
        world.begin_tick();
        ASSERT_TRUE(world.move(*train, at(x, 0, 0)));
        actor.tick(world);
        ASSERT_NEAR(actor.state.position.x - x, 0.5, 1e-9);
    }
    x += 10 * actor.dt;
    world.begin_tick();
    ASSERT_TRUE(world.move(*train, at(x, 0, 0)));
    actor.tick(world, {.jump = true});
    EXPECT_TRUE(actor.did(CharacterEvent::jumped));
    EXPECT_NEAR(actor.state.velocity.x, 10, 0.5);
}

TEST(MovementBodies, ATurntableTurnsItsRiderAboutItsMiddle) {
    World world;
    const auto table = world.add(Scene().floor(-4, 4, -4, 4).mesh());
    Actor actor;
    actor.state.position = {2, 1, 0};
    actor.run(world, 1);
    for (int tick = 1; tick <= 300; ++tick) {
        const double angle = tick * 0.02;
        world.begin_tick();
        ASSERT_TRUE(world.move(
            *table, {.position = {0, 0, 0}, .orientation = {std::cos(angle / 2), 0, std::sin(angle / 2), 0}}));
        actor.tick(world);
        ASSERT_TRUE(actor.on_ground());
        ASSERT_NEAR(actor.state.position.x, 2 * std::cos(angle), 1e-3) << tick;
        ASSERT_NEAR(actor.state.position.z, -2 * std::sin(angle), 1e-3) << tick;
    }
}

TEST(MovementBodies, AWallThatComesPushesHoweverFastItIs) {
    for (const double speed : {1.0, 10.0, 1000.0}) {
        World world;
        ASSERT_TRUE(world.add(Scene().floor(-400, 400, -20, 20).mesh()));
        const auto wall = world.add(Scene().block({-1, 0.05, -3}, {0, 3, 3}).mesh(), {.pose = at(-3, 0, 0)});
        Actor actor;
        actor.state.position = {0.2, 1, 0.1};
        actor.run(world, 0.5);
        double x = -3;
        for (int tick = 0; tick < 20; ++tick) {
            x += speed * actor.dt;
            world.begin_tick();
            ASSERT_TRUE(world.move(*wall, at(x, 0, 0)));
            actor.tick(world);
            ASSERT_GE(actor.state.position.x, x + 0.4) << speed << " tick " << tick;
        }
        EXPECT_TRUE(speed < 10 || actor.did(CharacterEvent::pushed));
        EXPECT_FALSE(actor.did(CharacterEvent::crushed));
        EXPECT_TRUE(actor.on_ground());
    }
}

TEST(MovementBodies, AWallThatPressesAgainstAnotherCrushes) {
    World world;
    ASSERT_TRUE(world.add(Scene().floor(-20, 20, -20, 20).block({2, 0, -5}, {3, 4, 5}).mesh()));
    const auto wall = world.add(Scene().block({-1, 0.05, -5}, {0, 4, 5}).mesh());
    Actor actor;
    actor.state.position = {1, 1, 0.1};
    actor.run(world, 0.5);
    double x = 0;
    for (int tick = 0; tick < 90; ++tick) {
        x += 1.0 * actor.dt;
        world.begin_tick();
        ASSERT_TRUE(world.move(*wall, at(x, 0, 0)));
        actor.tick(world);
        EXPECT_TRUE(x > 2 - 0.85 || !actor.did(CharacterEvent::crushed)) << x;
        ASSERT_LT(actor.state.position.x, 2) << x;
    }
    EXPECT_TRUE(actor.did(CharacterEvent::crushed));
}

TEST(MovementBodies, ACeilingThatComesDownOnAFloorCrushes) {
    World world;
    ASSERT_TRUE(world.add(Scene().floor(-20, 20, -20, 20).mesh()));
    const auto press = world.add(Scene().block({-2, 0, -2}, {2, 1, 2}).mesh(), {.pose = at(0, 3, 0)});
    Actor actor;
    actor.state.position = {0.2, 1, 0.1};
    actor.run(world, 0.5);
    double y = 3;
    while (y > 1.2 && !actor.did(CharacterEvent::crushed)) {
        y -= 1.0 * actor.dt;
        world.begin_tick();
        ASSERT_TRUE(world.move(*press, at(0, y, 0)));
        actor.tick(world);
        ASSERT_GT(actor.state.position.y, 0.8);
    }
    EXPECT_NEAR(y, 1.8 + 2 * actor.settings.skin, 0.05);
}

TEST(MovementBodies, ALongTickRidesAsFarAsManyShortOnes) {
    for (const double dt : {1.0 / 60, 1.0 / 4}) {
        World world;
        const auto train = world.add(Scene().floor(-3, 3, -2, 2).mesh());
        Actor actor{.dt = dt};
        actor.state.position = {0.5, 1, 0.2};
        actor.run(world, 1);
        double x = 0;
        for (double time = 0; time < 0.999; time += dt) {
            x += 2 * dt;
            world.begin_tick();
            ASSERT_TRUE(world.move(*train, at(x, 0, 0)));
            actor.tick(world);
        }
        EXPECT_NEAR(actor.state.position.x - x, 0.5, 1e-9) << dt;
    }
}

}  // namespace
}  // namespace surefoot::tests
