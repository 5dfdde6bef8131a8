// A game in a day, step 4: coins are taken, and who falls begins again at the last checkpoint.
#include <cstdio>

#include "pickups.hpp"

int main(int count, char** arguments) {
    const auto level = day::load_level(count > 1 ? arguments[1] : "level.glb");
    if (!level) return std::puts(level.error().text.c_str()), 1;
    surefoot::World world;
    if (!world.add(level->still)) return 1;
    const surefoot::CharacterSettings settings = day::hero_settings();

    // [main]
    day::Pickups pickups(*level);
    surefoot::CharacterState hero = day::standing_at(day::restart_place(pickups, *level));
    surefoot::Slab<day::Coin>::Handle wanted;  // the coin that the hero is after

    int falls = 0;
    for (int tick = 0; falls == 0; ++tick) {
        if (pickups.coins.get(wanted) == nullptr) {  // it is gone, and its handle knows: after the next one
            wanted = pickups.coins.begin().handle();
            std::printf("%u coins are left; the next is at z = %.0f\n", pickups.coins.size(),
                        pickups.coins[wanted].place.z);
        }
        const surefoot::dvec3 aim = pickups.coins[wanted].place;
        const bool is_up_there = aim.y > day::feet_of(hero).y + 0.5 && glm::distance(aim, hero.position) < 3;
        const surefoot::CharacterInput input{.wish = day::towards(hero.position, aim, 6), .jump = is_up_there};
        hero = surefoot::step(world, settings, input, day::tick_seconds, hero).state;
        day::touch(pickups, day::feet_of(hero));

        if (day::feet_of(hero).y < -10) {
            ++falls;
            hero = day::standing_at(day::restart_place(pickups, *level));
            std::printf("fell, and begins again at z = %.0f\n", day::feet_of(hero).z);
        }
    }
    // [/main]
    return pickups.coins.size() == 3 ? 0 : 1;
}
