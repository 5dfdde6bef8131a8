// Each side begins as a square larger than any map, and every other plane cuts off what is in front of it (I. E.
// Sutherland, G. W. Hodgman, "Reentrant polygon clipping", 1974).
#include "brush.hpp"

#include <algorithm>
#include <cmath>

namespace surefoot::internal::quake3 {
namespace {

using Polygon = std::vector<dvec3>;

/// Half the side of the first square. The game's worlds end at 2^17 units; a corner beyond 2^19 was never cut off.
constexpr double first_reach = 1048576;
constexpr double farthest = 524288;

double dot_product(const dvec3& a, const dvec3& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

dvec3 cross_product(const dvec3& a, const dvec3& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

double height(const Plane& plane, const dvec3& p) {
    return dot_product(plane.normal, p) - plane.distance;
}

double largest(const dvec3& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

/// A plane's distance is a float, so that its place is known to 2^-24 of it, and three meet in a corner; 2^-20 is a
/// generous multiple: 0.004 units at the far end of a large map.
double slack_at(double reach) {
    return std::max(reach, 1.0) * 0x1p-20;
}

Polygon square_on(const Plane& plane) {
    const dvec3& n = plane.normal;
    const dvec3 across = std::abs(n.z) < 0.9 ? dvec3(0, 0, 1) : dvec3(1, 0, 0);
    const dvec3 u = cross_product(across, n);
    const dvec3 v = cross_product(n, u);
    const double scale = first_reach / std::sqrt(dot_product(u, u));
    const dvec3 middle = n * (plane.distance / dot_product(n, n));
    return {middle - scale * (u + v), middle + scale * (u - v), middle + scale * (u + v), middle - scale * (u - v)};
}

/// Keeps what is behind the plane. `out` has the result.
void cut(const Polygon& in, const Plane& plane, double slack, Polygon& out) {
    out.clear();
    for (std::size_t i = 0; i < in.size(); ++i) {
        const dvec3& a = in[i];
        const dvec3& b = in[(i + 1) % in.size()];
        const double ha = height(plane, a);
        const double hb = height(plane, b);
        if (ha <= slack) out.push_back(a);
        // A corner within the slack counts as on the plane, and the edge is then cut nowhere else.
        if ((ha > slack && hb < -slack) || (ha < -slack && hb > slack)) out.push_back(a + (b - a) * (ha / (ha - hb)));
    }
}

bool same_plane(const Plane& a, const Plane& b, double slack) {
    return dot_product(a.normal, b.normal) > 1 - 1e-9 && std::abs(a.distance - b.distance) <= slack;
}

/// How far the bounded brush can reach: the distances of its planes, since no corner of a real one is much farther out.
double reach_of(std::span<const Plane> planes) {
    double reach = 0;
    for (const Plane& plane : planes) reach = std::max(reach, std::min(std::abs(plane.distance), farthest));
    return reach;
}

class Shaper {
public:
    explicit Shaper(std::span<const Plane> planes) : planes_(planes), slack_(slack_at(reach_of(planes))) {}

    BrushShape shape() {
        if (planes_.size() > max_brush_sides) return stopped(BrushShape::State::too_large);
        for (std::size_t i = 0; i < planes_.size(); ++i) {
            if (!is_first_of_its_kind(i)) continue;
            const Polygon polygon = side(i);
            if (std::ranges::any_of(polygon, [](const dvec3& p) { return !(largest(p) < farthest); }))
                return stopped(BrushShape::State::unbounded);
            add(i, polygon);
        }
        // A closed body has at least four sides; what has fewer is a sheet, an edge or a point.
        if (shape_.polygons.size() < 4) return stopped(BrushShape::State::empty);
        shape_.state = BrushShape::State::solid;
        return std::move(shape_);
    }

private:
    static BrushShape stopped(BrushShape::State state) { return {.state = state, .corners = {}, .polygons = {}}; }

    [[nodiscard]] bool is_first_of_its_kind(std::size_t i) const {
        for (std::size_t j = 0; j < i; ++j) {
            if (same_plane(planes_[i], planes_[j], slack_)) return false;
        }
        return true;
    }

    Polygon side(std::size_t i) {
        Polygon polygon = square_on(planes_[i]);
        for (std::size_t j = 0; j < planes_.size() && !polygon.empty(); ++j) {
            if (j == i || same_plane(planes_[i], planes_[j], slack_)) continue;
            cut(polygon, planes_[j], slack_, scratch_);
            polygon.swap(scratch_);
        }
        return polygon;
    }

    void add(std::size_t i, const Polygon& polygon) {
        BrushPolygon added{.side = static_cast<std::uint32_t>(i), .corners = {}};
        for (const dvec3& p : polygon) {
            const std::uint32_t corner = number_of(p);
            if (added.corners.empty() || added.corners.back() != corner) added.corners.push_back(corner);
        }
        while (added.corners.size() > 1 && added.corners.front() == added.corners.back()) added.corners.pop_back();
        if (added.corners.size() >= 3) shape_.polygons.push_back(std::move(added));
    }

    std::uint32_t number_of(const dvec3& p) {
        const auto found =
            std::ranges::find_if(shape_.corners, [&](const dvec3& q) { return largest(p - q) <= 2 * slack_; });
        const auto number = static_cast<std::uint32_t>(found - shape_.corners.begin());
        if (found == shape_.corners.end()) shape_.corners.push_back(p);
        return number;
    }

    std::span<const Plane> planes_;
    double slack_;
    BrushShape shape_;
    Polygon scratch_;
};

}  // namespace

BrushShape shape_of(std::span<const Plane> planes) {
    return Shaper(planes).shape();
}

}  // namespace surefoot::internal::quake3
