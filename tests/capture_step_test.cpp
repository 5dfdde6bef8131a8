// A step that was saved is made again to the same bits, from the triangles in the file alone; and what is no such file
// says so.
#include <algorithm>
#include <array>
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
    std::vector<Neighbour> neighbours;
    double dt = 1.0 / 60;
};

/// Others around it, in it and far away, hard and soft, some of them carried.
std::vector<Neighbour> any_neighbours(SplitMix& random, const dvec3& around) {
    const Volume volumes[] = {Ellipsoid{{0.4, 0.9, 0.4}}, Capsule{0.4, 0.5}, Box{{0.3, 0.9, 0.3}}, Sphere{0.5}};
    std::vector<Neighbour> all(random.next() % 5);
    for (Neighbour& one : all) {
        one.volume = volumes[random.next() % 4];
        one.position = around + dvec3{random.in(-1.5, 1.5), random.in(-0.5, 0.5), random.in(-1.5, 1.5)};
        one.velocity = {random.in(-9, 9), random.in(-2, 2), random.in(-9, 9)};
        one.id = static_cast<std::uint32_t>(random.next());
        one.firmness = random.next() % 4 == 0 ? Firmness::soft : Firmness::hard;
        one.is_carried = random.next() % 2 == 0;
        one.carrier = random.next() % 2 == 0 ? 17 : 2;
    }
    return all;
}

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
    any.neighbours = any_neighbours(random, any.state.position);
    any.settings.flat_foot = random.next() % 2 == 0;
    if (any.settings.flat_foot) any.settings.on_ledge = Ellipsoid{{0.3, 0.9, 0.3}};
    any.settings.firmness = random.next() % 2 == 0 ? Firmness::soft : Firmness::hard;
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
        const StepResult result = step(course.world, any.settings, any.input, any.dt, any.state, any.neighbours);
        const StepCapture capture =
            capture_step(course.world, any.settings, any.input, any.dt, any.state, any.neighbours);
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
          CharacterEvent::sub_stepped, CharacterEvent::recovered, CharacterEvent::met_neighbour}) {
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
    EXPECT_NE(wrong("\"surefoot_capture\": 3", "\"surefoot_capture\": 4").find("newer form"), std::string::npos);
    EXPECT_NE(wrong("\"body\": 0, \"start\"", "\"body\": 5, \"start\"").find("of a body that is not in the file"),
              std::string::npos);
}

/// Someone walks into someone, and somebody else stands in them.
StepCapture a_meeting() {
    const World world = Scene().floor(-5, 5, -5, 5).world();
    Actor actor;
    actor.state.position = {0, 1, 0};
    actor.run(world, 1);
    const CharacterInput input{.wish = {4, 0, 0}};
    const std::vector<Neighbour> others{
        neighbour_of(actor.settings, {}, {.position = {0.85, 0.91, 0}}, 12),
        neighbour_of(actor.settings, {}, {.position = {0, 0.91, -0.7}}, 90),
    };
    return capture_step(world, actor.settings, input, 0.1, actor.state, others);
}

TEST(CaptureStep, NeighboursAreKeptAndDecideWhatIsReplayed) {
    StepCapture capture = a_meeting();
    EXPECT_TRUE(capture.events.has(CharacterEvent::met_neighbour));
    const std::string text = capture_text(capture);
    const auto read = parse_step_capture(text);
    ASSERT_TRUE(read.has_value()) << read.error().text;
    ASSERT_EQ(read->neighbours.size(), 2U);
    EXPECT_EQ(read->neighbours[1].id, 90U);
    EXPECT_TRUE(replay(*read).is_same()) << replay(*read).differs;
    for (std::size_t i = 0; i < 2; ++i) {
        StepCapture without = *read;
        without.neighbours.erase(without.neighbours.begin() + static_cast<std::ptrdiff_t>(i));
        EXPECT_FALSE(replay(without).is_same()) << i;
    }
}

TEST(CaptureStep, TheBodyThatCarriesANeighbourIsKeptHoweverFarItsTrianglesAre) {
    World world = Scene().floor(-5, 5, -5, 5).world();
    const Mesh wheel = Scene().block({60, -0.2, -1}, {62, 0, 1}).mesh();
    const auto handle = world.add(wheel, {.body = 7});
    ASSERT_TRUE(handle && world.move(*handle, {{-0.3, 0, 0}, dquat(1, 0, 0, 0)}));
    const CharacterSettings settings;
    const CharacterState state{.position = {0, 0.91, 0}};
    Neighbour other = neighbour_of(settings, {}, {.position = {1, 0.91, 0}}, 3);
    other.carrier = 7;
    other.is_carried = true;
    const StepCapture capture = capture_step(world, settings, {.wish = {4, 0, 0}}, 1.0 / 60, state, {&other, 1});
    EXPECT_NE(capture.after, step(world, settings, {.wish = {4, 0, 0}}, 1.0 / 60, state).state);
    const auto read = parse_step_capture(capture_text(capture));
    ASSERT_TRUE(read.has_value()) << read.error().text;
    EXPECT_TRUE(replay(*read).is_same()) << replay(*read).differs;
}

TEST(CaptureStep, EachOfACrowdOnALiftIsReplayedWithTheNeighboursThatTheCrowdLists) {
    Course course;
    std::vector<CharacterState> states(12);
    std::vector<CharacterInput> inputs(states.size());
    const CharacterSettings settings;
    for (std::size_t i = 0; i < states.size(); ++i) {
        states[i].position = {3.2 + 0.5 * static_cast<double>(i % 4), 1.41, 0.6 * static_cast<double>(i / 4) - 0.6};
        inputs[i].wish = {i % 2 == 0 ? 3.0 : -3.0, 0, i % 3 == 0 ? 2.0 : -1.0};
    }
    std::vector<CharacterState> after(states.size());
    const Characters all{.settings = {&settings, 1}, .inputs = inputs, .before = states, .after = after};
    Crowd crowd;
    ASSERT_TRUE(crowd.gather(all, 1.0 / 60));
    step_all(course.world, crowd, all, 1.0 / 60);
    std::size_t shoved = 0;
    for (std::size_t i = 0; i < states.size(); ++i) {
        std::array<Neighbour, most_met_in_crowd> room;
        const std::size_t count = crowd.neighbours(i, room);
        const StepCapture capture = capture_step(course.world, settings, inputs[i], 1.0 / 60, states[i],
                                                 std::span(room).first(std::min(count, room.size())));
        EXPECT_EQ(capture.after, after[i]) << i;
        EXPECT_TRUE(replay(*parse_step_capture(capture_text(capture))).is_same()) << i;
        const auto parted = [](const StepRecord& record) { return record.act == StepAct::parted; };
        if (std::any_of(capture.records.begin(), capture.records.end(), parted)) ++shoved;
    }
    EXPECT_GT(shoved, 6U);
}

/// The text as a build wrote it that knew no neighbours.
std::string second_form_of(std::string text) {
    const auto cut = [&](std::string_view from, std::string_view to) {
        const std::size_t begin = text.find(from);
        text.erase(begin, text.find(to, begin) - begin);
    };
    cut(",\n      \"firmness\"", "\n    },\n    \"input\"");
    cut(",\n    \"neighbours\"", "\n  },\n  \"after\"");
    text.replace(text.find("\"surefoot_capture\": 3"), 21, "\"surefoot_capture\": 2");
    return text;
}

TEST(CaptureStep, AFileOfTheSecondFormIsAStepWithoutNeighbours) {
    const std::string text = capture_text(a_stop());
    const auto read = parse_step_capture(second_form_of(text));
    ASSERT_TRUE(read.has_value()) << read.error().text;
    EXPECT_TRUE(read->neighbours.empty());
    EXPECT_TRUE(replay(*read).is_same()) << replay(*read).differs;
    EXPECT_EQ(capture_text(*read), text) << "it is written in the newest form";
}

TEST(CaptureStep, AFileOfTheThirdFormWithoutABodyForEdgesIsAStepWithoutOne) {
    const std::string newest = capture_text(a_meeting());
    std::string text = newest;
    const std::string field = ",\n      \"on_ledge\": null";
    ASSERT_NE(text.find(field), std::string::npos);
    text.erase(text.find(field), field.size());
    const auto read = parse_step_capture(text);
    ASSERT_TRUE(read.has_value()) << read.error().text;
    EXPECT_TRUE(replay(*read).is_same()) << replay(*read).differs;
    EXPECT_EQ(capture_text(*read), newest);
}

TEST(CaptureStep, WhatCameWithTheThirdFormIsInAllOfItsFilesAndInNoOlderOne) {
    const std::string newest = capture_text(a_meeting());
    const std::string second = second_form_of(newest);
    const auto with_form = [](std::string text, char form) {
        text[text.find("\"surefoot_capture\": ") + 20] = form;
        return parse_step_capture(text);
    };
    EXPECT_TRUE(with_form(newest, '3').has_value());
    EXPECT_TRUE(with_form(second, '2').has_value());
    ASSERT_FALSE(with_form(newest, '2').has_value());
    EXPECT_NE(with_form(newest, '2').error().text.find("means nothing in a file of this form"), std::string::npos);
    ASSERT_FALSE(with_form(second, '3').has_value());
    EXPECT_NE(with_form(second, '3').error().text.find("is missing"), std::string::npos);
    EXPECT_FALSE(with_form(newest, '1').has_value());
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
