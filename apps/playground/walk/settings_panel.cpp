#include "playground/walk/settings_panel.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <imgui.h>

#include "playground/walk/settings_table.hpp"
#include "playground/walk/settings_text.hpp"
#include "view/theme.hpp"
#include "view/widgets.hpp"

namespace surefoot::playground {
namespace {

namespace ui = view::ui;

std::string range_text(const SettingRow& row) {
    if (row.high <= row.low) return row.says;
    return fmt::format("{}\n{:g} to {:g} {}", row.says, row.low, row.high, row.unit);
}

bool volume_row(const SettingRow& row, Volume& volume) {
    int kind = static_cast<int>(volume.shape.index());
    bool changed = false;
    if (ui::choice(row.name, kind, shape_names())) {
        volume.shape = as_large(volume.shape, static_cast<std::size_t>(kind));
        changed = true;
    }
    ui::hint(row.says);
    std::array<ShapeSize, 3> room;
    std::array<double, 3> values{};
    std::size_t count = 0;
    ImGui::Indent(ImGui::GetFontSize());
    for (const ShapeSize& size : sizes_of(volume.shape, room)) {
        values[count] = size.value;
        // A straight part may be none at all; everything else has a size.
        const double low = volume.shape.index() == 2 && count == 1 ? 0 : row.low;
        changed = ui::slider(size.name, values[count], low, row.high, "%.2f m") || changed;
        ++count;
    }
    ImGui::Unindent(ImGui::GetFontSize());
    if (changed) volume.shape = shape_from(volume.shape.index(), std::span(values).first(count));
    return changed;
}

struct DrawRow {
    const SettingRow& row;
    CharacterSettings& settings;

    bool operator()(SettingRow::Member<double> field) const {
        const std::string format = std::string("%.4g ") + row.unit;
        const bool wide = row.low > 0 && row.high / row.low > 50;
        return ui::slider(row.name, settings.*field, row.low, row.high, format.c_str(), wide);
    }
    bool operator()(SettingRow::Member<bool> field) const { return ui::checkbox(row.name, settings.*field); }
    bool operator()(SettingRow::Member<std::uint32_t> field) const {
        double value = settings.*field;
        const bool changed = ui::slider(row.name, value, row.low, row.high, "%.0f");
        if (changed) settings.*field = static_cast<std::uint32_t>(std::clamp(value + 0.5, 0.0, 1000.0));
        return changed;
    }
    template <typename T>
    requires std::is_enum_v<T>
    bool operator()(SettingRow::Member<T> field) const {
        int value = static_cast<int>(settings.*field);
        const bool changed = ui::choice(row.name, value, words_of(settings.*field));
        settings.*field = static_cast<T>(value);
        return changed;
    }
    bool operator()(SettingRow::Member<Volume> field) const { return volume_row(row, settings.*field); }
    bool operator()(SettingRow::Member<std::optional<Volume>> field) const {
        std::optional<Volume>& volume = settings.*field;
        bool has = volume.has_value();
        bool changed = false;
        if (ui::checkbox(row.name, has)) {
            if (has) {
                volume = settings.volume;
            } else {
                volume.reset();
            }
            changed = true;
        }
        ui::hint(row.says);
        return volume && volume_row(row, *volume) ? true : changed;
    }
};

bool draw_row(const SettingRow& row, CharacterSettings& settings) {
    static const CharacterSettings defaults;
    const bool differs = !same_field(row, settings, defaults);
    ImGui::PushID(row.name);
    if (differs) ImGui::PushStyleColor(ImGuiCol_Text, view::to_imgui(view::rgb(0x8FD6CA)));
    bool changed = std::visit(DrawRow{row, settings}, row.field);
    if (differs) ImGui::PopStyleColor();
    ui::hint(range_text(row) + (differs ? "\nA right click takes the library's default." : ""));
    if (differs && ImGui::IsItemClicked(ImGuiMouseButton_Right)) {
        copy_field(row, defaults, settings);
        changed = true;
    }
    ImGui::PopID();
    return changed;
}

bool clipboard_row(CharacterSettings& settings, view::Display& display, view::Toasts& toasts) {
    bool changed = false;
    if (ui::button("Defaults")) {
        settings = {};
        changed = true;
    }
    ui::hint("What `CharacterSettings{}` says.");
    ImGui::SameLine();
    if (ui::button("This room's")) {
        settings = room_settings();
        changed = true;
    }
    ui::hint("The defaults, and it can also crouch, dash, hang on edges and vault.");
    if (ui::button("Copy")) {
        display.set_clipboard(settings_json(settings));
        toasts.say("The settings are in the clipboard, to be pasted here again.");
    }
    ImGui::SameLine();
    if (ui::button("Copy as C++")) {
        display.set_clipboard(settings_cpp(settings));
        toasts.say("What differs from the defaults is in the clipboard, as C++.");
    }
    ImGui::SameLine();
    if (ui::button("Paste")) {
        if (const auto pasted = parse_settings(display.clipboard(), settings)) {
            settings = *pasted;
            changed = true;
        } else {
            toasts.warn(pasted.error().text);
        }
    }
    return changed;
}

bool surface_rows(std::vector<SurfaceRule>& rules, const tools::Level& level) {
    bool changed = false;
    for (std::uint32_t i = 0; i < rules.size(); ++i) {
        const std::string name = tools::surface_name(level, i);
        if (name.empty()) continue;
        ImGui::PushID(static_cast<int>(i));
        changed = ui::slider(name.c_str(), rules[i].grip, 0, 1, "grip %.2f") || changed;
        ui::hint("The share of acceleration and braking that feet get on it.");
        ImGui::PopID();
    }
    return changed;
}

}  // namespace

CharacterSettings room_settings() {
    CharacterSettings settings;
    settings.crouched = Ellipsoid{{0.4, 0.5, 0.4}};
    settings.dash_speed = 12;
    settings.ledge_reach = 0.4;
    settings.vault_height = 1;
    return settings;
}

void settings_panel(Walker& walker, const tools::Level& level, view::Display& display, view::Toasts& toasts) {
    CharacterSettings settings = walker.settings();
    bool changed = clipboard_row(settings, display, toasts);
    for (const SettingGroup& group : setting_groups()) {
        if (!ui::section(group.title, false)) continue;
        for (const SettingRow& row : group.rows) changed = draw_row(row, settings) || changed;
    }
    if (changed) walker.change(settings);
    if (!is_valid(settings)) ui::key_colour(view::paint::start, "A number is out of its range: it stands still.");
    if (!walker.surfaces().empty() && ui::section("Grip of surfaces", false)) {
        std::vector<SurfaceRule> rules = walker.surfaces();
        if (surface_rows(rules, level)) walker.change(rules);
    }
}

}  // namespace surefoot::playground
