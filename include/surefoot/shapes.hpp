/// The six shapes a player can be, and the volume that a query moves: a shape with an orientation.
///
/// Each shape is described about its reference point, the point that a motion moves, with +Y as its own up. The
/// reference point is the centre, except for the cone, where it is the apex.
///
/// Limits, for every dimension below: [1e-6 m, 1e6 m], and the largest at most 1e4 times the smallest; only a capsule's
/// half_height may be as small as 0, which makes it a sphere. A query with a volume outside these limits is blocked and
/// says `invalid`.
#pragma once

#include <type_traits>
#include <variant>

#include <surefoot/math.hpp>

namespace [[gnu::visibility("default")]] surefoot {
inline namespace v0 {

/// A ball.
struct Sphere {
    double radius = 0.5;  ///< [m]
};

/// A ball stretched along its own three axes. The upright player: {0.4, 0.9, 0.4}.
struct Ellipsoid {
    dvec3 radii{0.4, 0.9, 0.4};  ///< half the extent along its own x, y and z [m]
};

/// A cylinder with a half ball on each end, standing along its own Y. Its whole height is 2 * (half_height + radius).
struct Capsule {
    double radius = 0.4;       ///< [m]
    double half_height = 0.5;  ///< half the straight part, caps not counted [m, may be 0]
};

/// A box, its faces square to its own axes.
struct Box {
    dvec3 half_extents{0.4, 0.9, 0.4};  ///< half the extent along its own x, y and z [m]
};

/// A round column with flat ends, standing along its own Y.
struct Cylinder {
    double radius = 0.4;       ///< [m]
    double half_height = 0.9;  ///< half its height [m]
};

/// A cone that stands on its apex, like a spinning top: the apex is the reference point and the flat disc is `height`
/// above it along its own Y.
struct Cone {
    double radius = 0.4;  ///< of the disc [m]
    double height = 1.8;  ///< from the apex up to the disc [m]
};

/// One of the six.
using Shape = std::variant<Sphere, Ellipsoid, Capsule, Box, Cylinder, Cone>;

/// One of the six types, or `Shape` itself.
template <typename T>
concept ShapeType = std::is_same_v<T, Sphere> || std::is_same_v<T, Ellipsoid> || std::is_same_v<T, Capsule> ||
    std::is_same_v<T, Box> || std::is_same_v<T, Cylinder> || std::is_same_v<T, Cone> || std::is_same_v<T, Shape>;

/// A shape with an orientation. Any of the six shapes converts to an upright volume by itself, so a query can be handed
/// a shape directly.
///
/// The orientation turns the shape's own axes into the world's. It need not have unit length: a quaternion q turns v
/// into exactly q v q* / |q|^2, so a hand-written {0.7, 0, 0.7, 0} is no error. A quaternion that is zero or not finite
/// is (every component within +-2^500, the largest at least 2^-500): a query with it is blocked and says `invalid`.
struct Volume {
    Shape shape;
    dquat orientation{1, 0, 0, 0};  ///< w, x, y, z

    constexpr Volume() noexcept = default;

    template <ShapeType AnyShape>
    constexpr Volume(const AnyShape& any_shape, const dquat& turned_by = dquat(1, 0, 0, 0)) noexcept
        : shape(any_shape), orientation(turned_by) {}
};

static_assert(std::is_trivially_copyable_v<Volume>);

/// Are the shape's dimensions and orientation within the limits above?
[[nodiscard]] bool is_valid(const Volume& volume) noexcept;

}  // namespace v0
}  // namespace surefoot
