// A game in a day, step 9: the whole small game.
//
//     step9 LEVEL            in a window: WASD or arrows, space; Q, E, R, F turn the camera; C saves a moment; Enter
//     begins anew step9 LEVEL --script   plays by itself, and leaves three pictures
#include <chrono>
#include <cstdio>
#include <cstring>
#include <optional>

#include "picture.hpp"
#include "script.hpp"
#include "window.hpp"

namespace {

// [moment]
/// "Why did I stop?" The last tick once more, with everything that it asked the world, into a file; and in words.
bool save_moment(const day::Game& game, const std::string& path) {
    surefoot::StepCapture moment =
        surefoot::capture_step(game.world, game.settings, game.input, day::tick_seconds, game.before);
    moment.note = "I expected to get on";
    const auto saved = surefoot::write_capture(moment, path);
    if (!saved) return std::puts(saved.error().text.c_str()), false;
    for (const surefoot::StepSentence& sentence : surefoot::explain(surefoot::story_of(moment)))
        std::puts(sentence.text.c_str());
    const auto read = surefoot::read_step_capture(path);
    return read && surefoot::replay(*read).is_same();
}
// [/moment]

// [play]
void play(day::Window& window, const day::Level& level, const surefoot::NavigationMesh& mesh) {
    using Seconds = std::chrono::duration<double>;
    std::optional<day::Game> game(std::in_place, level, mesh);
    day::Camera camera;
    day::Keys keys;
    surefoot::FixedStep clock{.step = day::tick_seconds};
    auto last = std::chrono::steady_clock::now();
    bool saves = false;
    while (window.poll(keys)) {
        const auto now = std::chrono::steady_clock::now();
        clock.add(Seconds(now - last).count());
        last = now;
        while (clock.due()) {
            camera.yaw += 2 * keys.turn * clock.step;
            camera.pitch = glm::clamp(camera.pitch + keys.tilt * clock.step, -1.2, 0.3);
            surefoot::dvec3 wish = camera.forward() * keys.north + camera.right() * keys.east;
            if (glm::length(wish) > 0) wish = 6.0 * glm::normalize(wish);
            game->tick({.wish = wish, .jump = keys.jump});
            day::follow(camera, game->world, game->hero.position);
        }
        if (keys.restart) game.emplace(level, mesh);
        if (keys.save && !saves) (void)save_moment(*game, "moment.json");
        saves = keys.save;
        const std::string title = game->is_won ? "You have won. Enter begins anew"
                                               : std::to_string(game->pickups.coins.size()) + " coins to go";
        window.show(day::scene_of(*game, camera, clock.blend(), window.width_by_height()), title);
    }
}
// [/play]

// [script]
bool play_script(const day::Level& level, const surefoot::NavigationMesh& mesh) {
    day::Game game(level, mesh);
    day::Camera camera;
    day::Script script;
    while (!game.is_won && game.ticks < 3600) {
        game.tick(script.input(game));
        day::follow(camera, game.world, game.hero.position);
        if (game.ticks != 800 && game.ticks != 1060 && game.ticks != 1750) continue;  // ferry, enemy, lift
        day::Picture picture(1280, 720);
        picture.draw(day::scene_of(game, camera, 1, 1280.0 / 720));
        if (!picture.save("game-" + std::to_string(game.ticks) + ".ppm")) return false;
    }
    std::printf("%s after %.1f s\n", game.is_won ? "won" : "not won", double(game.ticks) * day::tick_seconds);

    // Another game, to the ledge in the south east, which looks low enough.
    day::Game stopped(level, mesh);
    day::Autopilot walker({{.to = {4, 0, 2}}, {.to = {4, 0, -3}}});
    const auto walk = [&] { stopped.tick({.wish = walker.wish(stopped.world, stopped.movers, stopped.hero)}); };
    while (stopped.ticks < 100) walk();
    if (!save_moment(stopped, "moment.json")) return false;
    stopped.settings.step_up = 0.51;
    while (stopped.ticks < 110) walk();
    std::printf("With step_up = 0.51 its feet are at a height of %.2f m.\n", day::feet_of(stopped.hero).y);
    return game.is_won;
}
// [/script]

}  // namespace

int main(int count, char** arguments) {
    const auto level = day::load_level(count > 1 ? arguments[1] : "level.glb");
    if (!level) return std::puts(level.error().text.c_str()), 1;
    const auto mesh = day::find_ground(*level);
    if (!mesh) return std::puts(mesh.error().text.c_str()), 1;

    const bool is_script = count > 2 && std::strcmp(arguments[2], "--script") == 0;
    const std::unique_ptr<day::Window> window = is_script ? nullptr : day::Window::open();
    if (!window) return play_script(*level, *mesh) ? 0 : 1;
    play(*window, *level, *mesh);
}
