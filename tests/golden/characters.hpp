// Characters that walk, jump, climb and ride where everything is drawn: every number of every state is hashed.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <surefoot/surefoot.hpp>

#include "hash.hpp"
#include "queries.hpp"

namespace golden {

inline constexpr int ticks_of_each = 600;

class Playground {
public:
    explicit Playground(Random& random) : random_(random) {
        std::vector<surefoot::vec3> vertices;
        std::vector<std::uint32_t> indices;
        constexpr std::uint32_t side = 17;
        for (std::uint32_t i = 0; i < side * side; ++i) {
            const auto x = static_cast<float>(i % side) - 8;
            const auto z = static_cast<float>(i / side) - 8;
            vertices.push_back(surefoot::vec3(x * 1.5F, eighths(-2, 4), z * 1.5F));
        }
        for (std::uint32_t i = 0; i < side * (side - 1); ++i) {
            if (i % side + 1 == side) continue;
            for (const std::uint32_t corner : {i, i + side, i + side + 1, i, i + side + 1, i + 1}) {
                indices.push_back(corner);
            }
        }
        add(vertices, indices, {});
        for (int k = 0; k < 12; ++k) add_block({.position = {eighths(-80, 80), eighths(-8, 8), eighths(-80, 80)}});
        lift_ = add_block({.position = {1, 0, 1}});
        table_ = add_block({.position = {-3, 0.5, 2}});
    }

    void tick() {
        world_.begin_tick();
        (void)world_.move(lift_, {.position = {1, eighths(0, 8), 1}});
        (void)world_.move(table_, {.position = {-3, 0.5, 2}, .orientation = {1, 0, eighths(-8, 8), 0}});
    }

    const surefoot::World& world() const { return world_; }

private:
    float eighths(std::int64_t low, std::int64_t high) {
        return static_cast<float>(random_.between(low, high)) * 0.125F;
    }

    surefoot::BodyHandle add(const std::vector<surefoot::vec3>& vertices, const std::vector<std::uint32_t>& indices,
                             const surefoot::Pose& pose) {
        const auto mesh = surefoot::Mesh::build({.vertices = vertices, .indices = indices});
        const auto handle = mesh ? world_.add(*mesh, {.pose = pose}) : tl::unexpected(mesh.error());
        return handle ? *handle : surefoot::BodyHandle{};
    }

    surefoot::BodyHandle add_block(const surefoot::Pose& pose) {
        const float x = eighths(2, 12);
        const float y = eighths(1, 12);
        const float z = eighths(2, 12);
        std::vector<surefoot::vec3> corners;
        for (int i = 0; i < 8; ++i) {
            corners.push_back(surefoot::vec3((i & 1) != 0 ? x : -x, (i & 2) != 0 ? y : -y, (i & 4) != 0 ? z : -z));
        }
        return add(corners, {2, 6, 7, 2, 7, 3, 0, 1, 5, 0, 5, 4, 0, 4, 6, 0, 6, 2,
                             1, 3, 7, 1, 7, 5, 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6},
                   pose);
    }

    Random& random_;
    surefoot::World world_;
    surefoot::BodyHandle lift_{};
    surefoot::BodyHandle table_{};
};

inline void add_to(Hash& hash, const surefoot::CharacterState& state) {
    hash << state.position << state.velocity << state.ground_normal << state.ground_velocity << state.since_ground
         << state.since_jump_press << state.since_wall << state.since_dash << state.wall_normal << state.ledge_point
         << state.since_hold << std::uint64_t{state.ground_body} << std::uint64_t{state.ground_triangle}
         << std::uint64_t{state.air_jumps_left} << static_cast<std::uint64_t>(state.footing)
         << static_cast<std::uint64_t>(state.form) << static_cast<std::uint64_t>(state.hold)
         << std::uint64_t{state.is_jumping};
}

inline void walk_about(Hash& hash, std::size_t kind) {
    Random random(900 + kind);
    Playground playground(random);
    const std::array<surefoot::Shape, 6> shapes{surefoot::Sphere{0.5},
                                                surefoot::Ellipsoid{{0.375, 0.875, 0.375}},
                                                surefoot::Capsule{0.375, 0.5},
                                                surefoot::Box{{0.375, 0.875, 0.375}},
                                                surefoot::Cylinder{0.375, 0.875},
                                                surefoot::Cone{0.375, 1.75}};
    surefoot::CharacterSettings settings{.volume = shapes[kind]};
    settings.air_jumps = 1;
    settings.ledge_reach = 0.25;
    settings.vault_height = 1;
    settings.wall_jump_speed = 5;
    settings.dash_speed = 12;
    surefoot::CharacterState state{.position = {0, 4, 0}};
    surefoot::CharacterInput input;
    for (int tick = 0; tick < ticks_of_each; ++tick) {
        if (tick % 16 == 0) {
            const auto sixteenths = [&] { return static_cast<double>(random.between(-96, 96)) * 0.0625; };
            input.wish = {sixteenths(), 0, sixteenths()};
            input.jump = random.between(0, 2) == 0;
            input.dash = random.between(0, 5) == 0;
        }
        if (tick % 100 == 0) state.position = {static_cast<double>(random.between(-8, 8)), 4, 0};
        playground.tick();
        const surefoot::StepResult result = surefoot::step(playground.world(), settings, input, 0.015625, state);
        state = result.state;
        add_to(hash, state);
        hash << std::uint64_t{result.events.set} << result.events.landing_speed;
    }
}

}  // namespace golden
