#include "mesh/edges.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/weld.hpp"
#include "vec.hpp"

namespace surefoot::internal {
namespace {

struct Side {
    std::uint32_t far;   // the higher one of its two corners
    std::uint32_t side;  // 3 * triangle + k
};

std::uint32_t next_in_triangle(std::uint32_t side) noexcept {
    return side % 3 == 2 ? side - 2 : side + 1;
}

// All sides of one bucket have the same lower corner, so they are one edge where the higher one is the same too.
void match_bucket(std::span<Side> bucket, std::vector<std::uint32_t>& partner) {
    std::sort(bucket.begin(), bucket.end(),
              [](const Side& a, const Side& b) { return a.far != b.far ? a.far < b.far : a.side < b.side; });
    for (std::size_t begin = 0; begin < bucket.size();) {
        std::size_t end = begin + 1;
        while (end < bucket.size() && bucket[end].far == bucket[begin].far) ++end;
        if (end - begin == 2) {
            partner[bucket[begin].side] = bucket[begin + 1].side;
            partner[bucket[begin + 1].side] = bucket[begin].side;
        } else {
            for (std::size_t i = begin; i < end; ++i)
                partner[bucket[i].side] = end - begin == 1 ? EdgeMatches::none : EdgeMatches::many;
        }
        begin = end;
    }
}

// How the surface goes on from the triangle a, b, c over its side ab to a triangle with the third corner o.
EdgeKind kind_of(const Vec& a, const Vec& b, const Vec& c, const Vec& o, double tolerance) noexcept {
    const Vec edge = b - a;
    const Vec own = cross(edge, c - a);
    const Vec other = cross(edge, o - a);
    const double own_area = std::sqrt(dot(own, own));
    const double other_area = std::sqrt(dot(other, other));
    if (own_area == 0 || other_area == 0) return EdgeKind::open;
    // Rounding a coordinate to float moves it by up to 2^-24 of it. Seen from the plane, the corners of this triangle
    // move o by so much more as o is farther from the edge than c is: the ratio of the areas.
    constexpr double float_noise = 0x1p-22;
    const double size = larger(larger(largest(a), largest(b)), larger(largest(c), largest(o)));
    const double height = dot(own, o - a);  // times own_area
    if (absolute(height) <= own_area * tolerance + float_noise * size * (own_area + other_area))
        return dot(own, other) > 0 ? EdgeKind::convex : EdgeKind::flat;
    return height > 0 ? EdgeKind::concave : EdgeKind::convex;
}

const Vec& widened(const Vec& v) noexcept {
    return v;
}
Vec widened(const vec3& v) noexcept {
    return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

template <typename Vertex>
std::vector<std::uint8_t> kinds_of(std::span<const Vertex> vertices, std::span<const std::uint32_t> indices,
                                   const EdgeMatches& matches, double tolerance) {
    const auto corner = [&](std::uint32_t side) { return Vec(widened(vertices[indices[side]])); };
    std::vector<std::uint8_t> kinds(indices.size() / 3);
    for (std::uint32_t id = 0; id < kinds.size(); ++id) {
        const Vec corners[3] = {corner(3 * id), corner(3 * id + 1), corner(3 * id + 2)};
        unsigned bits = 0;
        for (std::uint32_t k = 0; k < 3; ++k) {
            const std::uint32_t partner = matches.partner[3 * id + k];
            if (partner >= EdgeMatches::gone) continue;  // open, which is 0
            const Vec opposite = corner(next_in_triangle(next_in_triangle(partner)));
            const EdgeKind kind = kind_of(corners[k], corners[(k + 1) % 3], corners[(k + 2) % 3], opposite, tolerance);
            bits |= static_cast<unsigned>(kind) << (2 * k);
        }
        kinds[id] = static_cast<std::uint8_t>(bits);
    }
    return kinds;
}

}  // namespace

EdgeMatches match_edges(std::span<const std::uint32_t> corners, std::size_t vertex_count) {
    EdgeMatches matches;
    matches.partner.assign(corners.size(), EdgeMatches::gone);
    const auto each_side = [&](const auto& visit) {
        for (std::uint32_t first = 0; first + 3 <= corners.size(); first += 3) {
            const std::uint32_t a = corners[first];
            const std::uint32_t b = corners[first + 1];
            const std::uint32_t c = corners[first + 2];
            if (a == b || b == c || c == a) continue;
            visit(first, a, b);
            visit(first + 1, b, c);
            visit(first + 2, c, a);
        }
    };
    // Buckets by the lower corner, by counting: meshes number their vertices so that neighbours are near each other,
    // and this keeps to that order, where a table of edges would jump about.
    std::vector<std::uint32_t> begin(vertex_count + 1, 0);
    each_side([&](std::uint32_t, std::uint32_t from, std::uint32_t to) { ++begin[std::min(from, to) + 1]; });
    for (std::size_t v = 0; v < vertex_count; ++v) begin[v + 1] += begin[v];
    std::vector<Side> sides(begin[vertex_count]);
    std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
    each_side([&](std::uint32_t side, std::uint32_t from, std::uint32_t to) {
        sides[next[std::min(from, to)]++] = {std::max(from, to), side};
    });
    for (std::size_t v = 0; v < vertex_count; ++v)
        match_bucket(std::span(sides).subspan(begin[v], begin[v + 1] - begin[v]), matches.partner);
    return matches;
}

std::vector<std::uint8_t> edge_kinds(std::span<const vec3> vertices, std::span<const std::uint32_t> indices,
                                     double tolerance) {
    const std::vector<std::uint32_t> place = same_places(vertices);
    std::vector<std::uint32_t> corners(indices.size());
    std::transform(indices.begin(), indices.end(), corners.begin(), [&](std::uint32_t index) { return place[index]; });
    return kinds_of(vertices, std::span<const std::uint32_t>(corners), match_edges(corners, vertices.size()),
                    tolerance);
}

std::vector<std::uint8_t> edge_kinds(std::span<const Vec> vertices, std::span<const std::uint32_t> indices,
                                     const EdgeMatches& matches, double tolerance) {
    return kinds_of(vertices, indices, matches, tolerance);
}

}  // namespace surefoot::internal
