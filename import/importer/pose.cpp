#include "pose.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>

namespace surefoot::importer {

std::optional<ImportedMarker> marker_at(const glm::dmat4& matrix, const internal::Placement& placement) {
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) {
            if (!std::isfinite(matrix[column][row])) return std::nullopt;
        }
    }
    ImportedMarker marker;
    marker.position = placement.position(dvec3(matrix[3]));

    glm::dmat3 axes(matrix);
    dvec3 scale(glm::length(axes[0]), glm::length(axes[1]), glm::length(axes[2]));
    if (glm::determinant(axes) < 0) scale.x = -scale.x;
    marker.scale = placement.factors(scale);
    if (scale.x == 0 || scale.y == 0 || scale.z == 0) return marker;

    axes[0] /= scale.x;
    axes[1] = glm::normalize(axes[1] - axes[0] * glm::dot(axes[0], axes[1]));
    axes[2] = glm::cross(axes[0], axes[1]);
    const dquat turned = glm::normalize(glm::quat_cast(axes));
    if (std::isfinite(turned.w)) marker.orientation = placement.orientation(turned);
    return marker;
}

}  // namespace surefoot::importer
