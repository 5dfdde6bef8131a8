// Settings come back as they were kept, and keys do what they are bound to.
#include <cmath>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "platformer/screens/controls.hpp"
#include "platformer/screens/game_settings.hpp"
#include "platformer/screens/settings_rows.hpp"

namespace surefoot::platformer {
namespace {

namespace fs = std::filesystem;
using view::Key;
using view::PadAxis;
using view::PadButton;

class GameSettingsFile : public testing::Test {
protected:
    void SetUp() override {
        folder_ = fs::path(testing::TempDir()) /
                  ("surefoot-game-" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
        fs::remove_all(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }
    [[nodiscard]] std::string path() const { return (folder_ / "surefoot" / "platformer.json").string(); }
    void put(const std::string& text) const {
        fs::create_directories(fs::path(path()).parent_path());
        std::ofstream(path()) << text;
    }

    fs::path folder_;
};

TEST_F(GameSettingsFile, comes_back_as_it_was_kept_with_nothing_beside_it) {
    GameSettings settings;
    settings.mouse_sensitivity = 0.7;
    settings.invert_y = true;
    settings.colours = ColourVision::blue_yellow;
    settings.ui_scale = 1.25;
    ASSERT_FALSE(settings.bindings.bind(Action::jump, 1, view::MouseButton::right));
    ASSERT_FALSE(settings.bindings.bind(Action::dash, 2, PadAxis::left_trigger));
    ASSERT_TRUE(write_game_settings(settings, path()));
    EXPECT_EQ(read_game_settings(path()).value(), settings);
    EXPECT_EQ(std::distance(fs::directory_iterator(fs::path(path()).parent_path()), {}), 1);
}

TEST_F(GameSettingsFile, that_is_not_there_is_the_defaults) {
    EXPECT_EQ(read_game_settings(path()).value(), GameSettings{});
    EXPECT_EQ(read_game_settings("").value(), GameSettings{});
}

TEST_F(GameSettingsFile, that_is_damaged_says_so_and_names_itself) {
    for (const char* text : {"", "{", "[1]", "nonsense"}) {
        put(text);
        const auto read = read_game_settings(path());
        ASSERT_FALSE(read) << text;
        EXPECT_NE(read.error().text.find(path()), std::string::npos);
        EXPECT_NE(read.error().text.find("damaged"), std::string::npos);
    }
}

TEST_F(GameSettingsFile, with_values_out_of_range_or_of_another_kind_has_the_defaults_for_those) {
    put(R"({"volume": 7, "music": "loud", "invert_y": 1, "colours": "plaid", "ui_scale": 1.5,
            "bindings": {"jump": ["key Escape", "", "pad a", ""]}})");
    GameSettings expected;
    expected.ui_scale = 1.5;
    EXPECT_EQ(read_game_settings(path()).value(), expected);
    put(R"({"volume": 7, "music": "loud", "invert_y": 1, "colours": 3, "ui_scale": 1.5, "bindings": {"jump": 4}})");
    EXPECT_EQ(read_game_settings(path()).value(), expected);
}

// Of a program that did not know how to look around by keys.
TEST_F(GameSettingsFile, of_an_older_program_keeps_its_keys_and_gets_those_that_are_new) {
    GameSettings settings;
    ASSERT_FALSE(settings.bindings.bind(Action::jump, 0, Key::e));
    ASSERT_TRUE(write_game_settings(settings, path()));
    std::ifstream file(path());
    nlohmann::json json = nlohmann::json::parse(file);
    for (const char* const word : {"look_left", "look_right", "look_up", "look_down"}) json["bindings"].erase(word);
    put(json.dump());
    const Bindings read = read_game_settings(path()).value().bindings;
    EXPECT_EQ(read[Action::jump][0], Trigger(Key::e)) << "the player's own";
    EXPECT_EQ(read[Action::look_left][0], Trigger(Key::q));
    EXPECT_FALSE(read[Action::look_right][0]) << "E is taken";
}

TEST_F(GameSettingsFile, that_cannot_be_written_says_why_and_leaves_the_old_one) {
    put("{\"volume\": 0.25}");
    const std::string below_a_file = path() + "/platformer.json";
    const auto kept = write_game_settings({}, below_a_file);
    ASSERT_FALSE(kept);
    EXPECT_EQ(kept.error().code, ErrorCode::write_failed);
    EXPECT_EQ(read_game_settings(path()).value().volume, 0.25);
}

TEST(SettingRows, stay_in_their_range_and_come_to_the_numbers_that_people_write) {
    GameSettings settings;
    for (const SettingRow& row : setting_rows()) {
        if (row.number == nullptr) continue;
        for (int i = 0; i < 200; ++i) adjust(row, settings, 1);
        EXPECT_EQ(settings.*row.number, row.high) << row.label;
        for (int i = 0; i < 200; ++i) adjust(row, settings, -1);
        EXPECT_EQ(settings.*row.number, row.low) << row.label;
        set_share(row, settings, NAN);
        EXPECT_GE(settings.*row.number, row.low) << row.label;
    }
}

TEST(Bindings, take_a_key_from_who_had_it_and_give_what_was_there_before) {
    Bindings all = Bindings::defaults();
    EXPECT_FALSE(all.bind(Action::jump, 0, Key::shift));
    EXPECT_EQ(all[Action::jump][0], Trigger(Key::shift));
    EXPECT_EQ(all[Action::dash][0], Trigger(Key::space));
    EXPECT_EQ(all.bind(Action::jump, 1, Key::space).value_or(""), "Dash would have nothing left");
    EXPECT_TRUE(all.bind(Action::jump, 0, Key::escape).has_value());
    EXPECT_TRUE(all.bind(Action::jump, 2, PadButton::start).has_value());
    EXPECT_TRUE(all.bind(Action::jump, 0, PadButton::y).has_value()) << "no gamepad among the keys";
    EXPECT_TRUE(all.is_complete());
}

TEST(Bindings, are_written_and_read_by_name) {
    for (const Trigger trigger : {Trigger(Key::page_up), Trigger(view::MouseButton::middle),
                                  Trigger(PadButton::left_bumper), Trigger(PadAxis::right_trigger), Trigger()})
        EXPECT_EQ(trigger_from(text_of(trigger)), trigger) << text_of(trigger);
    for (const char* text : {"", "key", "key Nonsense", "pad 7", "axis left_x", "mouse fourth"})
        EXPECT_FALSE(trigger_from(text)) << text;
}

TEST(Prompts, name_the_keys_of_the_device_in_hand) {
    const Bindings all = Bindings::defaults();
    EXPECT_EQ(prompt_parts("Press {jump} twice.", all, Device::keyboard),
              (std::vector<PromptPart>{{"Press ", false}, {"Space", true}, {" twice.", false}}));
    EXPECT_EQ(prompt_parts("{jump}", all, Device::gamepad), (std::vector<PromptPart>{{"A", true}}));
    EXPECT_EQ(prompt_parts("{move}", all, Device::keyboard).size(), 4U);
    EXPECT_EQ(prompt_parts("{camera}", all, Device::gamepad), (std::vector<PromptPart>{{"Right stick", true}}));
    for (const char* text : {"{", "}", "{}", "{nonsense}", "a { b } c", "{jump", "{camera", "{{move}"}) {
        std::string whole;
        bool key = false;
        for (const PromptPart& part : prompt_parts(text, all, Device::keyboard)) {
            whole += part.text;
            key = key || part.is_key;
        }
        if (!key) {
            EXPECT_EQ(whole, text);
        }
    }
}

TEST(Controls, run_jump_and_look_by_keys_mouse_and_gamepad) {
    const GameSettings settings;
    Controls controls;
    const auto event = [&](const view::InputEvent& e) { return controls.event(e, settings.bindings); };
    event(view::KeyPress{.key = Key::w});
    event(view::KeyPress{.key = Key::d});
    event(view::KeyPress{.key = Key::space});
    event(view::KeyPress{.key = Key::space, .down = false});
    event(view::PointerMove{.by = {100, 40}});
    Asked asked = controls.take(settings, 1.0 / 60);
    EXPECT_NEAR(asked.move.x, std::sqrt(0.5), 1e-9);
    EXPECT_NEAR(asked.move.y, std::sqrt(0.5), 1e-9);
    EXPECT_TRUE(asked.jump) << "a tap between two ticks is not lost";
    EXPECT_GT(asked.turn.x, 0);
    EXPECT_LT(asked.turn.y, 0);
    asked = controls.take(settings, 1.0 / 60);
    EXPECT_FALSE(asked.jump);
    EXPECT_EQ(asked.turn.x, 0);
    controls.release();
    EXPECT_EQ(controls.take(settings, 1.0 / 60).move.x, 0);
    event(view::GamepadAxis{PadAxis::left_y, -1});
    event(view::GamepadAxis{PadAxis::left_x, 0.1});
    event(view::GamepadAxis{PadAxis::right_trigger, 0.6});
    event(view::GamepadAxis{PadAxis::right_y, 1});
    asked = controls.take(settings, 1.0 / 60);
    EXPECT_NEAR(asked.move.y, 1, 0.01);
    EXPECT_TRUE(asked.dash);
    EXPECT_LT(asked.turn.y, 0);
    GameSettings inverted = settings;
    inverted.invert_y = true;
    EXPECT_GT(controls.take(inverted, 1.0 / 60).turn.y, 0);
}

TEST(Controls, of_two_keys_for_one_thing_the_one_that_is_let_go_leaves_the_other) {
    const GameSettings settings;
    Controls controls;
    for (const Key key : {Key::control, Key::c}) controls.event(view::KeyPress{.key = key}, settings.bindings);
    controls.event(view::KeyPress{.key = Key::c, .down = false}, settings.bindings);
    static_cast<void>(controls.take(settings, 0.02));
    EXPECT_TRUE(controls.take(settings, 0.02).crouch);
}

TEST(Controls, keys_turn_the_camera_to_where_they_say) {
    GameSettings settings;
    settings.invert_x = settings.invert_y = true;  // of mouse and stick: keys have names
    for (const auto& [key, x, y] :
         {std::tuple{Key::q, -1, 0}, {Key::e, 1, 0}, {Key::page_up, 0, 1}, {Key::page_down, 0, -1}}) {
        Controls controls;
        EXPECT_TRUE(controls.event(view::KeyPress{.key = key}, settings.bindings));
        const Asked asked = controls.take(settings, 0.02);
        EXPECT_NEAR(asked.turn.x, 0.04 * x, 1e-12);
        EXPECT_NEAR(asked.turn.y, 0.04 * y, 1e-12);
        EXPECT_EQ(controls.take(settings, 0.02).turn, asked.turn) << "as long as it is held";
    }
}

TEST(Controls, a_stick_at_rest_does_not_creep) {
    const GameSettings settings;
    Controls controls;
    controls.event(view::GamepadAxis{PadAxis::left_x, 0.12}, settings.bindings);
    controls.event(view::GamepadAxis{PadAxis::right_x, -0.12}, settings.bindings);
    const Asked asked = controls.take(settings, 0.02);
    EXPECT_EQ(asked.move.x, 0);
    EXPECT_EQ(asked.turn.x, 0);
}

}  // namespace
}  // namespace surefoot::platformer
