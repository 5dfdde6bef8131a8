#include "platformer/hero/particles.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include <surefoot/random.hpp>

namespace surefoot::platformer {
namespace {

using view::Colour;
using view::rgb;

constexpr Colour dust = rgb(0xE6DCC6, 0.75);

}  // namespace

double Particles::random(double low, double high) {
    return low + (high - low) * next_share(random_);
}

dvec3 Particles::around(double angle_share) const {
    const double angle = 2 * std::numbers::pi * angle_share;
    return {std::cos(angle), 0, std::sin(angle)};
}

void Particles::add(const Puff& puff) {
    Puff made = puff;
    made.before = made.place;
    static_cast<void>(puffs_.insert(made));  // with the pool full it is not missed
}

void Particles::land(const dvec3& soles, double speed) {
    const int n = count(std::clamp(int(speed), 4, 14));
    for (int i = 0; i < n; ++i) {
        const dvec3 out = around((i + random(0, 0.6)) / n);
        add({.place = soles + out * 0.25 + dvec3(0, 0.06, 0),
             .velocity = out * random(1.2, 1.8) * std::min(0.6 + speed * 0.1, 1.8) + dvec3(0, random(0.2, 0.7), 0),
             .life = random(0.3, 0.5),
             .size = random(0.07, 0.12),
             .growth = 0.12,
             .slows = 4.5,
             .colour = dust});
    }
}

void Particles::sparkle(const dvec3& place, Colour colour) {
    const int n = count(9);
    for (int i = 0; i < n; ++i) {
        const dvec3 out = around((i + random(0, 0.5)) / n);
        add({.place = place + out * 0.15,
             .velocity = out * random(1.2, 2.2) + dvec3(0, random(0.8, 3.0), 0),
             .life = random(0.35, 0.6),
             .size = random(0.035, 0.065),
             .growth = -0.06,
             .fall = 6,
             .slows = 2,
             .colour = colour,
             .glow = 0.8F});
    }
}

void Particles::splash(const dvec3& place, double speed) {
    const int n = count(std::clamp(int(6 + speed), 6, 18));
    for (int i = 0; i < n; ++i) {
        const dvec3 out = around((i + random(0, 0.5)) / n);
        add({.place = place + out * 0.3,
             .velocity = out * random(0.8, 2.0) + dvec3(0, random(2.0, 4.0) * std::min(0.5 + speed * 0.08, 1.3), 0),
             .life = random(0.45, 0.75),
             .size = random(0.05, 0.10),
             .growth = -0.08,
             .fall = 12,
             .slows = 0.8,
             .colour = rgb(0xD6F1FA, 0.85),
             .glow = 0.2F});
    }
}

void Particles::burst(const dvec3& place, Colour colour) {
    const int n = count(16);
    for (int i = 0; i < n; ++i) {
        dvec3 out = around((i + random(0, 0.5)) / n) + dvec3(0, random(-0.7, 1.1), 0);
        out = glm::normalize(out);
        add({.place = place + out * 0.2,
             .velocity = out * random(2.2, 4.2),
             .life = random(0.3, 0.55),
             .size = random(0.08, 0.15),
             .growth = -0.16,
             .fall = 2,
             .slows = 4,
             .colour = i % 2 == 0 ? colour : rgb(0xFFF6E0),
             .glow = 0.35F});
    }
}

void Particles::follow(const HeroPose& pose, const CharacterState& before, const CharacterState& after,
                       const CharacterEvents& events, double dt) {
    if (events.has(CharacterEvent::landed) && events.landing_speed > 3) land(pose.soles, events.landing_speed);
    const bool from_air = before.footing == Footing::air;
    if (events.has(CharacterEvent::jumped)) {
        const int n = count(from_air ? 8 : 4);
        for (int i = 0; i < n; ++i) {
            const dvec3 out = around((i + random(0, 0.5)) / n);
            add({.place = pose.soles + out * 0.18,
                 .velocity = out * random(0.8, 1.4) - dvec3(0, from_air ? 1.2 : 0, 0),
                 .life = 0.35,
                 .size = random(0.06, 0.10),
                 .growth = 0.10,
                 .slows = 4,
                 .colour = from_air ? rgb(0xFFFFFF, 0.7) : dust});
        }
    }
    // What goes on for a while raises it bit by bit.
    since_dust_ += dt;
    const double pause = (reduced_motion ? 3 : 1) * (pose.act == HeroAct::dash ? 0.02 : 0.05);
    if (since_dust_ < pause) return;
    since_dust_ = 0;
    const dvec3 turned_back = before.velocity - after.velocity;
    const double speed = std::hypot(after.velocity.x, after.velocity.z);
    const bool skids = pose.act == HeroAct::run && glm::length(turned_back) / std::max(dt, 1e-6) > 35 && speed > 1;
    if (pose.act == HeroAct::dash) {
        const dvec3 at = pose.soles + dvec3(random(-0.3, 0.3), random(0.2, 1.2), random(-0.3, 0.3));
        add({.place = at,
             .velocity = after.velocity * 0.25,
             .life = 0.25,
             .size = 0.035,
             .growth = -0.08,
             .slows = 6,
             .colour = rgb(0x9BF0E4, 0.8),
             .glow = 0.8F,
             .stretch = 0.09});
    } else if (pose.act == HeroAct::slide || pose.act == HeroAct::wall_slide || skids) {
        const dvec3 at = pose.act == HeroAct::wall_slide
                             ? after.position - after.wall_normal * 0.3 + dvec3(0, random(0.0, 0.5), 0)
                             : pose.soles + dvec3(random(-0.15, 0.15), 0.06, random(-0.15, 0.15));
        add({.place = at,
             .velocity = after.wall_normal * 0.6 + dvec3(random(-0.5, 0.5), random(0.3, 0.9), random(-0.5, 0.5)),
             .life = random(0.3, 0.5),
             .size = random(0.06, 0.10),
             .growth = 0.14,
             .slows = 3,
             .colour = dust});
    }
}

void Particles::advance(double dt) {
    for (auto puff = puffs_.begin(); puff != puffs_.end(); ++puff) {
        puff->age += dt;
        puff->before = puff->place;
        puff->velocity = (puff->velocity - dvec3(0, puff->fall * dt, 0)) * std::exp(-puff->slows * dt);
        puff->place += puff->velocity * dt;
        if (puff->age >= puff->life) puffs_.erase(puff.handle());
    }
}

void Particles::draw(view::Renderer& renderer, double blend) const {
    for (const Puff& puff : puffs_) {
        const double share = puff.age / puff.life;
        const double size = (puff.size + puff.growth * puff.age) * std::min((1 - share) * 3, 1.0);
        if (size < 0.004) continue;
        const Frame frame{dmat3(1), puff.before + (puff.place - puff.before) * blend};
        dvec3 radii(size);
        dmat3 turn(1);
        const double speed = glm::length(puff.velocity);
        if (puff.stretch > 0 && speed > 0.1) {
            const dvec3 along = puff.velocity / speed;
            const auto [side, other] = view::across(along);
            turn = dmat3(glm::cross(other, along), other, along);
            radii.z += puff.stretch * speed;
        }
        Colour colour = puff.colour;
        colour.a = static_cast<std::uint8_t>(colour.a * std::min((1 - share) * 2.5, 1.0));
        view::Piece made = piece(frame, {0, 0, 0}, radii, colour, view::Solid::ball, turn);
        made.glow = puff.glow;
        renderer.piece(made);
    }
}

}  // namespace surefoot::platformer
