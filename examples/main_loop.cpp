// A game's main loop: fixed steps, pictures in between, a jump. Explained in docs/movement.md.
#include <array>
#include <cstdint>
#include <cstdio>

#include <surefoot/surefoot.hpp>

namespace {

surefoot::Expected<surefoot::Mesh> make_level() {
    // A floor, and a block of 30 cm that is walked on to.
    const std::array<surefoot::vec3, 12> corners{{{-20, 0, 20},
                                                  {20, 0, 20},
                                                  {20, 0, -20},
                                                  {-20, 0, -20},
                                                  {3, 0.3F, 2},
                                                  {6, 0.3F, 2},
                                                  {6, 0.3F, -2},
                                                  {3, 0.3F, -2},
                                                  {3, 0, 2},
                                                  {6, 0, 2},
                                                  {6, 0, -2},
                                                  {3, 0, -2}}};
    const std::array<std::uint32_t, 36> triangles{0, 1,  2, 0, 2, 3, 4,  5,  6, 4,  6, 7, 8,  9, 5, 8,  5, 4,
                                                  9, 10, 6, 9, 6, 5, 10, 11, 7, 10, 7, 6, 11, 8, 4, 11, 4, 7};
    return surefoot::Mesh::build({.vertices = corners, .indices = triangles});
}

}  // namespace

int main() {
    const auto level = make_level();
    if (!level) return std::puts(level.error().text.c_str()), 1;

    // [loop]
    surefoot::World world;
    if (!world.add(*level)) return 1;

    const surefoot::CharacterSettings hero{.volume = surefoot::Ellipsoid{{0.4, 0.9, 0.4}}};
    surefoot::CharacterState before{.position = {0, 1, 0}};
    surefoot::CharacterState after = before;
    surefoot::FixedStep clock{.step = 1.0 / 60};

    for (int frame = 0; frame < 200; ++frame) {
        const double seconds = frame % 3 == 0 ? 0.021 : 0.012;  // yours: how long the last frame took
        const surefoot::CharacterInput input{.wish = {2, 0, 0}, .jump = frame == 150};

        clock.add(seconds);
        while (clock.due()) {
            before = after;
            const surefoot::StepResult result = surefoot::step(world, hero, input, clock.step, before);
            after = result.state;
            if (result.events.has(surefoot::CharacterEvent::stepped_up)) std::puts("up the step");
            if (result.events.has(surefoot::CharacterEvent::jumped)) std::puts("jump");
            if (result.events.has(surefoot::CharacterEvent::landed))
                std::printf("landed at %.1f m/s\n", result.events.landing_speed);
        }

        // Drawn is what lies between the last two states.
        const double blend = clock.blend();
        const double height = before.position.y + blend * (after.position.y - before.position.y);
        if (frame % 50 == 0) std::printf("frame %d: drawn at a height of %.2f m\n", frame, height);
    }
    // [/loop]
    return after.position.x > 3 ? 0 : 1;
}
