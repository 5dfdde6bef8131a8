/// The sources of the shaders for small solids; see shaders.hpp, whose `light` goes before them.
#pragma once

#include <string_view>

namespace surefoot::view::shaders {

/// A little light of the sky at the rim tells small things from what is behind them.
inline constexpr std::string_view piece_light = R"(
vec3 piece_lit(vec3 albedo, vec3 place, vec3 unit_normal, float own) {
    float rim = 1.0 - abs(dot(unit_normal, normalize(place)));
    // What is small and alive is nowhere quite dark: the sky reaches around it.
    vec3 lit_colour = shaded(albedo, place, unit_normal) + albedo * sky_colour * 0.45 + sky_colour * rim * rim * rim * 0.3;
    return mix(lit_colour, albedo * 1.25, own);
}
)";

/// Small solids, one an instance. Without shadows light is worked out at corners, which is enough for what is small.
inline constexpr std::string_view piece_vertex = R"(
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 row_x;
layout(location = 3) in vec4 row_y;
layout(location = 4) in vec4 row_z;
layout(location = 5) in vec4 colour;
layout(location = 6) in float glow;
uniform mat4 clip_from_eye;
out vec3 v_place;
#ifdef SHADOWS
out vec3 v_normal;
flat out vec4 v_colour;
flat out float v_glow;
#else
out vec4 v_lit;
#endif

void main() {
    vec4 at = vec4(position, 1.0);
    v_place = vec3(dot(row_x, at), dot(row_y, at), dot(row_z, at));
    // What stretches a solid by a matrix turns its normals by the matrix of cofactors.
    vec3 turned = vec3(dot(cross(row_y.xyz, row_z.xyz), normal), dot(cross(row_z.xyz, row_x.xyz), normal),
                       dot(cross(row_x.xyz, row_y.xyz), normal));
    vec3 unit_normal = turned / max(length(turned), 1e-12);
#ifdef SHADOWS
    v_normal = unit_normal;
    v_colour = colour;
    v_glow = glow;
#else
    v_lit = vec4(piece_lit(colour.rgb * colour.rgb, v_place, unit_normal, glow), colour.a);
#endif
    gl_Position = clip_from_eye * vec4(v_place, 1.0);
}
)";

inline constexpr std::string_view piece_fragment = R"(
in vec3 v_place;
out vec4 result;
#ifdef SHADOWS
in vec3 v_normal;
flat in vec4 v_colour;
flat in float v_glow;
void main() {
    vec3 lit_colour = piece_lit(v_colour.rgb * v_colour.rgb, v_place, normalize(v_normal), v_glow);
    result = vec4(sqrt(fogged(lit_colour, v_place, v_glow)), v_colour.a);
}
#else
in vec4 v_lit;
void main() { result = vec4(sqrt(fogged(v_lit.rgb, v_place)), v_lit.a); }
#endif
)";

inline constexpr std::string_view piece_depth_vertex = R"(
layout(location = 0) in vec3 position;
layout(location = 2) in vec4 row_x;
layout(location = 3) in vec4 row_y;
layout(location = 4) in vec4 row_z;
uniform mat4 clip_from_middle;
void main() {
    vec4 at = vec4(position, 1.0);
    gl_Position = clip_from_middle * vec4(dot(row_x, at), dot(row_y, at), dot(row_z, at), 1.0);
}
)";

}  // namespace surefoot::view::shaders
