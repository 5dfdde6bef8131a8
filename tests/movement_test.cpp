#include "movement_scene.hpp"

namespace surefoot::tests {
namespace {

TEST(Movement, ACharacterThatFallsOnAFloorStandsOnItAndStays) {
    const World world = Scene().floor(-5, 5, -5, 5).world();
    Actor actor;
    actor.state.position = {0.3, 3, 0.2};
    actor.run(world, 2);
    EXPECT_TRUE(actor.on_ground());
    EXPECT_TRUE(actor.did(CharacterEvent::landed));
    EXPECT_NEAR(actor.state.position.y, 0.9 + actor.settings.skin, 0.3 * actor.settings.skin);
    const dvec3 before = actor.state.position;
    actor.run(world, 5);
    EXPECT_EQ(actor.state.position, before);
}

TEST(Movement, ACharacterAtRestHasTheSameHashForEver) {
    const World world = Scene().floor(-5, 5, -5, 5).world();
    Actor actor;
    actor.settings.dash_speed = 8;
    actor.settings.dash_pause = 12;  // longer than anything is remembered for by itself
    actor.state.position = {0.3, 3, 0.2};
    actor.run(world, 1, {.wish = {2, 0, 0}, .jump = true, .dash = true});
    actor.run(world, 11);
    const std::uint64_t still_counting = hash(actor.state);
    actor.run(world, 2);
    const CharacterState at_rest = actor.state;
    EXPECT_NE(hash(at_rest), still_counting) << "a dash is remembered for as long as its pause is";
    EXPECT_EQ(at_rest.since_dash, long_ago);
    for (int tick = 0; tick < 3000; ++tick) {
        actor.tick(world);
        ASSERT_EQ(hash(actor.state), hash(at_rest)) << tick;
    }
    EXPECT_EQ(actor.state, at_rest);
    actor.tick(world, {.jump = true});
    EXPECT_TRUE(actor.state.is_jumping);
}

TEST(Movement, AWindowIsClosedAfterItsTimeHoweverLongItIs) {
    const World world = Scene().world();
    for (const double pause : {0.3, 15.0, 1e9}) {
        Actor actor;
        actor.settings.dash_speed = 1;
        actor.settings.dash_time = 0.1;
        actor.settings.dash_pause = pause;
        actor.settings.gravity = 0;
        actor.dt = 0.1;
        const CharacterInput dash{.wish = {1, 0, 0}, .dash = true};
        actor.tick(world, dash);
        int ticks = 1;
        for (actor.events = 0; !actor.did(CharacterEvent::dashed) && ticks < 200; ticks += 2) {
            actor.tick(world);
            actor.tick(world, dash);
        }
        EXPECT_EQ(actor.did(CharacterEvent::dashed), pause < 1e9);
        EXPECT_NEAR(ticks * actor.dt, std::min(pause, 20.0) + 0.2, 0.35);
    }
}

TEST(Movement, WalkingOverAFloorOfAThousandSeamsKeepsItsHeightAndItsSpeed) {
    for (const Shape& shape : {Shape{Ellipsoid{}}, Shape{Sphere{}}, Shape{Capsule{}}, Shape{Box{}}, Shape{Cylinder{}},
                               Shape{Cone{.radius = 0.4, .height = 1.8}}}) {
        const World world = Scene().floor(-20, 20, -20, 20, 0, 60).world();
        Actor actor;
        actor.settings.volume = shape;
        actor.state.position = {-15, 1.5, -14.7};
        actor.run(world, 2);
        ASSERT_TRUE(actor.on_ground()) << shape.index();
        const double height = actor.state.position.y;
        const CharacterInput input{.wish = {4, 0, 3.3}};
        actor.run(world, 1, input);
        for (int i = 0; i < 240; ++i) {
            const dvec3 before = actor.state.position;
            actor.tick(world, input);
            ASSERT_TRUE(actor.on_ground());
            ASSERT_NEAR(actor.state.position.y, height, 0.1 * actor.settings.skin) << shape.index() << " tick " << i;
            ASSERT_NEAR(actor.state.position.x - before.x, 4.0 / 60, 4.0 / 60 * 1e-3) << shape.index() << " tick " << i;
            ASSERT_NEAR(actor.state.position.z - before.z, 3.3 / 60, 3.3 / 60 * 1e-3) << shape.index() << " tick " << i;
        }
    }
}

TEST(Movement, AWallOnAFloorIsSlidAlong) {
    const World world = Scene().floor(-20, 20, -20, 20, 0, 10).block({2, 0, -20}, {3, 4, 20}).world();
    Actor actor;
    actor.state.position = {0, 1, 0};
    actor.run(world, 3, {.wish = {3, 0, 1}});
    EXPECT_NEAR(actor.state.position.x, 2 - 0.4 - actor.settings.skin, 0.5 * actor.settings.skin);
    EXPECT_NEAR(actor.state.position.z, 3, 0.1);
    EXPECT_TRUE(actor.on_ground());
    EXPECT_TRUE(actor.did(CharacterEvent::blocked));
}

TEST(Movement, ACornerThatIsPressedIntoGivesNoMotionFromTheSecondTick) {
    for (double degrees = 10; degrees <= 170; degrees += 10) {
        const double half = degrees * 0.017453292519943295 / 2;
        const dvec3 left{-10 * std::cos(half), 0, -10 * std::sin(half)};
        const dvec3 right{-10 * std::cos(half), 0, 10 * std::sin(half)};
        const dvec3 up{0, 4, 0};
        const World world = Scene()
                                .floor(-20, 20, -20, 20, 0, 7)
                                .quad({0, 0, 0}, left, left + up, up)
                                .quad({0, 0, 0}, up, right + up, right)
                                .world();
        Actor actor;
        actor.state.position = {-8, 1, 0};
        actor.run(world, degrees < 170 ? 8 : 30, {.wish = {4, 0, 0.3}});
        const dvec3 before = actor.state.position;
        for (int i = 0; i < 30; ++i) actor.tick(world, {.wish = {4, 0, 0.3}});
        EXPECT_EQ(actor.state.position, before) << degrees;
        EXPECT_TRUE(actor.on_ground()) << degrees;
        EXPECT_LT(actor.state.position.x, 0) << degrees;
    }
}

TEST(Movement, SlopesUpToTheLimitAreWalkedUpAndSteeperOnesAreNot) {
    for (double degrees = 0; degrees < 90; degrees += 5) {
        const World world = Scene().floor(-20, 0, -10, 10).ramp(0, 3, degrees).world();
        Actor actor;
        actor.state.position = {-2, 1, 0};
        actor.run(world, 1.0, {.wish = {3, 0, 0}});
        actor.run(world, 0.5, {.wish = {3, 0, 0}});
        const double rise = actor.state.position.y - 0.9;
        if (degrees <= 49) {
            EXPECT_GT(actor.state.position.x, 1.5) << degrees;
            EXPECT_TRUE(actor.on_ground()) << degrees;
        } else if (degrees >= 55) {
            EXPECT_LT(actor.state.position.x, 0.1) << degrees;
            EXPECT_LT(rise, 0.1) << degrees;
        }
    }
}

TEST(Movement, WhoPressesAgainstASlopeThatIsTooSteepSlidesDownItAllTheSame) {
    const World world = Scene().floor(-20, 1, -10, 10).ramp(0, 6, 60).world();
    for (const double acceleration : {15.0, 60.0, 1000.0}) {
        Actor actor;
        actor.settings.air_acceleration = acceleration;
        actor.state.position = {1.5, 5, 0};
        actor.run(world, 12, {.wish = {6, 0, 0}});
        EXPECT_TRUE(actor.on_ground()) << acceleration;
        EXPECT_LT(actor.state.position.y, 1.1) << acceleration;
    }
}

TEST(Movement, StandingOnAWalkableSlopeDoesNotCreep) {
    const World world = Scene().floor(-20, 0, -10, 10).ramp(0, 10, 40).world();
    Actor actor;
    actor.state.position = {3, 5, 0};
    actor.run(world, 2);
    ASSERT_TRUE(actor.on_ground());
    const dvec3 before = actor.state.position;
    actor.run(world, 10);
    EXPECT_EQ(actor.state.position, before);
}

TEST(Movement, DroppedOnASlopeWhileWalkingUpItLandsAtTheTouch) {
    for (const double degrees : {10.0, 30.0, 45.0}) {
        const double steep = std::tan(degrees * 0.017453292519943295);
        const World world = Scene().ramp(0, 40, degrees).world();
        Actor actor;
        actor.state.position = {4, 4 * steep + 2.5, 0};
        // In the tick in which the slope is met it falls slower than it did, or not at all.
        double fell = 0;
        for (int i = 0; actor.state.velocity.y <= fell; ++i) {
            ASSERT_LT(i, 60) << degrees;
            fell = actor.state.velocity.y;
            actor.tick(world, {.wish = {6, 0, 0}});
        }
        EXPECT_TRUE(actor.did(CharacterEvent::landed)) << degrees;
        for (int i = 0; i < 60; ++i) {
            ASSERT_TRUE(actor.on_ground()) << degrees << " after " << i;
            actor.tick(world, {.wish = {6, 0, 0}});
        }
    }
}

TEST(Movement, AJumpUpASlopeLastsForAllOfItsRiseAndNoLonger) {
    // From about 35 degrees on, who runs up the slope meets it while the jump still rises.
    for (const double rate : {30.0, 60.0, 240.0}) {
        for (const double degrees : {10.0, 30.0, 40.0, 48.0}) {
            const World world = Scene().ramp(0, 60, degrees).world();
            const CharacterInput run{.wish = {6, 0, 0}};
            const CharacterInput jump{.wish = {6, 0, 0}, .jump = true};
            Actor actor;
            actor.dt = 1 / rate;
            actor.state.position = {4, 4 * std::tan(degrees * 0.017453292519943295) + 1.5, 0};
            actor.run(world, 1, run);
            ASSERT_TRUE(actor.on_ground()) << degrees << " at " << rate;
            const double rises = std::sqrt(2 * actor.settings.jump_height / actor.settings.gravity);
            const double level = 2 * rises;  // from take-off to where it would land on level ground
            double in_air = 0;
            do {
                actor.tick(world, jump);
                in_air += actor.dt;
            } while (!actor.on_ground() && in_air < 2 * level);
            EXPECT_GE(in_air, rises - actor.dt) << degrees << " at " << rate;
            EXPECT_LE(in_air, level + 2 * actor.dt) << degrees << " at " << rate;
        }
    }
}

TEST(Movement, StairsUpToTheStepHeightAreWalkedUpAtAnyFrameRate) {
    for (const double rate : {15.0, 30.0, 60.0, 144.0, 1000.0}) {
        for (const double rise : {0.1, 0.2, 0.3, 0.39, 0.45, 0.6}) {
            const World world = Scene().floor(-20, 20, -10, 10).stairs(0, 5, rise, 0.6).world();
            Actor actor;
            actor.dt = 1 / rate;
            actor.state.position = {-2, 1, 0};
            actor.run(world, 3, {.wish = {3, 0, 0}});
            if (rise < 0.4) {
                EXPECT_NEAR(actor.state.position.y, 0.91 + 5 * rise, 0.01) << rise << " at " << rate;
                EXPECT_GT(actor.state.position.x, 5) << rise << " at " << rate;
            } else {
                EXPECT_NEAR(actor.state.position.y, 0.91, 0.01) << rise << " at " << rate;
                EXPECT_LT(actor.state.position.x, 0) << rise << " at " << rate;
            }
        }
    }
}

TEST(Movement, WalkingDownStairsNeverLeavesTheGround) {
    const World world = Scene().floor(-20, 20, -10, 10).stairs(0, 8, 0.25, 0.3).world();
    Actor actor;
    actor.state.position = {4, 3.2, 0};
    actor.run(world, 1);
    ASSERT_TRUE(actor.on_ground());
    for (int i = 0; i < 180; ++i) {
        actor.tick(world, {.wish = {-3, 0, 0}});
        ASSERT_TRUE(actor.on_ground()) << i << " " << actor.state.position.x << " " << actor.state.position.y;
    }
    EXPECT_NEAR(actor.state.position.y, 0.91, 0.01);
}

TEST(Movement, AJumpRisesAsHighAsTheSettingsSayAtAnyFrameRate) {
    const World world = Scene().floor(-20, 20, -20, 20).world();
    for (const double rate : {15.0, 30.0, 60.0, 144.0, 1000.0}) {
        Actor actor;
        actor.dt = 1 / rate;
        actor.state.position = {0, 1, 0};
        actor.run(world, 1);
        const double ground = actor.state.position.y;
        double highest = 0;
        for (int i = 0; i < static_cast<int>(rate); ++i) {
            actor.tick(world, {.jump = true});
            highest = std::max(highest, actor.state.position.y - ground);
        }
        EXPECT_NEAR(highest, actor.settings.jump_height, 0.5 * 20 / (rate * rate) + 1e-9) << rate;
        EXPECT_TRUE(actor.on_ground());
    }
}

TEST(Movement, ABodyWedgedBetweenSteepThingsStandsAndCanJumpOut) {
    const Shape cone = Cone{.radius = 0.4, .height = 1.8};
    for (const Shape& shape : {Shape{Ellipsoid{}}, Shape{Sphere{}}, cone}) {
        // A funnel of four steep sides, and a shaft in which only the cone hangs by its rim.
        Scene funnel;
        funnel.quad({0, 0, 0}, {-2, 4, 2}, {2, 4, 2}, {0, 0, 0}).quad({0, 0, 0}, {2, 4, 2}, {2, 4, -2}, {0, 0, 0});
        funnel.quad({0, 0, 0}, {2, 4, -2}, {-2, 4, -2}, {0, 0, 0}).quad({0, 0, 0}, {-2, 4, -2}, {-2, 4, 2}, {0, 0, 0});
        const World world = funnel.world();
        Actor actor;
        actor.settings.volume = shape;
        actor.state.position = {0.1, 3, -0.2};
        actor.run(world, 3);
        EXPECT_TRUE(actor.on_ground()) << shape.index();
        const dvec3 before = actor.state.position;
        actor.run(world, 1);
        EXPECT_EQ(actor.state.position, before) << shape.index();
        actor.events = 0;
        actor.tick(world, {.jump = true});
        EXPECT_TRUE(actor.did(CharacterEvent::jumped)) << shape.index();
        EXPECT_GT(actor.state.position.y, before.y + 0.05) << shape.index();
    }
}

TEST(Movement, WhoBeginsInsideOfSomethingGetsOutAndSaysSo) {
    const World world =
        Scene().floor(-9, 9, -9, 9).block({0, -0.5, -5}, {1, 3, 5}).block({-6, 1.4, -3}, {-3, 3, 3}).world();
    // In a wall, in the floor, and between a floor and a ceiling that leave no room for it, where only sideways is out.
    for (const dvec3& place : {dvec3{-0.1, 1, 0}, dvec3{-2, 0.3, 0}, dvec3{-3.3, 0.7, 0}}) {
        Actor actor;
        actor.state.position = place;
        actor.run(world, 1);
        EXPECT_TRUE(actor.did(CharacterEvent::recovered)) << place.x;
        EXPECT_TRUE(fits(world, actor.settings, actor.state.position)) << place.x;
        EXPECT_TRUE(actor.on_ground()) << place.x;
        EXPECT_LT(actor.state.position.x, 0);
    }
}

TEST(Movement, WhoHasNoRoomAnywhereNearIsStuckAndStays) {
    const World world = Scene().block({-1, 0, -1}, {1, 1, 1}).world();
    Actor actor;
    actor.state.position = {0, 0.5, 0};
    const StepResult result = step(world, actor.settings, {}, 1.0 / 60, actor.state);
    EXPECT_TRUE(result.events.has(CharacterEvent::stuck));
    EXPECT_EQ(result.state.position, actor.state.position);
}

TEST(Movement, BadNumbersLeaveTheStateAsItWasAndSayInvalid) {
    const World world = Scene().floor(-5, 5, -5, 5).world();
    CharacterState state;
    state.position = {0, 1, 0};
    const double nan = std::nan("");
    for (const double dt : {0.0, -1.0, nan, 100.0, HUGE_VAL}) {
        const StepResult result = step(world, {}, {}, dt, state);
        EXPECT_EQ(result.state, state);
        EXPECT_TRUE(result.events.has(CharacterEvent::invalid)) << dt;
    }
    EXPECT_TRUE(step(world, {}, {.wish = {nan, 0, 0}}, 0.01, state).events.has(CharacterEvent::invalid));
    EXPECT_TRUE(step(world, {.skin = -1}, {}, 0.01, state).events.has(CharacterEvent::invalid));
    EXPECT_TRUE(step(world, {}, {}, 10, state).events.has(CharacterEvent::sub_stepped));
}

}  // namespace
}  // namespace surefoot::tests
