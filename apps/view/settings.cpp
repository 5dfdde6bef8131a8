#include "view/settings.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <random>

namespace surefoot::view {
namespace {

namespace fs = std::filesystem;

Error failed(ErrorCode code, const std::string& path, const std::string& what) {
    return {code, path + ": " + what, path, 0};
}

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
    const auto from = [](const char* variable, const char* below) -> std::string {
        const char* const value = std::getenv(variable);
        if (value == nullptr || *value == '\0') return {};
        return (fs::path(value) / below / "surefoot" / "playground.json").string();
    };
    for (const auto& [variable, below] : {std::pair{"XDG_CONFIG_HOME", ""}, {"APPDATA", ""}, {"HOME", ".config"}})
        if (std::string path = from(variable, below); !path.empty()) return path;
    return {};
}

Expected<Settings> read_settings(const std::string& path) {
    std::error_code error;
    if (path.empty() || !fs::exists(path, error)) return Settings{};
    std::ifstream file(path, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    const nlohmann::json json = nlohmann::json::parse(text, nullptr, false);
    if (!file || !json.is_object())
        return tl::unexpected(failed(ErrorCode::unreadable, path,
                                     "the settings are damaged, so those of the beginning are used; the file is "
                                     "replaced when settings are next kept"));
    return from_json(json);
}

Expected<void> write_settings(const Settings& settings, const std::string& path) {
    const nlohmann::json json{{"version", settings.version}, {"full_screen", settings.full_screen},
                              {"width", settings.width},     {"height", settings.height},
                              {"preset", settings.preset},   {"field_of_view", settings.field_of_view},
                              {"recent", settings.recent}};
    const auto fail = [&](const std::string& what) {
        return tl::unexpected(failed(ErrorCode::write_failed, path, "the settings could not be kept: " + what));
    };
    std::error_code error;
    fs::create_directories(fs::path(path).parent_path(), error);
    if (error) return fail(error.message());
    // A name of its own, so that two programs that end at once do not write into one file.
    const std::string beside = path + "." + std::to_string(std::random_device{}());
    {
        std::ofstream file(beside, std::ios::binary);
        // Names of files need not be UTF-8; what is not is replaced rather than lost with all the rest.
        file << json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) << '\n';
        file.close();
        if (!file) {
            fs::remove(beside, error);
            return fail("is the disk full?");
        }
    }
    fs::rename(beside, path, error);
    if (error) {
        const std::string why = error.message();
        fs::remove(beside, error);
        return fail(why);
    }
    return {};
}

}  // namespace surefoot::view
