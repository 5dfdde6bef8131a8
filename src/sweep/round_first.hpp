// What most sweeps of round shapes that are not a face hit are: a ball, or a capsule, that clearly meets one edge or
// one corner. That one plane is the whole answer if it has a gap until t and shape and triangle have a point in common
// at t; so the feature may be guessed, and the other features need not be asked.
#pragma once

#include <surefoot/shapes.hpp>

#include "sweep/face_first.hpp"

namespace surefoot::internal {

struct RoundFirst {
    enum class Verdict : std::uint8_t {
        undecided,  ///< ask all features
        free,       ///< a plane has a gap over the whole motion, or until after the limit: no hit
        hit,        ///< `plane` gives way at `t`, and `point` is of the shape and of the triangle
    };
    Verdict verdict = Verdict::undecided;
    Plane plane{};
    double t = 0;
    Vec point;             ///< in the shape's frame, relative to `from`
    unsigned corners = 0;  ///< the feature (bits, canonical order)
};

/// For a ball that touches one edge or one corner at `from`: whether the motion goes deeper, to rounding.
[[nodiscard]] RoundFirst ask_touching_feature(const SweepQuery& query, const Sphere& sphere) noexcept;
[[nodiscard]] RoundFirst ask_touching_feature(const SweepQuery& query, const Ellipsoid& ellipsoid) noexcept;

/// `face`: what the triangle's own plane said.
[[nodiscard]] RoundFirst ask_round_first(const SweepQuery& query, const Sphere& sphere, const FaceFirst& face,
                                         double limit) noexcept;
[[nodiscard]] RoundFirst ask_round_first(const SweepQuery& query, const Ellipsoid& ellipsoid, const FaceFirst& face,
                                         double limit) noexcept;

[[nodiscard]] RoundFirst ask_round_first(const SweepQuery& query, const Capsule& capsule, const FaceFirst& face,
                                         double limit) noexcept;

}  // namespace surefoot::internal
