// Saved moments: what the Debugger writes and what it opens.
#include <fstream>

#include <surefoot/capture.hpp>
#include <surefoot/sweep.hpp>

#include "debugger_house.hpp"
#include "playground/debugger_room/saved_moment.hpp"

namespace surefoot::playground {
namespace {

std::string scratch(const std::string& name) {
    return (std::filesystem::path(testing::TempDir()) / name).string();
}

Capture some_capture() {
    const Triangle triangle{{0, 0, 0}, {0, 0, 4}, {4, 0, 4}};
    return capture_sweep(triangle, Sphere{0.25}, {{1, 2, 3}, {1, -2, 3}});
}

TEST(DebuggerMoment, a_capture_that_is_dropped_is_opened_with_its_question_and_has_the_same_bits) {
    const std::string file = scratch("debugger-dropped.json");
    ASSERT_TRUE(write_capture(some_capture(), file));
    const DebuggerHouse house;
    house.play("drop " + file + "\nwait 60");
    const auto question = house.question();
    EXPECT_EQ(question.shape, debugger::ShapeName::sphere);
    EXPECT_EQ(question.sizes.sphere.radius, 0.25);
    EXPECT_EQ(question.motion.from, dvec3(1, 2, 3));
    ASSERT_EQ(question.triangles.size(), 1U);
    EXPECT_EQ(question.triangles[0].c, dvec3(4, 0, 4));
    EXPECT_NE(house.last_toast().find("clipboard"), std::string::npos);  // from `question`; the verdict was before it
    house.expect_a_picture();
}

TEST(DebuggerMoment, an_answer_of_other_bits_is_told) {
    Capture wrong = some_capture();
    ASSERT_TRUE(wrong.answer);
    wrong.answer->t += 1e-9;
    const std::string file = scratch("debugger-wrong.json");
    ASSERT_TRUE(write_capture(wrong, file));
    const DebuggerHouse house;
    house.play("drop " + file + "\nwait 2");
    EXPECT_NE(house.last_toast().find("otherwise"), std::string::npos);
    EXPECT_NE(house.last_toast().find("t differ"), std::string::npos);
    ASSERT_TRUE(write_capture(some_capture(), file));
    house.play("drop " + file + "\nwait 2");
    EXPECT_NE(house.last_toast().find("same bits"), std::string::npos);
}

TEST(DebuggerMoment, a_file_that_is_no_capture_is_told_and_the_question_stays) {
    const std::string file = scratch("debugger-broken.json");
    std::ofstream(file) << "{}";
    const DebuggerHouse house;
    house.play("drop " + file + "\nwait 2");
    EXPECT_NE(house.last_toast().find("debugger-broken.json"), std::string::npos);
    EXPECT_TRUE(house.question() == debugger::default_question(debugger::WorldKind::triangle));
}

TEST(DebuggerMoment, is_saved_where_the_field_says_and_replays_to_the_same_bits) {
    const std::string file = scratch("debugger-saved.json");
    std::filesystem::remove(file);
    const DebuggerHouse house;
    house.play("click \"World\"\nclick \"Acute wedge\"\nwait 60");
    house.play("click \"Keep it\"\nwait 2\nclick \"File\"\ntext " + file +
               "\nwait 2\nclick \"Save this moment\"\nwait 2");
    EXPECT_NE(house.last_toast().find("debugger-saved.json"), std::string::npos);
    const auto saved = read_capture(file);
    ASSERT_TRUE(saved) << saved.error().text;
    EXPECT_EQ(saved->triangles.size(), 2U);
    ASSERT_TRUE(saved->answer);
    EXPECT_TRUE(replay(*saved).is_same());
}

TEST(DebuggerMoment, without_a_user_nothing_is_saved_unless_a_path_is_given) {
    const DebuggerHouse house;
    house.play("key Control+S\nwait 2");
    EXPECT_NE(house.last_toast().find("Say first"), std::string::npos);
}

TEST(DebuggerMoment, is_copied_as_a_test_in_cpp_and_why_is_told) {
    const DebuggerHouse house;
    house.play("click \"Keep it\"\nwait 2\nclick \"Copy as C++ test\"\nwait 2");
    EXPECT_NE(house.app->stage().display.clipboard().find("TEST("), std::string::npos);
    house.play("click \"Keep it\"\nclick \"Why\"\nwait 2");
    house.expect_a_picture();
}

TEST(DebuggerMoment, of_a_level_keeps_the_triangles_near_the_way) {
    const std::string file = scratch("debugger-level.json");
    std::filesystem::remove(file);
    const DebuggerHouse house(SUREFOOT_LEVELS_DIR "/training-ground.glb");
    house.play("click \"Keep it\"\nwait 2\nclick \"File\"\ntext " + file +
               "\nwait 2\nclick \"Save this moment\"\nwait 2");
    const auto saved = read_capture(file);
    ASSERT_TRUE(saved) << saved.error().text;
    EXPECT_TRUE(replay(*saved).is_same());
    house.play("drop " + file + "\nwait 60");
    EXPECT_EQ(house.question().triangles.size(), saved->triangles.size());
}

TEST(DebuggerMoment, of_a_moving_body_stands_where_the_question_begins) {
    Capture capture = some_capture();
    capture.triangles[0].body = 7;
    capture.bodies.push_back({.body = 7, .start = {.position = {0, 1, 0}}, .end = {.position = {0, 2, 0}}});
    const std::string file = scratch("debugger-body.json");
    ASSERT_TRUE(write_capture(capture, file));
    const auto moment = open_moment(file);
    ASSERT_TRUE(moment) << moment.error().text;
    EXPECT_EQ(moment->question.triangles[0].a, dvec3(0, 1, 0));
    EXPECT_NE(moment->remark, "");
}

}  // namespace
}  // namespace surefoot::playground
