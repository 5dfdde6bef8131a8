/// A level as the commands use it: the mesh, what its surfaces are called, and how long it took to read.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <surefoot/import.hpp>
#include <surefoot/mesh.hpp>

// NOLINTNEXTLINE(readability-identifier-naming): CLI11's own
namespace CLI {
class App;  // its header takes seconds to compile
}

namespace surefoot::tools {

/// LEVEL, --scale, --up and the options of maps, as every command that reads a level has them.
struct LevelOptions {
    std::string file;
    std::optional<double> scale;
    std::string up;
    std::optional<double> tolerance;
    std::string solids;
    bool no_cache = false;

    void add_to(CLI::App& command, const char* positional = "LEVEL", bool required = true);

    /// All but LEVEL and --no-cache.
    void add_cooking_to(CLI::App& command);

    [[nodiscard]] ImportOptions import_options() const;

    /// How far cooking may move vertices [m]: not at all by default.
    [[nodiscard]] double welding_tolerance() const { return tolerance.value_or(0); }
};

struct Level {
    Mesh mesh;
    std::string file;
    std::vector<std::string> surface_names;  ///< by surface number; may be shorter than the numbers go
    std::vector<ImportedMarker> markers;
    ImportNotes notes;
    double import_seconds = 0;  ///< reading the file [s]; 0 if it was cooked before
    double build_seconds = 0;   ///< cooking it [s]; 0 if it was cooked before
    double open_seconds = 0;    ///< opening the cooked file [s]; 0 if there was none yet

    /// "read in 36 ms, cooked in 20 ms", or how long opening took if it was cooked before.
    [[nodiscard]] std::string how_long() const;
};

/// What is being done with a level.
enum class LoadStep : std::uint8_t {
    reading,  ///< the file, by the importer; how much of it is read is not known
    cooking,
    opening,  ///< a file that was cooked before
};

/// Told of a step when it begins, and while it goes on of how much of it is done [0 to 1].
using LoadProgress = std::function<void(LoadStep step, double done)>;

/// Opens a cooked level. Reads and cooks any other, and keeps it in the user's cache for the next time.
/// Throws `Failure` with a sentence that names near file names when there is no such file.
[[nodiscard]] Level load_level(const LevelOptions& options, const LoadProgress& progress = {});

/// The name of a surface, empty if it has none.
[[nodiscard]] std::string surface_name(const Level& level, std::uint32_t surface);

/// "stone (2)", or just the number for a surface without a name.
[[nodiscard]] std::string surface_text(const Level& level, std::uint32_t surface);

}  // namespace surefoot::tools
