#include "platformer/screens/settings_rows.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

namespace surefoot::platformer {
namespace {

using Kind = Entry::Kind;
using Unit = SettingRow::Unit;

const std::array rows{
    SettingRow{.heading = "Camera",
               .label = "Mouse speed",
               .hint = "How far the camera turns when the mouse is pushed.",
               .kind = Kind::slider,
               .number = &GameSettings::mouse_sensitivity,
               .low = 0.1,
               .high = 4,
               .step = 0.1,
               .unit = Unit::times},
    SettingRow{.label = "Stick and key speed",
               .hint = "How fast the right stick and keys turn the camera.",
               .kind = Kind::slider,
               .number = &GameSettings::pad_sensitivity,
               .low = 0.1,
               .high = 4,
               .step = 0.1,
               .unit = Unit::times},
    SettingRow{.label = "Invert up and down", .hint = "Pushing forward looks down.", .flag = &GameSettings::invert_y},
    SettingRow{.label = "Invert left and right", .hint = "Pushing right looks left.", .flag = &GameSettings::invert_x},
    SettingRow{.label = "Field of view",
               .hint = "Of the picture's height. Wide shows more, and makes speed look faster.",
               .kind = Kind::slider,
               .number = &GameSettings::field_of_view,
               .low = 45,
               .high = 90,
               .step = 1,
               .unit = Unit::degrees},
    SettingRow{.heading = "Sound",
               .label = "Volume",
               .hint = "Of everything.",
               .kind = Kind::slider,
               .number = &GameSettings::volume},
    SettingRow{.label = "Music", .kind = Kind::slider, .number = &GameSettings::music},
    SettingRow{.label = "Effects", .kind = Kind::slider, .number = &GameSettings::effects},
    SettingRow{.heading = "Picture",
               .label = "Colours",
               .hint = "For eyes that tell some colours less well. Signs differ in shape too.",
               .kind = Kind::choice},
    SettingRow{
        .label = "Less motion", .hint = "Nothing pulses, shakes or flies in.", .flag = &GameSettings::reduced_motion},
    SettingRow{.label = "Size of letters and signs",
               .kind = Kind::slider,
               .number = &GameSettings::ui_scale,
               .low = 0.75,
               .high = 1.5,
               .step = 0.05,
               .unit = Unit::percent},
    SettingRow{.label = "Show the clock", .flag = &GameSettings::timer},
    SettingRow{.label = "Show the map", .flag = &GameSettings::minimap},
    SettingRow{.label = "Full screen", .flag = &GameSettings::full_screen},
};

std::string value_text(const SettingRow& row, const GameSettings& settings) {
    if (row.flag != nullptr) return settings.*row.flag ? "On" : "Off";
    if (row.number == nullptr) return std::string(label_of(settings.colours));
    const double value = settings.*row.number;
    switch (row.unit) {
        case Unit::percent:
            return fmt::format("{:.0f}%", value * 100);
        case Unit::degrees:
            return fmt::format("{:.0f}\u00B0", value);
        case Unit::times:
            return fmt::format("{:.1f}", value);
    }
    return {};
}

}  // namespace

std::span<const SettingRow> setting_rows() {
    return rows;
}

Entry entry_of(const SettingRow& row, const GameSettings& settings) {
    Entry entry{.kind = row.kind,
                .label = std::string(row.label),
                .value = value_text(row, settings),
                .hint = std::string(row.hint),
                .act = Act::set};
    if (row.flag != nullptr) entry.share = settings.*row.flag ? 1 : 0;
    if (row.number != nullptr) entry.share = (settings.*row.number - row.low) / (row.high - row.low);
    return entry;
}

void adjust(const SettingRow& row, GameSettings& settings, int direction) {
    if (row.flag != nullptr) {
        settings.*row.flag = !(settings.*row.flag);
    } else if (row.number != nullptr) {
        set_share(row, settings, (settings.*row.number + direction * row.step - row.low) / (row.high - row.low));
    } else {
        constexpr int all = static_cast<int>(ColourVision::count);
        settings.colours = static_cast<ColourVision>((static_cast<int>(settings.colours) + direction + all) % all);
    }
}

void set_share(const SettingRow& row, GameSettings& settings, double share) {
    if (row.number == nullptr) return;
    const double steps = std::round((row.high - row.low) / row.step);
    const double taken = std::round((share > 0 ? std::min(share, 1.0) : 0.0) * steps);
    // Divided last, so that 0.1 times 7 is the 0.7 that people write.
    settings.*row.number = std::clamp(row.low + (row.high - row.low) * taken / steps, row.low, row.high);
}

}  // namespace surefoot::platformer
