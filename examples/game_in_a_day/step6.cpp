// A game in a day, step 6: a camera that comes near where there is a wall behind it.
#include <cstdio>

#include "camera.hpp"
#include "level.hpp"

int main(int count, char** arguments) {
    const auto level = day::load_level(count > 1 ? arguments[1] : "level.glb");
    if (!level) return std::puts(level.error().text.c_str()), 1;
    surefoot::World world;
    if (!world.add(level->still)) return 1;
    const surefoot::CharacterSettings settings = day::hero_settings();
    surefoot::CharacterState hero = day::standing_at(day::places(*level, "spawn").at(0));

    // [main]
    day::Camera camera;
    for (int tick = 0; tick < 180; ++tick) {
        const surefoot::CharacterInput input{.wish = tick < 60 ? surefoot::dvec3{0, 0, 0} : 3.0 * camera.forward()};
        hero = surefoot::step(world, settings, input, day::tick_seconds, hero).state;
        day::follow(camera, world, hero.position);
        if (tick % 60 == 59)
            std::printf("the hero is at z = %.1f, the camera %.1f m behind, at z = %.1f\n", hero.position.z,
                        camera.length, camera.eye().z);
        std::array<surefoot::Overlap, 1> touched;
        if (world.overlap(surefoot::Sphere{.radius = 0.19}, camera.eye(), touched) > 0)
            return std::puts("the camera is inside of something"), 1;
    }
    // [/main]
}
