#include "overlap/problem.hpp"

namespace surefoot::internal {

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
