#include "programs.hpp"

#include <array>
#include <cstdlib>
#include <filesystem>

namespace surefoot::internal {
namespace {

namespace fs = std::filesystem;

constexpr const char* importer_name = SUREFOOT_IMPORTER_NAME;

bool is_program(const fs::path& path) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    constexpr fs::perms any_exec = fs::perms::owner_exec | fs::perms::group_exec | fs::perms::others_exec;
    return !error && fs::is_regular_file(status) && (status.permissions() & any_exec) != fs::perms::none;
}

std::string environment(const char* name) {
    const char* const value = std::getenv(name);
    return value != nullptr ? value : "";
}

Error missing(std::string text) {
    return {.code = ErrorCode::unsupported, .text = std::move(text), .file = {}};
}

}  // namespace

Expected<std::string> find_importer(const ImportOptions& options) {
    if (!options.importer.empty()) {
        if (is_program(options.importer)) return options.importer;
        return tl::unexpected(missing("the helper program " + options.importer +
                                      " (ImportOptions::importer) cannot be run; correct the path"));
    }
    if (const std::string named = environment("SUREFOOT_IMPORTER"); !named.empty()) {
        if (is_program(named)) return named;
        return tl::unexpected(
            missing("the helper program " + named + " (SUREFOOT_IMPORTER) cannot be run; correct the path"));
    }
    std::error_code error;
    const fs::path here = fs::read_symlink("/proc/self/exe", error).parent_path();
    // Beside the program; an installed tree that may have been moved; a build tree; where the library was installed.
    const std::array<fs::path, 4> places{here / importer_name, here / ".." / SUREFOOT_LIBEXEC_DIR / importer_name,
                                         here / ".." / "import" / importer_name,
                                         fs::path(SUREFOOT_FULL_LIBEXEC_DIR) / importer_name};
    std::string looked_at;
    for (const fs::path& place : places) {
        if (place.is_absolute() && is_program(place)) return place.string();
        looked_at += (looked_at.empty() ? "" : ", ") + place.lexically_normal().parent_path().string();
    }
    return tl::unexpected(missing("the helper program " + std::string(importer_name) + " was not found (looked in " +
                                  looked_at + "); put it beside your program, or set SUREFOOT_IMPORTER to its path"));
}

Expected<std::string> find_blender() {
    if (const std::string named = environment("SUREFOOT_BLENDER"); !named.empty()) {
        if (is_program(named)) return named;
        return tl::unexpected(
            missing("a .blend of Blender 2.80 or later is read by Blender itself, and " + named +
                    " (SUREFOOT_BLENDER) cannot be run; correct the path, or export the level as .glb"));
    }
    const std::string path = environment("PATH");
    for (std::size_t begin = 0; begin <= path.size();) {
        const std::size_t end = std::min(path.find(':', begin), path.size());
        const fs::path place = fs::path(path.substr(begin, end - begin)) / "blender";
        if (place.is_absolute() && is_program(place)) return place.string();
        begin = end + 1;
    }
    return tl::unexpected(missing(
        "a .blend of Blender 2.80 or later, or a packed one, is read by Blender itself, which is not installed; "
        "install it "
        "(Debian: apt install blender python3-numpy), set SUREFOOT_BLENDER to its path, or export the level as .glb"));
}

}  // namespace surefoot::internal
