// Gilbert, Johnson, Keerthi, A fast procedure for computing the distance between complex objects in three-dimensional
// space (1988). Which part of the simplex is nearest is found by asking all of its faces, edges and corners: at most
// 15, and this is for one picture a frame.
#include "debugger/distance.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "debugger/question.hpp"
#include "debugger/support.hpp"

namespace surefoot::debugger {

namespace {

struct Simplex {
    std::array<dvec3, 4> points{};
    std::size_t count = 0;
};

struct Nearest {
    dvec3 point{0, 0, 0};
    Simplex part;  ///< the smallest part of the simplex that holds the point
};

/// The point nearest to the origin in the affine hull of up to three points, if it lies strictly within them.
bool within(const Simplex& part, dvec3& point) {
    const dvec3& a = part.points[0];
    if (part.count == 1) {
        point = a;
        return true;
    }
    const dvec3 u = part.points[1] - a;
    const double uu = glm::dot(u, u);
    if (part.count == 2) {
        const double s = -glm::dot(a, u) / uu;
        point = a + u * s;
        return s > 0 && s < 1;
    }
    const dvec3 v = part.points[2] - a;
    const dvec3 normal = glm::cross(u, v);
    const double squared = glm::dot(normal, normal);
    if (!(squared > 1e-24 * uu * glm::dot(v, v))) return false;
    const double s = glm::dot(glm::cross(-a, v), normal) / squared;
    const double t = glm::dot(glm::cross(u, -a), normal) / squared;
    point = normal * (glm::dot(a, normal) / squared);
    return s > 0 && t > 0 && s + t < 1;
}

/// Is the origin within a tetrahedron? On the inner side of each of its faces.
bool holds_origin(const Simplex& simplex) {
    for (std::size_t i = 0; i < 4; ++i) {
        const dvec3& a = simplex.points[(i + 1) % 4];
        const dvec3 normal = glm::cross(simplex.points[(i + 2) % 4] - a, simplex.points[(i + 3) % 4] - a);
        const double of_other = glm::dot(simplex.points[i] - a, normal);
        if (of_other * glm::dot(-a, normal) <= 0) return false;
    }
    return true;
}

/// With a plane between them known, no simplex holds the origin, whatever a flat one says by rounding.
Nearest nearest_to_origin(const Simplex& simplex, bool apart) {
    if (!apart && simplex.count == 4 && holds_origin(simplex)) return {{0, 0, 0}, simplex};
    Nearest best;
    double least = INFINITY;
    for (unsigned chosen = 1; chosen < (1U << simplex.count); ++chosen) {
        Simplex part;
        for (std::size_t i = 0; i < simplex.count; ++i)
            if ((chosen & (1U << i)) != 0) part.points[part.count++] = simplex.points[i];
        dvec3 point;
        if (part.count == 4 || !within(part, point)) continue;
        const double squared = glm::dot(point, point);
        if (squared < least) {
            least = squared;
            best = {point, part};
        }
    }
    return best;
}

}  // namespace

double distance(const Volume& volume, const dvec3& position, const Triangle& triangle) {
    const std::array<dvec3, 3> corners = corners_of(triangle);
    // The farthest point of (triangle minus shape) along n, seen from the shape's reference point.
    const auto farthest = [&](const dvec3& n) {
        const dvec3 corner = *std::max_element(corners.begin(), corners.end(), [&](const dvec3& a, const dvec3& b) {
            return glm::dot(a - position, n) < glm::dot(b - position, n);
        });
        return corner - position - farthest_point(volume, -n);
    };
    const dvec3 middle = (corners[0] + corners[1] + corners[2]) / 3.0 - position;
    Nearest at;
    at.point = farthest(middle == dvec3(0, 0, 0) ? dvec3(0, 1, 0) : -middle);
    at.part = {{at.point}, 1};
    double gap = 0;
    for (int i = 0; i < 200; ++i) {
        const double length = glm::length(at.point);
        if (length == 0) break;
        const dvec3 next = farthest(-at.point);
        gap = std::max(gap, glm::dot(next, at.point) / length);
        if (length - gap <= 1e-14 * length) break;
        Simplex grown = at.part;
        grown.points[grown.count++] = next;
        const Nearest nearer = nearest_to_origin(grown, gap > 0);
        if (!(glm::dot(nearer.point, nearer.point) < length * length)) break;  // rounding has the last word
        at = nearer;
    }
    return gap;
}

}  // namespace surefoot::debugger
