/// Which way surfaces face, corner by corner.
#pragma once

#include <span>
#include <vector>

#include <surefoot/math.hpp>
#include <surefoot/query.hpp>

namespace surefoot::view {

/// Three unit normals a triangle. Corners at one place share theirs where the triangles bend by less than `crease`
/// degrees; 0 leaves every triangle flat. Triangles without area face up.
[[nodiscard]] std::vector<vec3> corner_normals(std::span<const SourceTriangle> triangles, double crease);

}  // namespace surefoot::view
