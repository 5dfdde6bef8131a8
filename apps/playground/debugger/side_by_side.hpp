/// Five bodies of the same width and height, side by side: standing on a slope, walking at stairs, walking over a
/// ledge. They are moved by `step`. What differs is how far each stands off what it stands on, what it gets over, and
/// when it lets go.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <surefoot/character.hpp>
#include <surefoot/math.hpp>
#include <surefoot/shapes.hpp>

#include "debugger/arena.hpp"

namespace surefoot::debugger {

struct Contestant {
    std::string name;
    Shape shape;
};

/// Box, cylinder, cone, ellipsoid and capsule. Requires: 0 < half_width <= half_height (a capsule is not wider than it
/// is tall).
[[nodiscard]] std::array<Contestant, 5> contestants(double half_width = 0.4, double half_height = 0.9);

/// The height of the lowest point under the axis, seen from the reference point: -half_height, but 0 for a cone.
[[nodiscard]] double foot_of(const Shape& shape);

/// How a contestant walks: everything as `CharacterSettings` has it by default, but for its body.
[[nodiscard]] CharacterSettings walker(const Shape& shape);

/// How long a tick of the contest is [s].
inline constexpr double contest_tick = 1.0 / 60;

/// Steps through `ticks` of them in a row with one wish; the first state is the start.
[[nodiscard]] std::vector<CharacterState> track(const World& world, const CharacterSettings& settings,
                                                const CharacterState& start, const dvec3& wish, int ticks);

// Slope -------------------------------------------------------------------------------------------------------------

/// A plane that rises towards +x by this angle [rad, 0 to below pi/2], 40 m either way.
[[nodiscard]] std::vector<Triangle> slope(double angle);

/// How far the foot of a shape that just touches the slope is above it, straight down [m]:
///
///     box, cylinder   w tan a                       the uphill edge or rim touches
///     cone            max(0, w tan a - height)      the apex touches, until the slope is steeper than its side
///     ellipsoid       sqrt(w^2 tan^2 a + h^2) - h
///     capsule         r / cos a - r
[[nodiscard]] double stand_off(const Shape& shape, double angle);

struct SlopeReading {
    bool landed = false;  ///< it stands there
    dvec3 position{0, 0, 0};
    double gap = 0;        ///< from the foot straight down to the slope [m]
    double clearance = 0;  ///< between shape and slope, along the slope's normal: the skin [m]
    double expected = 0;   ///< stand_off + clearance / cos a [m]
};

/// The slope limit of those who stand on slopes here, so that all of them do [degrees].
inline constexpr double lesson_slope_limit_deg = 75;

/// Lets a body fall onto the slope and measures where it is `ticks` later.
[[nodiscard]] SlopeReading read_slope(const Shape& shape, double angle, int ticks = 180);

// Stairs ------------------------------------------------------------------------------------------------------------

struct Stairs {
    int count = 8;
    double rise = 0.2;  ///< [m]
    double run = 0.3;   ///< [m]
};

/// A floor up to x = 0, stairs upwards towards +x, a floor on top.
[[nodiscard]] std::vector<Triangle> stairs(const Stairs& stairs = {});

struct StairsReading {
    std::vector<CharacterState> places;  ///< one a tick
    double climbed = 0;                  ///< how high the foot came above the lower floor [m]
    double reached = 0;                  ///< x of the axis in the end [m]
};

/// Lets a body walk at the stairs.
[[nodiscard]] StairsReading read_stairs(const Shape& shape, const Stairs& which = {}, double speed = 2,
                                        int ticks = 240);

// Ledge -------------------------------------------------------------------------------------------------------------

/// A floor up to x = 0, a wall 3 m down there, and a lower floor.
[[nodiscard]] std::vector<Triangle> ledge();

/// How far the axis of a shape is beyond the ledge when its foot has sunk by `sink` below the floor while the shape
/// still touches the edge [m]: box and cylinder w (they do not sink before), cone sink w / height, ellipsoid
/// w sqrt(1 - (1 - sink / h)^2), capsule sqrt(r^2 - (r - sink)^2).
[[nodiscard]] double overhang(const Shape& shape, double sink);

struct LedgeReading {
    std::vector<CharacterState> places;  ///< one a tick
    std::optional<double> overhang;      ///< of the axis when the foot was first `sink` below the floor [m]
};

/// Lets a body walk over the ledge.
[[nodiscard]] LedgeReading read_ledge(const Shape& shape, double sink = 0.05, double speed = 0.5, int ticks = 360);

}  // namespace surefoot::debugger
