#include "game/whole_file.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>

namespace surefoot::game {

namespace fs = std::filesystem;

Expected<void> write_whole(const std::string& path, std::string_view bytes) {
    const auto fail = [&](const std::string& what) {
        return tl::unexpected(Error{ErrorCode::write_failed, path + ": it could not be written: " + what, path, 0});
    };
    std::error_code error;
    const fs::path folder = fs::path(path).parent_path();
    if (!folder.empty()) fs::create_directories(folder, error);
    if (error) return fail(error.message());
    // A name of its own, so that two programs that write at once do not write into one file.
    const std::string beside = path + "." + std::to_string(std::random_device{}());
    {
        std::ofstream file(beside, std::ios::binary);
        file.write(bytes.data(), std::streamsize(bytes.size()));
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

Expected<std::string> read_whole(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file)
        return tl::unexpected(
            Error{ErrorCode::not_found, path + ": there is no such file, or it may not be read", path, 0});
    return std::string{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

}  // namespace surefoot::game
