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

/// The planes at which a standing cylinder or cone is least deep.
void propose_upright_standing(const SweepQuery& query, Planes& planes) noexcept;

}  // namespace surefoot::internal
