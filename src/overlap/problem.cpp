#include "overlap/problem.hpp"

#include <utility>

namespace surefoot::internal {

OrderedTriangle ordered(const Triangle& triangle) noexcept {
    OrderedTriangle result{{to_vec(triangle.a), to_vec(triangle.b), to_vec(triangle.c)}};
    const auto order = [&](int i, int j) noexcept {
        if (lexicographically_less(result.corner[j], result.corner[i])) {
            std::swap(result.corner[i], result.corner[j]);
            result.mirrored = !result.mirrored;
        }
    };
    order(0, 1);
    order(1, 2);
    order(0, 1);
    return result;
}

TriangleProblem seen_by(const Frame& frame, const OrderedTriangle& world, const Vec& position) noexcept {
    TriangleProblem problem;
    problem.winding = world.mirrored ? -1 : 1;
    int longest = 0;
    for (int i = 0; i < 3; ++i) {
        problem.corner[i] = frame.to_local(world.corner[i] - position);
        problem.edge[i] = frame.to_local(world.corner[i == 2 ? 0 : i + 1] - world.corner[i]);
        problem.scale = larger(problem.scale, largest(problem.corner[i]));
        if (norm1(problem.edge[i]) > norm1(problem.edge[longest])) longest = i;
    }
    // From the two shorter edges: of a sliver they keep the most of its direction.
    const int second = longest == 2 ? 0 : longest + 1;
    const int third = second == 2 ? 0 : second + 1;
    problem.normal = unit(accurate_cross(scaled_to_one(problem.edge[second]), scaled_to_one(problem.edge[third])));
    problem.normal = problem.normal * problem.winding;
    if (problem.normal == Vec{}) {
        // A segment has no normal, but whoever sits on it needs some way out across it; a point may be left upwards.
        // Enlarged, since products of what is shorter than 1e-160 m are nothing.
        const Vec e = scaled_to_one(enlarged(problem.edge[longest]));
        const bool is_steep = absolute(e.y) >= larger(absolute(e.x), absolute(e.z));
        problem.normal = e == Vec{}
                             ? Vec{0, 1, 0}
                             : unit(is_steep ? Vec{e.y, -e.x, 0} : Vec{-e.y * e.x, e.x * e.x + e.z * e.z, -e.y * e.z});
    }
    return problem;
}

FarthestFeature farthest_along(const TriangleProblem& triangle, const Vec& normal, double hair) noexcept {
    double along[3];
    for (int i = 0; i < 3; ++i) along[i] = dot(normal, triangle.corner[i]);
    const double most = larger(along[0], larger(along[1], along[2]));
    bool is_far[3];
    int count = 0;
    for (int i = 0; i < 3; ++i) {
        is_far[i] = along[i] >= most - hair;
        if (is_far[i]) ++count;
    }
    FarthestFeature found;
    found.feature = count == 3 ? Feature::face : count == 2 ? Feature::edge : Feature::vertex;
    for (int i = 0; i < 3; ++i) {
        const bool next_is_far = is_far[i == 2 ? 0 : i + 1];
        if (count == 1 ? is_far[i] : is_far[i] && next_is_far) found.index = i;
    }
    return found;
}

}  // namespace surefoot::internal
