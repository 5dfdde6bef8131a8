#include "character/separation.hpp"

#include "overloaded.hpp"
#include "sweep/query.hpp"

namespace surefoot::internal {

namespace {

struct Extents {
    Vec half;        // half the extents along the shape's own axes
    double middle;   // where the middle of them is, along its own y
    bool has_sides;  // flat sides across its own axes
};

Extents extents_of(const Shape& shape) noexcept {
    return std::visit(Overloaded{
                          [](const Sphere& s) {
                              return Extents{Vec{s.radius, s.radius, s.radius}, 0, false};
                          },
                          [](const Ellipsoid& e) {
                              return Extents{to_vec(e.radii), 0, false};
                          },
                          [](const Capsule& c) {
                              return Extents{Vec{c.radius, c.radius + c.half_height, c.radius}, 0, false};
                          },
                          [](const Box& b) {
                              return Extents{to_vec(b.half_extents), 0, true};
                          },
                          [](const Cylinder& c) {
                              return Extents{Vec{c.radius, c.half_height, c.radius}, 0, true};
                          },
                          [](const Cone& c) {
                              return Extents{Vec{c.radius, 0.5 * c.height, c.radius}, 0.5 * c.height, true};
                          },
                      },
                      shape);
}

// The point of the triangle nearest to the origin (Ericson, "Real-Time Collision Detection", 5.1.5). In doubles: it
// only proposes a plane.
Vec nearest_to_origin(const Vec& a, const Vec& b, const Vec& c) noexcept {
    const Vec ab = b - a;
    const Vec ac = c - a;
    const double d1 = -dot(ab, a);
    const double d2 = -dot(ac, a);
    if (d1 <= 0 && d2 <= 0) return a;
    const double d3 = -dot(ab, b);
    const double d4 = -dot(ac, b);
    if (d3 >= 0 && d4 <= d3) return b;
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0) return a + ab * (d1 / (d1 - d3));
    const double d5 = -dot(ab, c);
    const double d6 = -dot(ac, c);
    if (d6 >= 0 && d5 <= d6) return c;
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0 && d2 >= 0 && d6 <= 0) return a + ac * (d2 / (d2 - d6));
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) return b + (c - b) * ((d4 - d3) / ((d4 - d3) + (d5 - d6)));
    const double sum = va + vb + vc;
    if (!(sum > 0)) return a;
    return a + ab * (vb / sum) + ac * (vc / sum);
}

class Widest {
public:
    Widest(const Shape& shape, const Vec (&corners)[3]) noexcept : shape_(shape), corners_(corners) {}

    void offer(const Vec& direction) noexcept {
        const double size = length(direction);
        if (!(size > 0)) return;
        const Vec normal = direction / size;
        const double behind =
            larger(dot(normal, corners_[0]), larger(dot(normal, corners_[1]), dot(normal, corners_[2])));
        const double gap = -behind - reach_against(shape_, normal);
        if (gap <= best_.gap && found_) return;
        best_ = {normal, gap};
        found_ = true;
    }
    [[nodiscard]] const Separation& get() const noexcept { return best_; }
    [[nodiscard]] bool found() const noexcept { return found_; }

private:
    const Shape& shape_;
    const Vec (&corners_)[3];
    Separation best_;
    bool found_ = false;
};

}  // namespace

Separator::Separator(const Shape& shape, const Frame& frame, const Vec& place) noexcept
    : shape_(shape), frame_(frame), place_(place) {
    const Extents extents = extents_of(shape);
    half_ = extents.half;
    per_half_ = divide_each({1, 1, 1}, half_);
    middle_ = extents.middle;
    has_sides_ = extents.has_sides;
    is_ball_ = std::holds_alternative<Sphere>(shape) || std::holds_alternative<Ellipsoid>(shape);
}

Separation Separator::from_ball(const Triangle& triangle) const noexcept {
    const auto squashed = [&](const dvec3& corner) noexcept {
        return multiply_each(frame_.to_local(to_vec(corner) - place_), per_half_);
    };
    const Vec a = squashed(triangle.a);
    const Vec b = squashed(triangle.b);
    const Vec c = squashed(triangle.c);
    const Vec nearest = nearest_to_origin(a, b, c);
    const double distance = length(nearest);
    if (!(distance > 0)) return {{}, -1};
    // What rounding did to the nearest point only tilts the plane: it is pushed against the triangle all the same.
    const Vec towards = nearest / distance;
    const double ahead = smaller(dot(towards, a), smaller(dot(towards, b), dot(towards, c)));
    const Vec stretched = multiply_each(towards, per_half_);
    const double scale = length(stretched);
    return {frame_.to_world(stretched / -scale), (ahead - 1) / scale};
}

Separation Separator::from(const Triangle& triangle) const noexcept {
    if (is_ball_) return from_ball(triangle);
    const Vec corners[3] = {frame_.to_local(to_vec(triangle.a) - place_), frame_.to_local(to_vec(triangle.b) - place_),
                            frame_.to_local(to_vec(triangle.c) - place_)};
    const Vec middle{0, middle_, 0};
    const Vec nearest =
        nearest_to_origin(multiply_each(corners[0] - middle, per_half_), multiply_each(corners[1] - middle, per_half_),
                          multiply_each(corners[2] - middle, per_half_));
    Widest widest(shape_, corners);
    widest.offer(-multiply_each(nearest, per_half_));
    const Vec face = cross(corners[1] - corners[0], corners[2] - corners[0]);
    widest.offer(dot(face, middle - corners[0]) < 0 ? -face : face);
    if (has_sides_) {
        const Vec size{absolute(nearest.x), absolute(nearest.y), absolute(nearest.z)};
        if (size.y >= size.x && size.y >= size.z) {
            widest.offer({0, nearest.y > 0 ? -1.0 : 1.0, 0});
        } else if (size.x >= size.z) {
            widest.offer({nearest.x > 0 ? -1.0 : 1.0, 0, 0});
        } else {
            widest.offer({0, 0, nearest.z > 0 ? -1.0 : 1.0});
        }
    }
    if (!widest.found()) return {{}, -1};
    return {frame_.to_world(widest.get().normal), widest.get().gap};
}

}  // namespace surefoot::internal
