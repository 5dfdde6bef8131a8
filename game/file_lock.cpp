#include "game/file_lock.hpp"

#include <chrono>
#include <filesystem>
#include <thread>

namespace surefoot::game {

namespace fs = std::filesystem;
using std::chrono::milliseconds;

// A folder is made or is there already, and of two who make it at once one is told so: on every system.
FileLock::FileLock(const std::string& path) : lock_(path + ".lock") {
    constexpr auto left_behind = milliseconds(3000);  // what is done under it takes a few milliseconds
    constexpr int tries = 400;
    std::error_code error;
    if (const fs::path folder = fs::path(path).parent_path(); !folder.empty()) fs::create_directories(folder, error);
    for (int i = 0; i < tries; ++i) {
        held_ = fs::create_directory(lock_, error);
        if (held_) return;
        // An error where whoever held it lets go just now says nothing; one without a lock in the way does.
        if (error && !fs::exists(lock_, error) && i > 3) return;
        const auto made = fs::last_write_time(lock_, error);
        if (!error && fs::file_time_type::clock::now() - made > left_behind) fs::remove(lock_, error);
        std::this_thread::sleep_for(milliseconds(10));
    }
}

FileLock::~FileLock() {
    std::error_code error;
    if (held_) std::filesystem::remove(lock_, error);
}

}  // namespace surefoot::game
