/// A node's matrix, taken apart.
#pragma once

#include <glm/ext/matrix_double4x4.hpp>
#include <optional>

#include <surefoot/import.hpp>

#include "placement.hpp"

namespace surefoot::importer {

/// A marker with the pose of `matrix` and nothing else; none when the matrix is not finite. A factor of zero leaves the
/// orientation upright, and what is sheared keeps its axis along x.
[[nodiscard]] std::optional<ImportedMarker> marker_at(const glm::dmat4& matrix, const internal::Placement& placement);

}  // namespace surefoot::importer
