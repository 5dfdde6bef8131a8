// The rules of the whole game: a state and a tick. No window, no clock, no camera.
#pragma once

#include <cstdint>

#include "enemy.hpp"
#include "pickups.hpp"
#include "platforms.hpp"

namespace day {

// [game]
struct Game {
    const Level& level;
    surefoot::NavigationQuery ground;
    surefoot::World world;
    std::vector<Mover> movers;
    Pickups pickups;
    surefoot::Slab<Enemy> enemies{16};
    surefoot::CharacterSettings settings = hero_settings();
    surefoot::CharacterState hero;
    surefoot::CharacterState before;  // the hero as it was when the last tick began,
    surefoot::CharacterInput input;   // and what it was asked to do in it
    std::uint64_t ticks = 0;
    int lives_lost = 0;
    bool is_won = false;

    /// Requires: both outlive the game.
    Game(const Level& its_level, const surefoot::NavigationMesh& mesh)
        : level(its_level), ground(mesh), pickups(its_level) {
        (void)world.add(level.still);
        movers = add_movers(world, level);
        for (const dvec3& place : places(level, "enemy")) (void)enemies.insert(Enemy{.home = place});
        begin_again();
    }

    /// Everybody is put back, so that nobody waits where the hero begins.
    void begin_again() {
        before = hero = standing_at(restart_place(pickups, level));
        for (Enemy& enemy : enemies) enemy = Enemy{.home = enemy.home};
    }

    void tick(const surefoot::CharacterInput& asked) {
        if (is_won) return;
        move_all(world, movers, ++ticks);
        input = asked;
        before = hero;
        hero = surefoot::step(world, settings, input, tick_seconds, before).state;
        for (Enemy& enemy : enemies) move_enemy(enemy, world, ground, feet_of(hero));
        touch(pickups, feet_of(hero));

        bool is_caught = feet_of(hero).y < -10;
        erase_if(enemies, [&](const Enemy& enemy) {
            const Meeting meeting = meet(enemy, hero);
            if (meeting == Meeting::stomped) hero.velocity.y = 6;  // a state is plain: write into it
            is_caught = is_caught || meeting == Meeting::caught;
            return meeting == Meeting::stomped;
        });
        if (is_caught) {
            ++lives_lost;
            begin_again();
        }
        is_won = pickups.coins.size() == 0 && is_near(feet_of(hero), places(level, "goal").at(0), 1.2);
    }
};

/// A number for all that moves: equal games have equal ones.
inline std::uint64_t hash(const Game& game) {
    std::uint64_t sum = surefoot::hash(game.hero);
    for (const Enemy& enemy : game.enemies) sum = 31 * sum + surefoot::hash(enemy.state);
    return 31 * sum + 1000 * game.pickups.coins.size() + game.ticks;
}
// [/game]

}  // namespace day
