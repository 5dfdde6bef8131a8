#include "level.hpp"

#include <chrono>
#include <filesystem>
#include <fmt/format.h>
#include <system_error>

#include "command.hpp"
#include "parse.hpp"

namespace surefoot::tools {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// The file in the same folder whose name comes nearest, for people who mistype.
std::string near_file(const std::filesystem::path& file) {
    const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
    std::vector<std::string> names;
    constexpr std::size_t most_names = 10000;
    std::error_code error;
    for (std::filesystem::directory_iterator entry(folder, error), end;
         !error && entry != end && names.size() < most_names; entry.increment(error))
        names.push_back(entry->path().filename().string());
    std::sort(names.begin(), names.end());
    const std::string near = nearest_word(file.filename().string(), names);
    return near.empty() ? near : (file.parent_path() / near).string();
}

}  // namespace

void LevelOptions::add_to(CLI::App& command, const char* positional, bool required) {
    command
        .add_option(positional, file,
                    "The level: .obj .gltf .glb .ply .stl .ac .blend .bsp .pk3 (FILE.pk3:MAP for one of several)")
        ->type_name("")
        ->required(required);
    command.add_option("--scale", scale, "Metres for one unit of the file (default: 1; 1/32 for .bsp and .pk3)")
        ->type_name("METRES");
    command.add_option("--up", up, "Which axis of the file points up: x, y or z (default: what its format says)")
        ->check(CLI::IsMember({"x", "y", "z"}));
    command
        .add_option("--tolerance", tolerance, "How far triangles may lie from a curve [m] (default: 0.01; .bsp, .pk3)")
        ->type_name("METRES");
    command
        .add_option(
            "--solids", solids,
            "What stops a player in .bsp and .pk3: what is drawn, and clip brushes (drawn, the default); or all "
            "brushes, as in the game (brushes)")
        ->check(CLI::IsMember({"drawn", "brushes"}));
}

Level load_level(const LevelOptions& options) {
    ImportOptions import;
    import.scale = options.scale;
    if (!options.up.empty()) import.up = options.up == "x" ? UpAxis::x : options.up == "y" ? UpAxis::y : UpAxis::z;
    import.tolerance = options.tolerance;
    if (options.solids == "brushes") import.quake3 = Quake3Solids::brushes;
    const Clock::time_point start = Clock::now();
    Expected<ImportedLevel> imported = import_level(options.file, import);
    if (!imported) {
        std::string text = imported.error().text;
        std::error_code ignored;
        if (imported.error().code == ErrorCode::not_found &&
            !std::filesystem::exists(level_path(options.file).file, ignored))
            if (const std::string near = near_file(options.file); !near.empty())
                text += fmt::format("; did you mean '{}'?", near);
        throw Failure{ExitCode::file, text};
    }
    const double import_seconds = seconds_since(start);
    const Clock::time_point build_start = Clock::now();
    Expected<Mesh> mesh = build_mesh(*imported);
    if (!mesh) throw Failure{ExitCode::file, mesh.error().text};
    return {.mesh = std::move(*mesh),
            .file = options.file,
            .surface_names = std::move(imported->surface_names),
            .markers = std::move(imported->markers),
            .notes = imported->notes,
            .import_seconds = import_seconds,
            .build_seconds = seconds_since(build_start)};
}

std::string surface_name(const Level& level, std::uint32_t surface) {
    return surface < level.surface_names.size() ? level.surface_names[surface] : std::string();
}

std::string surface_text(const Level& level, std::uint32_t surface) {
    const std::string name = surface_name(level, surface);
    return name.empty() ? std::to_string(surface) : fmt::format("{} ({})", name, surface);
}

}  // namespace surefoot::tools
