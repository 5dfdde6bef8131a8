// A hero, the ground that it walks on, and walks: what tests of what one sees begin with.
#pragma once

#include <cstdint>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <vector>

#include <surefoot/character.hpp>
#include <surefoot/import.hpp>
#include <surefoot/mesh.hpp>
#include <surefoot/random.hpp>
#include <surefoot/world.hpp>

namespace surefoot::platformer::tests {

inline constexpr double tick = 1.0 / 60;

inline CharacterSettings hero_settings() {
    CharacterSettings s;
    s.volume = Ellipsoid{{0.35, 0.8, 0.35}};
    s.crouched = Ellipsoid{{0.35, 0.45, 0.35}};
    s.gravity = 22;
    s.jump_height = 1.5;
    s.air_jumps = 1;
    s.wall_slide_speed = 2.5;
    s.wall_jump_speed = 6.5;
    s.dash_speed = 14;
    s.dash_time = 0.18;
    s.dash_pause = 0.5;
    s.ledge_reach = 0.35;
    s.hands_height = 1.4;
    s.flat_foot = true;
    return s;
}

/// Boxes put together into a mesh.
class Blocks {
public:
    Blocks& add(const dvec3& low, const dvec3& high) {
        const auto first = static_cast<std::uint32_t>(vertices_.size());
        for (int i = 0; i < 8; ++i)
            vertices_.emplace_back((i & 1) != 0 ? high.x : low.x, (i & 2) != 0 ? high.y : low.y,
                                   (i & 4) != 0 ? high.z : low.z);
        for (const std::uint32_t k : {0U, 4U, 6U, 0U, 6U, 2U, 1U, 3U, 7U, 1U, 7U, 5U, 0U, 1U, 5U, 0U, 5U, 4U,
                                      2U, 6U, 7U, 2U, 7U, 3U, 0U, 2U, 3U, 0U, 3U, 1U, 4U, 5U, 7U, 4U, 7U, 6U})
            indices_.push_back(first + k);
        return *this;
    }
    [[nodiscard]] Mesh mesh() const { return *Mesh::build({.vertices = vertices_, .indices = indices_}); }

private:
    std::vector<vec3> vertices_;
    std::vector<std::uint32_t> indices_;
};

inline World world_of(const Mesh& mesh) {
    World world;
    EXPECT_TRUE(world.add(mesh).has_value());
    return world;
}

inline Mesh training_ground() {
    const auto level = import_level(SUREFOOT_LEVELS_DIR "/training-ground.glb");
    EXPECT_TRUE(level.has_value()) << level.error().text;
    return *Mesh::build({.vertices = level->vertices, .indices = level->indices, .surfaces = level->surfaces});
}

/// Numbers that are the same on every machine.
class Random {
public:
    explicit Random(std::uint64_t seed) : state_(seed) {}
    double in(double low, double high) { return low + (high - low) * next_share(state_); }

private:
    std::uint64_t state_;
};

}  // namespace surefoot::platformer::tests
