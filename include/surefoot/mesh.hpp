/// A mesh: immutable triangles and a tree over them, ready for queries from any number of threads.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include <surefoot/error.hpp>
#include <surefoot/hit.hpp>
#include <surefoot/march.hpp>
#include <surefoot/math.hpp>
#include <surefoot/overlap.hpp>
#include <surefoot/shapes.hpp>
#include <surefoot/sweep.hpp>
#include <surefoot/trace.hpp>

namespace [[gnu::visibility("default")]] surefoot {
inline namespace v0 {

/// What a mesh is made from. The spans are read during `Mesh::build` only.
struct MeshInput {
    std::span<const vec3> vertices;             ///< [m, finite, each within +-1e9]
    std::span<const std::uint32_t> indices;     ///< three a triangle, counter-clockwise when seen from the front
    std::span<const std::uint32_t> surfaces{};  ///< one a triangle, your own numbers; empty means 0 for all
};

/// How a query on a mesh finds its triangles. Both give the same bits; brute force is the reference that proves it.
enum class Search : std::uint8_t { tree, brute_force };

struct MeshQueryOptions {
    bool one_sided = false;  ///< see SweepOptions and OverlapOptions
    Search search = Search::tree;
    Trace* trace = nullptr;  ///< records of every triangle that was tested; none by default
};

/// An axis-aligned box around something.
struct Bounds {
    dvec3 min{0, 0, 0};  ///< [m]
    dvec3 max{0, 0, 0};  ///< [m]
};

/// Immutable triangles and a tree. Cheap to copy: copies share the same data.
///
/// Threads: every const call may run on any number of threads at once, and so may making and destroying copies. Memory:
/// building allocates, queries never do. A mesh that was moved from may only be destroyed or assigned to.
/// Triangle ids are the order of the triangles in the input.
class Mesh {
public:
    /// Builds a mesh, in O(n log n). Fails with `invalid` when an index is out of range, the number of indices is not a
    /// multiple of three, the number of surfaces does not match, or a coordinate is not finite or beyond 1e9 m; with
    /// `limit` beyond 2^31 triangles. A mesh with no triangles is fine and is never hit.
    [[nodiscard]] static Expected<Mesh> build(const MeshInput& input);

    Mesh(const Mesh& other) noexcept;
    Mesh(Mesh&& other) noexcept;
    Mesh& operator=(Mesh other) noexcept;
    ~Mesh();

    /// The first touch of `volume` along `motion`; ties in t go to the lowest triangle id.
    [[nodiscard]] std::optional<Hit> sweep(const Volume& volume, const Motion& motion,
                                           const MeshQueryOptions& options = {}) const noexcept;

    /// Where the segment first meets the mesh; ties in t go to the lowest triangle id.
    [[nodiscard]] std::optional<Hit> ray(const Motion& motion, const MeshQueryOptions& options = {}) const noexcept;

    /// All triangles that `volume` at `position` touches, in the order of their ids. Fills `found` from the front and
    /// returns how many there were, which may be more than found room.
    std::size_t overlap(const Volume& volume, const dvec3& position, std::span<Overlap> found,
                        const MeshQueryOptions& options = {}) const noexcept;

    [[nodiscard]] std::size_t triangle_count() const noexcept;
    [[nodiscard]] std::size_t vertex_count() const noexcept;

    /// The box around all triangles; all zeros for an empty mesh.
    [[nodiscard]] Bounds bounds() const noexcept;

    /// Requires: `id` < triangle_count(). The corners, widened from float without change, in the order of the input.
    [[nodiscard]] Triangle triangle(std::uint32_t id) const noexcept;

    /// Requires: `id` < triangle_count().
    [[nodiscard]] std::uint32_t surface(std::uint32_t id) const noexcept;

private:
    struct Data;
    explicit Mesh(const Data* data) noexcept;
    const Data* data_;  // counts its owners; null once moved from
};

/// Walks `volume` along `path` through a mesh; see march.hpp. An unguarded march reports the lowest of the triangles
/// that overlap at the sample, a guarded one the first touch.
[[nodiscard]] std::optional<MarchHit> march(const Volume& volume, const Path& path, const Mesh& mesh,
                                            const MarchOptions& options = {});

}  // namespace v0
}  // namespace surefoot
