/// Where one looks from: places to the picture and back, in doubles, for any up.
#pragma once

#include <glm/ext/matrix_double4x4.hpp>
#include <optional>

#include <surefoot/bounds.hpp>
#include <surefoot/hit.hpp>
#include <surefoot/math.hpp>
#include <surefoot/mesh.hpp>

#include "view/input.hpp"

namespace surefoot::view {

using glm::dmat4;

/// A part of the picture [window units from the upper left].
struct Area {
    dvec2 low{0, 0};
    dvec2 high{0, 0};

    [[nodiscard]] dvec2 middle() const { return (low + high) * 0.5; }
    [[nodiscard]] dvec2 size() const { return high - low; }
};

/// A place on the picture.
struct Projected {
    dvec2 at{0, 0};    ///< in window units from the upper left
    double depth = 0;  ///< how far it is in front of the eye, along the line of sight [m]
};

struct Camera {
    dvec3 eye{0, 0, 0};
    dvec3 forward{0, 0, -1};      ///< unit, not along `up`
    dvec3 up{0, 1, 0};            ///< unit; the world's up, not the picture's
    double field_of_view = 0.87;  ///< of the picture's height [rad, 0.01 to 3]
    double nearest = 0.05;        ///< what is nearer than this is not drawn [m]
    double farthest = 5000;       ///< nor what is farther [m]
    dvec2 lens_shift{0, 0};       ///< where on the picture straight ahead is: right, up [-1 to 1, of its half]

    [[nodiscard]] dvec3 right() const;
    [[nodiscard]] dvec3 above() const;  ///< the picture's up

    /// Turns the world's axes into the picture's. Everything is drawn relative to the eye, so nothing is moved: a level
    /// far from its origin looks as one near it.
    [[nodiscard]] dmat4 turn() const;
    [[nodiscard]] dmat4 projection(double width_to_height) const;

    /// The unit direction through a place of the picture.
    [[nodiscard]] dvec3 direction(const dvec2& at, const ivec2& size) const;

    /// From the eye through a place of the picture, `length` metres far.
    [[nodiscard]] Motion ray(const dvec2& at, const ivec2& size, double length) const;

    /// Where a place appears; none for what is not in front of the eye.
    [[nodiscard]] std::optional<Projected> project(const dvec3& place, const ivec2& size) const;

    /// How large one window unit is at this depth [m].
    [[nodiscard]] double unit_at(double depth, const ivec2& size) const;
};

/// What is under a place of the picture: the mesh's own ray decides.
[[nodiscard]] std::optional<Hit> pick(const Mesh& mesh, const Camera& camera, const dvec2& at, const ivec2& size);

/// Two unit vectors across a unit `up`; for +Y they are +Z and +X.
struct Across {
    dvec3 first;
    dvec3 second;
};
[[nodiscard]] Across across(const dvec3& up);

}  // namespace surefoot::view
