#include "game/hero.hpp"

#include <algorithm>
#include <cmath>

#include "game/vectors.hpp"

namespace surefoot::game {
namespace {

constexpr double slide_from = 4;     // crouching faster than this slides [m/s]
constexpr double slide_until = 2;    // and slower than this it creeps [m/s]
constexpr double creep = 0.4;        // share of the running speed, crouched
constexpr double leap_height = 1.9;  // out of the water [m]
constexpr double leap_time = 0.3;    // [s]

}  // namespace

CharacterSettings hero_settings(std::span<const SurfaceRule> rules) {
    CharacterSettings settings;
    settings.volume = Ellipsoid{{0.35, 0.8, 0.35}};
    settings.crouched = Volume{Ellipsoid{{0.35, 0.45, 0.35}}};
    settings.snap_down = 0.4;
    settings.flat_foot = true;
    settings.gravity = 22;
    settings.terminal_speed = 40;
    settings.acceleration = 55;
    settings.braking = 65;
    settings.air_acceleration = 24;
    settings.jump_height = 1.5;
    settings.jump_cut = 2.2;
    settings.coyote_time = 0.12;
    settings.jump_buffer = 0.12;
    settings.air_jumps = 1;
    settings.wall_slide_speed = 2.5;
    settings.wall_jump_speed = 6.5;
    settings.wall_coyote_time = 0.15;
    settings.dash_speed = 14;
    settings.dash_time = 0.18;
    settings.dash_pause = 0.5;
    settings.swim_acceleration = 18;
    settings.sink_speed = 0.4;
    settings.ladder_speed = 3;
    settings.ledge_reach = 0.35;
    settings.hands_height = 1.4;
    settings.climb_speed = 3.5;
    settings.shimmy_speed = 1.6;
    settings.surfaces = rules;
    return settings;
}

CharacterSettings settings_now(const CharacterSettings& settings, const Hero& hero) {
    CharacterSettings now = settings;
    if (hero.slides) {
        now.acceleration = 0;
        now.braking = 4;
    }
    return now;
}

double feet_below(const CharacterSettings& settings, CharacterForm form) {
    const Volume& body = form == CharacterForm::crouched && settings.crouched ? *settings.crouched : settings.volume;
    return std::get<Ellipsoid>(body.shape).radii.y;
}

CharacterInput told(Hero& hero, const HeroInput& input, const HeroPlace& place, const CharacterSettings& settings) {
    CharacterInput told;
    dvec3 wish{double(input.move_x), 0, double(input.move_z)};
    if (!(std::abs(wish.x) <= 1) || !(std::abs(wish.z) <= 1)) wish = {0, 0, 0};
    if (const double length = flat_length(wish); length > 1) wish = wish / length;
    if (flat_length(wish) > 0.1) hero.facing = wish / flat_length(wish);

    const bool jump = holds(input, Button::jump);
    const bool jump_pressed = jump && (hero.held & static_cast<std::uint8_t>(Button::jump)) == 0;
    hero.held = input.buttons;
    told.jump = jump;
    told.crouch = holds(input, Button::crouch);
    told.dash = holds(input, Button::dash);

    hero.leaps_for = std::max(0.0, hero.leaps_for - tick_seconds);
    hero.in_water = place.under_water && hero.leaps_for == 0;
    if (hero.in_water && place.near_surface && jump_pressed) {
        hero.leaps_for = leap_time;
        hero.in_water = false;
        told.impulse.y += std::sqrt(2 * settings.gravity * leap_height) - hero.body.velocity.y;
    }

    const double speed = flat_length(hero.body.velocity);
    const bool on_ground = hero.body.footing == Footing::ground;
    const bool crouched = hero.body.form == CharacterForm::crouched;
    hero.slides = !hero.in_water && on_ground && told.crouch && speed > (hero.slides ? slide_until : slide_from);

    if (hero.in_water) {
        told.mode = CharacterMode::swim;
        told.wish = wish * swim_speed;
        told.wish.y = (jump ? swim_speed : 0) - (told.crouch ? swim_speed : 0);
        told.jump = false;
        told.crouch = false;
    } else {
        // Who slides keeps the way that it has.
        const double share = hero.slides ? 0 : crouched && on_ground ? creep : 1;
        told.wish = wish * (run_speed * share);
    }
    if (hero.bounce > 0) {
        told.impulse.y += hero.bounce - hero.body.velocity.y;
        hero.body.air_jumps_left = settings.air_jumps;
        hero.bounce = 0;
    }
    told.impulse = told.impulse + hero.knock;
    hero.knock = {0, 0, 0};
    return told;
}

}  // namespace surefoot::game
