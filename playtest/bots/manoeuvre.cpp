#include "playtest/bots/manoeuvre.hpp"

#include <algorithm>
#include <cmath>

#include "playtest/vectors.hpp"

namespace surefoot::playtest {
namespace {

constexpr double shaft_width = 4.5;  // at most, from wall to wall [m]

}  // namespace

Intent Manoeuvring::tick(const game::Hero& hero, const dvec3& feet, const World& world) {
    ++ticks_;
    const dvec3 way = flat(to_ - feet);
    Intent intent;
    intent.move = unit(way) * std::min(1.0, 0.2 + length(way));
    switch (how_) {
        case game::Manoeuvre::swim:
            return swim(hero, feet, world);
        case game::Manoeuvre::climb:
            return climb(hero, feet);
        case game::Manoeuvre::wall_jump:
            return wall_jump(hero, feet, world);
        case game::Manoeuvre::crouch:
            intent.crouch = true;
            break;
        case game::Manoeuvre::ride:
        case game::Manoeuvre::dash:
        case game::Manoeuvre::bounce:
            break;
    }
    return intent;
}

// Straight there; where something is in the way, at the height, above or below, at which nothing is.
Intent Manoeuvring::swim(const game::Hero& hero, const dvec3& feet, const World& world) {
    const dvec3 way = flat(to_ - feet);
    Intent intent;
    intent.move = unit(way) * std::min(1.0, 0.2 + length(way));
    if (!hero.in_water) {
        // Out of it at last, on to the bank; or not in it yet.
        intent.jump = hero.body.footing != Footing::ground && hero.body.velocity.y > 0;
        return intent;
    }
    const double wanted = to_.y - feet.y;
    double above = wanted;
    if (length(way) > 1.5) {
        const dvec3 ahead = unit(way) * std::min(4.0, length(way));
        const dvec3 across{-unit(way).z, 0, unit(way).x};
        double least = 1e300;
        double aside = 0;
        for (const double to_side : {0.0, 1.3, -1.3, 2.6, -2.6, 3.9, -3.9})
            for (int i = -1; i <= 16; ++i) {
                const double height = i < 0 ? wanted : 0.7 * ((i + 1) / 2) * (i % 2 == 0 ? 1 : -1);
                const dvec3 from = hero.body.position + across * to_side + dvec3{0, height, 0};
                const double cost = std::abs(height - wanted) + 0.1 * std::abs(height) + 3 * std::abs(to_side);
                if (cost >= least || world.ray_any({hero.body.position, from}, {.begin = 1, .end = 1}) ||
                    world.sweep_any(Sphere{0.45}, {from, from + ahead}, {.begin = 1, .end = 1}))
                    continue;
                least = cost;
                above = height;
                aside = to_side;
            }
        if (std::abs(above) > 0.8 && std::abs(above - wanted) > 0.5) intent.move = intent.move * 0.3;
        if (above > 1.5) intent.move = intent.move * 0.2;  // up first
        if (std::abs(aside) > 0.5) intent.move = across * (aside > 0 ? 0.8 : -0.8);
        const dvec3 head = hero.body.position + dvec3{0, 0.7, 0};
        const bool is_under = world.ray_any({head, head + dvec3{0, 1, 0}}, {.begin = 1, .end = 1});
        if (least > 1e299 && wanted > 1 && is_under) back_for_ = 45;
        if (back_for_ > 0) {  // out from under what is above
            --back_for_;
            intent.move = unit(way) * -0.8;
        }
        // Who is where it wants to be keeps from sinking.
        if (above < 0.35 && above > -0.35) above = hero.body.velocity.y < -0.2 ? 0 : -0.2;
    }
    intent.crouch = above < -0.4;
    // Up: held; at the surface let go now and then, since a leap is a press.
    if (above > -0.1) {
        if (rest_for_ > 0) {
            --rest_for_;
        } else {
            intent.jump = true;
            if (++jump_for_ > 25) {
                jump_for_ = 0;
                rest_for_ = 4;
            }
        }
    }
    return intent;
}

Intent Manoeuvring::climb(const game::Hero& hero, const dvec3& feet) {
    Intent intent;
    const dvec3 way = flat(to_ - feet);
    const bool down = to_.y < feet.y - 0.5;
    const bool on_it = hero.events.has(CharacterEvent::climbing) || hero.body.hold != Hold::none;
    if (on_it && flat_length(hero.body.wall_normal) > 0.5)
        intent.move = unit(flat(hero.body.wall_normal)) * -1.0;
    else
        intent.move = unit(way);
    if (on_it && down) {
        intent.move = {0, 0, 0};
        intent.crouch = true;
    }
    return intent;
}

// In between the two walls; at the nearer, off it to the other, and so on up; at the top over to where it leads.
Intent Manoeuvring::wall_jump(const game::Hero& hero, const dvec3& feet, const World& world) {
    Intent intent;
    const CharacterState& body = hero.body;
    const dvec3 way = flat(to_ - feet);
    const bool on_ground = body.footing == Footing::ground;
    if (body.hold != Hold::none) {  // an edge: over it
        intent.move = unit(flat(body.wall_normal)) * -1.0;
        return intent;
    }
    if (length(along_) < 0.5) along_ = length(way) > 0.5 ? unit(way) : dvec3{1, 0, 0};
    if (jump_for_ > 0) --jump_for_;
    const auto wall_at = [&](const dvec3& out) -> double {
        const dvec3 from = body.position + along_ * 0.3;
        const auto hit = world.ray({from, from + out * shaft_width}, {.begin = 1, .end = 1});
        return hit && std::abs(hit->normal.y) < 0.3 ? hit->t * shaft_width : 1e300;
    };
    const dvec3 aside{along_.z, 0, -along_.x};
    const double left = wall_at(aside);
    const double right = wall_at(aside * -1.0);
    const bool between = left + right < shaft_width;

    if (feet.y > to_.y - 0.1 && !on_ground) {  // high enough: there
        intent.move = unit(way) * std::min(1.0, 0.3 + length(way));
        intent.jump = jump_for_ > 0 || body.velocity.y > 0;
        return intent;
    }
    if (!between) {
        intent.move = along_;
        const dvec3 ahead = feet + along_ * 0.4;
        const bool edge =
            on_ground && !world.ray_any({ahead + dvec3{0, 0.5, 0}, ahead - dvec3{0, 0.7, 0}}, {.begin = 1, .end = 1});
        if (edge) jump_for_ = 20;
        intent.jump = jump_for_ > 0 && (on_ground || body.velocity.y > 0);
        wall_ = {0, 0, 0};
        return intent;
    }
    if (length(wall_) < 0.5) wall_ = left < right ? aside : aside * -1.0;
    intent.move = wall_;
    const bool touches = body.since_wall < 0.05 && !on_ground;
    if (on_ground) {
        // Let go now and then: a button that is held makes no second jump.
        intent.jump = ticks_ % 40 > 12;
        if (intent.jump) jump_for_ = 10;
    } else if (touches && body.velocity.y < 2.5 && jump_for_ == 0) {
        jump_for_ = 14;
        intent.jump = true;
        wall_ = unit(flat(body.wall_normal));
    } else {
        intent.jump = jump_for_ > 0 && (jump_for_ > 10 || body.velocity.y > 0);
    }
    return intent;
}

}  // namespace surefoot::playtest
