// A step that was saved is made again to the same bits, from the triangles in the file alone; and what is no such file
// says so.
#include <filesystem>
#include <unistd.h>

#include "capture_moments.hpp"
#include "movement_scene.hpp"

namespace surefoot::tests {
namespace {

/// Rough ground, stairs, walls, a lift, a turntable, a train and a belt.
struct Course {
    std::vector<SurfaceRule> rules{{.grip = 0.5, .conveyor = {0.5, 0, 0}}, {.grip = 0.1}};
    World world;
    Mesh ground, deck, wheel;

    Course() : ground(level()), deck(plate(1.5)), wheel(plate(2)) {
        EXPECT_TRUE(world.add(ground, {.body = 4}).has_value());
        const auto lift = world.add(deck, {.pose = {{4, 0.5, 0}, dquat(1, 0, 0, 0)}, .body = 17});
        const auto table = world.add(wheel, {.pose = {{-4, 0.2, 4}, dquat(1, 0, 0, 0)}, .body = 2});
        const auto ram =
            world.add(wheel, {.pose = {{0, 1, -4}, dquat(0.7071067811865476, 0, 0, 0.7071067811865476)}, .body = 30});
        EXPECT_TRUE(lift && table && ram);
        EXPECT_TRUE(world.move(*lift, {{4, 0.56, 0}, dquat(1, 0, 0, 0)}));
        EXPECT_TRUE(world.move(*table, {{-4, 0.2, 4}, dquat(0.999, 0, 0.04, 0)}));
        EXPECT_TRUE(world.move(*ram, {{0.1, 1, -4}, dquat(0.7071067811865476, 0, 0, 0.7071067811865476)}));
    }
    static Mesh level() {
        Scene scene;
        scene.floor(-10, 10, -10, 10, 0, 12).stairs(6, 3, 0.3, 0.4).block({-8, 0, -3}, {-7, 2, 3});
        return scene.quad({-9, 0, 6}, {9, 0, 6}, {9, 5, 8}, {-9, 5, 8}).mesh();
    }
    static Mesh plate(double half) { return Scene().block({-half, -0.2, -half}, {half, 0, half}).mesh(); }
};

/// Where a character may be in that course, and what it may want.
struct Any {
    CharacterSettings settings{};
    CharacterInput input{};
    CharacterState state{};
    double dt = 1.0 / 60;
};

Any any_step(SplitMix& random, const Course& course) {
    Any any;
    if (random.next() % 2 == 0) any.settings.volume = Capsule{0.4, 0.5};
    if (random.next() % 4 == 0) any.settings.volume = Box{{0.3, 0.9, 0.3}};
    if (random.next() % 5 == 0) any.settings.step_up = 0;
    if (random.next() % 3 == 0) any.settings.crouched = Sphere{0.4};
    if (random.next() % 3 == 0) any.settings.in_air = Ellipsoid{{0.4, 0.7, 0.4}};
    if (random.next() % 2 == 0) any.settings.ledge_reach = 0.3;
    any.settings.surfaces = SurfaceRules(course.rules);
    const double speeds[] = {5, 5, 20, 400};
    const double speed = speeds[random.next() % 4];
    any.input = {.wish = {random.in(-speed, speed), 0, random.in(-speed, speed)},
                 .jump = random.next() % 4 == 0,
                 .crouch = random.next() % 4 == 0};
    const double times[] = {1.0 / 60, 1.0 / 1000, 0.1, 0.35};
    any.dt = times[random.next() % 4];
    any.state.position = {random.in(-9, 9), random.in(0.5, 2.5), random.in(-9, 9)};
    any.state.velocity = {random.in(-speed, speed), random.in(-20, 10), random.in(-speed, speed)};
    for (std::uint64_t i = random.next() % 30; i > 0; --i) {
        any.state = step(course.world, any.settings, any.input, 1.0 / 60, any.state).state;
    }
    return any;
}

bool same_results(const StepCapture& capture, const StepResult& result) {
    return capture.after == result.state && capture.events.set == result.events.set &&
           capture.events.blocked_triangle == result.events.blocked_triangle;
}

TEST(CaptureStep, AnyStepOfACourseThatMovesIsReplayedToTheSameBitsThroughTheTextOfItsFile) {
    const Course course;
    SplitMix random(7);
    std::uint32_t events = 0;
    std::size_t most = 0;
    for (int i = 0; i < 1500; ++i) {
        const Any any = any_step(random, course);
        const StepResult result = step(course.world, any.settings, any.input, any.dt, any.state);
        const StepCapture capture = capture_step(course.world, any.settings, any.input, any.dt, any.state);
        ASSERT_TRUE(same_results(capture, result)) << i;
        const std::string text = capture_text(capture);
        ASSERT_EQ(saved_kind(text), SavedKind::step);
        const auto read = parse_step_capture(text);
        ASSERT_TRUE(read.has_value()) << read.error().text;
        ASSERT_EQ(capture_text(*read), text);
        const StepReplay again = replay(*read);
        ASSERT_TRUE(again.is_same()) << i << ": " << again.differs;
        ASSERT_EQ(explain_text(story_of(*read)), explain_text(story_of(capture)));
        events |= result.events.set;
        most = std::max(most, capture.triangles.size());
    }
    for (const CharacterEvent event :
         {CharacterEvent::landed, CharacterEvent::blocked, CharacterEvent::pushed, CharacterEvent::stepped_up,
          CharacterEvent::sub_stepped, CharacterEvent::recovered}) {
        EXPECT_NE(events & static_cast<std::uint32_t>(event), 0U)
            << "no step had " << static_cast<std::uint32_t>(event);
    }
    EXPECT_GT(most, 50U);
}

StepCapture a_stop() {
    const World world = Scene().floor(-5, 5, -5, 5).ramp(1, 3, 62).world();
    Actor actor;
    actor.state.position = {0, 1, 0};
    actor.run(world, 1.5, {.wish = {3, 0, 0}});
    StepCapture capture = capture_step(world, actor.settings, {.wish = {3, 0, 0}}, actor.dt, actor.state);
    capture.note = "a \"stop\"";
    return capture;
}

TEST(CaptureStep, AFileWhoseAnswerIsAnotherSaysWhatDiffersFirst) {
    StepCapture capture = a_stop();
    capture.after.position.x += 0x1p-50;
    EXPECT_EQ(replay(capture).differs.find("position, ("), 0U) << replay(capture).differs;
    capture = a_stop();
    capture.events.set ^= 1;
    EXPECT_EQ(replay(capture).differs.find("events: set, "), 0U) << replay(capture).differs;
    capture = a_stop();
    capture.records[2].value = 7;
    EXPECT_EQ(replay(capture).differs.find("record 2 of the story ("), 0U) << replay(capture).differs;
    capture = a_stop();
    capture.records.pop_back();
    EXPECT_EQ(replay(capture).differs.find("the length of the story, "), 0U) << replay(capture).differs;
    capture = a_stop();
    capture.triangles.clear();
    EXPECT_FALSE(replay(capture).is_same());
}

TEST(CaptureStep, ASettingThatIsChangedInTheFileIsSteppedWith) {
    StepCapture capture = a_stop();
    EXPECT_NE(explain_text(story_of(capture)).find("that face rises by 62 degrees, and the slope limit is 50"),
              std::string::npos);
    capture.settings.slope_limit_deg = 63;
    const StepReplay again = replay(capture);
    EXPECT_GT(again.result.state.position.x, capture.after.position.x);
}

TEST(CaptureStep, TheFileIsWrittenAndReadAndIsNoQuestion) {
    const std::string path = std::filesystem::temp_directory_path() / ("surefoot-step-" + std::to_string(getpid()));
    const StepCapture capture = a_stop();
    ASSERT_TRUE(write_capture(capture, path).has_value());
    const auto read = read_step_capture(path);
    ASSERT_TRUE(read.has_value());
    EXPECT_EQ(read->note, "a \"stop\"");
    EXPECT_EQ(capture_text(*read), capture_text(capture));
    const auto question = read_capture(path);
    ASSERT_FALSE(question.has_value());
    EXPECT_EQ(question.error().code, ErrorCode::unsupported);
    std::filesystem::remove(path);
    EXPECT_EQ(read_step_capture(path).error().code, ErrorCode::not_found);
}

TEST(CaptureStep, WhatIsCutOrChangedIsAnErrorWithItsByteOrAStepLikeAnyOther) {
    const std::string text = capture_text(a_stop());
    for (std::size_t size = 0; size + 1 < text.size(); size += 7) {
        const auto cut = parse_step_capture(text.substr(0, size), "f.json");
        if (size + 2 > text.size()) continue;
        ASSERT_FALSE(cut.has_value()) << size;
        ASSERT_LE(cut.error().byte, size);
        ASSERT_EQ(cut.error().text.find("f.json: no step: byte "), 0U);
    }
    SplitMix random(3);
    int read_anyway = 0;
    for (int i = 0; i < 3000; ++i) {
        std::string changed = text;
        changed[random.next() % changed.size()] = static_cast<char>(random.next());
        const auto read = parse_step_capture(changed);
        if (!read) continue;
        ++read_anyway;
        static_cast<void>(explain_text(story_of(*read)));
        if (read->dt <= 1 && read->settings.longest_tick > 0.01) static_cast<void>(replay(*read));
    }
    EXPECT_GT(read_anyway, 30);
}

TEST(CaptureStep, MembersThatAreMissingUnknownOrTwiceAreNamed) {
    const std::string text = capture_text(a_stop());
    const auto wrong = [&](const std::string& part, const std::string& instead) {
        std::string changed = text;
        const std::size_t place = changed.find(part);
        EXPECT_NE(place, std::string::npos) << part;
        changed.replace(place, part.size(), instead);
        const auto read = parse_step_capture(changed);
        return read ? std::string("read") : read.error().text;
    };
    EXPECT_NE(wrong("\"skin\"", "\"thin\"").find("means nothing here"), std::string::npos);
    EXPECT_NE(wrong("\"skin\": 0.01,", "").find("\"skin\" is missing"), std::string::npos);
    EXPECT_NE(wrong("\"skin\": 0.01,", "\"skin\": 0.01, \"skin\": 0.01,").find("is there twice"), std::string::npos);
    EXPECT_NE(wrong("\"slide\"", "\"glide\"").find("one of \"slide\", \"stop\" must be here"), std::string::npos);
    EXPECT_NE(wrong("\"jump_held\": 0", "\"jump_held\": 2").find("0 or 1 must be here"), std::string::npos);
    EXPECT_NE(wrong("\"surefoot_capture\": 2", "\"surefoot_capture\": 3").find("newer form"), std::string::npos);
    EXPECT_NE(wrong("\"body\": 0, \"start\"", "\"body\": 5, \"start\"").find("of a body that is not in the file"),
              std::string::npos);
}

TEST(CaptureStep, AStepThatCannotBeIsSavedAsWell) {
    const World world;
    CharacterState state;
    state.position.x = std::numeric_limits<double>::quiet_NaN();
    const StepCapture capture = capture_step(world, {}, {}, 1.0 / 60, state);
    EXPECT_TRUE(capture.events.has(CharacterEvent::invalid));
    const auto read = parse_step_capture(capture_text(capture));
    ASSERT_TRUE(read.has_value()) << read.error().text;
    EXPECT_TRUE(replay(*read).is_same()) << replay(*read).differs;
}

TEST(CaptureStep, BodiesThatMakeNoWorldLeaveTheStateAsItWas) {
    StepCapture capture = a_stop();
    capture.bodies[0].start.orientation = dquat(0, 0, 0, 0);
    const StepReplay again = replay(capture);
    EXPECT_EQ(again.result.state, capture.before);
    EXPECT_TRUE(again.result.events.has(CharacterEvent::invalid));
}

}  // namespace
}  // namespace surefoot::tests
