// A game in a day, step 8: a game is its inputs. Played again they give the same game, to the last bit.
#include <cstdio>

#include "script.hpp"

int main(int count, char** arguments) {
    const auto level = day::load_level(count > 1 ? arguments[1] : "level.glb");
    if (!level) return std::puts(level.error().text.c_str()), 1;
    const auto mesh = day::find_ground(*level);
    if (!mesh) return std::puts(mesh.error().text.c_str()), 1;

    // [main]
    day::Game game(*level, *mesh);
    day::Script script;
    std::vector<surefoot::CharacterInput> inputs;
    while (!game.is_won && game.ticks < 3600) {
        inputs.push_back(script.input(game));
        game.tick(inputs.back());
    }
    std::printf("won: %s, after %d ticks and %d lost lives, with %u enemies left\n", game.is_won ? "yes" : "no",
                int(game.ticks), game.lives_lost, game.enemies.size());

    const auto play = [&] {
        day::Game again(*level, *mesh);
        for (const surefoot::CharacterInput& input : inputs) again.tick(input);
        return day::hash(again);
    };
    const bool is_same = play() == day::hash(game);
    inputs.back().wish.x += 1e-9;
    const bool is_other = play() != day::hash(game);
    std::printf("played again: %s\n", is_same ? "the same hash" : "another hash");
    std::printf("with a nanometre a second more at the end: %s\n", is_other ? "another hash" : "the same hash");
    // [/main]
    return game.is_won && is_same && is_other ? 0 : 1;
}
