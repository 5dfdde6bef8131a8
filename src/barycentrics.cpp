#include <surefoot/barycentrics.hpp>

#include "exact/products.hpp"
#include "ieee_guard.hpp"
#include "nearest.hpp"

namespace surefoot {
inline namespace v0 {

namespace {

using namespace internal;

// How far along the segment a, b the point lies [0, 1]; 0 for a segment without length.
double share_along(const Vec& point, const Vec& a, const Vec& b) noexcept {
    const Vec edge = b - a;
    const double squared = dot(edge, edge);
    return squared > 0 ? smaller(1, larger(0, dot(point - a, edge) / squared)) : 0;
}

bool is_finite(const Vec& v) noexcept {
    return norm1(v) <= 0x1p1000;  // false for NaN too
}

}  // namespace

dvec3 barycentrics(const dvec3& point, const Triangle& triangle) noexcept {
    const IeeeGuard guard;
    const Vec place = to_vec(point);
    const Vec given[3] = {to_vec(triangle.a), to_vec(triangle.b), to_vec(triangle.c)};
    if (!is_finite(place) || !is_finite(given[0]) || !is_finite(given[1]) || !is_finite(given[2])) {
        return dvec3(1, 0, 0);
    }
    // About the point, and of a size near one, so that nothing is lost and nothing overflows.
    Vec corners[3] = {given[0] - place, given[1] - place, given[2] - place};
    const double size = larger(largest(corners[0]), larger(largest(corners[1]), largest(corners[2])));
    const double scale = power_of_two_of(size);
    if (!(scale > 0x1p-1000)) return dvec3(1, 0, 0);
    for (Vec& corner : corners) corner = corner / scale;
    const Vec nearest = nearest_on_triangle({}, corners);

    const Vec normal = accurate_cross(corners[1] - corners[0], corners[2] - corners[0]);
    const double area = dot(normal, normal);
    if (!(area > 0)) {
        int longest = 0;
        for (int i = 1; i < 3; ++i) {
            const auto edge = [&](int k) { return length(corners[(k + 1) % 3] - corners[k]); };
            if (edge(i) > edge(longest)) longest = i;
        }
        const int next = (longest + 1) % 3;
        double weights[3] = {0, 0, 0};
        weights[next] = share_along(nearest, corners[longest], corners[next]);
        weights[longest] = 1 - weights[next];
        return dvec3(weights[0], weights[1], weights[2]);
    }
    // The areas of the three triangles that the point makes with the edges, as shares of the whole.
    const auto share = [&](int i) {
        const Vec& from = corners[(i + 1) % 3];
        const Vec opposite = accurate_cross(corners[(i + 2) % 3] - from, nearest - from);
        return smaller(1, larger(0, dot(opposite, normal) / area));
    };
    const double a = share(0);
    const double b = share(1);
    const double c = share(2);
    const double sum = a + b + c;
    return sum > 0 ? dvec3(a / sum, b / sum, c / sum) : dvec3(1, 0, 0);
}

}  // namespace v0
}  // namespace surefoot
