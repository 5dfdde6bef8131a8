// A world with a floor and a lift, and three ticks in it. Explained in docs/world.md.
#include <array>
#include <cstdint>
#include <cstdio>

#include <surefoot/surefoot.hpp>

namespace {

surefoot::Expected<surefoot::Mesh> make_plate(float half) {
    const std::array<surefoot::vec3, 4> corners{
        {{-half, 0, half}, {half, 0, half}, {half, 0, -half}, {-half, 0, -half}}};
    const std::array<std::uint32_t, 6> triangles{0, 1, 2, 0, 2, 3};
    return surefoot::Mesh::build({.vertices = corners, .indices = triangles});
}

}  // namespace

int main() {
    const auto ground = make_plate(50);
    const auto plate = make_plate(1);
    if (!ground || !plate) return 1;

    // [place]
    constexpr std::uint32_t ground_id = 0;
    constexpr std::uint32_t lift_id = 1;
    surefoot::World world;
    const auto level = world.add(*ground, {.body = ground_id});
    const auto lift = world.add(*plate, {.pose = {.position = {4, 0.1, 0}}, .body = lift_id, .layers = 2});
    if (!level || !lift) return 1;  // the error says which body and why
    // [/place]

    // [tick]
    surefoot::dvec3 player{4, 1.1, 0};  // stands a little above the lift
    const surefoot::Ellipsoid body{.radii = {0.4, 0.9, 0.4}};
    for (int tick = 0; tick < 3; ++tick) {
        world.begin_tick();
        surefoot::Pose next = world.poses(*lift).end;
        next.position.y += 0.25;
        if (!world.move(*lift, next)) return 1;  // it was not finite

        // Standing still, the player is in the lift's way; riding along, it is not.
        const auto hit = world.sweep(body, {.from = player, .to = player});
        if (hit && hit->body == lift_id) {
            std::printf("the lift arrives after %.0f%% of tick %d\n", 100 * hit->t, tick);
            player = world.carried(*lift, player);
        }
    }
    std::printf("the player is at %.2f m\n", player.y);
    // [/tick]

    // [snapshot]
    std::array<surefoot::BodyPose, 8> saved;  // yours: for as many bodies as can move
    const std::size_t count = world.save_poses(saved, 2);
    if (count > saved.size()) return 1;

    world.begin_tick();
    if (!world.move(*lift, {.position = {4, 9, 0}})) return 1;
    if (!world.restore_poses(std::span(saved).first(count))) return 1;  // as if that had not been
    // [/snapshot]
    return world.poses(*lift).end.position.y == 0.85 ? 0 : 1;
}
