// A game in a day, step 7: a picture of it, in a window or in a file.
//
//     step7 LEVEL            a window, if there is a display
//     step7 LEVEL --script   game.ppm
#include <cstdio>
#include <cstring>

#include "picture.hpp"
#include "window.hpp"

int main(int count, char** arguments) {
    const auto level = day::load_level(count > 1 ? arguments[1] : "level.glb");
    if (!level) return std::puts(level.error().text.c_str()), 1;
    const auto mesh = day::find_ground(*level);
    if (!mesh) return std::puts(mesh.error().text.c_str()), 1;
    const bool is_script = count > 2 && std::strcmp(arguments[2], "--script") == 0;

    // [main]
    day::Game game(*level, *mesh);
    day::Camera camera;
    const std::unique_ptr<day::Window> window = is_script ? nullptr : day::Window::open();
    day::Keys keys;
    while (game.ticks < 150 || window) {
        if (window && !window->poll(keys)) return 0;
        game.tick({.wish = day::towards(game.hero.position, {0, 0, -9}, 6)});
        day::follow(camera, game.world, game.hero.position);
        if (window) window->show(day::scene_of(game, camera, 1, window->width_by_height()), "step 7");
    }
    day::Picture picture(1280, 720);
    picture.draw(day::scene_of(game, camera, 1, 1280.0 / 720));
    if (!picture.save("game.ppm")) return 1;
    std::printf("game.ppm: about %.0f tenths of it are not sky\n", 10 * picture.covered());
    // [/main]
    return picture.covered() > 0.3 ? 0 : 1;
}
