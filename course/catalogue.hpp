/// All scenes of the course, by what they are about.
#pragma once

#include <vector>

#include "course/scene.hpp"

namespace surefoot::course {

using Scenes = std::vector<Scene>;

void add_floors(Scenes& scenes);
void add_walls(Scenes& scenes);
void add_stairs(Scenes& scenes);
void add_slopes(Scenes& scenes);
void add_tight(Scenes& scenes);
void add_fast(Scenes& scenes);
void add_scale(Scenes& scenes);
void add_moving(Scenes& scenes);
void add_inside(Scenes& scenes);

/// Every scene, in the order in which they are told.
[[nodiscard]] Scenes all_scenes(BodyShape shape = BodyShape::capsule);

}  // namespace surefoot::course
