#include "playground/walk/fetcher.hpp"

#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <future>
#include <thread>
#include <utility>

namespace surefoot::playground {
namespace {

namespace fs = std::filesystem;

constexpr const char* package = "openarena-081-maps";

std::string cache_folder() {
    const auto below = [](const char* variable, const char* inside) {
        const char* const value = std::getenv(variable);
        return value == nullptr || *value == '\0' ? std::string() : (fs::path(value) / inside).string();
    };
    const std::string cache = below("XDG_CACHE_HOME", "surefoot/levels");
    return cache.empty() ? below("HOME", ".cache/surefoot/levels") : cache;
}

/// What a command wrote last on its error output; empty if it went well.
std::string run(const std::string& script) {
    std::string quoted = "'";
    for (const char c : script) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    FILE* const pipe = popen((quoted + "' openarena 2>&1 >/dev/null").c_str(), "r");
    if (pipe == nullptr) return "levels/fetch cannot be started";
    std::string last;
    std::array<char, 512> line{};
    while (std::fgets(line.data(), static_cast<int>(line.size()), pipe) != nullptr) last = line.data();
    while (!last.empty() && last.back() == '\n') last.pop_back();
    const int code = pclose(pipe);
    if (code == 0) return {};
    return last.empty() ? "levels/fetch did not succeed" : last;
}

/// What the fetch that runs will say; only the thread of the window asks.
std::future<std::string>& under_way() {
    static std::future<std::string> result;
    return result;
}

}  // namespace

std::string find_in_project(const std::string& path) {
    std::error_code error;
    for (fs::path folder = fs::current_path(error); !error; folder = folder.parent_path()) {
        if (fs::exists(folder / path, error)) return (folder / path).string();
        if (folder == folder.parent_path()) break;
    }
    return {};
}

Fetcher::Fetcher() : script_(find_in_project("levels/fetch")), cache_(cache_folder()) {}

std::optional<std::string> Fetcher::folder() const {
    std::error_code error;
    if (cache_.empty() || !fs::exists(fs::path(cache_) / package, error)) return std::nullopt;
    return (fs::path(cache_) / package / "usr/share/games/openarena/baseoa").string();
}

bool Fetcher::offers() const {
    return !script_.empty() && !cache_.empty() && !running() && !folder();
}

bool Fetcher::running() const {
    return under_way().valid();
}

void Fetcher::begin() {
    if (running()) return;
    // A thread that nobody waits for: the room may be left, and the window closed, while it runs.
    std::packaged_task<std::string()> task([script = script_] { return run(script); });
    under_way() = task.get_future();
    std::thread(std::move(task)).detach();
}

std::optional<std::string> Fetcher::update() {
    std::future<std::string>& result = under_way();
    if (!result.valid() || result.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return std::nullopt;
    const std::string wrong = result.get();
    return wrong.empty() ? std::string("OpenArena's maps are there: open one from its .pk3.") : wrong;
}

}  // namespace surefoot::playground
