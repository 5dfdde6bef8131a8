// Fans where a fan is right, else ear clipping (G. H. Meisters, "Polygons have ears", 1975), seen along the polygon's
// Newell normal (M. E. Newell; in Sutherland, Sproull, Schumacker, 1974), which is twice its area for a flat one.
#include "polygon.hpp"

#include <algorithm>
#include <cmath>

namespace surefoot::internal {
namespace {

dvec3 widened(const vec3& v) {
    return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

dvec3 minus(const dvec3& a, const dvec3& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}

dvec3 cross_product(const dvec3& a, const dvec3& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

double dot_product(const dvec3& a, const dvec3& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

struct Polygon {
    std::span<const vec3> corners;
    dvec3 normal{0, 0, 0};

    explicit Polygon(std::span<const vec3> all) : corners(all) {
        // Relative to corner 0, so that a polygon far from the origin keeps its digits.
        for (std::size_t i = 1; i + 1 < all.size(); ++i) {
            const dvec3 n = cross_product(minus(at(i), at(0)), minus(at(i + 1), at(0)));
            normal = {normal.x + n.x, normal.y + n.y, normal.z + n.z};
        }
    }

    [[nodiscard]] dvec3 at(std::size_t i) const { return widened(corners[i]); }

    /// Positive when the corners turn the polygon's way.
    [[nodiscard]] double turn(std::size_t a, std::size_t b, std::size_t c) const {
        return dot_product(cross_product(minus(at(b), at(a)), minus(at(c), at(a))), normal);
    }

    /// Inside or on the border.
    [[nodiscard]] bool holds(std::size_t a, std::size_t b, std::size_t c, std::size_t p) const {
        return turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
    }
};

/// Floats round a straight row of corners into one that turns back a little; a millionth of the polygon's area passes.
double slack_of(const Polygon& polygon) {
    return 1e-6 * dot_product(polygon.normal, polygon.normal);
}

bool is_fan(const Polygon& polygon) {
    const double least = -slack_of(polygon);
    for (std::size_t i = 1; i + 1 < polygon.corners.size(); ++i) {
        if (polygon.turn(0, i, i + 1) < least) return false;
    }
    return true;
}

void append(std::vector<std::uint32_t>& triangles, std::size_t a, std::size_t b, std::size_t c) {
    triangles.push_back(static_cast<std::uint32_t>(a));
    triangles.push_back(static_cast<std::uint32_t>(b));
    triangles.push_back(static_cast<std::uint32_t>(c));
}

void append_fan(std::vector<std::uint32_t>& triangles, std::span<const std::uint32_t> ring) {
    for (std::size_t i = 1; i + 1 < ring.size(); ++i) append(triangles, ring[0], ring[i], ring[i + 1]);
}

/// `place` is a position in the ring of corners that are left.
bool is_ear(const Polygon& polygon, const std::vector<std::uint32_t>& ring, std::size_t place) {
    const std::size_t n = ring.size();
    const std::uint32_t a = ring[(place + n - 1) % n];
    const std::uint32_t b = ring[place];
    const std::uint32_t c = ring[(place + 1) % n];
    if (polygon.turn(a, b, c) <= 0) return false;
    return std::ranges::none_of(ring, [&](std::uint32_t p) {
        const vec3& corner = polygon.corners[p];
        // A corner at the same place as one of the ear's does not block it: such is the bridge to a hole.
        if (corner == polygon.corners[a] || corner == polygon.corners[b] || corner == polygon.corners[c]) return false;
        return polygon.holds(a, b, c, p);
    });
}

/// What is left has no area worth the name: corners in a row, which no ear can take.
bool is_flat(const Polygon& polygon, const std::vector<std::uint32_t>& ring) {
    const double slack = slack_of(polygon);
    for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
        if (std::abs(polygon.turn(ring[0], ring[i], ring[i + 1])) > slack) return false;
    }
    return true;
}

PolygonCut clip_ears(const Polygon& polygon, Deadline deadline, std::vector<std::uint32_t>& triangles) {
    std::vector<std::uint32_t> ring(polygon.corners.size());
    for (std::size_t i = 0; i < ring.size(); ++i) ring[i] = static_cast<std::uint32_t>(i);

    std::size_t place = 1;
    std::size_t refused = 0;
    while (ring.size() > 3) {
        const std::size_t n = ring.size();
        if (std::chrono::steady_clock::now() > deadline) return PolygonCut::timed_out;
        if (refused == n) {
            append_fan(triangles, ring);
            return is_flat(polygon, ring) ? PolygonCut::ears : PolygonCut::crossed;
        }
        place %= n;
        if (is_ear(polygon, ring, place)) {
            append(triangles, ring[(place + n - 1) % n], ring[place], ring[(place + 1) % n]);
            ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(place));
            refused = 0;
        } else {
            ++place;
            ++refused;
        }
    }
    append_fan(triangles, ring);
    return PolygonCut::ears;
}

}  // namespace

PolygonCut cut_polygon(std::span<const vec3> corners, Deadline deadline, std::vector<std::uint32_t>& triangles) {
    triangles.clear();
    const Polygon polygon(corners);
    if (corners.size() > 3 && !is_fan(polygon)) return clip_ears(polygon, deadline, triangles);
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) append(triangles, 0, i, i + 1);
    return PolygonCut::fan;
}

bool is_degenerate(const vec3& a, const vec3& b, const vec3& c) noexcept {
    const dvec3 n = cross_product(minus(widened(b), widened(a)), minus(widened(c), widened(a)));
    return n.x == 0 && n.y == 0 && n.z == 0;
}

}  // namespace surefoot::internal
