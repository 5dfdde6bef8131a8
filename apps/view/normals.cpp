#include "view/normals.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <numbers>
#include <tuple>

namespace surefoot::view {
namespace {

dvec3 normal_of(const Triangle& t) {
    const dvec3 cross = glm::cross(t.b - t.a, t.c - t.a);
    const double length = glm::length(cross);
    return length > 0 ? cross / length : dvec3(0, 1, 0);
}

const dvec3& corner_of(const Triangle& t, std::size_t i) {
    return i == 0 ? t.a : i == 1 ? t.b : t.c;
}

double angle_at(const Triangle& t, std::size_t i) {
    const dvec3 a = corner_of(t, (i + 1) % 3) - corner_of(t, i);
    const dvec3 b = corner_of(t, (i + 2) % 3) - corner_of(t, i);
    const double lengths = glm::length(a) * glm::length(b);
    return lengths > 0 ? std::acos(std::clamp(glm::dot(a, b) / lengths, -1.0, 1.0)) : 0;
}

}  // namespace

std::vector<vec3> corner_normals(std::span<const SourceTriangle> triangles, double crease) {
    std::vector<vec3> normals(3 * triangles.size());
    for (std::size_t i = 0; i < normals.size(); ++i) normals[i] = vec3(normal_of(triangles[i / 3].triangle));
    if (crease <= 0) return normals;
    const std::vector<vec3> faces = normals;
    std::vector<std::uint32_t> order(normals.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
    const auto place = [&](std::uint32_t i) {
        const dvec3& p = corner_of(triangles[i / 3].triangle, i % 3);
        return std::tuple(p.x, p.y, p.z);
    };
    std::sort(order.begin(), order.end(),
              [&](std::uint32_t a, std::uint32_t b) { return std::tuple(place(a), a) < std::tuple(place(b), b); });
    const auto bend = static_cast<float>(std::cos(crease * std::numbers::pi / 180));
    for (std::size_t first = 0; first < order.size();) {
        std::size_t end = first + 1;
        while (end < order.size() && place(order[end]) == place(order[first])) ++end;
        // A fan of thousands around one corner stays flat rather than taking the square of its size.
        constexpr std::size_t largest_fan = 512;
        for (std::size_t i = first; i < end && end - first <= largest_fan; ++i) {
            vec3 sum(0);
            for (std::size_t k = first; k < end; ++k) {
                const std::uint32_t corner = order[k];
                if (glm::dot(faces[order[i]], faces[corner]) < bend) continue;
                sum += faces[corner] * static_cast<float>(angle_at(triangles[corner / 3].triangle, corner % 3));
            }
            if (glm::length(sum) > 0) normals[order[i]] = glm::normalize(sum);
        }
        first = end;
    }
    return normals;
}

}  // namespace surefoot::view
