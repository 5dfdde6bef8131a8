/// A mesh: immutable triangles and a tree over them, ready for queries from any number of threads.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <surefoot/bounds.hpp>
#include <surefoot/error.hpp>
#include <surefoot/file.hpp>
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

/// One box of a mesh's tree, for those who want to look at it.
struct TreeBox {
    Bounds bounds;                ///< around everything below it
    std::uint32_t depth = 0;      ///< 0 for the children of the root
    std::uint32_t triangles = 0;  ///< how many are in it, if it is a leaf; 0 if there are boxes below
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

    /// Maps a cooked file (`surefoot cook IN -o OUT.surefoot`) and uses it where it lies: in under a millisecond,
    /// whatever its size, with one copy in memory for all processes. Requires: nobody cuts the file short or writes
    /// into it as long as the mesh lives; replacing it as `write` does is fine. Otherwise `read` it.
    /// Fails with `not_found`; `unreadable`, with the byte, for what is no such file or is damaged, as far as `check`
    /// looks; `unsupported` for a file of another version, which has to be cooked again.
    [[nodiscard]] static Expected<Mesh> open(const std::string& path, Check check = Check::header);

    /// The same with memory of its own, for files that somebody may cut or change. Fails with `out_of_memory` too.
    [[nodiscard]] static Expected<Mesh> read(const std::string& path, Check check = Check::header);

    /// The same from the bytes of a file, which are copied.
    [[nodiscard]] static Expected<Mesh> read(std::span<const std::byte> bytes, Check check = Check::header);

    /// Writes the mesh, the sections that it carries, and more of them; one of the same owner and name is replaced.
    /// Guarantees: whoever looks finds the whole old file or the whole new one, even after a full disk, a kill, or with
    /// two writers. Fails with `write_failed`, or with `invalid` for a section that cannot be called so.
    [[nodiscard]] Expected<void> write(const std::string& path, std::span<const Section> extra = {}) const;

    /// All sections of the file that this mesh was opened or read from, in its order; none for one that was built.
    [[nodiscard]] std::span<const Section> sections() const noexcept;

    /// One of them, if it is there. Its bytes are good as long as this mesh or a copy lives.
    [[nodiscard]] std::optional<Section> section(std::string_view owner, std::string_view name) const noexcept;

    /// `CookOptions::made_from` of the file; 0 for a mesh that was built.
    [[nodiscard]] std::uint64_t made_from() const noexcept;

    Mesh(const Mesh& other) noexcept;
    Mesh(Mesh&& other) noexcept;
    Mesh& operator=(Mesh other) noexcept;
    ~Mesh();

    /// The first touch of `volume` along `motion`; ties in t go to the lowest triangle id.
    [[nodiscard]] std::optional<Hit> sweep(const Volume& volume, const Motion& motion,
                                           const QueryOptions& options = {}) const noexcept;

    /// Many sweeps of one volume: `hits[i]` becomes what `sweep` along `motions[i]` answers, bit for bit. Short motions
    /// are searched eight at a time, which hides some of the time that memory takes: a tenth to a fifth of the whole
    /// in large levels. `options.trace` gets the records of all, mixed; a filter may be asked in any order.
    /// Requires: room in `hits` for one answer a motion; what does not fit is not asked.
    void sweep_many(const Volume& volume, std::span<const Motion> motions, std::span<std::optional<Hit>> hits,
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

    /// The boxes of the tree, parents before what is below them, in the same order every time. Fills `found` from the
    /// front and returns how many there are, which may be more than found room. For debuggers: it walks the whole tree.
    std::size_t tree_boxes(std::span<TreeBox> found) const noexcept;

    [[nodiscard]] std::size_t triangle_count() const noexcept;
    [[nodiscard]] std::size_t vertex_count() const noexcept;

    /// The box around all triangles; all zeros for an empty mesh.
    [[nodiscard]] Bounds bounds() const noexcept;

    /// The corners, widened from float without change, in the order of the input. All zeros for an id that is not
    /// there, as a hit in a file that was not checked may name one.
    [[nodiscard]] Triangle triangle(std::uint32_t id) const noexcept;

    /// 0 for an id that is not there.
    [[nodiscard]] std::uint32_t surface(std::uint32_t id) const noexcept;

    [[nodiscard]] bool is_hidden(std::uint32_t id) const noexcept;

    [[nodiscard]] MeshMemory memory() const noexcept;

private:
    struct Data;
    explicit Mesh(const Data* data) noexcept;
    template <typename Bytes>
    [[nodiscard]] static Expected<Mesh> over(Bytes&& bytes, const std::string& file, Check check);
    const Data* data_;  // counts its owners; null once moved from
};

/// Walks `volume` along `path` through a mesh; see march.hpp. An unguarded march reports the lowest of the triangles
/// that overlap at the sample, a guarded one the first touch.
[[nodiscard]] std::optional<MarchHit> march(const Volume& volume, const Path& path, const Mesh& mesh,
                                            const MarchOptions& options = {});

}  // namespace v0
}  // namespace surefoot
