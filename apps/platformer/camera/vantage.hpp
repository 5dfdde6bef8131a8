/// From which direction a hero is seen best where the usual one has no room: the directions around it are tried.
#pragma once

#include <optional>

#include <surefoot/world.hpp>

namespace surefoot::platformer {

/// A direction from the hero to the eye: which way the eye looks about up, and how high it stands.
struct Vantage {
    double yaw = 0;    ///< as that of a camera [rad]
    double pitch = 0;  ///< [rad]
};

/// What a camera stands in, and for whom it looks for a place.
struct Surroundings {
    const World& world;        ///< what the eye cannot be in, nor see through
    const World* decor;        ///< what it is better not behind; may be null
    double slight = 0;         ///< what it sees through, as `sight_share` has it [m]
    WorldQuery query{};        ///< which bodies there are for it
    dvec3 head{0, 0, 0};       ///< where in the hero's volume there is room for the ball of the eye [m]
    dvec3 soon{0, 0, 0};       ///< and where that will be in a moment [m]
    dvec3 middle{0, 0, 0};     ///< of the hero's volume [m]
    double half_height = 0.8;  ///< [m]
    dvec3 look_at{0, 0, 0};    ///< what it stands around [m]
    double distance = 5.6;     ///< from there, where there is room [m]
};

/// From the hero to the eye, unit.
[[nodiscard]] dvec3 outward(const Vantage& vantage);

/// How far the ball of the eye gets from the hero's head in this direction, now and in a moment, whichever is less [m].
[[nodiscard]] double reach(const Surroundings& around, const Vantage& vantage);

/// How many of the hero's `body_points` are behind something that is drawn, for an eye that is there.
[[nodiscard]] int veiled_points(const Surroundings& around, const dvec3& eye);

/// How good a picture from so far away is: 1 is all that one wants, below 0 one sees next to nothing.
[[nodiscard]] double worth_of(double reach, double distance);

/// What is to be gained by another direction than `now`: the best one, or `now` itself where there is room enough or
/// nothing better. Turning costs, and costs more with `still` (a player who turns the camera by hand is not to be
/// overruled but in need); the direction that was `chosen` before costs less.
[[nodiscard]] Vantage best_vantage(const Surroundings& around, const Vantage& now, bool still,
                                   const std::optional<Vantage>& chosen);

}  // namespace surefoot::platformer
