/// The table of what the options screen offers.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "platformer/screens/game_settings.hpp"
#include "platformer/screens/menu.hpp"

namespace surefoot::platformer {

struct SettingRow {
    std::string_view heading{};  ///< above it; empty for none
    std::string_view label{};
    std::string_view hint{};
    Entry::Kind kind = Entry::Kind::toggle;
    double GameSettings::*number = nullptr;  ///< of a slider
    bool GameSettings::*flag = nullptr;      ///< of a toggle
    double low = 0;
    double high = 1;
    double step = 0.05;
    enum class Unit : std::uint8_t { percent, degrees, times } unit = Unit::percent;
};

[[nodiscard]] std::span<const SettingRow> setting_rows();

/// The entry as it stands now.
[[nodiscard]] Entry entry_of(const SettingRow& row, const GameSettings& settings);

/// One step up or down; a toggle turns over, and a choice goes round.
void adjust(const SettingRow& row, GameSettings& settings, int direction);

/// To this share of a slider's way, by whole steps.
void set_share(const SettingRow& row, GameSettings& settings, double share);

}  // namespace surefoot::platformer
