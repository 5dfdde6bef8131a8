// Shapes and triangles in space, drawn on the sheet: a camera without perspective, and outlines by support points.
#pragma once

#include <string_view>
#include <vector>

#include <surefoot/hit.hpp>
#include <surefoot/math.hpp>
#include <surefoot/shapes.hpp>

#include "canvas.hpp"

namespace pictures {

using surefoot::dvec3;

double dot(const dvec3& a, const dvec3& b);
dvec3 cross(const dvec3& a, const dvec3& b);
double length(const dvec3& a);
dvec3 unit(const dvec3& a);

// Looks from `azimuth` degrees around +Y and `elevation` degrees above the ground.
class Camera {
public:
    Camera(double azimuth, double elevation, Point centre, double scale);

    [[nodiscard]] Point operator()(const dvec3& p) const;
    [[nodiscard]] const dvec3& right() const { return right_; }
    [[nodiscard]] const dvec3& up() const { return up_; }
    [[nodiscard]] const dvec3& towards_viewer() const { return towards_viewer_; }

private:
    dvec3 right_;
    dvec3 up_;
    dvec3 towards_viewer_;
    Point centre_;
    double scale_;
};

// The point of an upright shape, about its reference point, that lies furthest along `direction`.
dvec3 support_point(const surefoot::Shape& shape, const dvec3& direction);

// The smallest convex outline around the points, in order.
std::vector<Point> hull(std::vector<Point> points);

void draw_triangle(Canvas& canvas, const Camera& camera, const surefoot::Triangle& triangle);

// An upright shape: its outline, and the lines that tell what it is.
void draw_shape(Canvas& canvas, const Camera& camera, const surefoot::Shape& shape, const dvec3& position,
                bool ghost = false);

// The point of touch and the normal there.
void draw_touch(Canvas& canvas, const Camera& camera, const surefoot::Hit& hit, double normal_length);

}  // namespace pictures
