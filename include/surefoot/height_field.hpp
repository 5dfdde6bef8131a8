/// A height field: terrain as a grid of heights, a triangle source of its own. No mesh is made of it: 16-bit samples
/// with materials and holes take about three bytes a triangle.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include <surefoot/bounds.hpp>
#include <surefoot/error.hpp>
#include <surefoot/hit.hpp>
#include <surefoot/math.hpp>
#include <surefoot/overlap.hpp>
#include <surefoot/query.hpp>
#include <surefoot/shapes.hpp>

namespace [[gnu::visibility("default")]] surefoot {
inline namespace v0 {

/// Which way quads are cut in two: a rising diagonal runs from the corner of least x and least z to that of most x and
/// most z, a falling one joins the other two corners.
enum class Diagonal : std::uint8_t {
    rising,
    falling,
    alternating,  ///< rising where column + row of the quad is even, falling elsewhere
};

/// One quad's flags, to be added.
inline constexpr std::uint8_t quad_hole = 1;     ///< its two triangles are not there
inline constexpr std::uint8_t quad_flipped = 2;  ///< cut the other way than the field's `Diagonal` says

/// What a height field is made from. The spans are read during `HeightField::build` only.
///
/// Samples lie row by row: sample (column, row) is at `row * columns + column`, x grows with the column and z with the
/// row. Quad (column, row) lies between the samples (column, row) and (column + 1, row + 1), and quads are stored like
/// samples, in rows of `columns - 1`.
struct HeightFieldInput {
    std::uint32_t columns = 0;                  ///< samples along x [>= 2]
    std::uint32_t rows = 0;                     ///< samples along z [>= 2]
    std::span<const float> heights{};           ///< one a sample; give these or `levels`
    std::span<const std::uint16_t> levels{};    ///< one a sample, the 16-bit form
    double cell_x = 1;                          ///< from column to column [m, > 0]
    double cell_z = 1;                          ///< from row to row [m, > 0]
    double height_scale = 1;                    ///< metres for one unit of a sample
    dvec3 origin{0, 0, 0};                      ///< of sample (0, 0) at height 0 [m]
    Diagonal diagonal = Diagonal::rising;       ///< which way quads are cut
    std::span<const std::uint8_t> quads{};      ///< flags, one a quad; empty means 0 for all
    std::span<const std::uint8_t> materials{};  ///< two a quad, one for each triangle; empty means 0 for all
    std::span<const std::uint32_t> surfaces{};  ///< the surface of each material; empty means the material's number
};

/// New samples for a rectangle of a height field: a crater, a footprint, a road. Empty spans change nothing.
struct HeightFieldPatch {
    std::uint32_t column = 0;                   ///< first column of samples
    std::uint32_t row = 0;                      ///< first row of samples
    std::uint32_t columns = 0;                  ///< samples along x [>= 1]
    std::uint32_t rows = 0;                     ///< samples along z [>= 1]
    std::span<const float> heights{};           ///< one a sample of the rectangle, for a field made of `heights`
    std::span<const std::uint16_t> levels{};    ///< one a sample of the rectangle, for a field made of `levels`
    std::span<const std::uint8_t> quads{};      ///< one for each of the (columns - 1) * (rows - 1) quads between them
    std::span<const std::uint8_t> materials{};  ///< two for each of those quads
};

/// Terrain over a grid. Each quad is two triangles whose fronts look up (+Y); quad q has the triangles 2q and 2q + 1.
///
/// Triangle 2q holds the quad's side of least x, 2q + 1 that of most x. Corners are exactly these floats: x =
/// float(origin.x + cell_x * column), y = float(origin.y + height_scale * sample) and z = float(origin.z + cell_z *
/// row), computed in doubles and rounded once at the end. The queries are those of `Mesh` and their answers are those
/// of a mesh with the same triangles, bit for bit.
///
/// Threads: every const call may run on any number of threads at once; `set` may not run beside anything else.
/// Memory: building and copying allocate, queries and `set` never do. A field that was moved from may only be destroyed
/// or assigned to.
class HeightField {
public:
    /// Builds a field, in O(samples). Fails with `invalid` when a span has the wrong length, a number is not finite, a
    /// corner would lie beyond 1e9 m, neighbouring columns or rows would round to the same float, or a material has no
    /// surface; with `limit` beyond 2^30 quads.
    [[nodiscard]] static Expected<HeightField> build(const HeightFieldInput& input);

    HeightField(const HeightField& other);
    HeightField(HeightField&& other) noexcept;
    HeightField& operator=(HeightField other) noexcept;
    ~HeightField();

    /// Changes a rectangle, in O(its samples + log(all samples)). Fails, changing nothing, for the reasons of `build`
    /// and when the rectangle leaves the field.
    Expected<void> set(const HeightFieldPatch& patch);

    /// See Mesh; ties go to the lowest triangle.
    [[nodiscard]] std::optional<Hit> sweep(const Volume& volume, const Motion& motion,
                                           const QueryOptions& options = {}) const noexcept;
    [[nodiscard]] bool sweep_any(const Volume& volume, const Motion& motion,
                                 const QueryOptions& options = {}) const noexcept;
    [[nodiscard]] std::optional<Hit> ray(const Motion& motion, const QueryOptions& options = {}) const noexcept;
    [[nodiscard]] bool ray_any(const Motion& motion, const QueryOptions& options = {}) const noexcept;
    std::size_t overlap(const Volume& volume, const dvec3& position, std::span<Overlap> found,
                        const QueryOptions& options = {}) const noexcept;
    [[nodiscard]] std::optional<NearestPoint> nearest(const dvec3& point, double farthest,
                                                      const QueryOptions& options = {}) const noexcept;
    /// As for Mesh, but the kinds of edges are not worked out: all are `open`.
    std::size_t gather(const Bounds& near, std::span<SourceTriangle> found,
                       const QueryOptions& options = {}) const noexcept;

    /// How many ids there are: two a quad, holes counted.
    [[nodiscard]] std::uint32_t triangle_count() const noexcept;
    /// The box around all triangles, holes counted.
    [[nodiscard]] Bounds bounds() const noexcept;
    /// Requires: `id` < triangle_count(). Holes have corners too.
    [[nodiscard]] Triangle triangle(std::uint32_t id) const noexcept;
    /// Requires: `id` < triangle_count().
    [[nodiscard]] std::uint32_t surface(std::uint32_t id) const noexcept;
    /// Is this triangle's quad a hole? Requires: `id` < triangle_count().
    [[nodiscard]] bool is_hole(std::uint32_t id) const noexcept;
    /// What the field holds on to [bytes].
    [[nodiscard]] std::size_t bytes() const noexcept;

private:
    struct Data;
    explicit HeightField(Data* data) noexcept;
    Data* data_;  // owned; null once moved from
};

}  // namespace v0
}  // namespace surefoot
