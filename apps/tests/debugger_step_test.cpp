// "Why did I stop?" in the Debugger: saved steps that are opened, pasted, looked into and made again.
#include <cstdlib>
#include <cstring>

#include <surefoot/capture_step.hpp>

#include "debugger/saved_step.hpp"
#include "debugger_house.hpp"
#include "view/widgets.hpp"

namespace surefoot::playground {
namespace {

const std::string stopped = SUREFOOT_PICTURE_SCRIPTS "/stopped.json";

bool has(const std::string& label) {
    return view::ui::find_item(label).has_value();
}

bool same(const view::Picture& a, const view::Picture& b) {
    return std::memcmp(a.pixels.data(), b.pixels.data(), a.pixels.size() * sizeof(view::Colour)) == 0;
}

/// How many pixels around a place of the world look different.
std::size_t different(const view::Picture& a, const view::Picture& b, const view::dvec2& at) {
    constexpr int near = 14;
    std::size_t count = 0;
    for (int y = int(at.y) - near; y <= int(at.y) + near; ++y)
        for (int x = int(at.x) - near; x <= int(at.x) + near; ++x) {
            const view::Colour& p = a.at(x, y);
            const view::Colour& q = b.at(x, y);
            count += std::abs(p.r - q.r) + std::abs(p.g - q.g) + std::abs(p.b - q.b) > 24;
        }
    return count;
}

TEST(DebuggerStep, a_saved_step_that_is_dropped_opens_its_panel_with_the_body_before_and_its_triangles) {
    const auto saved = debugger::open_step(stopped);
    ASSERT_TRUE(saved) << saved.error().text;
    const DebuggerHouse house;
    house.play("drop " + stopped + "\nwait 90");
    EXPECT_NE(house.last_toast().find("same step of it, to the last bit"), std::string::npos) << house.last_toast();
    EXPECT_TRUE(has("Line")) << "the panel A step is open";
    house.expect_a_picture();
    const debugger::Question question = house.question();
    EXPECT_EQ(question.motion.from, saved->capture.before.position);
    EXPECT_EQ(question.triangles.size(), saved->capture.triangles.size());
    EXPECT_EQ(question.sizes.cylinder.radius, 0.35);
}

TEST(DebuggerStep, a_saved_step_on_the_command_line_and_in_the_clipboard_opens_as_well) {
    {
        const DebuggerHouse house(stopped);
        house.play("wait 10");
        EXPECT_TRUE(has("Line"));
    }
    const auto saved = read_step_capture(stopped);
    ASSERT_TRUE(saved);
    const DebuggerHouse house;
    EXPECT_FALSE(has("Line"));
    house.app->stage().display.set_clipboard(capture_text(*saved));
    house.play("key Control+V\nwait 10");
    EXPECT_TRUE(has("Line"));
    EXPECT_EQ(house.question().motion.from, saved->before.position);
    house.app->stage().display.set_clipboard("{\"step\":1}");
    house.play("key Control+V\nwait 2");
    EXPECT_NE(house.last_toast().find("clipboard"), std::string::npos) << "what is wrong is told";
}

TEST(DebuggerStep, of_other_bits_is_told) {
    auto wrong = read_step_capture(stopped);
    ASSERT_TRUE(wrong);
    wrong->after.velocity.z += 1;
    const std::string file = (std::filesystem::path(testing::TempDir()) / "debugger-other-step.json").string();
    ASSERT_TRUE(write_capture(*wrong, file));
    const DebuggerHouse house;
    house.play("drop " + file + "\nwait 3");
    EXPECT_NE(house.last_toast().find("differs first in velocity"), std::string::npos) << house.last_toast();
}

TEST(DebuggerStep, an_edited_setting_draws_the_step_made_again_beside_the_recorded_one) {
    const auto saved = debugger::open_step(stopped);
    ASSERT_TRUE(saved);
    const DebuggerHouse house({}, {1280, 720});
    house.play("drop " + stopped + "\nwait 90\nclick \"Why did it stop?\"\nclick \"Its story\"\nmove 500 700\nwait 5");
    const view::Picture before = house.app->picture();
    EXPECT_FALSE(has("As they were"));
    house.play("click \"Step up\"\nmove 500 700\nwait 5");  // in the middle of its slider: 0.75 m
    EXPECT_TRUE(has("As they were"));
    // Over the kerb the body's top is nearly half a metre higher, where nothing was before.
    const dvec3 top = saved->capture.after.position + dvec3(0, 0.9 + 0.4, 0);
    EXPECT_GT(different(before, house.app->picture(), house.on_picture(top)), 100U);
    house.play("click \"As they were\"\nmove 500 700\nwait 5");
    EXPECT_FALSE(has("As they were"));
    EXPECT_EQ(different(before, house.app->picture(), house.on_picture(top)), 0U);
}

TEST(DebuggerStep, every_line_of_the_story_is_a_picture) {
    const DebuggerHouse house;
    house.play("drop " + stopped + "\nwait 90\nclick \"Line\"\nwait 2");
    view::Picture last = house.app->picture();
    for (int i = 0; i < 3; ++i) {
        house.play("click \"Next line\"\nwait 3");
        house.expect_a_picture();
        EXPECT_FALSE(same(last, house.app->picture())) << i;
        last = house.app->picture();
    }
    for (int i = 0; i < 40; ++i) house.play("click \"Line before\"");
    house.expect_a_picture();
}

TEST(DebuggerStep, the_result_of_a_live_question_is_looked_into_and_copied_as_a_step) {
    const DebuggerHouse house;
    house.play("click \"A step\"\nwait 60");
    house.expect_a_picture();
    house.play("click \"Copy this step\"\nwait 2");
    const auto copied = parse_step_capture(house.app->stage().display.clipboard());
    ASSERT_TRUE(copied) << copied.error().text;
    EXPECT_TRUE(replay(*copied).is_same());
    EXPECT_EQ(copied->before.position, debugger::default_question(debugger::WorldKind::triangle).motion.from);
    EXPECT_EQ(copied->input.mode, CharacterMode::fly);
    // Pasted it is that step, and as soon as anything is changed it is a question again.
    house.play("key Control+V\nwait 5");
    EXPECT_NE(house.last_toast().find("to the last bit"), std::string::npos);
    house.play("key Escape\nwait 30\nclick \"One-sided\"\nwait 5");
    EXPECT_TRUE(house.question().one_sided);
    house.expect_a_picture();
}

TEST(DebuggerStep, on_a_level_has_its_story_too) {
    const DebuggerHouse house(SUREFOOT_LEVELS_DIR "/training-ground.glb");
    house.play("click \"A step\"\nwait 60");
    EXPECT_TRUE(has("Line"));
    house.expect_a_picture();
}

}  // namespace
}  // namespace surefoot::playground
