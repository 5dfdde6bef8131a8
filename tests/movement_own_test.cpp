// Ways of moving of the user's own, what it presses against, and flat feet.
#include <limits>

#include "movement_scene.hpp"

namespace surefoot::tests {
namespace {

dvec3 mirrored(const dvec3& v, const dvec3& normal) {
    return v - normal * (2 * (v.x * normal.x + v.y * normal.y + v.z * normal.z));
}
constexpr auto bounce = [](const MetOnTheWay& met) {
    return OwnMotion{mirrored(met.left.way, met.normal), mirrored(met.left.velocity, met.normal)};
};
constexpr auto drift = [](const OwnTick& tick) { return OwnMotion{tick.velocity * tick.dt, tick.velocity}; };
constexpr auto stick = [](const MetOnTheWay&) { return OwnMotion{}; };

Actor in_room(const CharacterHooks& hooks) {
    Actor actor;
    actor.state.position = {0, 2, 0};
    actor.hooks = hooks;
    return actor;
}

Actor ball_in_room(const dvec3& velocity, const CharacterHooks& hooks) {
    Actor ball = in_room(hooks);
    ball.settings.volume = Sphere{0.3};
    ball.state.velocity = velocity;
    return ball;
}

World room() {
    Scene scene;
    scene.block({-4, -1, -4}, {4, 0, 4}).block({-4, 4, -4}, {4, 5, 4});
    scene.block({-5, -1, -5}, {-4, 5, 5}).block({4, -1, -5}, {5, 5, 5});
    return scene.block({-5, -1, -5}, {5, 5, -4}).block({-5, -1, 4}, {5, 5, 5}).world();
}

TEST(MovementOwn, ABallInARoomBouncesForTenSecondsAndKeepsItsSpeed) {
    const World world = room();
    Actor ball = ball_in_room({5, 3, 2}, {.respond = bounce, .move = drift});
    const CharacterInput input{.mode = CharacterMode::own};
    int turns = 0;
    dvec3 before = ball.state.velocity;
    for (int i = 0; i < 600; ++i) {
        ball.tick(world, input);
        const dvec3& v = ball.state.velocity;
        if (!(v == before)) ++turns;
        before = v;
        ASSERT_NEAR(v.x * v.x + v.y * v.y + v.z * v.z, 38, 1e-9) << "after " << i << " ticks";
        ASSERT_LT(std::abs(ball.state.position.x), 3.7 + 1e-9);
        ASSERT_LT(std::abs(ball.state.position.z), 3.7 + 1e-9);
        ASSERT_GT(ball.state.position.y, 0.3);
    }
    EXPECT_GT(turns, 15) << "without a rule of its own it would have slid into a corner";

    Actor slides = ball_in_room({5, 3, 2}, {.move = drift});
    slides.run(world, 10, input);
    EXPECT_EQ(slides.state.velocity, dvec3(0, 0, 0)) << "this is what the rule changes";
}

TEST(MovementOwn, WhatSticksStaysWhereItTouched) {
    const World world = room();
    Actor dart = ball_in_room({5, 1, 2}, {.respond = stick, .move = drift});
    dart.run(world, 2, {.mode = CharacterMode::own});
    EXPECT_EQ(dart.state.velocity, dvec3(0, 0, 0));
    EXPECT_NEAR(dart.state.position.x, 3.7 - dart.settings.skin, 1e-6);
    EXPECT_NEAR(dart.state.position.z, 2.0 * dart.state.position.x / 5, 1e-6) << "on its line";
}

TEST(MovementOwn, OnFootAWallOfGlueHoldsWhoeverWouldSlideAlongIt) {
    const World world = Scene().floor(-5, 5, -5, 5).block({2, -1, -5}, {3, 3, 5}).world();
    const CharacterInput along{.wish = {3, 0, 3}};
    Actor free;
    Actor held;
    free.state.position = held.state.position = {0, 1, 0};
    free.run(world, 1.5, along);
    bool on_foot = false;
    const auto glue = [&](const MetOnTheWay& met) {
        on_foot = on_foot || met.on_foot;
        return OwnMotion{};
    };
    held.hooks.respond = glue;
    held.run(world, 1.5, along);
    EXPECT_TRUE(on_foot);
    EXPECT_GT(free.state.position.z, 3);
    EXPECT_LT(held.state.position.z, 2);
    EXPECT_EQ(held.state.footing, Footing::ground);
}

TEST(MovementOwn, AModeOfOnesOwnWithoutItsRuleIsInvalidAndChangesNothing) {
    const World world = room();
    Actor actor = in_room({});
    const CharacterState before = actor.state;
    actor.tick(world, {.mode = CharacterMode::own});
    EXPECT_TRUE(actor.did(CharacterEvent::invalid));
    EXPECT_EQ(actor.state, before);
}

TEST(MovementOwn, AnAnswerThatIsNoNumberStandsStill) {
    const World world = room();
    const auto nonsense = [](const OwnTick&) {
        const double none = std::numeric_limits<double>::quiet_NaN();
        return OwnMotion{{none, 0, 0}, {0, none, 0}};
    };
    Actor actor = in_room({.move = nonsense});
    for (int i = 0; i < 10; ++i) actor.tick(world, {.mode = CharacterMode::own});
    EXPECT_EQ(actor.state.position, dvec3(0, 2, 0));
    EXPECT_EQ(actor.state.velocity, dvec3(0, 0, 0));
}

const CharacterContact* contact_with(const StepResult& result, std::uint32_t body) {
    for (const CharacterContact& contact : result.contacts.get()) {
        if (contact.body == body) return &contact;
    }
    return nullptr;
}

// A floor, body 1, and a wall of its own, body 2, at x = 2.
World walled() {
    World world;
    EXPECT_TRUE(world.add(Scene().floor(-5, 5, -5, 5).mesh(), {.body = 1}));
    EXPECT_TRUE(world.add(Scene().block({2, 0, -5}, {3, 3, 5}).mesh(), {.body = 2}));
    return world;
}

TEST(MovementContacts, WhoStandsPressesWithTheWeightOfATick) {
    const World world = walled();
    Actor actor;
    actor.state.position = {0, 1, 0};
    actor.run(world, 1);
    const StepResult result = step(world, actor.settings, {}, actor.dt, actor.state);
    ASSERT_EQ(result.contacts.count, 1U);
    const CharacterContact* floor = contact_with(result, 1);
    ASSERT_NE(floor, nullptr);
    EXPECT_EQ(floor->impulse, dvec3(0, -actor.settings.gravity * actor.dt, 0));
    EXPECT_NEAR(floor->point.y, 0, 1e-12);
}

TEST(MovementContacts, AWallIsGivenTheVelocityThatItTakesAndNoMore) {
    const World world = walled();
    Actor actor;
    actor.state.position = {1, 1, 0};
    const CharacterContact* wall = nullptr;
    StepResult result;
    for (int i = 0; i < 120 && wall == nullptr; ++i) {
        result = step(world, actor.settings, {.wish = {3, 0, 2}}, actor.dt, actor.state);
        actor.state = result.state;
        wall = contact_with(result, 2);
    }
    ASSERT_NE(wall, nullptr);
    EXPECT_NEAR(wall->impulse.x, 3, 1e-6);
    EXPECT_NEAR(wall->impulse.z, 0, 1e-6) << "along it nothing is taken";
    EXPECT_NEAR(wall->normal.x, -1, 1e-9);
    EXPECT_NEAR(wall->point.x, 2, 1e-9);
}

TEST(MovementContacts, WhatFallsGivesItsSpeedToWhatItLandsOn) {
    const World world = walled();
    Actor actor;
    actor.state.position = {0, 4, 0};
    for (int i = 0; i < 120; ++i) {
        const StepResult result = step(world, actor.settings, {}, actor.dt, actor.state);
        actor.state = result.state;
        if (!result.events.has(CharacterEvent::landed)) {
            EXPECT_EQ(result.contacts.count, 0U) << "nothing is pressed in the air";
            continue;
        }
        const CharacterContact* floor = contact_with(result, 1);
        ASSERT_NE(floor, nullptr);
        const double weight = actor.settings.gravity * actor.dt;
        EXPECT_NEAR(-floor->impulse.y, result.events.landing_speed + weight, 1e-6);
        return;
    }
    FAIL() << "it never landed";
}

// The lowest that the feet come to, walking off a floor's edge on to one 0.3 m lower, before the axis is 0.15 m past
// it.
double dip(bool flat) {
    const World world = Scene().floor(-5, 0, -5, 5).floor(0, 5, -5, 5, -0.3).world();
    Actor actor;
    actor.settings.flat_foot = flat;
    actor.state.position = {-2, 1, 0};
    actor.run(world, 1);
    const double level = actor.state.position.y;
    double lowest = 0;
    for (int i = 0; i < 240 && actor.state.position.x < 0.14; ++i) {
        actor.tick(world, {.wish = {1, 0, 0}});
        if (actor.state.position.x < 0.15) lowest = std::min(lowest, actor.state.position.y - level);
    }
    EXPECT_FALSE(actor.did(CharacterEvent::left_ground));
    for (int i = 0; i < 120; ++i) actor.tick(world, {.wish = {1, 0, 0}});
    EXPECT_NEAR(actor.state.position.y, level - 0.3, 1e-3) << "and then it is down";
    return -lowest;
}

TEST(MovementOwn, FlatFeetKeepTheFloorsHeightBesideItsEdgeWhereAnEllipsoidDips) {
    EXPECT_GT(dip(false), 0.04);
    EXPECT_LT(dip(true), 1e-3);
}

TEST(MovementOwn, FlatFeetStandStillBesideAnEdgeBitForBit) {
    const World world = Scene().floor(-5, 0, -5, 5).world();
    Actor actor;
    actor.settings.flat_foot = true;
    actor.state.position = {-1, 1, 0};
    actor.run(world, 1);
    for (int i = 0; i < 240 && actor.state.position.x < 0.1; ++i) actor.tick(world, {.wish = {1, 0, 0}});
    actor.run(world, 0.5);
    const dvec3 place = actor.state.position;
    EXPECT_GT(place.x, 0.05);
    actor.run(world, 2);
    EXPECT_EQ(actor.state.position, place);
    EXPECT_TRUE(actor.on_ground());
}

}  // namespace
}  // namespace surefoot::tests
