// A body's pose at one moment, ready to carry points between the world and the body. A body at the origin that is not
// turned carries every number unchanged, zeros with their signs included.
#pragma once

#include <surefoot/pose.hpp>

#include "frame.hpp"
#include "quat.hpp"

namespace surefoot::internal {

/// How much a pose may round, as a share of the distance to the body's origin (by the 1-norm) and of the volume's size.
/// The difference costs 1 unit of 2^-53, a matrix good to 5 and a dot product of 3 come to 16 for the length of the
/// vector, and the product of two quaternions turns the volume by 16 units at most. 2^-46 is eight times that.
inline constexpr double pose_rounding = 0x1p-46;

/// A point or direction carried into a body, and whether anything was rounded.
struct CarriedPoint {
    Vec point;
    bool exact = true;
};

class Stance {
public:
    Stance(const Vec& position, const Quat& turned) noexcept
        : position_(position),
          turned_(turned),
          frame_(to_dquat(turned)),
          upright_(turned.v == Vec{}),
          at_origin_(position == Vec{}) {}

    /// From a difference in the world that has been made already.
    [[nodiscard]] Vec direction_to_body(const Vec& v) const noexcept { return frame_.to_local(v); }
    [[nodiscard]] Vec direction_to_world(const Vec& v) const noexcept { return frame_.to_world(v); }

    [[nodiscard]] CarriedPoint to_body(const Vec& place) const noexcept {
        if (at_origin_) return {frame_.to_local(place), upright_};
        const auto is_exact = [](double a, double b) noexcept { return two_sum(a, -b).low == 0; };
        const bool exact = upright_ && is_exact(place.x, position_.x) && is_exact(place.y, position_.y) &&
                           is_exact(place.z, position_.z);
        return {frame_.to_local(place - position_), exact};
    }
    [[nodiscard]] Vec to_world(const Vec& point) const noexcept {
        const Vec turned = frame_.to_world(point);
        return at_origin_ ? turned : position_ + turned;
    }

    /// A volume's orientation as the body sees it.
    [[nodiscard]] dquat orientation_in_body(const dquat& orientation) const noexcept {
        return upright_ ? orientation : to_dquat(product(conjugate(turned_), scaled_to_one(orientation)));
    }
    [[nodiscard]] bool is_upright() const noexcept { return upright_; }
    /// Are the body's coordinates the world's?
    [[nodiscard]] bool is_identity() const noexcept { return upright_ && at_origin_; }

private:
    Vec position_;
    Quat turned_;
    Frame frame_;
    bool upright_;
    bool at_origin_;
};

}  // namespace surefoot::internal
