#include "view/lighting.hpp"

namespace surefoot::view {

void Lighting::set(const gl::Program& program) const {
    program.set("to_sun", to_sun);
    program.set("up", up);
    program.set("sun_colour", sky->sun);
    program.set("sky_colour", sky->above);
    program.set("ground_colour", sky->below);
    program.set("fog_colour", sky->horizon);
    program.set("fog", fog ? static_cast<float>(1 / (sky->fog_distance * sky->fog_distance)) : 0.0F);
    program.set("still_from_eye", still_from_eye);
    program.set("moving_from_eye", moving_from_eye);
    program.set("shadow_size", shadow_size);
    program.set("moving_strength", moving_strength);
    program.set("still_map", 0);
    program.set("moving_map", 1);
}

}  // namespace surefoot::view
