#include "scene.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <type_traits>

namespace pictures {
namespace {

constexpr int outline_points = 144;

double turn(int step, int steps) {
    return 2 * std::numbers::pi * step / steps;
}

const Style outline{.stroke = colour::shape, .width = 1.8, .fill = colour::shape_fill, .opacity = 0.82};
const Style detail{.stroke = colour::shape, .width = 1.1, .opacity = 0.75};
const Style ghost_outline{.stroke = colour::shape, .width = 1.2, .dashed = true, .opacity = 0.6};

double sign(double s) {
    return s < 0 ? -1 : 1;
}

// A horizontal ring; only the part that faces the viewer unless `whole`.
void draw_ring(Canvas& canvas, const Camera& camera, const dvec3& centre, double radius_x, double radius_z,
               bool whole) {
    std::vector<Point> part;
    const auto flush = [&] {
        if (part.size() > 1) canvas.polyline(part, detail);
        part.clear();
    };
    // Start behind, so that the visible half is one piece.
    const double start = std::atan2(-camera.towards_viewer().z * radius_z, -camera.towards_viewer().x * radius_x);
    for (int i = 0; i <= outline_points; ++i) {
        const double angle = start + turn(i, outline_points);
        const dvec3 outward(std::cos(angle) / radius_x, 0, std::sin(angle) / radius_z);
        if (whole || dot(outward, camera.towards_viewer()) >= 0) {
            part.push_back(camera(centre + dvec3(radius_x * std::cos(angle), 0, radius_z * std::sin(angle))));
        } else {
            flush();
        }
    }
    flush();
}

void draw_box_edges(Canvas& canvas, const Camera& camera, const surefoot::Box& box, const dvec3& position) {
    const dvec3 half = box.half_extents;
    const dvec3 eye = camera.towards_viewer();
    // The corner nearest to the viewer, and the three edges that leave it.
    const dvec3 near(half.x * sign(eye.x), half.y * sign(eye.y), half.z * sign(eye.z));
    for (int axis = 0; axis < 3; ++axis) {
        dvec3 other = near;
        other[axis] = -other[axis];
        canvas.line(camera(position + near), camera(position + other), detail);
    }
}

}  // namespace

double dot(const dvec3& a, const dvec3& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
dvec3 cross(const dvec3& a, const dvec3& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
double length(const dvec3& a) {
    return std::sqrt(dot(a, a));
}
dvec3 unit(const dvec3& a) {
    return a / length(a);
}

Camera::Camera(double azimuth, double elevation, Point centre, double scale) : centre_(centre), scale_(scale) {
    const double a = azimuth * std::numbers::pi / 180;
    const double e = elevation * std::numbers::pi / 180;
    towards_viewer_ = {std::sin(a) * std::cos(e), std::sin(e), std::cos(a) * std::cos(e)};
    right_ = {std::cos(a), 0, -std::sin(a)};
    up_ = cross(towards_viewer_, right_);
}

Point Camera::operator()(const dvec3& p) const {
    return {centre_.x + scale_ * dot(right_, p), centre_.y - scale_ * dot(up_, p)};
}

dvec3 support_point(const surefoot::Shape& shape, const dvec3& direction) {
    const double sideways = std::sqrt(direction.x * direction.x + direction.z * direction.z);
    const dvec3 rim = sideways > 0 ? dvec3(direction.x / sideways, 0, direction.z / sideways) : dvec3(0);
    return std::visit(
        [&](const auto& kind) -> dvec3 {
            using Kind = std::decay_t<decltype(kind)>;
            if constexpr (std::is_same_v<Kind, surefoot::Sphere>) {
                return kind.radius * unit(direction);
            } else if constexpr (std::is_same_v<Kind, surefoot::Ellipsoid>) {
                const dvec3 squashed = kind.radii * direction;
                return kind.radii * unit(squashed);
            } else if constexpr (std::is_same_v<Kind, surefoot::Capsule>) {
                return dvec3(0, sign(direction.y) * kind.half_height, 0) + kind.radius * unit(direction);
            } else if constexpr (std::is_same_v<Kind, surefoot::Box>) {
                return {kind.half_extents.x * sign(direction.x), kind.half_extents.y * sign(direction.y),
                        kind.half_extents.z * sign(direction.z)};
            } else if constexpr (std::is_same_v<Kind, surefoot::Cylinder>) {
                return kind.radius * rim + dvec3(0, sign(direction.y) * kind.half_height, 0);
            } else {
                const dvec3 on_rim = kind.radius * rim + dvec3(0, kind.height, 0);
                return dot(on_rim, direction) > 0 ? on_rim : dvec3(0);
            }
        },
        shape);
}

std::vector<Point> hull(std::vector<Point> points) {
    std::sort(points.begin(), points.end(), [](Point a, Point b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
    std::vector<Point> chain;
    const auto turns_left = [](Point a, Point b, Point c) {
        return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x) > 1e-9;
    };
    for (int pass = 0; pass < 2; ++pass) {
        const std::size_t begin = chain.size();
        for (const Point& p : points) {
            while (chain.size() >= begin + 2 && !turns_left(chain[chain.size() - 2], chain.back(), p)) chain.pop_back();
            chain.push_back(p);
        }
        chain.pop_back();
        std::reverse(points.begin(), points.end());
    }
    return chain;
}

void draw_triangle(Canvas& canvas, const Camera& camera, const surefoot::Triangle& triangle) {
    const Point corners[] = {camera(triangle.a), camera(triangle.b), camera(triangle.c)};
    canvas.polygon(corners, {.stroke = colour::ground, .width = 1.8, .fill = colour::ground_fill});
}

void draw_shape(Canvas& canvas, const Camera& camera, const surefoot::Shape& shape, const dvec3& position, bool ghost) {
    std::vector<Point> points;
    for (int i = 0; i < outline_points; ++i) {
        const double angle = turn(i, outline_points) + 1e-3;  // no tie between two corners of a box
        const dvec3 direction = camera.right() * std::cos(angle) + camera.up() * std::sin(angle);
        points.push_back(camera(position + support_point(shape, direction)));
    }
    canvas.polygon(hull(points), ghost ? ghost_outline : outline);
    if (ghost) return;
    std::visit(
        [&](const auto& kind) {
            using Kind = std::decay_t<decltype(kind)>;
            const auto up = [&](double height) { return position + dvec3(0, height, 0); };
            if constexpr (std::is_same_v<Kind, surefoot::Sphere>) {
                draw_ring(canvas, camera, position, kind.radius, kind.radius, false);
            } else if constexpr (std::is_same_v<Kind, surefoot::Ellipsoid>) {
                draw_ring(canvas, camera, position, kind.radii.x, kind.radii.z, false);
            } else if constexpr (std::is_same_v<Kind, surefoot::Capsule>) {
                draw_ring(canvas, camera, up(kind.half_height), kind.radius, kind.radius, false);
                draw_ring(canvas, camera, up(-kind.half_height), kind.radius, kind.radius, false);
            } else if constexpr (std::is_same_v<Kind, surefoot::Box>) {
                draw_box_edges(canvas, camera, kind, position);
            } else if constexpr (std::is_same_v<Kind, surefoot::Cylinder>) {
                draw_ring(canvas, camera, up(kind.half_height), kind.radius, kind.radius,
                          camera.towards_viewer().y > 0);
                draw_ring(canvas, camera, up(-kind.half_height), kind.radius, kind.radius,
                          camera.towards_viewer().y < 0);
            } else {
                draw_ring(canvas, camera, up(kind.height), kind.radius, kind.radius, camera.towards_viewer().y > 0);
            }
        },
        shape);
}

void draw_touch(Canvas& canvas, const Camera& camera, const surefoot::Hit& hit, double normal_length) {
    canvas.arrow(camera(hit.point), camera(hit.point + normal_length * hit.normal),
                 {.stroke = colour::touch, .width = 2});
    canvas.dot(camera(hit.point), colour::touch, 4.5);
}

}  // namespace pictures
