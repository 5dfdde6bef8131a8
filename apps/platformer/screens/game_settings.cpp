#include "platformer/screens/game_settings.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <vector>

#include "view/kept_file.hpp"

namespace surefoot::platformer {
namespace {

using nlohmann::json;

void take(const json& from, const char* name, bool& value) {
    const auto found = from.find(name);
    if (found != from.end() && found->is_boolean()) value = found->get<bool>();
}

void take(const json& from, const char* name, double& value, double low, double high) {
    const auto found = from.find(name);
    if (found == from.end() || !found->is_number()) return;
    const auto read = found->get<double>();
    if (read >= low && read <= high) value = read;
}

void take(const json& from, const char* name, int& value, int low, int high) {
    double number = value;
    take(from, name, number, low, high);
    value = static_cast<int>(number);
}

/// Each as if the player had chosen it, so that a file can leave no action without a key either.
void take_bindings(const json& from, Bindings& bindings) {
    const auto found = from.find("bindings");
    if (found == from.end() || !found->is_object()) return;
    Bindings read;
    std::vector<std::size_t> unknown;  // to the program that wrote them
    for (std::size_t i = 0; i < action_count; ++i) {
        const auto row = found->find(std::string(word_of(static_cast<Action>(i))));
        if (row == found->end()) {
            unknown.push_back(i);
            continue;
        }
        if (!row->is_array() || row->size() != Bindings::places) return;
        for (std::size_t place = 0; place < Bindings::places; ++place) {
            const json& text = (*row)[place];
            const Trigger trigger = text.is_string() ? trigger_from(text.get<std::string>()) : Trigger();
            if (trigger && read.bind(static_cast<Action>(i), place, trigger)) return;
        }
    }
    const auto is_taken = [&](const Trigger& trigger) {
        for (const Bindings::Row& row : read.rows)
            if (std::ranges::find(row, trigger) != row.end()) return true;
        return false;
    };
    const Bindings usual = Bindings::defaults();
    for (const std::size_t i : unknown)
        for (std::size_t place = 0; place < Bindings::places; ++place)
            if (!is_taken(usual.rows[i][place])) read.rows[i][place] = usual.rows[i][place];
    if (read.is_complete()) bindings = read;
}

GameSettings from_json(const json& from) {
    GameSettings s;
    take(from, "mouse_sensitivity", s.mouse_sensitivity, 0.1, 4);
    take(from, "pad_sensitivity", s.pad_sensitivity, 0.1, 4);
    take(from, "invert_x", s.invert_x);
    take(from, "invert_y", s.invert_y);
    take(from, "field_of_view", s.field_of_view, 45, 90);
    take(from, "volume", s.volume, 0, 1);
    take(from, "music", s.music, 0, 1);
    take(from, "effects", s.effects, 0, 1);
    take(from, "reduced_motion", s.reduced_motion);
    take(from, "ui_scale", s.ui_scale, 0.75, 1.5);
    take(from, "timer", s.timer);
    take(from, "minimap", s.minimap);
    take(from, "full_screen", s.full_screen);
    take(from, "width", s.width, 320, 16384);
    take(from, "height", s.height, 240, 16384);
    const auto colours = from.find("colours");
    if (colours != from.end() && colours->is_string()) s.colours = colour_vision_named(colours->get<std::string>());
    take_bindings(from, s.bindings);
    return s;
}

}  // namespace

std::string game_settings_path() {
    return view::kept_path("platformer.json");
}

Expected<GameSettings> read_game_settings(const std::string& path) {
    return view::read_kept(path, "the game's settings").map(from_json);
}

Expected<void> write_game_settings(const GameSettings& s, const std::string& path) {
    json bindings = json::object();
    for (std::size_t i = 0; i < action_count; ++i) {
        json row = json::array();
        for (const Trigger& trigger : s.bindings.rows[i]) row.push_back(text_of(trigger));
        bindings[std::string(word_of(static_cast<Action>(i)))] = std::move(row);
    }
    const json all{{"version", 1},
                   {"mouse_sensitivity", s.mouse_sensitivity},
                   {"pad_sensitivity", s.pad_sensitivity},
                   {"invert_x", s.invert_x},
                   {"invert_y", s.invert_y},
                   {"field_of_view", s.field_of_view},
                   {"volume", s.volume},
                   {"music", s.music},
                   {"effects", s.effects},
                   {"colours", std::string(word_of(s.colours))},
                   {"reduced_motion", s.reduced_motion},
                   {"ui_scale", s.ui_scale},
                   {"timer", s.timer},
                   {"minimap", s.minimap},
                   {"full_screen", s.full_screen},
                   {"width", s.width},
                   {"height", s.height},
                   {"bindings", std::move(bindings)}};
    return view::write_kept(all, path, "the game's settings");
}

}  // namespace surefoot::platformer
