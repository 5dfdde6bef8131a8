// Two ellipsoids of one shape, turned alike: what characters of one kind are to each other. Squashed to balls they are
// one ball of both radii about the second one's place, and a point: every question has a short closed form, inside too.
#pragma once

#include <optional>

#include <surefoot/shapes.hpp>

#include "frame.hpp"
#include "vec.hpp"

namespace surefoot::internal {

class AlikeEllipsoids {
public:
    struct Meeting {
        double t;  ///< [0, 1]
        Vec normal;
        Vec point;  ///< relative to the place of the second one [m]
    };
    struct Overlap {
        Vec normal;
        double depth;  ///< going so far along `normal` parts them [m]
    };

    /// `by` is how far they are kept apart where they are thinnest [m]. Nothing if they are not alike.
    static std::optional<AlikeEllipsoids> of(const Volume& a, const Volume& b, double by) noexcept;

    /// When does the first, `from` the second one's place, meet it on its way? Inside a touch is met if it goes deeper.
    [[nodiscard]] std::optional<Meeting> sweep(const Vec& from, const Vec& motion) const noexcept;

    /// A way out, if they overlap. Along the normal of where they would touch if they were balls: not quite the
    /// shortest, but the one that the planes of a slide are made of.
    [[nodiscard]] std::optional<Overlap> overlap(const Vec& from) const noexcept;

private:
    AlikeEllipsoids(const Ellipsoid& ellipsoid, const dquat& orientation, double by) noexcept;
    [[nodiscard]] Vec normal_at(const Vec& squashed) const noexcept;

    Frame frame_;
    Vec radii_;  // of both together
};

}  // namespace surefoot::internal
