// What is to be seen of a game: triangles with colours, as any renderer takes them.
#pragma once

#include <array>
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <numbers>

#include "camera.hpp"
#include "game.hpp"

namespace day {

// [drawn]
struct Colour {
    double r, g, b;
};

struct Drawn {
    std::array<dvec3, 3> corners;
    Colour colour;  // with its light
};

struct Scene {
    std::vector<Drawn> triangles;
    glm::dmat4 view_and_projection;
};

inline void draw(Scene& scene, const dvec3& a, const dvec3& b, const dvec3& c, const Colour& colour) {
    const dvec3 across = glm::cross(b - a, c - a);
    if (glm::length(across) == 0) return;
    const double light = 0.65 + 0.35 * glm::dot(glm::normalize(across), glm::normalize(dvec3{0.4, 1, 0.6}));
    scene.triangles.push_back({{a, b, c}, {light * colour.r, light * colour.g, light * colour.b}});
}
// [/drawn]

inline void draw(Scene& scene, const surefoot::Mesh& mesh, const dvec3& place, const Level& level) {
    for (std::uint32_t id = 0; id < mesh.triangle_count(); ++id) {
        const std::string& name = level.surfaces[mesh.surface(id)];
        const Colour colour = name == "grass"         ? Colour{0.45, 0.68, 0.35}
                              : name == "light grass" ? Colour{0.52, 0.75, 0.40}
                              : name == "earth"       ? Colour{0.55, 0.42, 0.32}
                              : name == "brick"       ? Colour{0.80, 0.52, 0.42}
                              : name == "wood"        ? Colour{0.72, 0.55, 0.33}
                                                      : Colour{0.66, 0.70, 0.76};
        const surefoot::Triangle triangle = mesh.triangle(id);
        draw(scene, triangle.a + place, triangle.b + place, triangle.c + place, colour);
    }
}

/// With 4 slices and 2 rings it is an octahedron.
inline void draw_ball(Scene& scene, const dvec3& middle, const dvec3& radii, const Colour& colour, int slices = 16,
                      int rings = 12) {
    const auto at = [&](int slice, int ring) {
        const double around = 2 * std::numbers::pi * slice / slices;
        const double down = std::numbers::pi * ring / rings;
        return middle +
               radii * dvec3{std::sin(down) * std::sin(around), std::cos(down), std::sin(down) * std::cos(around)};
    };
    for (int ring = 0; ring < rings; ++ring)
        for (int slice = 0; slice < slices; ++slice) {
            draw(scene, at(slice, ring), at(slice, ring + 1), at(slice + 1, ring + 1), colour);
            draw(scene, at(slice, ring), at(slice + 1, ring + 1), at(slice + 1, ring), colour);
        }
}

// [scene]
/// The game between its last two ticks.
inline Scene scene_of(const Game& game, const Camera& camera, double blend, double width_by_height) {
    Scene scene;
    draw(scene, game.level.still, {0, 0, 0}, game.level);
    for (std::size_t i = 0; i < game.movers.size(); ++i) {
        const surefoot::BodyPose poses = game.world.poses(game.movers[i].body);
        draw(scene, game.level.platforms[i].mesh, glm::mix(poses.start.position, poses.end.position, blend),
             game.level);
    }
    for (const Coin& coin : game.pickups.coins)
        draw_ball(scene, coin.place + dvec3{0, 0.6, 0}, {0.3, 0.4, 0.3}, {1, 0.8, 0.15}, 4, 2);
    for (const Checkpoint& checkpoint : game.pickups.checkpoints)
        draw_ball(scene, checkpoint.place + dvec3{1.5, 1, 0}, {0.15, 1, 0.15},
                  checkpoint.is_reached ? Colour{0.3, 0.9, 0.5} : Colour{0.6, 0.6, 0.6}, 4, 2);
    draw_ball(scene, places(game.level, "goal").at(0) + dvec3{0, 1.5, 0}, {0.6, 1.2, 0.6}, {0.35, 0.6, 1}, 4, 2);
    const dvec3 size{0.35, hero_half_height, 0.35};
    for (const Enemy& enemy : game.enemies)
        draw_ball(scene, glm::mix(enemy.before.position, enemy.state.position, blend), size, {0.6, 0.3, 0.75});
    const dvec3 hero = glm::mix(game.before.position, game.hero.position, blend);
    draw_ball(scene, hero, size, {0.95, 0.4, 0.2});
    if (const auto below = game.world.ray({hero, hero - dvec3{0, 20, 0}}, {.begin = blend, .end = blend}))
        draw_ball(scene, below->point + dvec3{0, 0.02, 0}, {0.4, 0.01, 0.4}, {0.2, 0.25, 0.2});  // its shadow

    const dvec3 eye = camera.eye() + (hero - game.hero.position);
    scene.view_and_projection =
        glm::perspective(1.0, width_by_height, 0.1, 200.0) * glm::lookAt(eye, eye + camera.view(), dvec3{0, 1, 0});
    return scene;
}
// [/scene]

}  // namespace day
