#include "course/catalogue.hpp"

#include "course/catches.hpp"

namespace surefoot::course {

Scenes all_scenes() {
    Scenes scenes;
    for (const auto add :
         {add_floors, add_walls, add_stairs, add_slopes, add_tight, add_fast, add_scale, add_moving, add_inside})
        add(scenes);
    for (Scene& scene : scenes) scene.catches = broken_movers_caught_by(scene.name);
    return scenes;
}

}  // namespace surefoot::course
