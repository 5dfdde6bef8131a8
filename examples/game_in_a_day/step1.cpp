// A game in a day, step 1: a loop without a window, and a hero that runs and jumps over a level made in code.
// docs/game-in-a-day.md tells the story.
#include <cstdint>
#include <cstdio>
#include <vector>

#include "hero.hpp"

namespace {

// [box]
struct Triangles {
    std::vector<surefoot::vec3> corners;
    std::vector<std::uint32_t> indices;  // three a triangle, counter-clockwise when seen from the front
};

void add_box(Triangles& to, const surefoot::vec3& low, const surefoot::vec3& high) {
    const auto first = std::uint32_t(to.corners.size());
    for (int corner = 0; corner < 8; ++corner)
        to.corners.push_back({corner & 1 ? high.x : low.x, corner & 2 ? high.y : low.y, corner & 4 ? high.z : low.z});
    constexpr std::uint32_t sides[] = {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 4, 6, 0, 6, 2,   // north, south, west
                                       1, 3, 7, 1, 7, 5, 2, 6, 7, 2, 7, 3, 0, 1, 5, 0, 5, 4};  // east, top, bottom
    for (const std::uint32_t corner : sides) to.indices.push_back(first + corner);
}
// [/box]

}  // namespace

int main() {
    // [level]
    Triangles level;
    add_box(level, {-5, -1, -20}, {5, 0, 5});      // the ground: its top is at y = 0
    add_box(level, {-1, 0, -9}, {1, 1, -7});       // a crate, too high to step on
    add_box(level, {-5, 0, -15}, {5, 0.3F, -13});  // a kerb, low enough
    const auto mesh = surefoot::Mesh::build({.vertices = level.corners, .indices = level.indices});
    if (!mesh) return std::puts(mesh.error().text.c_str()), 1;

    surefoot::World world;
    if (!world.add(*mesh)) return 1;
    // [/level]

    // [loop]
    const surefoot::CharacterSettings hero = day::hero_settings();
    surefoot::CharacterState before = day::standing_at({0, 0, 3});
    surefoot::CharacterState now = before;
    surefoot::FixedStep clock{.step = day::tick_seconds};

    for (int frame = 0; frame < 144; ++frame) {
        clock.add(1.0 / 36);  // yours: how long the last frame took. This machine is slow, and the game is not
        while (clock.due()) {
            // North is -Z. The button goes down two metres before the crate.
            const surefoot::CharacterInput input{.wish = {0, 0, -6},
                                                 .jump = now.position.z < -5 && now.position.z > -7};
            before = now;
            const surefoot::StepResult result = surefoot::step(world, hero, input, clock.step, before);
            now = result.state;

            const double z = now.position.z;
            if (result.events.has(surefoot::CharacterEvent::jumped)) std::printf("jumps at z = %.1f\n", z);
            if (result.events.has(surefoot::CharacterEvent::landed))
                std::printf("lands at z = %.1f, at a height of %.1f m\n", z, day::feet_of(now).y);
            if (result.events.has(surefoot::CharacterEvent::stepped_up)) std::printf("steps up at z = %.1f\n", z);
            if (result.events.has(surefoot::CharacterEvent::left_ground))
                std::printf("leaves the ground at z = %.1f\n", z);
        }

        // What is drawn lies between the last two ticks.
        const surefoot::dvec3 drawn = before.position + clock.blend() * (now.position - before.position);
        if (frame % 36 == 35) std::printf("frame %d: drawn at z = %.2f\n", frame, drawn.z);
    }
    // [/loop]
}
