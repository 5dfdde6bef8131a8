// The table of a character's settings, and the clipboard.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include <surefoot/capture_step.hpp>

#include "playground/walk/settings_panel.hpp"
#include "playground/walk/settings_table.hpp"
#include "playground/walk/settings_text.hpp"

namespace surefoot::playground {
namespace {

std::set<std::string> names_of_rows() {
    std::set<std::string> names;
    for (const SettingGroup& group : setting_groups())
        for (const SettingRow& row : group.rows) EXPECT_TRUE(names.insert(row.name).second) << row.name;
    return names;
}

TEST(WalkSettings, every_field_that_a_capture_keeps_has_a_row) {
    const auto capture = nlohmann::json::parse(capture_text(StepCapture{}), nullptr, false);
    ASSERT_TRUE(capture.contains("step"));
    std::set<std::string> kept{"firmness"};  // decides nothing about the one who has it, so no capture keeps it
    for (const auto& field : capture["step"]["settings"].items()) kept.insert(field.key());
    kept.erase("surfaces");  // the level's
    EXPECT_EQ(names_of_rows(), kept);
}

TEST(WalkSettings, each_row_has_a_consequence_and_its_default_is_within_its_range) {
    const CharacterSettings defaults;
    for (const SettingGroup& group : setting_groups())
        for (const SettingRow& row : group.rows) {
            EXPECT_GT(std::string(row.says).size(), 10U) << row.name;
            if (const auto* const field = std::get_if<SettingRow::Member<double>>(&row.field)) {
                EXPECT_GE(defaults.**field, row.low) << row.name;
                EXPECT_LE(defaults.**field, row.high) << row.name;
            }
        }
}

TEST(WalkSettings, what_is_copied_is_pasted_with_every_field) {
    CharacterSettings settings = room_settings();
    settings.volume = Capsule{0.3, 0.55};
    settings.on_ramp = Cone{0.4, 1.7};
    settings.step_up = 0.123456789012345;
    settings.air_jumps = 2;
    settings.response = Response::stop;
    settings.keeps_ground_velocity = false;
    const auto pasted = parse_settings(settings_json(settings), {});
    ASSERT_TRUE(pasted) << pasted.error().text;
    for (const SettingGroup& group : setting_groups())
        for (const SettingRow& row : group.rows) EXPECT_TRUE(same_field(row, settings, *pasted)) << row.name;
    EXPECT_EQ(pasted->step_up, settings.step_up);
}

TEST(WalkSettings, a_paste_of_one_field_leaves_the_others_and_a_wrong_one_is_told) {
    const auto error_of = [](const char* text) {
        const auto pasted = parse_settings(text, {});
        return pasted ? std::string() : pasted.error().text;
    };
    const auto pasted = parse_settings(R"({"step_up": 0.7})", room_settings());
    ASSERT_TRUE(pasted);
    EXPECT_EQ(pasted->step_up, 0.7);
    EXPECT_EQ(pasted->vault_height, room_settings().vault_height);
    EXPECT_NE(error_of("no json").find("no settings"), std::string::npos);
    EXPECT_NE(error_of(R"({"step_op": 1})").find("\"step_op\""), std::string::npos);
    EXPECT_NE(error_of(R"({"step_up": "high"})").find("does not fit"), std::string::npos);
    EXPECT_NE(error_of(R"({"volume": ["Sphere", 1, 2]})").find("\"volume\""), std::string::npos);
    EXPECT_NE(error_of(R"({"response": "bounce"})").find("\"response\""), std::string::npos);
    EXPECT_NE(error_of(R"({"gravity": -1})").find("out of its range"), std::string::npos);
}

TEST(WalkSettings, as_cpp_it_is_what_differs_from_the_defaults) {
    EXPECT_EQ(settings_cpp({}), "const surefoot::CharacterSettings hero{};\n");
    CharacterSettings settings;
    settings.volume = Box{{0.3, 0.9, 0.2}};
    settings.crouched = Capsule{0.3, 0.2};
    settings.slope_speed = SlopeSpeed::along;
    settings.air_jumps = 1;
    EXPECT_EQ(settings_cpp(settings),
              "const surefoot::CharacterSettings hero{\n"
              "    .volume = surefoot::Box{{0.3, 0.9, 0.2}},\n"
              "    .crouched = surefoot::Capsule{0.3, 0.2},\n"
              "    .slope_speed = surefoot::SlopeSpeed::along,\n"
              "    .air_jumps = 1,\n"
              "};\n");
}

TEST(WalkSettings, another_shape_is_as_wide_and_as_high) {
    const Shape person = Ellipsoid{{0.4, 0.9, 0.4}};
    const auto capsule = std::get<Capsule>(as_large(person, 2));
    EXPECT_NEAR(capsule.radius + capsule.half_height, 0.9, 1e-15);
    EXPECT_EQ(std::get<Cone>(as_large(person, 5)).height, 1.8);
    EXPECT_EQ(std::get<Cylinder>(as_large(as_large(person, 3), 4)).half_height, 0.9);
    EXPECT_EQ(std::get<Ellipsoid>(as_large(as_large(person, 5), 1)).radii.y, 0.9);
}

}  // namespace
}  // namespace surefoot::playground
