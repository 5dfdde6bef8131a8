// Moving along what is met: all planes that are met at one place are obeyed at once.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include <surefoot/character_hooks.hpp>

#include "character/planes.hpp"
#include "character/surroundings.hpp"

namespace surefoot::internal {

/// How a body moves, apart from where.
struct Gait {
    Vec up;                  ///< unit
    double least_ground_up;  ///< the cosine of the slope limit
    double skin;             ///< [m]
    bool on_foot = false;    ///< walks on ground: rising is free, and what is too steep is a wall
    bool stops = false;      ///< stays where it meets something

    /// What is asked when something is in the way, if there is such a rule; and the velocity that it is told of.
    const OwnRule<MetOnTheWay>* respond = nullptr;
    Vec velocity{};
};

/// The same with the user's own response, if there is one.
[[nodiscard]] Gait answered_by(Gait gait, const OwnRule<MetOnTheWay>& respond, const Vec& velocity) noexcept;

/// Something that was in the way.
struct Obstacle {
    Vec normal;  ///< unit; zero if there was none
    Vec point;
    std::uint32_t body = 0;
    std::uint32_t triangle = 0;
    bool is_neighbour = false;
    double share = 0;  ///< how squarely it was met: the cosine of the angle to the wish [0, 1]
};

struct SlideResult {
    Vec position;
    Planes3 planes;                 ///< all that were obeyed
    Obstacle obstacle;              ///< the one that was met the most squarely
    std::array<Obstacle, 4> met{};  ///< the first of the world's that were obeyed
    std::size_t met_count = 0;
    std::array<Obstacle, 3> walls{};  ///< what cannot be walked on and does not hang over; for steps
    std::size_t wall_count = 0;
    bool met_ceiling = false;
    bool overflow = false;          ///< there was no room for all that was met: the move ended early
    std::optional<Vec> answered{};  ///< the velocity that the user's own response left
};

/// Moves by `wish`, along what is met. `planes` are obeyed from the start. The wish's end is kept in mind: what is left
/// of the way leads there from wherever the last touch was.
[[nodiscard]] SlideResult slide(Surroundings& surroundings, const Body& body, const Gait& gait, const Vec& from,
                                const Vec& wish, const Planes3& planes) noexcept;

/// What becomes of a velocity along these planes, without a foot on the ground: what is too steep does not turn it
/// upwards.
[[nodiscard]] Vec velocity_along(const Planes3& planes, const Gait& gait, Vec velocity) noexcept;

}  // namespace surefoot::internal
