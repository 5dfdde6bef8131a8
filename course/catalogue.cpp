#include "course/catalogue.hpp"

namespace surefoot::course {

Scenes all_scenes() {
    Scenes scenes;
    for (const auto add :
         {add_floors, add_walls, add_stairs, add_slopes, add_tight, add_fast, add_scale, add_moving, add_inside})
        add(scenes);
    return scenes;
}

}  // namespace surefoot::course
