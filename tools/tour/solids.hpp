/// The few solids that a picture of a route is made of, each met by a line of sight in closed form.
#pragma once

#include <optional>

#include <surefoot/math.hpp>

namespace surefoot::tools {

/// Where a line of sight enters a solid.
struct Sighting {
    double distance;  ///< from the eye, in lengths of the direction
    dvec3 normal;     ///< unit, outwards
};

/// An ellipsoid swept from one place to another; a capsule if its radii are equal, an ellipsoid if it stays.
struct SweptEllipsoid {
    dvec3 from{0, 0, 0};
    dvec3 to{0, 0, 0};
    dvec3 radii{1, 1, 1};
    dquat orientation{1, 0, 0, 0};  ///< unit

    [[nodiscard]] std::optional<Sighting> sight(const dvec3& eye, const dvec3& direction) const;
    [[nodiscard]] dvec3 centre() const { return (from + to) * 0.5; }
    [[nodiscard]] double reach() const;  ///< the radius of a ball around it
};

/// The head of an arrow.
struct ArrowHead {
    dvec3 base{0, 0, 0};
    dvec3 tip{0, 1, 0};
    double radius = 0.1;

    [[nodiscard]] std::optional<Sighting> sight(const dvec3& eye, const dvec3& direction) const;
    [[nodiscard]] dvec3 centre() const { return (base + tip) * 0.5; }
    [[nodiscard]] double reach() const;
};

}  // namespace surefoot::tools
