/// Where a picture is taken from.
#pragma once

#include <optional>
#include <span>

#include <surefoot/mesh.hpp>

namespace surefoot::tools {

/// A point of the picture, and how far it is from the eye along the line of sight.
struct Projected {
    double x;      ///< [pixels from the left]
    double y;      ///< [pixels from the top]
    double depth;  ///< [m]
};

struct Camera {
    dvec3 eye{0, 0, 0};
    dvec3 forward{0, 0, -1};
    dvec3 right{1, 0, 0};
    dvec3 up{0, 1, 0};
    double tan_half = 0.3;   ///< of half the angle from the middle to the upper border
    double ceiling = 1e300;  ///< what is higher is cut away, so that one can see into a house [m]
    int width = 1280;
    int height = 800;

    /// How far along this unit direction sight begins: at the eye, or below the ceiling [m].
    [[nodiscard]] double sight_begins(const dvec3& unit_direction) const;

    /// The unit direction through a point of the picture [pixels].
    [[nodiscard]] dvec3 direction(double x, double y) const;

    /// None for what is not in front of the eye.
    [[nodiscard]] std::optional<Projected> project(const dvec3& point) const;

    /// How large a pixel is at this distance [m].
    [[nodiscard]] double footprint(double distance) const { return 2 * tan_half * distance / height; }
};

struct CameraWish {
    std::span<const dvec3> frame;     ///< points that must be in the picture
    std::span<const dvec3> see;       ///< points that should not be hidden, as many as possible
    std::span<const dvec3> across;    ///< unit directions to be seen from the side, so that their lengths show
    std::span<const double> pitches;  ///< from the horizon down [degrees]
    double margin = 0.14;             ///< left free on each side, as a share of the picture
    bool one_sided = false;           ///< the level is looked at through the backs of its triangles
    int width = 1280;
    int height = 800;
};

/// Looks down at the points from the side from which most of them are seen; where a house hides them from all sides,
/// its upper part is cut away.
[[nodiscard]] Camera choose_camera(const Mesh& mesh, const CameraWish& wish);

}  // namespace surefoot::tools
