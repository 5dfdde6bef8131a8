#include "playtest/bots/hop.hpp"

#include <algorithm>
#include <cmath>

#include "playtest/vectors.hpp"

namespace surefoot::playtest {
namespace {

constexpr double looks_ahead = 0.045;  // of an edge: what a hand is late on the average [s]
constexpr double deep = 0.6;           // ground that is farther down has ended [m]

}  // namespace

bool Hop::ground_ends(const game::Hero& hero, const dvec3& feet, const World& world, const dvec3& way) const {
    const double speed = std::max(1.0, dot(hero.body.velocity, way));
    const dvec3 ahead = feet + way * (0.1 + speed * looks_ahead);
    return !world.ray_any({ahead + dvec3{0, 0.5, 0}, ahead - dvec3{0, deep, 0}}, {.begin = 1, .end = 1});
}

Intent Hop::tick(const game::Hero& hero, const dvec3& feet, const CharacterSettings& settings, const World& world,
                 const HopAim& aim) {
    Intent intent;
    ++ticks_;
    const CharacterState& body = hero.body;
    const dvec3 way = flat(aim.place - feet);
    const double distance = length(way);
    const dvec3 towards = unit(way);
    const bool on_ground = body.footing == Footing::ground;

    if (body.hold != Hold::none) {
        intent.move = unit(flat(body.wall_normal) * -1.0);
        return intent;
    }
    if (on_ground && !left_ground_) {
        intent.move = towards * std::min(1.0, 0.15 + distance / 0.6);
        const bool is_time = style_.takeoff > 0 ? distance <= style_.takeoff : ground_ends(hero, feet, world, towards);
        if (style_.jumps && (jumped_ || is_time)) {
            intent.jump = true;
            jumped_ = true;
            held_ = 1;
        }
        return intent;
    }
    if (!on_ground) left_ground_ = true;
    if (on_ground) {  // landed somewhere: to the very place
        const dvec3 wish = way / 0.25;
        intent.move = length(wish) > game::run_speed ? towards : wish / game::run_speed;
        return intent;
    }

    const double rising = body.velocity.y;
    const double above = aim.place.y - feet.y;
    const double gravity = settings.gravity;
    const double squared = rising * rising - 2 * gravity * above;
    const double time = squared > 0 ? (rising + std::sqrt(squared)) / gravity : 0;
    const dvec3 to_go = way + aim.velocity * std::max(time, 0.05);
    const double needed = length(to_go) / std::max(time, 1.0 / 60);
    intent.move = needed > game::run_speed ? unit(to_go) : unit(to_go) * (needed / game::run_speed);

    // Held while it rises; let go at the top, so that it can be pressed again.
    intent.jump = held_ > 0 && rising > 0.8;
    if (presses_for_ > 0) {  // hands are a little late, and the press must not be over before it began
        --presses_for_;
        held_ = 1;
        intent.jump = true;
        return intent;
    }
    if (intent.jump) {
        released_ = 0;
        return intent;
    }
    held_ = 0;
    ++released_;
    const bool short_of_it = squared <= 0 || needed > 0.97 * game::run_speed;
    // A press is none before the button was let go.
    if (air_jumps_ < style_.air_jumps && body.air_jumps_left > 0 && short_of_it && released_ > 2) {
        const double after = std::sqrt(2 * gravity * settings.jump_height);
        const double fall_left = after * after - 2 * gravity * above;
        const double time_after = fall_left > 0 ? (after + std::sqrt(fall_left)) / gravity : 0;
        // As late as it still gets there with room to spare.
        const bool still_fits = time_after * game::run_speed * 0.9 > distance + 0.5;
        if (!style_.late || rising < -5 || !still_fits) {
            ++air_jumps_;
            presses_for_ = 5;
            intent.jump = true;
            return intent;
        }
    }
    if (style_.dashes && !dashed_ && air_jumps_ >= style_.air_jumps && short_of_it && rising < 0) {
        dashed_ = true;
        intent.dash = true;
        intent.move = towards;
    }
    return intent;
}

}  // namespace surefoot::playtest
