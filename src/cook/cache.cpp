#include <charconv>
#include <string>
#include <utility>

#include <surefoot/cook.hpp>
#include <surefoot/version.hpp>

#include "file/format.hpp"
#include "platform/folders.hpp"

namespace surefoot {
inline namespace v0 {
namespace {

// A folder for each version: what another one cooked is cooked again instead of being looked at.
std::string cache_folder() {
    std::string folder = internal::cache_folder();
    if (folder.empty()) return folder;
    const Version version = library_version();
    return folder + "/cooked-" + std::to_string(version.major) + "." + std::to_string(version.minor) + "." +
           std::to_string(version.patch) + "-" + std::to_string(internal::format_version);
}

Error no_cache() {
    return {ErrorCode::not_found,
            "there is no folder for caches: set XDG_CACHE_HOME or HOME (on Windows, LOCALAPPDATA)",
            {},
            0};
}

}  // namespace

std::string cache_path(std::uint64_t made_from) {
    std::string folder = cache_folder();
    if (folder.empty()) return folder;
    char digits[16];
    const auto end = std::to_chars(digits, digits + sizeof digits, made_from, 16).ptr;
    const std::string number(digits, end);
    return folder + "/" + std::string(sizeof digits - number.size(), '0') + number + ".surefoot";
}

Expected<Mesh> open_cached(std::uint64_t made_from) {
    const std::string path = cache_path(made_from);
    if (path.empty()) return tl::unexpected(no_cache());
    auto mesh = Mesh::open(path);
    if (mesh && mesh->made_from() != made_from)
        return tl::unexpected(
            Error{ErrorCode::unreadable, path + ": was made from something else: remove it", path, 0});
    return mesh;
}

Expected<void> write_cached(const Mesh& mesh, std::span<const Section> extra) {
    const std::string path = cache_path(mesh.made_from());
    if (path.empty()) return tl::unexpected(no_cache());
    if (auto made = internal::make_folders(cache_folder()); !made) return made;
    return mesh.write(path, extra);
}

}  // namespace v0
}  // namespace surefoot
