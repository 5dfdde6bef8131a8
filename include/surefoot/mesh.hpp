/// A mesh: immutable triangles and a tree over them, ready for queries from any number of threads.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include <surefoot/bounds.hpp>
#include <surefoot/error.hpp>
#include <surefoot/hit.hpp>
#include <surefoot/march.hpp>
#include <surefoot/math.hpp>
#include <surefoot/overlap.hpp>
#include <surefoot/query.hpp>
#include <surefoot/shapes.hpp>
#include <surefoot/sweep.hpp>

namespace [[gnu::visibility("default")]] surefoot {
inline namespace v0 {

/// What a mesh is made from. The spans are read during `Mesh::build` only.
struct MeshInput {
    std::span<const vec3> vertices;             ///< [m, finite, each within +-1e9]
    std::span<const std::uint32_t> indices;     ///< three a triangle, counter-clockwise when seen from the front
    std::span<const std::uint32_t> surfaces{};  ///< one a triangle, your own numbers; empty means 0 for all
};

/// How much memory a mesh takes [bytes].
struct MeshMemory {
    std::size_t nodes = 0;     ///< the tree
    std::size_t leaves = 0;    ///< triangles: vertices, ids, kinds of edges
    std::size_t places = 0;    ///< from an id to its triangle; queries do not read it
    std::size_t surfaces = 0;  ///< read for what was hit only

    [[nodiscard]] std::size_t total() const noexcept { return nodes + leaves + places + surfaces; }
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
    /// `limit` beyond some 80 million triangles. A mesh with no triangles is fine and is never hit. Uses up to 16
    /// threads; the mesh is the same however many there are.
    [[nodiscard]] static Expected<Mesh> build(const MeshInput& input);

    /// The same triangles, moved: the shape of the tree is kept and its boxes are made anew, in O(n), which is several
    /// times as fast as building. The further triangles move from their neighbours, the slower queries get; answers
    /// are those of a new mesh. Surfaces are kept if none are given, and what is hidden stays hidden. Fails as `build`
    /// does, and with `invalid` if there are more or fewer triangles.
    [[nodiscard]] Expected<Mesh> refit(const MeshInput& moved) const;

    /// The same mesh with these triangles hidden (or shown again): queries do not meet what is hidden. The triangles
    /// are shared with this mesh, a bit a triangle is not. Fails with `invalid` if there is no such triangle.
    [[nodiscard]] Expected<Mesh> with_hidden(std::span<const std::uint32_t> ids, bool hidden = true) const;

    Mesh(const Mesh& other) noexcept;
    Mesh(Mesh&& other) noexcept;
    Mesh& operator=(Mesh other) noexcept;
    ~Mesh();

    /// The first touch of `volume` along `motion`; ties in t go to the lowest triangle id.
    [[nodiscard]] std::optional<Hit> sweep(const Volume& volume, const Motion& motion,
                                           const QueryOptions& options = {}) const noexcept;

    /// Where the segment first meets the mesh; ties in t go to the lowest triangle id.
    [[nodiscard]] std::optional<Hit> ray(const Motion& motion, const QueryOptions& options = {}) const noexcept;

    /// All triangles that `volume` at `position` touches, in the order of their ids. Fills `found` from the front and
    /// returns how many there were, which may be more than found room.
    std::size_t overlap(const Volume& volume, const dvec3& position, std::span<Overlap> found,
                        const QueryOptions& options = {}) const noexcept;

    /// Is there any touch along `motion`? The same as asking whether `sweep` has an answer, but any triangle will do.
    [[nodiscard]] bool sweep_any(const Volume& volume, const Motion& motion,
                                 const QueryOptions& options = {}) const noexcept;

    /// Does the segment meet anything? The same as asking whether `ray` has an answer, but any triangle will do.
    [[nodiscard]] bool ray_any(const Motion& motion, const QueryOptions& options = {}) const noexcept;

    /// The point of the mesh that is nearest to `point`, if it is within `farthest` [m, >= 0].
    [[nodiscard]] std::optional<NearestPoint> nearest(const dvec3& point, double farthest,
                                                      const QueryOptions& options = {}) const noexcept;

    /// All triangles whose own box meets `near`, touching included, in the order of their ids: for a step that asks
    /// many questions of the same few triangles. Fills `found` from the front and returns how many there were, which
    /// may be more than found room; then the ones found are any of them, still in order.
    std::size_t gather(const Bounds& near, std::span<SourceTriangle> found,
                       const QueryOptions& options = {}) const noexcept;

    [[nodiscard]] std::size_t triangle_count() const noexcept;
    [[nodiscard]] std::size_t vertex_count() const noexcept;

    /// The box around all triangles; all zeros for an empty mesh.
    [[nodiscard]] Bounds bounds() const noexcept;

    /// Requires: `id` < triangle_count(). The corners, widened from float without change, in the order of the input.
    [[nodiscard]] Triangle triangle(std::uint32_t id) const noexcept;

    /// Requires: `id` < triangle_count().
    [[nodiscard]] std::uint32_t surface(std::uint32_t id) const noexcept;

    [[nodiscard]] bool is_hidden(std::uint32_t id) const noexcept;

    [[nodiscard]] MeshMemory memory() const noexcept;

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
