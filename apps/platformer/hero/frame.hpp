/// Placing pieces: frames inside of frames, as the parts of a figure hang on each other.
#pragma once

#include <cmath>
#include <glm/ext/matrix_double3x3.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <surefoot/math.hpp>

#include "view/piece_pass.hpp"

namespace surefoot::platformer {

using glm::dmat3;

/// Axes and an origin. Of a figure: X to its left, Y up, Z where it faces.
struct Frame {
    dmat3 axes{1};
    dvec3 origin{0, 0, 0};

    [[nodiscard]] dvec3 at(const dvec3& local) const { return origin + axes * local; }
    [[nodiscard]] dvec3 to_local(const dvec3& place) const { return glm::inverse(axes) * (place - origin); }
    [[nodiscard]] Frame inside(const dvec3& at_local, const dmat3& turn = dmat3(1)) const {
        return {axes * turn, at(at_local)};
    }
};

/// Forward, over the toes, when positive [rad].
[[nodiscard]] inline dmat3 pitched(double angle) {
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    return {1, 0, 0, 0, c, s, 0, -s, c};
}

/// To the left when positive [rad].
[[nodiscard]] inline dmat3 turned(double angle) {
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    return {c, 0, -s, 0, 1, 0, s, 0, c};
}

/// Leaning to the left when positive [rad].
[[nodiscard]] inline dmat3 rolled(double angle) {
    const double c = std::cos(angle);
    const double s = std::sin(-angle);
    return {c, s, 0, -s, c, 0, 0, 0, 1};
}

[[nodiscard]] inline dmat3 scaled(const dvec3& by) {
    return {by.x, 0, 0, 0, by.y, 0, 0, 0, by.z};
}

/// Without what it rises.
[[nodiscard]] inline dvec3 flat(const dvec3& v) {
    return {v.x, 0, v.z};
}

/// Where a figure looks that is turned by `facing` about up [rad].
[[nodiscard]] inline dvec3 forward_of(double facing) {
    return {std::sin(facing), 0, std::cos(facing)};
}

/// The angle from `from` to `to` by the shorter way [rad, -pi to pi].
[[nodiscard]] inline double turn_between(double from, double to) {
    return std::remainder(to - from, 2 * 3.14159265358979323846);
}

/// The share of a way that is gone in `dt` by something that comes nearer by `rate` [1/s].
[[nodiscard]] inline double eased(double rate, double dt) {
    return 1 - std::exp(-rate * dt);
}

[[nodiscard]] inline view::Piece piece(const Frame& frame, const dvec3& at, const dvec3& radii, view::Colour colour,
                                       view::Solid solid = view::Solid::ball, const dmat3& turn = dmat3(1)) {
    const dmat3 axes = frame.axes * turn * scaled(radii);
    return {.solid = solid, .place = {axes[0], axes[1], axes[2], frame.at(at)}, .colour = colour};
}

}  // namespace surefoot::platformer
