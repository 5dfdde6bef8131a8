// A game in a day, step 5: an enemy comes round a wall for a hero who stands still.
#include <cstdio>

#include "enemy.hpp"

int main(int count, char** arguments) {
    const auto level = day::load_level(count > 1 ? arguments[1] : "level.glb");
    if (!level) return std::puts(level.error().text.c_str()), 1;
    surefoot::World world;
    if (!world.add(level->still)) return 1;

    // [main]
    const auto mesh = day::find_ground(*level);
    if (!mesh) return std::puts(mesh.error().text.c_str()), 1;
    const surefoot::NavigationQuery ground(*mesh);

    day::Enemy enemy{.home = day::places(*level, "enemy").at(0)};
    const surefoot::CharacterState hero = day::standing_at({-4, 0, -27});  // the wall is between them
    day::Meeting meeting = day::Meeting::none;
    int tick = 0;
    for (; tick < 600 && meeting == day::Meeting::none; ++tick) {
        day::move_enemy(enemy, world, ground, day::feet_of(hero));
        meeting = day::meet(enemy, hero);
        if (tick == 0) {
            const double straight = glm::distance(enemy.home, day::feet_of(hero));
            std::printf("%.1f m away, and %.1f m to walk\n", straight, enemy.follower.line().length());
        }
        if (tick % 60 == 59)
            std::printf("after %d s at x = %.1f, z = %.1f\n", (tick + 1) / 60, enemy.state.position.x,
                        enemy.state.position.z);
    }
    std::printf("%s after %.1f s\n", meeting == day::Meeting::caught ? "caught" : "not caught", tick / 60.0);
    // [/main]
    return meeting == day::Meeting::caught ? 0 : 1;
}
