/// The question that the debugger is about: a shape, where it starts, where it would like to be, and in which world.
/// A plain value; everything else that the room shows is computed from it.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <surefoot/math.hpp>
#include <surefoot/shapes.hpp>

namespace surefoot::debugger {

/// The six shapes, in the order of `Shape`.
enum class ShapeName : std::uint8_t { sphere, ellipsoid, capsule, box, cylinder, cone };

/// Of all six, so that switching to another shape and back changes nothing.
struct ShapeSizes {
    Sphere sphere{.radius = 0.8};
    Ellipsoid ellipsoid{.radii = {0.8, 1.4, 0.8}};
    Capsule capsule{.radius = 0.8, .half_height = 0.6};
    Box box{.half_extents = {0.8, 1.4, 0.8}};
    Cylinder cylinder{.radius = 0.8, .half_height = 1.4};
    Cone cone{.radius = 0.8, .height = 2.8};

    [[nodiscard]] Shape get(ShapeName name) const;
    /// Keeps the sizes of the shape that `shape` is, and leaves those of the others.
    void set(const Shape& shape);
};

[[nodiscard]] ShapeName name_of(const Shape& shape);

enum class WorldKind : std::uint8_t {
    triangle,  ///< one triangle
    fold,      ///< two that meet in an edge, as the walls of a roof do
    wedge,     ///< one that stands over the far edge of the first and leans over it
    own,       ///< a few triangles that came with a pasted question
    level,     ///< a level, named by its file
};

struct Question {
    WorldKind world = WorldKind::triangle;
    std::vector<Triangle> triangles;  ///< of the world; none for a level
    std::string level;                ///< its file; empty for a few triangles
    std::uint32_t opened = 0;         ///< tells levels apart that were opened from one file, which may have changed
    Motion motion;                    ///< START and END
    ShapeName shape = ShapeName::ellipsoid;
    ShapeSizes sizes;
    dquat orientation{1, 0, 0, 0};
    bool one_sided = false;

    [[nodiscard]] Volume volume() const { return {sizes.get(shape), orientation}; }
};

[[nodiscard]] bool operator==(const Question& a, const Question& b);

/// Something to tell about a question.
struct Remark {
    bool refused = false;  ///< the library answers `invalid`; else it is only something to know
    std::string text;      ///< a sentence
};

/// What is wrong with a question, and what is odd about it.
[[nodiscard]] std::vector<Remark> remarks(const Question& question);

/// The nearest point whose coordinates are multiples of `step` [m]; the point itself if `step` is not above 0.
[[nodiscard]] dvec3 snapped(const dvec3& point, double step);

/// The corners of a triangle by number: 0 is a, 1 is b, 2 is c.
[[nodiscard]] std::array<dvec3, 3> corners_of(const Triangle& triangle);
[[nodiscard]] dvec3& corner_of(Triangle& triangle, std::size_t corner);

}  // namespace surefoot::debugger
