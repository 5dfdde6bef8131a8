/// The sources of the shaders for models; see shaders.hpp, whose `light` goes before them.
#pragma once

#include <string_view>

namespace surefoot::view::shaders {

/// Backs are darker and warmer. `colour` has in place of its opacity how much of it shines by itself.
inline constexpr std::string_view mesh_light = R"(
vec3 lit_from_eye(vec3 normal, vec3 place, vec4 colour) {
    normal = normalize(normal);
    bool back = dot(normal, place) > 0.0;
    if (back) normal = -normal;
    vec3 albedo = colour.rgb * colour.rgb;
    vec3 own = albedo * 1.3;
    if (back) albedo *= vec3(0.72, 0.66, 0.70);
    return mix(shaded(albedo, place, normal), own, colour.a);
}
)";

/// With LIT_WHOLE, light is worked out once for a flat triangle on which no shadow falls, and not for its every pixel.
inline constexpr std::string_view mesh_vertex = R"(
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 colour;
#ifdef EDGES
layout(location = 3) in uint info;
out vec3 v_corner;
flat out uint v_info;
#endif
#ifdef PATTERNS
layout(location = 4) in int pattern;
out vec3 v_drawn;        // repetitions of the patterns along the model's axes
flat out vec3 v_facing;
flat out vec4 v_channel; // which pattern, and how strong it is
#endif
uniform mat4 clip_from_eye;
uniform mat4 eye_from_model;
out vec3 v_place;
#ifdef LIT_WHOLE
flat out vec4 v_lit;
#else
#ifdef FLAT
flat
#endif
out vec3 v_normal;
flat out vec4 v_colour;
#endif
void main() {
    vec4 place = eye_from_model * vec4(position, 1.0);
    v_place = place.xyz;
#ifdef LIT_WHOLE
    v_lit = vec4(lit_from_eye(mat3(eye_from_model) * normal, v_place, colour), colour.a);
#else
    v_normal = mat3(eye_from_model) * normal;
    v_colour = colour;
#endif
#ifdef PATTERNS
    v_drawn = position / 6.0;
    v_facing = abs(normal);
    v_channel = pattern == 1 ? vec4(0.42, 0.0, 0.0, 0.0) : pattern == 2 ? vec4(0.0, 0.62, 0.0, 0.0) :
                pattern == 3 ? vec4(0.0, 0.0, 0.60, 0.0) : pattern == 4 ? vec4(0.0, 0.0, 0.0, 0.46) : vec4(0.0);
#endif
#ifdef EDGES
    int corner = gl_VertexID % 3;
    v_corner = vec3(corner == 0, corner == 1, corner == 2);
    v_info = info;
#endif
    gl_Position = clip_from_eye * place;
}
)";

/// Edges are drawn by the triangles that have them, so they cost nothing apart and fight with no surface. With DOOR,
/// `door` (door_shader.hpp) goes before it.
inline constexpr std::string_view mesh_fragment = R"(
in vec3 v_place;
#ifdef PATTERNS
in vec3 v_drawn;
flat in vec3 v_facing;
flat in vec4 v_channel;
uniform sampler2D patterns;
#endif
#ifdef LIT_WHOLE
flat in vec4 v_lit;
#else
#ifdef FLAT
flat
#endif
in vec3 v_normal;
flat in vec4 v_colour;
#endif
out vec4 result;
#ifdef EDGES
in vec3 v_corner;
flat in uint v_info;
uniform float edge_width;
uniform vec4 edge_colours[4];

vec4 kind(uint edge) {
    uint k = (v_info >> (2u * edge)) & 3u;
    return k == 0u ? edge_colours[0] : k == 1u ? edge_colours[1] : k == 2u ? edge_colours[2] : edge_colours[3];
}
#endif
void main() {
#ifdef DOOR
    if (is_hole(v_place)) discard;
#endif
#ifdef LIT_WHOLE
    vec3 colour = v_lit.rgb;
    float own = v_lit.a;
#else
    vec3 colour = lit_from_eye(v_normal, v_place, v_colour);
    float own = v_colour.a;
#endif
#ifdef PATTERNS
    // Seen from the axis along which the triangle faces most.
    vec2 at = v_facing.y > 0.6 ? v_drawn.xz : v_facing.x > v_facing.z ? v_drawn.zy : v_drawn.xy;
    colour *= 1.0 + dot(texture(patterns, at) - 0.5, v_channel);
#endif
#ifdef EDGES
    vec3 per_pixel = fwidth(v_corner);
    vec3 far = v_corner / per_pixel;         // pixels from the edges bc, ca, ab
    vec3 tall = 1.0 / per_pixel;             // how many pixels the triangle is high over each
    vec3 cover = clamp(edge_width * 0.5 + 0.5 - far, 0.0, 1.0);
    float room = min(tall.x, min(tall.y, tall.z));
    cover *= smoothstep(1.0, 7.0, room);
    vec4 c = kind(1u);
    colour = mix(colour, c.rgb * c.rgb, cover.x * c.a);
    c = kind(2u);
    colour = mix(colour, c.rgb * c.rgb, cover.y * c.a);
    c = kind(0u);
    colour = mix(colour, c.rgb * c.rgb, cover.z * c.a);
#endif
    result = vec4(sqrt(fogged(colour, v_place, own)), 1.0);
}
)";

}  // namespace surefoot::view::shaders
