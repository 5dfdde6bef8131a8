#include "view/signs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>
#include <span>

namespace surefoot::view {
namespace {

using glm::dvec2;

double disc(const dvec2& p, const dvec2& middle, double radius) {
    return glm::length(p - middle) - radius;
}

double ring(const dvec2& p, const dvec2& middle, double radius, double width) {
    return std::abs(disc(p, middle, radius)) - width / 2;
}

double box(const dvec2& p, const dvec2& middle, const dvec2& half, double radius) {
    const dvec2 q = glm::abs(p - middle) - half + radius;
    return glm::length(glm::max(q, dvec2(0))) + std::min(std::max(q.x, q.y), 0.0) - radius;
}

double bar(const dvec2& p, const dvec2& from, const dvec2& to, double width) {
    const dvec2 along = to - from;
    const double share = std::clamp(glm::dot(p - from, along) / glm::dot(along, along), 0.0, 1.0);
    return glm::length(p - from - along * share) - width / 2;
}

/// Distance to the edges, negative where their crossings to one side are odd in number.
double polygon(const dvec2& p, std::span<const dvec2> corners) {
    double nearest = 1e9;
    bool inside = false;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const dvec2 a = corners[i];
        const dvec2 b = corners[(i + 1) % corners.size()];
        nearest = std::min(nearest, bar(p, a, b, 0));
        if ((a.y > p.y) != (b.y > p.y) && p.x < (b.x - a.x) * (p.y - a.y) / (b.y - a.y) + a.x) inside = !inside;
    }
    return inside ? -nearest : nearest;
}

double without(double shape, double hole) {
    return std::max(shape, -hole);
}

double star(const dvec2& p, double outer, double inner) {
    std::array<dvec2, 10> corners;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const double angle = double(i) * std::numbers::pi / 5;
        corners[i] = dvec2(std::sin(angle), -std::cos(angle)) * (i % 2 == 0 ? outer : inner) + dvec2(0, 0.06);
    }
    return polygon(p, corners) - 0.08;
}

double heart(const dvec2& p) {
    constexpr double r = 0.5;
    const double lobes = std::min(disc(p, {-0.46, -0.34}, r), disc(p, {0.46, -0.34}, r));
    const std::array corners{dvec2(-0.84, -0.02), dvec2(0, -0.36), dvec2(0.84, -0.02), dvec2(0, 0.9)};
    return std::min(lobes, polygon(p, corners));
}

double key(const dvec2& p) {
    const double bow = without(disc(p, {-0.5, 0}, 0.46), disc(p, {-0.5, 0}, 0.2));
    const double blade = bar(p, {-0.1, 0}, {0.86, 0}, 0.24);
    const double teeth = std::min(bar(p, {0.84, 0}, {0.84, 0.34}, 0.22), bar(p, {0.46, 0}, {0.46, 0.28}, 0.2));
    return std::min({bow, blade, teeth});
}

double clock(const dvec2& p) {
    return std::min({ring(p, {0, 0}, 0.8, 0.24), bar(p, {0, 0}, {0, -0.48}, 0.2), bar(p, {0, 0}, {0.36, 0.2}, 0.2)});
}

double skull(const dvec2& p) {
    const double head = std::min(disc(p, {0, -0.18}, 0.74), box(p, {0, 0.6}, {0.42, 0.34}, 0.12));
    const double eyes = std::min(disc(p, {-0.32, -0.1}, 0.22), disc(p, {0.32, -0.1}, 0.22));
    const double gaps = std::min(bar(p, {-0.15, 0.68}, {-0.15, 1.1}, 0.12), bar(p, {0.15, 0.68}, {0.15, 1.1}, 0.12));
    return without(head, std::min(eyes, gaps));
}

double flag(const dvec2& p) {
    const std::array cloth{dvec2(-0.5, -0.84), dvec2(0.8, -0.44), dvec2(-0.5, 0.02)};
    return std::min(bar(p, {-0.6, -0.85}, {-0.6, 0.88}, 0.22), polygon(p, cloth) - 0.05);
}

/// Light that rises in a gate.
double beam(const dvec2& p) {
    const double posts = std::min(bar(p, {-0.68, -0.6}, {-0.68, 0.84}, 0.24), bar(p, {0.68, -0.6}, {0.68, 0.84}, 0.24));
    return std::min({posts, bar(p, {-0.84, -0.7}, {0.84, -0.7}, 0.26), bar(p, {0, -0.22}, {0, 0.84}, 0.34)});
}

double gamepad(const dvec2& p) {
    const double body = std::min({box(p, {0, -0.06}, {0.86, 0.44}, 0.4), bar(p, {-0.66, 0.1}, {-0.74, 0.46}, 0.44),
                                  bar(p, {0.66, 0.1}, {0.74, 0.46}, 0.44)});
    const double cross =
        std::min(bar(p, {-0.6, -0.1}, {-0.26, -0.1}, 0.13), bar(p, {-0.43, -0.27}, {-0.43, 0.07}, 0.13));
    return without(body, std::min({cross, disc(p, {0.56, -0.2}, 0.11), disc(p, {0.34, 0.02}, 0.11)}));
}

double keyboard(const dvec2& p) {
    double keys = bar(p, {-0.36, 0.26}, {0.36, 0.26}, 0.16);
    for (const double x : {-0.6, -0.2, 0.2, 0.6}) keys = std::min(keys, box(p, {x, -0.14}, {0.11, 0.11}, 0.03));
    return without(box(p, {0, 0.03}, {0.94, 0.58}, 0.16), keys);
}

double mouse(const dvec2& p) {
    return without(box(p, {0, 0}, {0.56, 0.88}, 0.54),
                   std::min(bar(p, {0, -0.58}, {0, -0.3}, 0.2), bar(p, {-0.7, -0.08}, {0.7, -0.08}, 0.1)));
}

double lock(const dvec2& p) {
    const double bow = std::max(ring(p, {0, -0.3}, 0.42, 0.22), p.y + 0.1);
    return std::min(bow, without(box(p, {0, 0.36}, {0.68, 0.5}, 0.14),
                                 std::min(disc(p, {0, 0.28}, 0.14), bar(p, {0, 0.3}, {0, 0.56}, 0.13))));
}

double medal(const dvec2& p) {
    const std::array left{dvec2(-0.62, -0.95), dvec2(-0.18, -0.95), dvec2(0.2, -0.1), dvec2(-0.2, -0.1)};
    const std::array right{dvec2(0.62, -0.95), dvec2(0.18, -0.95), dvec2(-0.2, -0.1), dvec2(0.2, -0.1)};
    return std::min({polygon(p, left), polygon(p, right), disc(p, {0, 0.36}, 0.58)});
}

double ghost(const dvec2& p) {
    const double body = std::min(disc(p, {0, -0.24}, 0.68), box(p, {0, 0.3}, {0.68, 0.54}, 0));
    double hem = 1e9;
    for (const double x : {-0.46, 0.0, 0.46}) hem = std::min(hem, disc(p, {x, 0.96}, 0.21));
    return without(body, std::min({hem, disc(p, {-0.24, -0.24}, 0.15), disc(p, {0.24, -0.24}, 0.15)}));
}

double enemy(const dvec2& p) {
    const std::array left{dvec2(-0.86, -0.9), dvec2(-0.2, -0.56), dvec2(-0.66, -0.2)};
    const std::array right{dvec2(0.86, -0.9), dvec2(0.2, -0.56), dvec2(0.66, -0.2)};
    const double head = std::min({disc(p, {0, 0.12}, 0.72), polygon(p, left), polygon(p, right)});
    return without(head,
                   std::min(bar(p, {-0.44, -0.14}, {-0.16, 0.04}, 0.2), bar(p, {0.44, -0.14}, {0.16, 0.04}, 0.2)));
}

double arrow(const dvec2& p) {
    const std::array corners{dvec2(0, -0.8), dvec2(0.7, 0.72), dvec2(0, 0.4), dvec2(-0.7, 0.72)};
    return polygon(p, corners) - 0.08;
}

double play(const dvec2& p) {
    const std::array corners{dvec2(-0.5, -0.7), dvec2(0.74, 0), dvec2(-0.5, 0.7)};
    return polygon(p, corners) - 0.12;
}

}  // namespace

double distance_to(Sign sign, const dvec2& p) {
    switch (sign) {
        case Sign::heart:
            return heart(p);
        case Sign::coin:
            return std::min(ring(p, {0, 0}, 0.78, 0.24), box(p, {0, 0}, {0.15, 0.38}, 0.12));
        case Sign::star:
            return star(p, 0.9, 0.42);
        case Sign::key:
            return key(p);
        case Sign::clock:
            return clock(p);
        case Sign::skull:
            return skull(p);
        case Sign::flag:
            return flag(p);
        case Sign::gamepad:
            return gamepad(p);
        case Sign::keyboard:
            return keyboard(p);
        case Sign::mouse:
            return mouse(p);
        case Sign::lock:
            return lock(p);
        case Sign::door:
            return without(box(p, {0, 0}, {0.6, 0.9}, 0.1), disc(p, {0.3, 0.06}, 0.13));
        case Sign::arrow:
            return arrow(p);
        case Sign::check:
            return std::min(bar(p, {-0.7, 0.1}, {-0.2, 0.58}, 0.3), bar(p, {-0.2, 0.58}, {0.74, -0.5}, 0.3));
        case Sign::medal:
            return medal(p);
        case Sign::ghost:
            return ghost(p);
        case Sign::play:
            return play(p);
        case Sign::enemy:
            return enemy(p);
        case Sign::beam:
            return beam(p);
        case Sign::count:
            break;
    }
    return 1;
}

}  // namespace surefoot::view
