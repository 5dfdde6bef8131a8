#include "level.hpp"

#include <CLI/CLI.hpp>
#include <chrono>
#include <fmt/format.h>
#include <utility>

#include "command.hpp"
#include "kitchen.hpp"
#include "text.hpp"

namespace surefoot::tools {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

Level level_of(Mesh mesh, const std::string& file) {
    auto notes = level_notes(mesh);
    if (!notes) throw Failure{ExitCode::file, fmt::format("{}: {}", file, notes.error().text)};
    const ImportNotes import_notes = import_notes_of(mesh);
    return {.mesh = std::move(mesh),
            .file = file,
            .surface_names = std::move(notes->surface_names),
            .markers = std::move(notes->markers),
            .notes = import_notes};
}

Level open_level(const LevelOptions& options) {
    if (options.scale || !options.up.empty() || options.tolerance || !options.solids.empty()) {
        throw Failure{ExitCode::usage, fmt::format("{}: is cooked already; --scale, --up, --tolerance and --solids are "
                                                   "for cooking: give them to `surefoot cook`",
                                                   options.file)};
    }
    const Clock::time_point start = Clock::now();
    Expected<Mesh> mesh = Mesh::open(options.file);
    if (!mesh) throw Failure{ExitCode::file, with_near_file(mesh.error(), options.file)};
    const double seconds = seconds_since(start);
    Level level = level_of(std::move(*mesh), options.file);
    level.open_seconds = seconds;
    return level;
}

}  // namespace

void LevelOptions::add_to(CLI::App& command, const char* positional, bool required) {
    command
        .add_option(positional, file,
                    "The level: .surefoot, or .obj .gltf .glb .ply .stl .ac .blend .bsp .pk3 (FILE.pk3:MAP for one of "
                    "several)")
        ->type_name("")
        ->required(required);
    add_cooking_to(command);
    command.add_flag("--no-cache", no_cache, "Read and cook the level anew, and keep nothing of it for the next time");
}

void LevelOptions::add_cooking_to(CLI::App& command) {
    command.add_option("--scale", scale, "Metres for one unit of the file (default: 1; 1/32 for .bsp and .pk3)")
        ->type_name("METRES");
    command.add_option("--up", up, "Which axis of the file points up: x, y or z (default: what its format says)")
        ->check(CLI::IsMember({"x", "y", "z"}));
    command
        .add_option("--tolerance", tolerance,
                    "How near vertices are one, and triangles to curves [m] (default: only what is at one place is "
                    "one; curves 0.01)")
        ->type_name("METRES");
    command
        .add_option(
            "--solids", solids,
            "What stops a player in .bsp and .pk3: what is drawn, and clip brushes (drawn, the default); or all "
            "brushes, as in the game (brushes)")
        ->check(CLI::IsMember({"drawn", "brushes"}));
}

ImportOptions LevelOptions::import_options() const {
    ImportOptions import;
    import.scale = scale;
    if (!up.empty()) import.up = up == "x" ? UpAxis::x : up == "y" ? UpAxis::y : UpAxis::z;
    if (tolerance) import.tolerance = *tolerance;
    if (solids == "brushes") import.quake3 = Quake3Solids::brushes;
    return import;
}

std::string Level::how_long() const {
    if (open_seconds > 0) return fmt::format("opened in {}, cooked before", duration(open_seconds));
    return fmt::format("read in {}, cooked in {}", duration(import_seconds), duration(build_seconds));
}

Level load_level(const LevelOptions& options, const LoadProgress& progress) {
    const auto tell = [&](LoadStep step, double done) {
        if (progress) progress(step, done);
    };
    tell(LoadStep::opening, 0);
    if (is_cooked_name(options.file)) return open_level(options);
    const ImportOptions import = options.import_options();
    const auto made_from =
        options.no_cache ? std::nullopt : hash_of_sources({options.file}, import, options.welding_tolerance());
    if (made_from) {
        const Clock::time_point start = Clock::now();
        if (Expected<Mesh> mesh = open_cached(*made_from)) {
            const double seconds = seconds_since(start);
            Level level = level_of(std::move(*mesh), options.file);
            level.open_seconds = seconds;
            return level;
        }
    }
    tell(LoadStep::reading, 0);
    const Clock::time_point start = Clock::now();
    ImportedLevel imported = import_all({options.file}, import);
    const double import_seconds = seconds_since(start);
    const Clock::time_point cook_start = Clock::now();
    Cooked cooked = cook_imported(imported, options.welding_tolerance(), made_from.value_or(0),
                                  [&](double done) { tell(LoadStep::cooking, done); });
    const double build_seconds = seconds_since(cook_start);
    const std::vector<std::byte> notes = to_bytes(imported.notes);
    Section section = import_notes_section;
    section.bytes = notes;
    // Without a cache everything works; it only takes longer the next time.
    if (made_from) static_cast<void>(write_cached(cooked.mesh, std::span(&section, 1)));
    Level level = level_of(std::move(cooked.mesh), options.file);
    level.notes = imported.notes;
    level.import_seconds = import_seconds;
    level.build_seconds = build_seconds;
    return level;
}

std::string surface_name(const Level& level, std::uint32_t surface) {
    return surface < level.surface_names.size() ? level.surface_names[surface] : std::string();
}

std::string surface_text(const Level& level, std::uint32_t surface) {
    const std::string name = surface_name(level, surface);
    return name.empty() ? std::to_string(surface) : fmt::format("{} ({})", name, surface);
}

}  // namespace surefoot::tools
