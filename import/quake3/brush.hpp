/// A brush, which is the space behind all of its planes, becomes the polygons that bound it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <surefoot/math.hpp>

#include "map.hpp"

namespace surefoot::internal::quake3 {

/// One side of a brush: its corners, counter-clockwise when seen from outside.
struct BrushPolygon {
    std::uint32_t side = 0;  ///< which of the planes, counted from 0
    std::vector<std::uint32_t> corners;
};

struct BrushShape {
    enum class State : std::uint8_t {
        solid,      ///< what `polygons` tells
        empty,      ///< nothing is behind all planes, or no more than a sheet
        unbounded,  ///< the planes do not close
        too_large,  ///< more work than a brush may ask for
    };
    State state = State::empty;
    std::vector<dvec3> corners;  ///< each place once, so that neighbouring sides share theirs to the bit
    std::vector<BrushPolygon> polygons;
};

/// The most sides that a brush may have; compilers of maps stop at a quarter of it.
inline constexpr std::size_t max_brush_sides = 1024;

/// Places closer together than the floats of the planes can tell apart become one. O(n^2) in sides for brushes that
/// people make, O(n^3) at worst.
[[nodiscard]] BrushShape shape_of(std::span<const Plane> planes);

}  // namespace surefoot::internal::quake3
