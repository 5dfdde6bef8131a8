#include "platformer/play/ears.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace surefoot::platformer {

using game::Happening;
using sound::Effect;

sound::Ground ground_of(const game::Level& level, std::uint32_t surface) {
    if (surface >= level.materials.size()) return sound::Ground::stone;
    struct Word {
        std::string_view word;
        sound::Ground ground;
    };
    static constexpr std::array words{
        Word{"grass", sound::Ground::grass}, Word{"moss", sound::Ground::grass},  Word{"leaf", sound::Ground::grass},
        Word{"earth", sound::Ground::grass}, Word{"sand", sound::Ground::grass},  Word{"wood", sound::Ground::wood},
        Word{"plank", sound::Ground::wood},  Word{"metal", sound::Ground::metal}, Word{"brass", sound::Ground::metal},
        Word{"iron", sound::Ground::metal},  Word{"steel", sound::Ground::metal}, Word{"ice", sound::Ground::ice},
        Word{"snow", sound::Ground::ice},    Word{"water", sound::Ground::water}};
    const std::string& name = level.materials[surface].name;
    for (const Word& word : words)
        if (name.find(word.word) != std::string::npos) return word.ground;
    return sound::Ground::stone;
}

void Ears::play(Effect effect, const dvec3& place, double gain, double pitch) {
    speaker_.play(effect, {.place = place, .gain = gain, .pitch = pitch});
}

void Ears::listen(const view::Camera& camera) {
    speaker_.listen({.place = camera.eye, .forward = camera.forward, .up = camera.up});
}

void Ears::tick(const game::Game& game, const HeroPose& before, const HeroPose& pose) {
    const dvec3 feet = game.feet();
    for (const game::GameEvent& event : game.events()) {
        switch (event.what) {
            case Happening::jumped:
                play(Effect::jump, feet);
                break;
            case Happening::air_jumped:
                play(Effect::double_jump, feet);
                break;
            case Happening::wall_jumped:
                play(Effect::wall_jump, feet);
                break;
            case Happening::dashed:
                play(Effect::dash, feet);
                break;
            case Happening::landed:
                if (event.strength > 3)
                    play(event.strength > 12 ? Effect::land_hard : Effect::land_soft, feet,
                         std::min(1.0, event.strength / 12));
                break;
            case Happening::grabbed_ledge:
                play(Effect::grab, event.place);
                break;
            case Happening::climbed:
                play(Effect::climb, event.place);
                break;
            case Happening::splashed_in:
            case Happening::splashed_out:
                play(Effect::splash, feet);
                break;
            case Happening::bounced:
                play(Effect::bounce, event.place);
                break;
            // Coins in a row climb a scale, so that a whole line of them is a tune.
            case Happening::took_coin:
                play(Effect::coin, event.place, 0.8, 1 + 0.06 * (event.number % 8));
                break;
            case Happening::took_star:
                play(Effect::star, event.place);
                break;
            case Happening::took_heart:
                play(Effect::heart, event.place);
                break;
            case Happening::took_key:
                play(Effect::key, event.place);
                break;
            case Happening::door_opened:
                play(Effect::door, event.place);
                break;
            case Happening::checkpoint:
                play(Effect::checkpoint, event.place);
                break;
            case Happening::crumbling:
                play(Effect::crumble, event.place);
                break;
            case Happening::hurt:
                play(Effect::hurt, feet);
                break;
            case Happening::fell:
                play(Effect::hurt, feet, 1, 0.8);
                break;
            case Happening::stomped:
                play(Effect::stomp, event.place);
                break;
            case Happening::enemy_noticed:
                play(Effect::enemy_notice, event.place);
                break;
            case Happening::enemy_jumped:
                play(Effect::jump, event.place, 0.7, 0.6);
                break;
            case Happening::shot:
                play(Effect::shot, event.place);
                break;
            case Happening::won:
                speaker_.play(Effect::win);
                break;
            case Happening::lost:
                speaker_.play(Effect::lose);
                break;
            case Happening::crumbled:
            case Happening::crumble_back:
            case Happening::respawned:
            case Happening::shot_gone:
                break;
        }
    }
    // Two steps a stride: one whenever a half of it is full.
    const bool steps = std::floor(2 * before.stride) != std::floor(2 * pose.stride);
    if (steps && pose.act == HeroAct::run && game.hero().body.footing == Footing::ground)
        play(sound::step_on(ground_of(game.level(), game.hero().body.ground_surface)), feet, 0.5);
    slide_wait_ = std::max(0.0, slide_wait_ - game::tick_seconds);
    if (game.hero().slides && slide_wait_ == 0) {
        play(Effect::slide, feet, 0.6);
        slide_wait_ = 0.3;
    }
}

}  // namespace surefoot::platformer
