/// How far a camera may be from what it looks at: sweeps and looks through the world.
#pragma once

#include <array>

#include <surefoot/world.hpp>

namespace surefoot::platformer {

inline constexpr double eye_radius = 0.25;  ///< of the ball in which nothing is but the eye [m]

struct Sight {
    double free = 0;     ///< how far one sees [m]
    double allowed = 0;  ///< the same, less where something is about to come between [m, at most `free`]
    double to_left = 0;  ///< which way there is more room: -1 to 1; it is 0 where nothing is in the way
};

/// From `anchor` along the unit `direction` for `length` metres, in the world as it stands when the tick ends. Beside
/// that direction it looks too: something that is an angle of `a` away allows only what is left of the way to it and
/// `length_per_angle * a`. So what comes between is met by a camera that is near already, and in a corridor it stays
/// close.
[[nodiscard]] Sight look_back(const World& world, const dvec3& anchor, const dvec3& direction, double length,
                              double slight, const WorldQuery& query = {});
inline constexpr double length_per_angle = 7;  ///< [m/rad]

/// How far a thin ray with a little room around it gets from `from` to `to`, as a share of the way.
[[nodiscard]] double seen_share(const World& world, const dvec3& from, const dvec3& to, const WorldQuery& query = {});

/// The same, but what is no thicker than `slight` along the look does not count: boards, posts, the edge of a corner.
/// One who draws lets the hero be seen through it.
[[nodiscard]] double sight_share(const World& world, const dvec3& from, const dvec3& to, double slight,
                                 const WorldQuery& query = {});

/// Places of a body that is `half_height` high to both sides of its middle, as they are seen from `eye`: head, chest,
/// shins, both sides.
[[nodiscard]] std::array<dvec3, 5> body_points(const dvec3& middle, double half_height, const dvec3& eye);

/// The ball of the eye, from `from` to `to`; past nothing.
[[nodiscard]] double ball_share(const World& world, const dvec3& from, const dvec3& to, const WorldQuery& query = {});

/// Where the ball of the eye is pushed by what it is in, a little at a time; it may still be in something then.
[[nodiscard]] dvec3 pushed_out(const World& world, const dvec3& place, const WorldQuery& query = {});

/// The farthest share of the way at which the ball of the eye touches nothing, at most `most`; 0 if there is none.
[[nodiscard]] double roomy_share(const World& world, const dvec3& from, const dvec3& to, double most,
                                 const WorldQuery& query = {});

/// Where the ball of the eye gets that would go from `from` to `to`, along what it meets.
[[nodiscard]] dvec3 moved_ball(const World& world, const dvec3& from, const dvec3& to, const WorldQuery& query = {});

}  // namespace surefoot::platformer
