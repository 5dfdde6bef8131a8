#include "platformer/screens/game_settings.hpp"

#include <nlohmann/json.hpp>

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

/// Each as if the player had chosen it, so that a file can leave no action without a key either.
void take_bindings(const json& from, Bindings& bindings) {
    const auto found = from.find("bindings");
    if (found == from.end() || !found->is_object()) return;
    Bindings read;
    for (std::size_t i = 0; i < action_count; ++i) {
        const auto row = found->find(std::string(word_of(static_cast<Action>(i))));
        if (row == found->end() || !row->is_array() || row->size() != Bindings::places) return;
        for (std::size_t place = 0; place < Bindings::places; ++place) {
            const json& text = (*row)[place];
            const Trigger trigger = text.is_string() ? trigger_from(text.get<std::string>()) : Trigger();
            if (trigger && read.bind(static_cast<Action>(i), place, trigger)) return;
        }
    }
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
                   {"bindings", std::move(bindings)}};
    return view::write_kept(all, path, "the game's settings");
}

}  // namespace surefoot::platformer
