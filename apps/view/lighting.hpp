/// What the light is like, and how it gets into a shader.
#pragma once

#include <surefoot/math.hpp>

#include "view/gl.hpp"

namespace surefoot::view {

/// The parts of a picture that cost time on a machine without a graphics card.
struct Effects {
    bool shadows = true;
    bool smooth_edges = true;  ///< FXAA
    bool fog = true;
    bool fine_edges = true;     ///< thin lines on the edges of models, where they are no more than decoration
    bool soft_patterns = true;  ///< what is drawn on surfaces is smooth from near by, and not of small squares
    int shadow_size = 2048;     ///< of the map, in texels

    /// What stays is light, fog and the lines that mean something, which are smooth by themselves.
    [[nodiscard]] static Effects full() { return {}; }
    [[nodiscard]] static Effects software() {
        return {.shadows = false,
                .smooth_edges = false,
                .fog = true,
                .fine_edges = false,
                .soft_patterns = false,
                .shadow_size = 1024};
    }

    [[nodiscard]] bool operator==(const Effects&) const = default;
};

/// Colours of light; as they add up, not as they are shown.
struct Sky {
    dvec3 towards_sun{0.42, 0.80, 0.43};
    vec3 sun{1.02F, 0.92F, 0.76F};
    vec3 above{0.34F, 0.41F, 0.52F};   ///< light from the sky on what faces up
    vec3 below{0.20F, 0.185F, 0.17F};  ///< light from the ground on what faces down
    vec3 zenith{0.115F, 0.26F, 0.47F};
    vec3 horizon{0.66F, 0.735F, 0.76F};
    vec3 nadir{0.40F, 0.45F, 0.49F};
    double fog_distance = 900;  ///< where half of the colour is the fog's [m]
    double shadow_radius = 90;  ///< larger levels have the shadows of a region around what is looked at [m]
};

/// What every lit thing of one frame shares.
struct Lighting {
    gl::vec3 to_sun;
    gl::vec3 up;
    const Sky* sky;
    bool fog;
    gl::mat4 still_from_eye{1};
    gl::mat4 moving_from_eye{1};
    gl::vec4 shadow_size{0, 0, 0, 0};
    float moving_strength = 0;

    /// The program has to be in use. Shadow maps are in texture units 0 (still) and 1 (moving).
    void set(const gl::Program& program) const;
};

}  // namespace surefoot::view
