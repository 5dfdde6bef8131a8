#include "debugger/question.hpp"

#include <cmath>
#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "query.hpp"

namespace surefoot::debugger {

namespace {

bool same(const Triangle& a, const Triangle& b) {
    return a.a == b.a && a.b == b.b && a.c == b.c;
}

bool same_sizes(const ShapeSizes& a, const ShapeSizes& b) {
    return a.sphere.radius == b.sphere.radius && a.ellipsoid.radii == b.ellipsoid.radii &&
           a.capsule.radius == b.capsule.radius && a.capsule.half_height == b.capsule.half_height &&
           a.box.half_extents == b.box.half_extents && a.cylinder.radius == b.cylinder.radius &&
           a.cylinder.half_height == b.cylinder.half_height && a.cone.radius == b.cone.radius &&
           a.cone.height == b.cone.height;
}

dvec3 normal_of(const Triangle& t) {
    return glm::cross(t.b - t.a, t.c - t.a);
}

}  // namespace

Shape ShapeSizes::get(ShapeName name) const {
    switch (name) {
        case ShapeName::sphere:
            return sphere;
        case ShapeName::ellipsoid:
            return ellipsoid;
        case ShapeName::capsule:
            return capsule;
        case ShapeName::box:
            return box;
        case ShapeName::cylinder:
            return cylinder;
        case ShapeName::cone:
            break;
    }
    return cone;
}

void ShapeSizes::set(const Shape& shape) {
    if (const auto* given = std::get_if<Sphere>(&shape)) sphere = *given;
    if (const auto* given = std::get_if<Ellipsoid>(&shape)) ellipsoid = *given;
    if (const auto* given = std::get_if<Capsule>(&shape)) capsule = *given;
    if (const auto* given = std::get_if<Box>(&shape)) box = *given;
    if (const auto* given = std::get_if<Cylinder>(&shape)) cylinder = *given;
    if (const auto* given = std::get_if<Cone>(&shape)) cone = *given;
}

ShapeName name_of(const Shape& shape) {
    return static_cast<ShapeName>(shape.index());
}

bool operator==(const Question& a, const Question& b) {
    if (a.triangles.size() != b.triangles.size()) return false;
    for (std::size_t i = 0; i < a.triangles.size(); ++i)
        if (!same(a.triangles[i], b.triangles[i])) return false;
    return a.world == b.world && a.level == b.level && a.opened == b.opened && a.motion.from == b.motion.from &&
           a.motion.to == b.motion.to && a.shape == b.shape && same_sizes(a.sizes, b.sizes) &&
           a.orientation == b.orientation && a.one_sided == b.one_sided;
}

std::vector<Remark> remarks(const Question& question) {
    std::vector<Remark> all;
    const auto refuse = [&](const std::optional<std::string>& complaint) {
        if (complaint) all.push_back({true, *complaint});
    };
    refuse(tools::complaint(question.volume()));
    refuse(tools::complaint("START", question.motion.from));
    refuse(tools::complaint("END", question.motion.to));
    const dvec3 along = question.motion.to - question.motion.from;
    bool all_from_behind = question.one_sided && !question.triangles.empty();
    for (std::size_t i = 0; i < question.triangles.size(); ++i) {
        const Triangle& triangle = question.triangles[i];
        for (const dvec3& corner : corners_of(triangle)) {
            const auto complaint = tools::complaint(fmt::format("triangle {}", i), corner);
            refuse(complaint);
            if (complaint) break;
        }
        const dvec3 normal = normal_of(triangle);
        if (normal == dvec3(0, 0, 0))
            all.push_back(
                {false, fmt::format("Triangle {} has no area: it blocks as the segment or point that it is{}.", i,
                                    question.one_sided ? ", but has no front to be met from" : "")});
        if (glm::dot(along, normal) < 0) all_from_behind = false;
    }
    if (question.motion.from == question.motion.to)
        all.push_back({false, "START and END are one place. What stands still comes no closer: there is no hit."});
    else if (all_from_behind)
        all.push_back({false, "The motion comes from behind, and one-sided triangles do not exist for it."});
    return all;
}

dvec3 snapped(const dvec3& point, double step) {
    if (!(step > 0)) return point;
    const auto snap = [&](double x) { return std::round(x / step) * step; };
    return {snap(point.x), snap(point.y), snap(point.z)};
}

std::array<dvec3, 3> corners_of(const Triangle& triangle) {
    return {triangle.a, triangle.b, triangle.c};
}

dvec3& corner_of(Triangle& triangle, std::size_t corner) {
    return corner == 0 ? triangle.a : (corner == 1 ? triangle.b : triangle.c);
}

}  // namespace surefoot::debugger
