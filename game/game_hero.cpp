// The hero's own tick: what it is told, the step, and what it is said to have done.
#include <algorithm>

#include "game/game.hpp"

namespace surefoot::game {
namespace {

constexpr double surface_reach = 0.7;  // the air is so near above the middle of a hero that may leap out [m]
constexpr double outside = 40;         // beyond the level's box it counts as fallen out [m]
constexpr double stuck_limit = 1.5;    // [s]

}  // namespace

CharacterInput Game::told(const HeroInput& input) {
    const auto wet = [&](const dvec3& place) {
        return std::ranges::any_of(level_->waters, [&](const Zone& water) { return water.holds(place); });
    };
    const dvec3 middle = hero_.body.position;
    const HeroPlace place{.under_water = wet(middle), .near_surface = !wet(middle + dvec3{0, surface_reach, 0})};
    return game::told(hero_, input, place, settings_);
}

void Game::move_hero(const HeroInput& input) {
    hero_.safe_for = std::max(0.0, hero_.safe_for - tick_seconds);
    last_input_ = told(input);
    const StepResult result = step(world_, settings_now(settings_, hero_), last_input_, tick_seconds, hero_.body);
    hero_.body = result.state;
    hero_.events = result.events;
    say_what_the_hero_did();

    if (result.events.has(CharacterEvent::crushed)) {
        fall(Cause::crushed);
        return;
    }
    hero_.stuck_for = result.events.has(CharacterEvent::stuck) ? hero_.stuck_for + tick_seconds : 0;
    const dvec3& place = hero_.body.position;
    const Bounds box = level_->ground.bounds();
    const bool is_outside = place.x < box.min.x - outside || place.x > box.max.x + outside ||
                            place.z < box.min.z - outside || place.z > box.max.z + outside ||
                            place.y > box.max.y + 5 * outside;
    if (place.y < level_->kill_y || is_outside || hero_.stuck_for > stuck_limit) fall(Cause::fall);
}

void Game::say_what_the_hero_did() {
    const CharacterState& before = hero_before_.body;
    const CharacterEvents& events = hero_.events;
    if (events.has(CharacterEvent::jumped)) {
        const bool from_ground = before.footing == Footing::ground || before.since_ground <= settings_.coyote_time;
        const bool in_air = !from_ground && hero_.body.air_jumps_left < before.air_jumps_left;
        const Happening what = from_ground ? Happening::jumped
                               : in_air    ? Happening::air_jumped
                                           : Happening::wall_jumped;
        say(what, feet());
    }
    if (events.has(CharacterEvent::dashed)) say(Happening::dashed, hero_.body.position);
    if (events.has(CharacterEvent::landed)) say(Happening::landed, feet(), events.landing_speed);
    if (events.has(CharacterEvent::grabbed_ledge)) say(Happening::grabbed_ledge, hero_.body.ledge_point);
    if (events.has(CharacterEvent::climbed_ledge)) say(Happening::climbed, feet());
    if (hero_.in_water && !hero_before_.in_water) say(Happening::splashed_in, feet(), -before.velocity.y);
    if (!hero_.in_water && hero_before_.in_water) say(Happening::splashed_out, feet());
}

}  // namespace surefoot::game
