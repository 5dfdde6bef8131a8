#include "view/settings.hpp"

#include <nlohmann/json.hpp>

#include "view/kept_file.hpp"

namespace surefoot::view {
namespace {

template <typename T>
void take(const nlohmann::json& json, const char* name, T& value) {
    const auto found = json.find(name);
    if (found == json.end()) return;
    if constexpr (std::is_same_v<T, bool>) {
        if (found->is_boolean()) value = found->get<bool>();
    } else if constexpr (std::is_arithmetic_v<T>) {
        if (found->is_number()) value = found->get<T>();
    } else if (found->is_string()) {
        value = found->get<std::string>();
    }
}

Settings from_json(const nlohmann::json& json) {
    const Settings defaults;
    Settings settings;
    take(json, "full_screen", settings.full_screen);
    take(json, "width", settings.width);
    take(json, "height", settings.height);
    take(json, "preset", settings.preset);
    take(json, "field_of_view", settings.field_of_view);
    if (settings.width < 320 || settings.width > 16384) settings.width = defaults.width;
    if (settings.height < 240 || settings.height > 16384) settings.height = defaults.height;
    if (!(settings.field_of_view >= 20 && settings.field_of_view <= 120))
        settings.field_of_view = defaults.field_of_view;
    if (settings.preset != "full" && settings.preset != "software") settings.preset.clear();
    const auto recent = json.find("recent");
    if (recent != json.end() && recent->is_array()) {
        for (const nlohmann::json& level : *recent)
            if (level.is_string() && settings.recent.size() < Settings::most_recent)
                settings.recent.push_back(level.get<std::string>());
    }
    return settings;
}

}  // namespace

void Settings::remember_level(const std::string& level) {
    std::erase(recent, level);
    recent.insert(recent.begin(), level);
    if (recent.size() > most_recent) recent.resize(most_recent);
}

std::string settings_path() {
    return kept_path("playground.json");
}

Expected<Settings> read_settings(const std::string& path) {
    return read_kept(path, "the settings").map(from_json);
}

Expected<void> write_settings(const Settings& settings, const std::string& path) {
    const nlohmann::json json{{"version", settings.version}, {"full_screen", settings.full_screen},
                              {"width", settings.width},     {"height", settings.height},
                              {"preset", settings.preset},   {"field_of_view", settings.field_of_view},
                              {"recent", settings.recent}};
    return write_kept(json, path, "the settings");
}

}  // namespace surefoot::view
