// A game in a day, step 3: a ferry over the gap, and a lift.
#include <cstdio>

#include "autopilot.hpp"

int main(int count, char** arguments) {
    const auto level = day::load_level(count > 1 ? arguments[1] : "level.glb");
    if (!level) return std::puts(level.error().text.c_str()), 1;
    surefoot::World world;
    if (!world.add(level->still)) return 1;
    const std::vector<day::Mover> movers = day::add_movers(world, *level);
    const surefoot::CharacterSettings settings = day::hero_settings();
    surefoot::CharacterState hero = day::standing_at(day::places(*level, "spawn").at(0));

    // [main]
    day::Autopilot player({{.to = {0, 0, -13}},
                           {.to = {}, .rides = 0},
                           {.to = {2, 0, -27}},
                           {.to = {2, 0, -34}},
                           {.to = {0, 0, -36}},
                           {.to = {}, .rides = 1},
                           {.to = {0, 4, -45}}});
    std::uint32_t stood_on = 0;
    for (std::uint64_t tick = 1; tick < 3600 && !player.is_done(); ++tick) {
        day::move_all(world, movers, tick);
        const surefoot::CharacterInput input{.wish = player.wish(world, movers, hero)};
        hero = surefoot::step(world, settings, input, day::tick_seconds, hero).state;
        if (hero.footing == surefoot::Footing::ground && hero.ground_body != stood_on) {
            stood_on = hero.ground_body;
            const surefoot::dvec3 feet = day::feet_of(hero);
            std::printf("tick %4d: on body %u, at z = %.1f, height %.1f m\n", int(tick), stood_on, feet.z, feet.y);
        }
    }
    std::printf("arrived: %s\n", player.is_done() ? "yes" : "no");
    // [/main]
    return player.is_done() ? 0 : 1;
}
