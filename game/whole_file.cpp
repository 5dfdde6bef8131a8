#include "game/whole_file.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <span>

#include <surefoot/whole_file.hpp>

namespace surefoot::game {

namespace fs = std::filesystem;

Expected<void> write_whole(const std::string& path, std::string_view bytes) {
    std::error_code error;
    const fs::path folder = fs::path(path).parent_path();
    if (!folder.empty()) fs::create_directories(folder, error);
    if (error)
        return tl::unexpected(
            Error{ErrorCode::write_failed, path + ": its folder could not be made: " + error.message(), path, 0});
    return write_whole_file(path, std::as_bytes(std::span(bytes)));
}

Expected<std::string> read_whole(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file)
        return tl::unexpected(
            Error{ErrorCode::not_found, path + ": there is no such file, or it may not be read", path, 0});
    return std::string{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

}  // namespace surefoot::game
