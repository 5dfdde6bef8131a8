/// The source of the shader for what is seen through; see shaders.hpp.
#pragma once

#include <string_view>

namespace surefoot::view::shaders {

/// What is before the thing that is to be seen has holes, in an order (Bayer's) that spreads them evenly: as many as
/// the place is near to the line of sight, and none close to the thing itself.
inline constexpr std::string_view door = R"(
uniform vec3 door_middle; // what is to be seen
uniform vec3 door_ahead;  // towards it, by its distance squared
uniform vec3 door_right;  // across the look, by the half size
uniform vec3 door_above;
uniform float door_strength;
uniform float door_near;
uniform float door_gap;   // before what is to be seen, where nothing has holes
const float holes[16] = float[16](0.5, 8.5, 2.5, 10.5, 12.5, 4.5, 14.5, 6.5, 3.5, 11.5, 1.5, 9.5, 15.5, 7.5, 13.5, 5.5);

bool is_hole(vec3 place) {
    float share = dot(place, door_ahead); // of the way to what is to be seen
    vec3 off = place / share - door_middle;
    float aside = length(vec2(dot(off, door_right), dot(off, door_above)));
    float before = (1.0 - share) * length(door_middle);
    float open = door_strength * (1.0 - smoothstep(0.85, 1.5, aside)) * smoothstep(door_gap, door_gap + 0.3, before);
    open = max(open, 0.9 * (1.0 - smoothstep(0.3, max(door_near, 0.31), length(place))));
    ivec2 hole = ivec2(gl_FragCoord.xy) & 3;
    return open * 16.0 > holes[hole.y * 4 + hole.x];
}
)";

}  // namespace surefoot::view::shaders
