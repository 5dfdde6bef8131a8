// Which planes each shape asks. One file a family of cases.
#pragma once

#include "sweep/planes.hpp"

namespace surefoot::internal {

void propose_planes(const SweepQuery& query, const Sphere& sphere, Planes& planes) noexcept;
void propose_planes(const SweepQuery& query, const Ellipsoid& ellipsoid, Planes& planes) noexcept;
void propose_planes(const SweepQuery& query, const Capsule& capsule, Planes& planes) noexcept;
void propose_planes(const SweepQuery& query, const Box& box, Planes& planes) noexcept;
void propose_planes(const SweepQuery& query, const Cylinder& cylinder, Planes& planes) noexcept;
void propose_planes(const SweepQuery& query, const Cone& cone, Planes& planes) noexcept;

/// The planes at which a standing cylinder or cone is least deep; where a corner lies on the axis, those sides that a
/// motion with this heading (in the shape's frame) leaves and closes on the most.
void propose_upright_standing(const SweepQuery& query, const Vec& heading, Planes& planes) noexcept;

}  // namespace surefoot::internal
