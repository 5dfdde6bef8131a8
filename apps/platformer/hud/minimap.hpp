/// The level from above: a picture that is made once, and the part of it about the hero.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <surefoot/math.hpp>

#include "platformer/screens/palette.hpp"
#include "view/canvas.hpp"
#include "view/picture.hpp"

namespace surefoot::platformer {

struct MapItem {
    enum class Kind : std::uint8_t { coin, star, heart, key, enemy, checkpoint, goal, ghost };
    Kind kind = Kind::coin;
    dvec3 place{0, 0, 0};                  ///< [m]
    std::optional<view::Colour> colour{};  ///< another one than its kind has
};

/// A level's plan: north, -Z, is up; the higher a floor, the lighter; edges of floors are drawn.
struct Plan {
    view::Picture picture;
    dvec3 low{0, 0, 0};  ///< of what the picture covers [m]
    double metres = 1;   ///< that a side of the picture covers [m]

    /// Parts of the picture, x to the east and y to the south [0 to 1].
    [[nodiscard]] view::dvec2 share(const dvec3& place) const;
};

/// Of triangles, three corners each, as the level stands. Walls are left out; of floors above each other the highest is
/// seen. An empty picture of one pixel where there is nothing to draw.
[[nodiscard]] Plan make_plan(std::span<const dvec3> corners, int side = 512);

/// The part about the hero, with the way the camera looks upwards.
void draw_minimap(view::Canvas& canvas, const Plan& plan, std::span<const MapItem> items, const view::Rect& place,
                  const dvec3& hero, const dvec3& facing, const dvec3& looking, const Palette& palette);

}  // namespace surefoot::platformer
