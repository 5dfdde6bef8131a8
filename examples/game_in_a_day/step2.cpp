// A game in a day, step 2: the level comes out of a file, with the places that the game needs.
#include <cstdio>

#include "level.hpp"

int main(int count, char** arguments) {
    // [main]
    const auto level = day::load_level(count > 1 ? arguments[1] : "level.glb");
    if (!level) return std::puts(level.error().text.c_str()), 1;
    std::printf("%zu still triangles, %zu platforms, %zu coins\n", level->still.triangle_count(),
                level->platforms.size(), day::places(*level, "coin").size());

    surefoot::World world;
    if (!world.add(level->still)) return 1;
    const surefoot::CharacterSettings hero = day::hero_settings();
    surefoot::CharacterState state = day::standing_at(day::places(*level, "spawn").at(0));

    // Run to the first coin and on north, over the edge.
    const surefoot::dvec3 coin = day::places(*level, "coin").at(0);
    bool has_coin = false;
    for (int tick = 0; tick < 240; ++tick) {
        const surefoot::dvec3 aim = has_coin ? surefoot::dvec3{0, 0, -20} : coin;
        const surefoot::CharacterInput input{.wish = day::towards(state.position, aim, 6)};
        const surefoot::StepResult result = surefoot::step(world, hero, input, day::tick_seconds, state);
        state = result.state;
        if (!has_coin && glm::distance(day::feet_of(state), coin) < 0.5) {
            has_coin = true;
            std::printf("at the coin after %d ticks\n", tick + 1);
        }
        if (result.events.has(surefoot::CharacterEvent::left_ground))
            std::printf("over the edge at z = %.1f\n", state.position.z);
    }
    std::printf("falling at %.0f m/s, %.0f m below the level\n", -state.velocity.y, -state.position.y);
    // [/main]
}
