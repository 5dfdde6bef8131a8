// Carrying a query into the frame of its shape: the reference point at `from` becomes the origin, the shape's own axes
// become x, y, z. Differences first, rotation second, so that a level far from the origin keeps its digits.
#pragma once

#include "exact/products.hpp"
#include "vec.hpp"

namespace surefoot::internal {

/// The rotation of a quaternion of any length but zero, in doubles: rows are the shape's axes in the world.
class Frame {
public:
    explicit Frame(const dquat& orientation) noexcept {
        const double scale =
            power_of_two_of(larger(largest({orientation.x, orientation.y, orientation.z}), absolute(orientation.w)));
        if (!(scale > 0)) return;
        const double x = orientation.x / scale;
        const double y = orientation.y / scale;
        const double z = orientation.z / scale;
        const double w = orientation.w / scale;
        if (x == 0 && y == 0 && z == 0) return;
        const double squared = x * x + y * y + z * z + w * w;
        x_axis_ = Vec{w * w + x * x - y * y - z * z, 2 * (x * y + w * z), 2 * (x * z - w * y)} / squared;
        y_axis_ = Vec{2 * (x * y - w * z), w * w - x * x + y * y - z * z, 2 * (y * z + w * x)} / squared;
        z_axis_ = Vec{2 * (x * z + w * y), 2 * (y * z - w * x), w * w - x * x - y * y + z * z} / squared;
        upright_ = false;
    }

    /// Are the shape's axes exactly the world's?
    [[nodiscard]] bool is_upright() const noexcept { return upright_; }

    /// A direction or difference of the world, seen by the shape.
    [[nodiscard]] Vec to_local(const Vec& world) const noexcept {
        if (upright_) return world;
        return {dot(x_axis_, world), dot(y_axis_, world), dot(z_axis_, world)};
    }

    /// A direction or difference of the shape's frame, seen by the world.
    [[nodiscard]] Vec to_world(const Vec& local) const noexcept {
        if (upright_) return local;
        return x_axis_ * local.x + y_axis_ * local.y + z_axis_ * local.z;
    }

private:
    Vec x_axis_{1, 0, 0};
    Vec y_axis_{0, 1, 0};
    Vec z_axis_{0, 0, 1};
    bool upright_ = true;
};

}  // namespace surefoot::internal
