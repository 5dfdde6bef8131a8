#include "check.hpp"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>
#include <optional>

#include <surefoot/overlap.hpp>
#include <surefoot/ray.hpp>
#include <surefoot/sweep.hpp>

namespace surefoot::bench {
namespace {

// No part of a body is further than this from its reference point along any axis, by a good margin [m].
constexpr double reach = 2;

/// May anything within reach of the motion meet the triangle's box? By slabs, generous, and by no tree.
bool is_near(const Motion& motion, const Triangle& triangle) {
    const dvec3 low = glm::min(glm::min(triangle.a, triangle.b), triangle.c) - reach;
    const dvec3 high = glm::max(glm::max(triangle.a, triangle.b), triangle.c) + reach;
    double enter = 0;
    double leave = 1;
    for (glm::length_t axis = 0; axis < 3; ++axis) {
        const double from = motion.from[axis];
        const double along = motion.to[axis] - from;
        if (along == 0) {
            if (from < low[axis] || from > high[axis]) return false;
            continue;
        }
        const double a = (low[axis] - from) / along;
        const double b = (high[axis] - from) / along;
        enter = std::max(enter, std::min(a, b));
        leave = std::min(leave, std::max(a, b));
    }
    return enter <= leave;
}

bool meets(const Bounds& bounds, const Triangle& triangle) {
    const dvec3 low = glm::min(glm::min(triangle.a, triangle.b), triangle.c);
    const dvec3 high = glm::max(glm::max(triangle.a, triangle.b), triangle.c);
    return glm::all(glm::lessThanEqual(low, bounds.max)) && glm::all(glm::lessThanEqual(bounds.min, high));
}

/// What has been found so far for one question.
struct Reference {
    std::optional<Hit> first{};
    std::size_t found = 0;
};

void ask_triangle(Reference& reference, const Workload& workload, const Volume& volume, const Motion& motion,
                  const Triangle& triangle, std::uint32_t id) {
    if (workload.question == Question::overlap) {
        if (overlap(volume, motion.to, triangle)) ++reference.found;
        return;
    }
    if (workload.question == Question::gather) {
        if (meets(bounds_of(workload.body, motion), triangle)) ++reference.found;
        return;
    }
    std::optional<Hit> hit =
        workload.question == Question::ray ? ray(motion, triangle) : sweep(volume, motion, triangle);
    // Ids come in rising order, so that the first of equals stays.
    if (!hit || (reference.first && reference.first->t <= hit->t)) return;
    hit->triangle = id;
    reference.first = hit;
}

bool same_nearest(const Mesh& mesh, const dvec3& point) {
    const auto found = mesh.nearest(point, nearest_within);
    const auto reference = mesh.nearest(point, nearest_within, {.search = Search::brute_force});
    if (found.has_value() != reference.has_value()) return false;
    return !found || (found->triangle == reference->triangle && found->distance == reference->distance &&
                      found->point == reference->point);
}

bool agrees(const Reference& reference, const Stage& stage, const Workload& workload, const Volume& volume,
            const Motion& motion) {
    if (workload.question == Question::overlap) return stage.mesh.overlap(volume, motion.to, {}) == reference.found;
    if (workload.question == Question::gather)
        return stage.mesh.gather(bounds_of(workload.body, motion), {}) == reference.found;
    if (workload.question == Question::nearest) return same_nearest(stage.mesh, motion.to);
    std::optional<Hit> hit;
    if (workload.question == Question::ray) {
        hit = stage.mesh.ray(motion);
    } else if (workload.question == Question::sweeps) {
        stage.mesh.sweep_many(volume, {&motion, 1}, {&hit, 1});
    } else {
        hit = stage.mesh.sweep(volume, motion);
    }
    if (hit.has_value() != reference.first.has_value()) return false;
    return !hit || (hit->t == reference.first->t && hit->triangle == reference.first->triangle &&
                    hit->normal == reference.first->normal && hit->point == reference.first->point);
}

}  // namespace

Checked check(const Stage& stage, const Workload& workload, std::span<const Motion> motions) {
    Checked checked;
    if (workload.solver != Solver::surefoot) return checked;
    const Volume volume = volume_of(workload.body);
    std::vector<Reference> references(motions.size());
    for (std::uint32_t id = 0; id < stage.scene.triangle_count(); ++id) {
        const Triangle triangle = stage.scene.triangle(id);
        for (std::size_t i = 0; i < motions.size(); ++i)
            if (is_near(motions[i], triangle)) ask_triangle(references[i], workload, volume, motions[i], triangle, id);
    }
    for (std::size_t i = 0; i < motions.size(); ++i) {
        ++checked.answers;
        if (!agrees(references[i], stage, workload, volume, motions[i])) ++checked.wrong;
    }
    return checked;
}

}  // namespace surefoot::bench
