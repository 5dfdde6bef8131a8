/// Cooking: from triangles, as they come out of a modelling program, to a mesh that is written once and mapped ever
/// after.
///
/// Cooking keeps every triangle and its id. Vertices at one place become one; a level too large for floats is cut into
/// tiles; edges get their kinds; and what is odd about the triangles is reported with its places instead of being
/// mended in silence. docs/cooking.md tells more.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include <surefoot/error.hpp>
#include <surefoot/math.hpp>
#include <surefoot/mesh.hpp>
#include <surefoot/notes.hpp>

namespace [[gnu::visibility("default")]] surefoot {
inline namespace v0 {

/// What is cooked. The spans are read during `cook` only.
struct CookInput {
    std::span<const dvec3> vertices;            ///< [m, finite, each within +-1e9]
    std::span<const std::uint32_t> indices;     ///< three a triangle, counter-clockwise when seen from the front
    std::span<const std::uint32_t> surfaces{};  ///< one a triangle, your own numbers; empty means 0 for all
    LevelNotes notes{};                         ///< carried along
};

/// Any callable `void(double done)` that is told how far cooking has come, from 0 to 1. Non-owning: it must outlive the
/// call it is handed to. It is called by the thread that cooks, and may not throw.
class CookProgress {
public:
    constexpr CookProgress() noexcept = default;

    template <typename Callable>
    requires(std::is_invocable_v<const Callable&, double> &&
             !std::is_same_v<Callable, CookProgress>) constexpr CookProgress(const Callable& callable) noexcept
        : callable_(&callable),
          call_([](const void* target, double done) { (*static_cast<const Callable*>(target))(done); }) {}

    void operator()(double done) const {
        if (call_ != nullptr) call_(callable_, done);
    }

private:
    const void* callable_ = nullptr;
    void (*call_)(const void*, double) = nullptr;
};

/// How to cook. Every default is meant to be kept.
struct CookOptions {
    /// A vertex moves onto an earlier one that is no farther away than this, and edges that bend less are flat
    /// [m, 0 to 1]. 0 moves nothing: only what is at exactly one place is one. Too large and small things collapse.
    double tolerance = 0;

    /// How many places of each finding the report keeps; it counts them all.
    std::size_t most_places = 32;

    /// How many threads may work [1 to 64]. The result is the same.
    int threads = 2;

    /// A hash of what is cooked, written into the file for those who want to know whether it is stale.
    std::uint64_t made_from = 0;

    CookProgress progress{};
};

/// One oddity of a level: how often, and where first.
struct Finding {
    struct Place {
        std::uint32_t triangle = 0;  ///< its id
        dvec3 point{0, 0, 0};        ///< on it [m]
    };
    std::uint64_t count = 0;
    std::vector<Place> places;  ///< of the first ones, in the order of the triangles; at most CookOptions::most_places
};

/// What cooking found and what it changed. Findings are no errors: every triangle is in the mesh.
struct CookReport {
    std::uint64_t triangles = 0;
    std::uint64_t vertices_given = 0;
    std::uint64_t vertices_kept = 0;    ///< after welding; those of no triangle are gone
    std::uint64_t vertices_unused = 0;  ///< were of no triangle
    std::uint64_t vertices_moved = 0;   ///< by the tolerance, or by rounding to floats
    double largest_move = 0;            ///< how far the farthest of them went [m]
    std::uint64_t tiles = 0;            ///< 1 for a level that floats can hold as it is
    Finding degenerate;                 ///< triangles without area; they block as the segment or point that they are
    Finding open_edges;          ///< sides of triangles that no other triangle shares: fine for a ground's border
    Finding non_manifold_edges;  ///< sides that more than one other triangle shares
    Finding flipped_edges;       ///< pairs of triangles that share an edge but face opposite ways
    Finding t_junctions;         ///< corners that lie on an open edge of another triangle, where cracks begin
    std::uint64_t edges_unsearched = 0;  ///< open edges that were too long or too many to search for T-junctions
};

struct Cooked {
    Mesh mesh;  ///< carries its notes and the report as sections
    CookReport report;
};

/// Cooks a level. Up to 2 seconds per million triangles.
///
/// Guarantees: triangle ids are the order of the triangles in the input. Vertices that are floats stay what they are.
/// Others become the nearest floats if the level lies within 1024 m of its origin; else it is cut into tiles of 1024 m,
/// and vertices are rounded to multiples of 2^-14 m (0.06 mm; coarser only for triangles larger than a tile), so that a
/// vertex is the same real point in every tile. The same input gives the same mesh on every machine.
///
/// Fails with `invalid` as `Mesh::build` does, and for options out of range; with `limit` beyond 2^30 triangles.
[[nodiscard]] Expected<Cooked> cook(const CookInput& input, const CookOptions& options = {});

/// What a mesh carries besides its triangles; nothing for one that was not cooked. Fails with `unreadable` when that
/// part of its file is damaged.
[[nodiscard]] Expected<LevelNotes> level_notes(const Mesh& mesh);

/// What cooking said of a mesh; nothing but zeros for one that was not cooked. Fails as `level_notes` does.
[[nodiscard]] Expected<CookReport> cook_report(const Mesh& mesh);

/// Where the user's cache keeps a mesh with this `CookOptions::made_from`, whether it is there or not: under
/// XDG_CACHE_HOME, HOME/.cache, or LOCALAPPDATA on Windows. Empty if the environment names no such folder.
[[nodiscard]] std::string cache_path(std::uint64_t made_from);

/// Maps a mesh from the user's cache. Fails if it is not there, or was damaged or cooked by another version: then cook.
[[nodiscard]] Expected<Mesh> open_cached(std::uint64_t made_from);

/// Writes a mesh into the user's cache, under what it was made from; with more sections, as `Mesh::write` does.
[[nodiscard]] Expected<void> write_cached(const Mesh& mesh, std::span<const Section> extra = {});

}  // namespace v0
}  // namespace surefoot
