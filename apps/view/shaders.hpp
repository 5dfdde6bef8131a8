/// The sources of all shaders: the part of GLSL that 3.30 and ES 3.00 share. `gl::Program` puts the version before
/// them. Colours are squared to compute with light and rooted to show it, a cheap stand-in for the curve of sRGB.
/// Places are relative to the eye.
#pragma once

#include <string_view>

namespace surefoot::view::shaders {

/// Light from the sun, the sky and the ground, shadow, and fog; for whatever stands in the world.
inline constexpr std::string_view light = R"(
uniform vec3 to_sun;
uniform vec3 up;
uniform vec3 sun_colour;
uniform vec3 sky_colour;
uniform vec3 ground_colour;
uniform vec3 fog_colour;
uniform float fog;           // per metre, squared
uniform mat4 still_from_eye; // into the shadow map of what stands still
uniform mat4 moving_from_eye;
uniform vec4 shadow_size;    // one texel of either map in the map, and in metres
uniform float moving_strength;
#ifdef SHADOWS
uniform sampler2DShadow still_map;
uniform sampler2DShadow moving_map;

float lit(sampler2DShadow map, vec3 at, float texel) {
    if (any(lessThan(at, vec3(0.0))) || any(greaterThan(at.xy, vec2(1.0)))) return 1.0;
    at.z = min(at.z, 1.0); // beyond the map's end is as far as it tells
    vec2 d = vec2(texel * 0.75, texel * -0.75);
    return 0.25 * (texture(map, at + vec3(d.xx, 0.0)) + texture(map, at + vec3(d.xy, 0.0)) +
                   texture(map, at + vec3(d.yx, 0.0)) + texture(map, at + vec3(d.yy, 0.0)));
}
#endif

float sunlight(vec3 place, vec3 normal, float facing) {
#ifdef SHADOWS
    if (facing <= 0.0) return 0.0;
    float slope = 1.0 - facing * facing;
    vec3 from = place + normal * shadow_size.z * (0.6 + 1.8 * slope);
    float light = lit(still_map, (still_from_eye * vec4(from, 1.0)).xyz, shadow_size.x);
    if (moving_strength > 0.0) {
        from = place + normal * shadow_size.w * (0.6 + 1.8 * slope);
        light *= mix(1.0, lit(moving_map, (moving_from_eye * vec4(from, 1.0)).xyz, shadow_size.y), moving_strength);
    }
    return light * facing;
#else
    return max(facing, 0.0);
#endif
}

vec3 shaded(vec3 albedo, vec3 place, vec3 normal) {
    float facing = dot(normal, to_sun);
    float height = 0.5 + 0.5 * dot(normal, up);
    vec3 light = mix(ground_colour, sky_colour, height) + sun_colour * sunlight(place, normal, facing);
    return albedo * light;
}

// What shines by itself is seen farther through fog.
vec3 fogged(vec3 colour, vec3 place, float own) {
    float d = dot(place, place) * fog;
    return mix(colour, fog_colour, d / (1.0 + d) * (1.0 - 0.8 * own));
}
vec3 fogged(vec3 colour, vec3 place) { return fogged(colour, place, 0.0); }
)";

inline constexpr std::string_view depth_vertex = R"(
layout(location = 0) in vec3 position;
uniform mat4 clip_from_model;
void main() { gl_Position = clip_from_model * vec4(position, 1.0); }
)";

inline constexpr std::string_view depth_fragment = "void main() {}\n";

inline constexpr std::string_view shape_vertex = R"(
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
uniform mat4 clip_from_eye;
uniform mat4 eye_from_model;
out vec3 v_place;
out vec3 v_normal;
void main() {
    vec4 place = eye_from_model * vec4(position, 1.0);
    v_place = place.xyz;
    v_normal = mat3(eye_from_model) * normal;
    gl_Position = clip_from_eye * place;
}
)";

/// A translucent body is denser towards its rim, as one of glass is.
inline constexpr std::string_view shape_fragment = R"(
in vec3 v_place;
in vec3 v_normal;
uniform vec4 colour;
out vec4 result;
void main() {
    vec3 normal = normalize(v_normal);
    vec3 look = normalize(v_place);
    float facing = abs(dot(normal, look));
    if (dot(normal, look) > 0.0) normal = -normal;
    // Light goes round a body of glass and through it, so there is no dark half.
    float round = 0.5 + 0.5 * dot(normal, to_sun);
    float height = 0.5 + 0.5 * dot(normal, up);
    vec3 lit_colour = colour.rgb * colour.rgb * (mix(ground_colour, sky_colour, height) * 1.15 + sun_colour * round * 0.85);
    vec3 mirrored = reflect(look, normal);
    float gleam = max(dot(mirrored, to_sun), 0.0);
    gleam *= gleam; gleam *= gleam; gleam *= gleam; gleam *= gleam;
    lit_colour += sun_colour * gleam * 0.12;
    float rim = 1.0 - facing;
    float alpha = colour.a + (1.0 - colour.a) * rim * rim * rim * 0.75;
    result = vec4(sqrt(fogged(lit_colour, v_place)), colour.a >= 1.0 ? 1.0 : alpha);
}
)";

inline constexpr std::string_view flat_vertex = R"(
layout(location = 0) in vec3 position;
layout(location = 1) in vec4 colour;
uniform mat4 clip_from_eye;
uniform float lift;
out vec4 v_colour;
void main() {
    v_colour = colour;
    gl_Position = clip_from_eye * vec4(position, 1.0);
    // As deep as a place a little nearer to the eye, so that it lies on what it covers.
    vec4 nearer = clip_from_eye * vec4(position * (1.0 - lift), 1.0);
    gl_Position.z = nearer.z / nearer.w * gl_Position.w;
}
)";

inline constexpr std::string_view flat_fragment = R"(
in vec4 v_colour;
out vec4 result;
void main() { result = v_colour; }
)";

inline constexpr std::string_view sky_vertex = R"(
uniform vec3 view_forward;
uniform vec3 view_right;
uniform vec3 view_above;
out vec3 v_look;
void main() {
    vec2 at = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
    v_look = view_forward + view_right * at.x + view_above * at.y;
    gl_Position = vec4(at, 1.0, 1.0);
}
)";

inline constexpr std::string_view sky_fragment = R"(
in vec3 v_look;
uniform vec3 up;
uniform vec3 to_sun;
uniform vec3 zenith;
uniform vec3 horizon;
uniform vec3 nadir;
out vec4 result;
void main() {
    vec3 look = normalize(v_look);
    float height = dot(look, up);
    float rise = clamp(height * 1.5, 0.0, 1.0);
    vec3 colour = mix(horizon, zenith, rise * (2.0 - rise));
    colour = mix(colour, nadir, smoothstep(0.0, -0.5, height));
    float near_sun = max(dot(look, to_sun), 0.0);
    float glow = near_sun * near_sun * near_sun * near_sun;
    colour += vec3(0.10, 0.07, 0.03) * glow * glow;
    // Half a step of noise, so that the gradient has no bands.
    float noise = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
    result = vec4(sqrt(colour) + (noise - 0.5) / 255.0, 1.0);
}
)";

/// One line an instance, with round ends of two widths; a point is a line without length, an arrow's head one that
/// shrinks to nothing.
inline constexpr std::string_view line_vertex = R"(
layout(location = 0) in vec3 from;
layout(location = 1) in vec3 to;
layout(location = 2) in vec3 widths; // at either end in pixels, and how much of it is seen behind things
layout(location = 3) in vec4 colour;
uniform mat4 clip_from_eye;
uniform vec2 picture;
uniform float nearest;
uniform float lift;
uniform float pixel; // how large one is a metre away
uniform float behind;
flat out vec4 v_ends;
flat out vec2 v_radii;
flat out vec4 v_colour;

// A round thing in the picture's plane lies before the surface that it marks, and is not cut in half by it.
float depth_of(vec3 place, float radius) {
    vec4 nearer = clip_from_eye * vec4(place * (1.0 - lift - min(radius * pixel * 2.5, 0.1)), 1.0);
    return nearer.z / max(nearer.w, 1e-6);
}

void main() {
    vec3 a = from;
    vec3 b = to;
    float a_depth = (clip_from_eye * vec4(a, 1.0)).w;
    float b_depth = (clip_from_eye * vec4(b, 1.0)).w;
    float limit = nearest * 1.01;
    v_ends = vec4(0.0);
    v_radii = vec2(0.0);
    v_colour = colour;
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
    if (a_depth < limit && b_depth < limit) return;
    if (a_depth < limit) a = mix(b, a, (b_depth - limit) / (b_depth - a_depth));
    if (b_depth < limit) b = mix(a, b, (a_depth - limit) / (a_depth - b_depth));
    vec4 a_clip = clip_from_eye * vec4(a, 1.0);
    vec4 b_clip = clip_from_eye * vec4(b, 1.0);
    vec2 a_at = (a_clip.xy / a_clip.w * 0.5 + 0.5) * picture;
    vec2 b_at = (b_clip.xy / b_clip.w * 0.5 + 0.5) * picture;
    vec2 along = b_at - a_at;
    float length_along = length(along);
    along = length_along > 1e-4 ? along / length_along : vec2(1.0, 0.0);
    vec2 radii = widths.xy * 0.5;
    // Thinner than a pixel is a pixel that is seen less.
    float strongest = max(max(radii.x, radii.y), 1e-3);
    v_colour.a *= min(strongest * 2.0, 1.0);
    if (strongest < 0.5) radii *= 0.5 / strongest;
    if (behind > 0.5) v_colour.a *= widths.z;
    bool at_end = gl_VertexID > 1;
    float side = (gl_VertexID & 1) == 0 ? -1.0 : 1.0;
    float room = max(radii.x, radii.y) + 1.0;
    vec2 corner = at_end ? b_at + along * room : a_at - along * room;
    corner += vec2(-along.y, along.x) * side * room;
    v_ends = vec4(a_at, b_at);
    v_radii = radii;
    gl_Position = vec4(corner / picture * 2.0 - 1.0, depth_of(at_end ? b : a, max(radii.x, radii.y)), 1.0);
}
)";

inline constexpr std::string_view line_fragment = R"(
flat in vec4 v_ends;
flat in vec2 v_radii;
flat in vec4 v_colour;
out vec4 result;
void main() {
    vec2 at = gl_FragCoord.xy - v_ends.xy;
    vec2 along = v_ends.zw - v_ends.xy;
    float square = dot(along, along);
    float share = square > 0.0 ? clamp(dot(at, along) / square, 0.0, 1.0) : 0.0;
    float gap = length(at - along * share) - mix(v_radii.x, v_radii.y, share);
    float cover = clamp(0.5 - gap, 0.0, 1.0);
    if (cover <= 0.0) discard;
    result = vec4(v_colour.rgb, v_colour.a * cover);
}
)";

inline constexpr std::string_view screen_vertex = R"(
void main() {
    gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0);
}
)";

/// Cheap anti-aliasing of the finished picture, after the idea of Lottes's FXAA: where brightness jumps, blend along
/// the edge.
inline constexpr std::string_view smooth_fragment = R"(
uniform sampler2D picture;
uniform vec2 texel;
out vec4 result;

float bright(vec3 c) { return dot(c, vec3(0.30, 0.59, 0.11)); }

void main() {
    // Whole texels first: where nothing jumps, and that is nearly everywhere, there is nothing to blend.
    ivec2 here = ivec2(gl_FragCoord.xy);
    ivec2 last = textureSize(picture, 0) - 1;
    vec3 middle = texelFetch(picture, here, 0).rgb;
    float m = bright(middle);
    float sw = bright(texelFetch(picture, max(here - 1, ivec2(0)), 0).rgb);
    float se = bright(texelFetch(picture, clamp(here + ivec2(1, -1), ivec2(0), last), 0).rgb);
    float nw = bright(texelFetch(picture, clamp(here + ivec2(-1, 1), ivec2(0), last), 0).rgb);
    float ne = bright(texelFetch(picture, min(here + 1, last), 0).rgb);
    float low = min(m, min(min(sw, se), min(nw, ne)));
    float high = max(m, max(max(sw, se), max(nw, ne)));
    if (high - low < max(0.025, high * 0.06)) {
        result = vec4(middle, 1.0);
        return;
    }
    vec2 at = gl_FragCoord.xy * texel;
    vec2 along = vec2(sw + se - nw - ne, nw + sw - ne - se);
    float least = min(abs(along.x), abs(along.y)) + 0.02 * (sw + se + nw + ne) + 0.004;
    along = clamp(along / least, -6.0, 6.0) * texel;
    vec3 near_by = 0.5 * (texture(picture, at - along * 0.166).rgb + texture(picture, at + along * 0.166).rgb);
    vec3 wide = 0.5 * near_by + 0.25 * (texture(picture, at - along * 0.5).rgb + texture(picture, at + along * 0.5).rgb);
    float w = bright(wide);
    result = vec4(w < low || w > high ? near_by : wide, 1.0);
}
)";

}  // namespace surefoot::view::shaders
