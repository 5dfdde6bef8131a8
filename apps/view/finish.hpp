/// What a triangle of a model looks like: its colour, how much it shines by itself, and a drawing on it.
#pragma once

#include <cstdint>

#include "view/colour.hpp"

namespace surefoot::view {

/// A tone that lies over a flat triangle's colour, the same wherever it is in its model; see pattern.hpp.
enum class Pattern : std::uint8_t {
    none,
    patches,  ///< of grass, sand or snow, with flecks
    bricks,   ///< courses of half a metre
    boards,   ///< a hand wide, with grain
    strata,   ///< uneven layers, for cliffs
};
inline constexpr int pattern_count = 4;  // but for `none`

struct Finish {
    // NOLINTNEXTLINE(google-explicit-constructor): a colour alone is a finish
    constexpr Finish(Colour c, double own = 0, Pattern drawn = Pattern::none) : colour(c), glow(own), pattern(drawn) {}

    Colour colour;  ///< its opacity is of no use
    double glow;    ///< how much of its colour it shines by itself [0 to 1]
    Pattern pattern;
};

}  // namespace surefoot::view
