// Finding the triangles of a mesh that a moving shape may meet, eight at a time. Everything here is a conservative
// question in floats: a triangle is thrown out only where a plane certainly keeps the shape away from it, and doubles
// decide about the rest. docs/tree.md derives the margins.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include <surefoot/math.hpp>
#include <surefoot/shapes.hpp>

#include "query/reach.hpp"
#include "tree/view.hpp"

namespace surefoot::internal {

/// The shape as the filter sees it, in a space that is the shape's own frame divided by its half extents.
enum class FilterKind : std::uint8_t { ball, box, capsule, cylinder, cone, point };

struct ShapeFilter {
    float to_scaled[3][3];  ///< from the world's axes to that space
    float motion[3];        ///< there
    float centre[3];        ///< of the shape, about its reference point, there
    float per_extent[3];    ///< 1 / half extents
    float radius = 0;       ///< capsule: [m]
    float half_height = 0;  ///< capsule: [m]
    float row_sum = 0;      ///< the largest sum of absolute values in a row of to_scaled
    float motion_size = 0;  ///< the largest component of `motion`
    FilterKind kind = FilterKind::ball;
    bool is_diagonal = false;  ///< to_scaled is: the shape is not turned
};

/// A triangle that may be met, and a time before which it is not.
struct Candidate {
    float t;
    std::uint32_t place;  ///< as in MeshView::places
};

struct MeshSearch {
    const MeshView* view = nullptr;
    Motion motion;  ///< in the mesh's frame
    Box3 extent;    ///< of the shape about its reference point, with its margin
    Box3 region;    ///< what the motion sweeps
    ShapeFilter filter;
    float limit = 1;          ///< candidates that begin later are of no interest
    std::uint64_t nodes = 0;  ///< counts those that were opened
    bool overflowed = false;  ///< a bound on the work was exceeded: only bytes that nobody wrote do that

    /// Takes candidates, in any order, and returns the new limit.
    float (*take)(void* context, std::span<Candidate> candidates) noexcept = nullptr;
    void* context = nullptr;
};

/// Requires: valid arguments; `extent` as from extent_of.
[[nodiscard]] MeshSearch make_search(const MeshView& view, const Volume& volume, const Motion& motion,
                                     const Box3& extent) noexcept;
[[nodiscard]] MeshSearch make_point_search(const MeshView& view, const Motion& motion, const Box3& extent) noexcept;

/// For motions that are short beside the shape: everything in the region, in one go.
void search_region(MeshSearch& search) noexcept;

/// The same for up to `most_regions` searches of one mesh, by turns.
inline constexpr std::size_t most_regions = 8;
void search_regions(std::span<MeshSearch> searches) noexcept;

/// For long motions: nearest first.
void search_along(MeshSearch& search) noexcept;

/// Triangles whose own box meets the region, to rounding outwards; no filter.
void search_boxes(MeshSearch& search) noexcept;

}  // namespace surefoot::internal
