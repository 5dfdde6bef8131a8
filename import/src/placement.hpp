/// From the file's units and axes to metres with +Y up. Turning is a swap of axes with a change of sign, so it is
/// exact; scaling rounds once, from double to float.
#pragma once

#include <surefoot/import.hpp>

namespace surefoot::internal {

struct Placement {
    double scale = 1;
    UpAxis up = UpAxis::y;  ///< not by_format: whoever knows the format has decided

    /// A direction or a place, turned and not scaled.
    [[nodiscard]] dvec3 turned(const dvec3& v) const noexcept {
        switch (up) {
            case UpAxis::x:
                return {-v.y, v.x, v.z};
            case UpAxis::z:
                return {v.x, v.z, -v.y};
            case UpAxis::y:
            case UpAxis::by_format:
                break;
        }
        return v;
    }

    [[nodiscard]] dvec3 position(const dvec3& v) const noexcept {
        const dvec3 t = turned(v);
        return {t.x * scale, t.y * scale, t.z * scale};
    }

    [[nodiscard]] vec3 vertex(const dvec3& v) const noexcept {
        const dvec3 p = position(v);
        return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
    }

    /// The orientation of something whose own axes are turned the same way: the axis of rotation turns along.
    [[nodiscard]] dquat orientation(const dquat& q) const noexcept {
        const dvec3 axis = turned({q.x, q.y, q.z});
        return {q.w, axis.x, axis.y, axis.z};
    }

    /// Factors along a thing's own axes: these swap, and have no sign to change.
    [[nodiscard]] dvec3 factors(const dvec3& s) const noexcept {
        switch (up) {
            case UpAxis::x:
                return {s.y, s.x, s.z};
            case UpAxis::z:
                return {s.x, s.z, s.y};
            case UpAxis::y:
            case UpAxis::by_format:
                break;
        }
        return s;
    }
};

}  // namespace surefoot::internal
