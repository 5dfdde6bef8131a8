/// Levels made in other programs: OBJ, glTF (.gltf, .glb), .ply, .stl, .ac, .blend and maps of Quake III (.bsp, .pk3)
/// become triangles, surfaces, parts and markers, ready for `Mesh::build`.
///
/// OBJ and maps of Quake III are read here, exactly. Everything else is read in a child process with limits on its time
/// and memory, so that a file that crashes, hangs or bloats the reader becomes an `Error` in your program and nothing
/// worse. The child is the helper program `surefoot-importer`, looked for in this order: `ImportOptions::importer`, the
/// environment variable SUREFOOT_IMPORTER, beside the running program, and where this library was installed.
/// docs/import.md tells what each format carries.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <surefoot/error.hpp>
#include <surefoot/math.hpp>
#include <surefoot/mesh.hpp>
#include <surefoot/notes.hpp>

namespace [[gnu::visibility("default")]] surefoot {
inline namespace v0 {

/// Which axis of the file points up. Whatever it is, the imported level has +Y up and stays right-handed.
enum class UpAxis : std::uint8_t {
    by_format,  ///< what the format says or, where it says nothing, what is usual: +Z for .stl, .ply, .blend and Quake
                ///< III, else +Y
    x,          ///< +X is up: (x, y, z) becomes (-y, x, z)
    y,          ///< +Y is up: nothing is turned
    z,          ///< +Z is up: (x, y, z) becomes (x, z, -y)
};

/// Which triangles of a Quake III map stand for what stops a player.
enum class Quake3Solids : std::uint8_t {
    drawn,    ///< what is seen and solid, curves to `ImportOptions::tolerance`, and the invisible player-clip brushes
    brushes,  ///< what the game asks: all sides of solid and player-clip brushes, and curves; no models made of
              ///< triangles
};

/// How to read a file. Every default is meant to be kept.
struct ImportOptions {
    /// Metres for one unit of the file [1e-9 to 1e9]: 0.01 for centimetres, 0.0254 for inches. Nothing: what is usual,
    /// 1, and 1/32 for maps of Quake III, whose players of 56 units are then 1.75 m tall.
    std::optional<double> scale{};

    /// `by_format` is right unless the file breaks its format's habit.
    UpAxis up = UpAxis::by_format;

    /// How far the triangles of a curved surface may lie from it [m, 1e-6 to 1e6]. Too large and columns have corners;
    /// too small and a level fails with `limit`. Only maps of Quake III have such surfaces.
    double tolerance = 0.01;

    Quake3Solids quake3 = Quake3Solids::drawn;  ///< maps of Quake III only

    /// How long reading may take [s, above 0, at most 86400]. Too small and a large level fails with `limit`.
    double time_limit = 120;

    /// How much memory reading may take [bytes, at least 16 MiB]. Too small and a large level fails with `limit`.
    std::uint64_t memory_limit = std::uint64_t{4} << 30;

    /// Path of the helper program; empty means that it is looked for as told above. Not used for OBJ and
    /// Quake III.
    std::string importer{};
};

using ImportedPart = Part;

/// Every node with glTF `extras` becomes a marker, and so does an empty node (no mesh, no children) without any.
/// `ImportOptions::scale` is not in the marker's own scale.
using ImportedMarker = Marker;

/// What reading a file left out or found odd. None of it is an error.
struct ImportNotes {
    std::uint64_t points_skipped = 0;        ///< points, and faces with one corner
    std::uint64_t lines_skipped = 0;         ///< lines, and faces with two corners
    std::uint64_t curves_skipped = 0;        ///< free-form curves and surfaces of an OBJ
    std::uint64_t polygons_split = 0;        ///< faces with four or more corners, cut into triangles
    std::uint64_t polygons_concave = 0;      ///< those among them whose ears had to be clipped
    std::uint64_t polygons_crossed = 0;      ///< those that cross themselves, cut as a fan for want of anything better
    std::uint64_t degenerate_triangles = 0;  ///< without area, as a double sees it; kept, with their ids
    std::uint64_t patches = 0;               ///< curved surfaces, cut into triangles
    std::uint64_t brushes = 0;               ///< brushes whose sides became triangles
    std::uint64_t brushes_empty = 0;         ///< brushes left out because there is no space within their planes
    std::uint64_t nonsolid_skipped = 0;      ///< surfaces left out because they stop no player: water, leaves, fog
};

/// A level as it was in the file: every face, in the order of the file.
struct ImportedLevel {
    std::string file;                     ///< where it came from
    std::vector<vec3> vertices;           ///< [m], finite, +Y up
    std::vector<std::uint32_t> indices;   ///< three a triangle, each below vertices.size()
    std::vector<std::uint32_t> surfaces;  ///< one a triangle, an index into surface_names
    std::vector<std::string>
        surface_names;  ///< materials by first use; [0] is "": triangles about which nothing is said
    std::vector<std::string> surface_extras;  ///< one a surface: the material's glTF extras as JSON text, or empty
    std::vector<ImportedPart> parts;
    std::vector<ImportedMarker> markers;
    ImportNotes notes;

    [[nodiscard]] std::size_t triangle_count() const noexcept { return indices.size() / 3; }

    /// For `Mesh::build`. Good as long as this level lives and does not change.
    [[nodiscard]] MeshInput mesh_input() const noexcept {
        return {.vertices = vertices, .indices = indices, .surfaces = surfaces};
    }
};

/// The file that holds a level, and the level's place within it if the file holds several.
struct LevelPath {
    std::string file;
    std::string inside;  ///< empty if `path` names a file and nothing in it
};

/// Takes "pak0.pk3:maps/q3dm1.bsp" apart. A path is whole if there is such a file, or if nothing in it ends in ".pk3:".
[[nodiscard]] LevelPath level_path(const std::string& path);

/// The maps in a .pk3, by name: each as "maps/q3dm1.bsp", to be named behind a colon for `import_level`. None if `file`
/// is of any other kind, or if there are none in it. Reads the list of files alone, within `options.time_limit`.
///
/// Fails with `not_found`; `unreadable` when it is no .pk3 or its list of files is damaged; `limit`; `invalid` for
/// options out of range.
[[nodiscard]] Expected<std::vector<std::string>> maps_in(const std::string& file, const ImportOptions& options = {});

/// Reads the level at `path` (UTF-8), in the format that the end of its name tells. Of a .pk3 with several maps, one is
/// named behind a colon: "pak0.pk3:maps/q3dm1.bsp", or just "pak0.pk3:q3dm1".
///
/// Guarantees: triangle ids are the order of the faces in the file; a face with n corners becomes n - 2 triangles in
/// a row; no vertex is merged, moved or dropped. Coordinates of an OBJ are the floats nearest to the decimals in the
/// file. Neighbouring curves of a Quake III map meet without cracks.
///
/// Fails with `not_found`, also for a .pk3 with several maps of which none is named, and then lists them; `unreadable`
/// when the file is damaged, or crashes its reader; `unsupported` for an unknown kind of file, or when the helper
/// program or Blender is needed and not there; `limit` beyond time_limit or memory_limit; `invalid` for options out of
/// range, a coordinate that is not finite, an index out of range, or no triangles at all. The text names the file, the
/// place in it, and what to do.
///
/// Threads: may be called from any number of threads at once.
[[nodiscard]] Expected<ImportedLevel> import_level(const std::string& path, const ImportOptions& options = {});

/// `Mesh::build` of an imported level; an error then names the file.
[[nodiscard]] Expected<Mesh> build_mesh(const ImportedLevel& level);

}  // namespace v0
}  // namespace surefoot
