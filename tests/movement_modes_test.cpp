// Crouching and other bodies, walls, dashes, water, ladders, flying, and any direction for up.
#include <array>

#include "movement_scene.hpp"

namespace surefoot::tests {
namespace {

TEST(MovementModes, WhoCrouchesPassesUnderALowCeilingAndStandsUpBehindItAndNotBefore) {
    const World world = Scene().floor(-20, 20, -5, 5).block({2, 1.2, -5}, {4, 3, 5}).world();
    Actor actor;
    actor.settings.crouched = Volume(Ellipsoid{{0.4, 0.5, 0.4}});
    actor.state.position = {0, 1, 0};
    actor.run(world, 1, {.wish = {3, 0, 0}});
    EXPECT_LT(actor.state.position.x, 2) << "too tall";
    actor.run(world, 0.75, {.wish = {3, 0, 0}, .crouch = true});
    EXPECT_GT(actor.state.position.x, 2.3);
    EXPECT_NEAR(actor.state.position.y, 0.51, 0.005);
    const CharacterEvents events = actor.tick(world, {});
    EXPECT_TRUE(events.has(CharacterEvent::no_room));
    EXPECT_EQ(actor.state.form, CharacterForm::crouched);
    actor.run(world, 1.5, {.wish = {3, 0, 0}});
    EXPECT_GT(actor.state.position.x, 5);
    EXPECT_EQ(actor.state.form, CharacterForm::standing);
    EXPECT_NEAR(actor.state.position.y, 0.91, 0.005);
}

TEST(MovementModes, OnASlopeItCrouchesAndStandsUpToo) {
    for (const double degrees : {5.0, 16.5, 30.0, 45.0}) {
        const World world = Scene().floor(-20, 0, -5, 5).ramp(0, 20, degrees).world();
        Actor actor;
        actor.settings.volume = Ellipsoid{{0.35, 0.8, 0.35}};
        actor.settings.crouched = Volume(Ellipsoid{{0.35, 0.45, 0.35}});
        actor.settings.flat_foot = true;
        actor.state.position = {-1, 1, 0};
        actor.run(world, 1.5, {.wish = {4, 0, 0}});
        ASSERT_GT(actor.state.position.x, 0.5);
        actor.run(world, 0.3, {});
        EXPECT_FALSE(actor.tick(world, {.crouch = true}).has(CharacterEvent::no_room)) << degrees;
        EXPECT_EQ(actor.state.form, CharacterForm::crouched) << degrees;
        actor.run(world, 0.3, {.crouch = true});
        EXPECT_EQ(actor.state.footing, Footing::ground) << degrees;
        actor.tick(world, {});
        EXPECT_EQ(actor.state.form, CharacterForm::standing) << degrees;
    }
}

TEST(MovementModes, ABodyForTheAirIsTakenInTheAirAndGivenBackOnTheGround) {
    const World world = Scene().floor(-20, 20, -5, 5).world();
    Actor actor;
    actor.settings.volume = Box{{0.4, 0.9, 0.4}};
    actor.settings.in_air = Volume(Ellipsoid{{0.4, 0.9, 0.4}});
    actor.state.position = {0, 1, 0};
    actor.run(world, 0.5);
    EXPECT_EQ(actor.state.form, CharacterForm::standing);
    actor.run(world, 0.2, {.jump = true});
    EXPECT_EQ(actor.state.form, CharacterForm::in_air);
    actor.run(world, 2);
    EXPECT_EQ(actor.state.form, CharacterForm::standing);
    EXPECT_TRUE(actor.on_ground());
}

TEST(MovementModes, AWallHoldsBackWhoPressesAgainstItAndIsJumpedOff) {
    const World world = Scene().floor(-20, 20, -5, 5).block({2, 0, -5}, {3, 30, 5}).world();
    Actor actor;
    actor.settings.wall_slide_speed = 2;
    actor.settings.wall_jump_speed = 6;
    actor.state.position = {1.5, 20, 0};
    actor.run(world, 1.5, {.wish = {3, 0, 0}});
    EXPECT_NEAR(actor.state.velocity.y, -2, 1e-9);
    actor.tick(world, {.wish = {3, 0, 0}, .jump = true});
    EXPECT_TRUE(actor.did(CharacterEvent::jumped));
    EXPECT_LT(actor.state.velocity.x, -5);
    EXPECT_GT(actor.state.velocity.y, 5);
}

TEST(MovementModes, ADashGoesAsFarAsItsSpeedAndTimeSayAndNotAgainBeforeItsPauseIsOver) {
    const World world = Scene().floor(-50, 50, -5, 5).world();
    for (const double rate : {30.0, 60.0, 240.0}) {
        Actor actor{.dt = 1 / rate};
        actor.settings.dash_speed = 20;
        actor.settings.braking = 1e6;
        actor.state.position = {0, 1, 0};
        actor.run(world, 0.5);
        actor.run(world, 0.2, {.wish = {0.001, 0, 0}, .dash = true});
        EXPECT_NEAR(actor.state.position.x, 4, 20 / rate + 0.01) << rate;
        actor.events = 0;
        actor.tick(world, {.wish = {1, 0, 0}});
        actor.tick(world, {.wish = {1, 0, 0}, .dash = true});
        EXPECT_FALSE(actor.did(CharacterEvent::dashed)) << "the pause";
        actor.run(world, 1);
        actor.tick(world, {.wish = {1, 0, 0}, .dash = true});
        EXPECT_TRUE(actor.did(CharacterEvent::dashed));
    }
}

TEST(MovementModes, ASwimmerGoesWhereItLikesSinksWithoutAWishAndMeetsTheFloor) {
    const World world = Scene().floor(-20, 20, -5, 5).world();
    Actor actor;
    actor.state.position = {0, 5, 0};
    actor.run(world, 2, {.wish = {1, 1, 0}, .mode = CharacterMode::swim});
    EXPECT_NEAR(actor.state.position.y, 7, 0.3);
    actor.run(world, 2, {.mode = CharacterMode::swim});
    EXPECT_NEAR(actor.state.velocity.y, -actor.settings.sink_speed, 1e-9);
    actor.run(world, 30, {.wish = {0, -2, 0}, .mode = CharacterMode::swim});
    EXPECT_NEAR(actor.state.position.y, 0.91, 0.005);
}

TEST(MovementModes, WhoFliesIsHeldByWallsAndByNothingElse) {
    const World world = Scene().floor(-20, 20, -5, 5).block({2, 0, -5}, {3, 30, 5}).world();
    Actor actor;
    actor.state.position = {0, 5, 0};
    actor.run(world, 2, {.mode = CharacterMode::fly});
    EXPECT_EQ(actor.state.position, dvec3(0, 5, 0));
    actor.run(world, 3, {.wish = {4, 1, 0}, .mode = CharacterMode::fly});
    EXPECT_LT(actor.state.position.x, 1.6);
    EXPECT_GT(actor.state.position.y, 7);
}

TEST(MovementModes, ALadderIsClimbedByPressingAgainstItAndLeftAtItsTop) {
    constexpr std::array<SurfaceRule, 2> rules{SurfaceRule{}, SurfaceRule{.ladder = true}};
    const World world = Scene()
                            .floor(-20, 20, -5, 5)
                            .block({2.01, 0, -5}, {16, 4, 5})
                            .made_of(1)
                            .quad({2, 0, 1}, {2, 0, -1}, {2, 4, -1}, {2, 4, 1})
                            .world();
    Actor actor;
    actor.settings.surfaces = SurfaceRules(rules);
    actor.state.position = {0, 1, 0};
    actor.run(world, 2, {.wish = {2, 0, 0}});
    EXPECT_TRUE(actor.did(CharacterEvent::climbing));
    EXPECT_GT(actor.state.position.y, 2);
    actor.run(world, 3, {.wish = {2, 0, 0}});
    EXPECT_TRUE(actor.on_ground());
    EXPECT_NEAR(actor.state.position.y, 4.91, 0.005);
    Actor down;
    down.settings.surfaces = SurfaceRules(rules);
    down.state.position = {1.58, 3, 0};
    down.run(world, 0.5, {.wish = {2, 0, 0}, .crouch = true});
    EXPECT_NEAR(down.state.velocity.y, -down.settings.ladder_speed, 1e-9);
}

TEST(MovementModes, AnyDirectionCanBeUp) {
    // A wall is a floor to whom +X is up.
    const World world = Scene().quad({0, -9, -9}, {0, 9, -9}, {0, 9, 9}, {0, -9, 9}).world();
    Actor actor;
    actor.state.position = {3, 0, 0};
    actor.run(world, 2, {.up = {5, 0, 0}});
    EXPECT_TRUE(actor.on_ground());
    EXPECT_NEAR(actor.state.position.x, 0.91, 0.005);
    actor.run(world, 1, {.wish = {0, 3, 0}, .up = {5, 0, 0}});
    EXPECT_NEAR(actor.state.position.y, 3, 0.1);
    EXPECT_NEAR(actor.state.position.x, 0.91, 0.005);
}

TEST(MovementModes, APlanetIsWalkedAround) {
    // A ball of 20 m made of flat faces; up is away from its middle, and changes at every step.
    Scene planet;
    const int rings = 48;
    const auto at = [&](int i, int k) {
        const double a = 3.141592653589793 * i / rings, b = 3.141592653589793 * k / rings;
        return dvec3{20 * std::sin(a) * std::cos(b), 20 * std::cos(a), 20 * std::sin(a) * std::sin(b)};
    };
    for (int i = 0; i < rings; ++i) {
        for (int k = 0; k < 2 * rings; ++k) {
            if (i > 0) planet.triangle(at(i, k), at(i, k + 1), at(i + 1, k));
            if (i + 1 < rings) planet.triangle(at(i, k + 1), at(i + 1, k + 1), at(i + 1, k));
        }
    }
    const World world = planet.world();
    Actor actor;
    actor.state.position = {0, 22, 0.3};
    double turned = 0;
    dvec3 before = actor.state.position;
    for (int tick = 0; tick < 60 * 35; ++tick) {
        const dvec3 p = actor.state.position;
        const double size = std::sqrt(p.x * p.x + p.y * p.y + p.z * p.z);
        const dvec3 up{p.x / size, p.y / size, p.z / size};
        // Along the meridian, in the plane of x and y.
        actor.tick(world, {.wish = {5 * up.y, -5 * up.x, 0}, .up = up});
        const dvec3 q = actor.state.position;
        turned += std::atan2(before.y * q.x - before.x * q.y, before.x * q.x + before.y * q.y);
        before = q;
        ASSERT_TRUE(tick < 60 || actor.on_ground()) << tick;
        ASSERT_LT(std::abs(std::sqrt(q.x * q.x + q.y * q.y + q.z * q.z) - 20.9), tick > 60 ? 0.1 : 3) << tick;
    }
    EXPECT_GT(turned, 6.5) << "once around, and more";
}

}  // namespace
}  // namespace surefoot::tests
