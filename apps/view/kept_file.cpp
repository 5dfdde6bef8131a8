#include "view/kept_file.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <span>
#include <utility>

#include <surefoot/whole_file.hpp>

namespace surefoot::view {
namespace {

namespace fs = std::filesystem;

Error failed(ErrorCode code, const std::string& path, const std::string& what) {
    return {code, path + ": " + what, path, 0};
}

}  // namespace

std::string kept_path(std::string_view name) {
    const auto from = [&](const char* variable, const char* below) -> std::string {
        const char* const value = std::getenv(variable);
        if (value == nullptr || *value == '\0') return {};
        return (fs::path(value) / below / "surefoot" / name).string();
    };
    for (const auto& [variable, below] : {std::pair{"XDG_CONFIG_HOME", ""}, {"APPDATA", ""}, {"HOME", ".config"}})
        if (std::string path = from(variable, below); !path.empty()) return path;
    return {};
}

Expected<nlohmann::json> read_kept(const std::string& path, std::string_view what) {
    std::error_code error;
    if (path.empty() || !fs::exists(path, error)) return nlohmann::json::object();
    std::ifstream file(path, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    nlohmann::json json = nlohmann::json::parse(text, nullptr, false);
    if (!file || !json.is_object())
        return tl::unexpected(failed(ErrorCode::unreadable, path,
                                     std::string(what) +
                                         " are damaged, so those of the beginning are used; the file is "
                                         "replaced when " +
                                         std::string(what) + " are next kept"));
    return json;
}

Expected<void> write_kept(const nlohmann::json& json, const std::string& path, std::string_view what) {
    const auto fail = [&](const std::string& why) {
        return tl::unexpected(failed(ErrorCode::write_failed, path, std::string(what) + " could not be kept: " + why));
    };
    std::error_code error;
    fs::create_directories(fs::path(path).parent_path(), error);
    if (error) return fail(error.message());
    // Names of files need not be UTF-8; what is not is replaced rather than lost with all the rest.
    const std::string text = json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
    if (const auto written = write_whole_file(path, std::as_bytes(std::span(text))); !written)
        return fail(written.error().text);
    return {};
}

}  // namespace surefoot::view
