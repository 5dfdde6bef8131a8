// The record of a step in words, and what a record may not do: change the step.
#include <bit>
#include <set>

#include "movement_scene.hpp"
#include "splitmix.hpp"

namespace surefoot::tests {
namespace {

/// Makes one step and tells why it went as it did.
std::string told(const World& world, Actor& actor, const CharacterInput& input = {},
                 std::span<const Neighbour> neighbours = {}) {
    std::vector<StepRecord> room(4096);
    StepTrace trace(room);
    StepStory story{actor.settings, input, actor.dt, actor.state, {}, {}, 0};
    story.result = step(world, actor.settings, input, actor.dt, actor.state, neighbours, &trace);
    story.records = trace.records();
    actor.state = story.result.state;
    return explain_text(story);
}

TEST(Why, WhoIsAskedForNothingStandsStillForThatReason) {
    const World world = Scene().floor(-5, 5, -5, 5).world();
    Actor actor;
    actor.state.position = {0, 1, 0};
    actor.run(world, 1);
    EXPECT_EQ(told(world, actor), "It stood still: nothing was asked of it, the wish is zero.\n");
}

TEST(Why, WhoWalksFreelyIsToldHowFar) {
    const World world = Scene().floor(-5, 5, -5, 5).world();
    Actor actor;
    actor.state.position = {0, 1, 0};
    actor.run(world, 1, {.wish = {3, 0, 0}});
    EXPECT_EQ(told(world, actor, {.wish = {3, 0, 0}}), "Nothing stopped it: it went 0.05 m.\n");
}

TEST(Why, EachSettingOutOfItsRangeIsNamed) {
    const World world = Scene().floor(-5, 5, -5, 5).world();
    Actor actor;
    actor.settings.slope_limit_deg = 95;
    actor.settings.skin = 2;
    EXPECT_EQ(told(world, actor),
              "Nothing was moved: the step was asked for what cannot be.\n"
              "skin, 2, is out of its range.\n"
              "slope_limit_deg, 95, is out of its range.\n");
    actor.settings = {};
    actor.dt = -1;
    EXPECT_EQ(told(world, actor),
              "Nothing was moved: the step was asked for what cannot be.\ndt, -1 s, is out of its range.\n");
    actor.dt = 1.0 / 60;
    actor.settings.volume = Sphere{-1};
    EXPECT_NE(told(world, actor).find("volume is out of its range."), std::string::npos);
}

TEST(Why, AJumpThatComesTooLateIsToldWithTheTimeAndTheLimit) {
    const World world = Scene().floor(-5, 5, -5, 5).world();
    Actor actor;
    actor.state.position = {0, 1, 0};
    actor.run(world, 1);
    actor.state.position.y = 4;  // the ground is gone
    actor.run(world, 0.2);
    const std::string late = told(world, actor, {.jump = true});
    EXPECT_NE(late.find("It did not jump: it is 0.2"), std::string::npos) << late;
    EXPECT_NE(late.find("coyote_time is 0.1."), std::string::npos) << late;
}

TEST(Why, ACornerNamesBothOfItsWalls) {
    const World world =
        Scene().floor(-20, 20, -20, 20).block({2, 0, -20}, {3, 4, 20}).block({-20, 0, 2}, {2, 4, 3}).world();
    Actor actor;
    actor.state.position = {1, 1, 1};
    actor.run(world, 2, {.wish = {3, 0, 3}});
    const std::string text = told(world, actor, {.wish = {3, 0, 3}});
    EXPECT_EQ(text.find("It stopped at triangle "), 0U) << text;
    EXPECT_NE(text.find("; and at triangle "), std::string::npos) << text;
}

TEST(Why, WhoSlidesAlongAWallIsToldWhatShareOfItsWayIsLeft) {
    const World world = Scene().floor(-20, 20, -20, 20).block({2, 0, -20}, {3, 4, 20}).world();
    Actor actor;
    actor.state.position = {1, 1, 0};
    actor.run(world, 1, {.wish = {3, 0, 3}});
    const std::string text = told(world, actor, {.wish = {3, 0, 3}});
    EXPECT_EQ(text.find("It got 50 % of the way that was wished, because of triangle "), 0U) << text;
    EXPECT_NE(text.find("that face stands upright"), std::string::npos) << text;
}

TEST(Why, WhoMayNotSlideIsToldThat) {
    const World world = Scene().floor(-20, 20, -20, 20).block({2, 0, -20}, {3, 4, 20}).world();
    Actor actor;
    actor.settings.response = Response::stop;
    actor.state.position = {1.4, 1, 0};
    actor.run(world, 0.3);
    std::string text;
    for (int i = 0; i < 30 && text.find("response") == std::string::npos; ++i) {
        text = told(world, actor, {.wish = {3, 0, 3}});
    }
    EXPECT_NE(text.find("response is stop"), std::string::npos) << text;
}

TEST(Why, ANeighbourInTheWayIsNamedAndWereItSoftItWouldNotBe) {
    const World world = Scene().floor(-5, 5, -5, 5).world();
    Actor actor;
    actor.state.position = {0, 1, 0};
    actor.run(world, 1);
    Neighbour other = neighbour_of(actor.settings, {}, {.position = {0.815, 0.91, 0}}, 12);
    const Actor before = actor;
    EXPECT_EQ(told(world, actor, {.wish = {4, 0, 0}}, {&other, 1}),
              "It got 7.5 % of the way that was wished, because of neighbour 12: it is hard, and in the way like a "
              "wall.\n");
    actor = before;
    other.firmness = Firmness::soft;
    EXPECT_EQ(told(world, actor, {.wish = {4, 0, 0}}, {&other, 1}), "Nothing stopped it: it went 0.008333 m.\n");
}

TEST(Why, WhoIsTooCloseToANeighbourIsToldByHowMuchAndToWhich) {
    const World world = Scene().floor(-5, 5, -5, 5).world();
    Actor actor;
    actor.state.position = {0, 1, 0};
    actor.run(world, 1);
    const Neighbour others[] = {neighbour_of(actor.settings, {}, {.position = {0.78, 0.91, 0}}, 3),
                                neighbour_of(actor.settings, {}, {.position = {0.7, 0.91, 0}}, 4)};
    EXPECT_EQ(told(world, actor, {}, others),
              "It was 0.105 m too close to neighbour 4, and was moved out by 0.055 m.\n");
    const World narrow = Scene().floor(-5, 5, -5, 5).block({-3, 0, -5}, {-0.41, 2, 5}).world();
    actor.state = {.position = {0, 1, 0}};
    actor.run(narrow, 1);
    EXPECT_EQ(told(narrow, actor, {}, others),
              "It was 0.105 m too close to neighbour 4, and there was no room to move out.\n");
}

TEST(Why, ATraceThatIsTooSmallSaysHowMuchIsMissing) {
    const World world = Scene().floor(-20, 20, -20, 20).block({2, 0, -20}, {3, 4, 20}).world();
    Actor actor;
    actor.state.position = {1.4, 1, 0};
    actor.run(world, 1);
    StepRecord room[2];
    StepTrace trace(room);
    StepStory story{actor.settings, {.wish = {3, 0, 0}}, actor.dt, actor.state, {}, {}, 0};
    story.result = step(world, actor.settings, story.input, actor.dt, actor.state, {}, &trace);
    story.records = trace.records();
    story.dropped = trace.dropped();
    EXPECT_GT(story.dropped, 0U);
    EXPECT_NE(explain_text(story).find("no room in the trace for " + std::to_string(story.dropped)), std::string::npos);
}

TEST(Why, ATraceChangesNoBitOfAnyStep) {
    SplitMix random(5);
    Scene scene;
    scene.floor(-10, 10, -10, 10, 0, 8).stairs(2, 4, 0.45, 0.5).block({-4, 0, -3}, {-3, 0.5, 3});
    scene.block({-6, 0, 2}, {6, 0.2, 4})
        .block({-9, 2, -9}, {-5, 3, -5})
        .quad({-9, 0, 9}, {9, 0, 9}, {9, 3, 10}, {-9, 3, 10});
    const World world = scene.world();
    std::vector<StepRecord> room(4096);
    for (int walk = 0; walk < 40; ++walk) {
        Actor plain;
        if (walk % 2 == 1) plain.settings.step_up = 0;
        plain.state.position = {random.in(-8, 8), 3, random.in(-8, 8)};
        Actor traced = plain;
        CharacterInput input;
        for (int i = 0; i < 200; ++i) {
            if (i % 20 == 0) input = {.wish = {random.in(-8, 8), 0, random.in(-8, 8)}, .jump = random.next() % 3 == 0};
            plain.tick(world, input);
            StepTrace trace(room);
            traced.state = step(world, traced.settings, input, traced.dt, traced.state, {}, &trace).state;
            ASSERT_EQ(plain.state, traced.state) << walk << " tick " << i;
        }
    }
}

TEST(Why, EqualStatesHashAlikeAndEveryFieldCounts) {
    CharacterState state;
    state.position = {1, 0, 3};
    CharacterState minus = state;
    minus.position.y = -0.0;
    EXPECT_EQ(state, minus);
    EXPECT_EQ(hash(state), hash(minus));
    std::set<std::uint64_t> hashes{hash(state)};
    const auto add = [&](const auto& change) {
        CharacterState other = state;
        change(other);
        EXPECT_NE(other, state);
        EXPECT_TRUE(hashes.insert(hash(other)).second) << hashes.size();
    };
    for (int i = 0; i < 3; ++i) {
        add([&](CharacterState& s) { s.position[i] += 0x1p-40; });
        add([&](CharacterState& s) { s.velocity[i] = 1; });
        add([&](CharacterState& s) { s.ground_normal[i] = 1; });
        add([&](CharacterState& s) { s.ground_velocity[i] = 1; });
        add([&](CharacterState& s) { s.wall_normal[i] = 1; });
        add([&](CharacterState& s) { s.ledge_point[i] = 1; });
    }
    add([](CharacterState& s) { s.since_ground = 2; });
    add([](CharacterState& s) { s.since_jump_press = 2; });
    add([](CharacterState& s) { s.since_wall = 2; });
    add([](CharacterState& s) { s.since_dash = 2; });
    add([](CharacterState& s) { s.since_hold = 2; });
    add([](CharacterState& s) { s.dash_held = 1; });
    add([](CharacterState& s) { s.form = CharacterForm::crouched; });
    add([](CharacterState& s) { s.hold = Hold::hanging; });
    add([](CharacterState& s) { s.ground_body = 1; });
    add([](CharacterState& s) { s.ground_triangle = 1; });
    add([](CharacterState& s) { s.ground_surface = 1; });
    add([](CharacterState& s) { s.air_jumps_left = 1; });
    add([](CharacterState& s) { s.footing = Footing::steep; });
    add([](CharacterState& s) { s.jump_held = 1; });
    add([](CharacterState& s) { s.is_jumping = 1; });
    EXPECT_EQ(hash(CharacterState{}), 3300509087508479879U) << "the same on every machine";
}

}  // namespace
}  // namespace surefoot::tests
