/// A level as the commands use it: the mesh, what its surfaces are called, and how long it took to read.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include <surefoot/import.hpp>
#include <surefoot/mesh.hpp>

namespace surefoot::tools {

/// LEVEL, --scale, --up and the options of maps, as every command that reads a level has them.
struct LevelOptions {
    std::string file;
    std::optional<double> scale;
    std::string up;
    double tolerance = 0.01;
    std::string solids;

    void add_to(CLI::App& command, const char* positional = "LEVEL", bool required = true);
};

struct Level {
    Mesh mesh;
    std::string file;
    std::vector<std::string> surface_names;  ///< by surface number; may be shorter than the numbers go
    std::vector<ImportedMarker> markers;
    ImportNotes notes;
    double import_seconds = 0;  ///< reading the file [s]
    double build_seconds = 0;   ///< building the mesh and its tree [s]
};

/// Reads a level; throws `Failure` with a sentence that names near file names when there is no such file.
[[nodiscard]] Level load_level(const LevelOptions& options);

/// The name of a surface, empty if it has none.
[[nodiscard]] std::string surface_name(const Level& level, std::uint32_t surface);

/// "stone (2)", or just the number for a surface without a name.
[[nodiscard]] std::string surface_text(const Level& level, std::uint32_t surface);

}  // namespace surefoot::tools
