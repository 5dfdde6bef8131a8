/// Where the questions of the benchmarks are asked: motions that a game would make in a scene.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include <surefoot/mesh.hpp>
#include <surefoot/shapes.hpp>

#include "scenes/scene.hpp"

namespace surefoot::bench {

/// The six shapes of a player, about as large as each other.
enum class Body { sphere, ellipsoid, capsule, box, cylinder, cone };
constexpr Body bodies[] = {Body::sphere, Body::ellipsoid, Body::capsule, Body::box, Body::cylinder, Body::cone};
[[nodiscard]] std::string_view name_of(Body body);
[[nodiscard]] Volume volume_of(Body body);

enum class Path { brief, distant };

/// Brief: a frame's move. The body stands off a random point of a random triangle, 0.5 to 5 cm along its normal, and
/// overlaps nothing. It moves 0.1 to 0.5 m: six in ten along the surface and a little into it, three in ten downwards
/// and aside as in a fall, one in ten anywhere.
///
/// Distant: 20 to 50 m, half of them in any direction and half nearly level as shots and looks are, from a point 0.5 to
/// 2 m off a random point of a random triangle where none of the six shapes overlaps anything. The same motions for
/// every shape, so `body` does not matter.
///
/// Fewer than `count` where a scene has no room. The same motions on every machine, whatever tree the mesh has.
[[nodiscard]] std::vector<Motion> make_motions(const Scene& scene, const Mesh& mesh, Body body, Path path,
                                               std::size_t count);

/// The same motions in the order of a Morton curve through their beginnings: neighbours in space asked one by one.
[[nodiscard]] std::vector<Motion> sorted_in_space(std::vector<Motion> motions);

}  // namespace surefoot::bench
