// What the hero touches: harm, things to take, checkpoints, the goal.
#include <algorithm>
#include <array>
#include <cmath>

#include "game/game.hpp"

namespace surefoot::game {
namespace {

constexpr double take_reach = 0.95;       // from the middle of the hero, aside [m]
constexpr double take_height = 1.3;       // and up and down [m]
constexpr double checkpoint_reach = 2.8;  // nobody has to look for a flag to stand on [m]
constexpr double harm_reach = 0.04;       // what is so near to the body touches it [m]: more than its skin

bool is_near(const dvec3& a, const dvec3& b, double aside, double height) {
    const double x = a.x - b.x;
    const double z = a.z - b.z;
    return x * x + z * z <= aside * aside && std::abs(a.y - b.y) <= height;
}

}  // namespace

void Game::touch_harm() {
    if (!has_harm_) return;
    Volume around = hero_.body.form == CharacterForm::crouched ? *settings_.crouched : settings_.volume;
    dvec3& radii = std::get<Ellipsoid>(around.shape).radii;
    radii = radii + dvec3{harm_reach, harm_reach, harm_reach};

    const auto body_at = [&](std::uint32_t number) -> const MovingBody* {
        for (const MovingBody& body : bodies_)
            if (body.body == number) return &body;
        return nullptr;
    };
    const auto is_hazard = [&](const MovingBody* body) {
        return body != nullptr && level_->bodies[body->plan].kind == BodyKind::hazard;
    };
    const auto harms = [&](std::uint32_t body, std::uint32_t, std::uint32_t surface) {
        return (surface < level_->materials.size() && level_->materials[surface].deadly) || is_hazard(body_at(body));
    };
    std::array<Overlap, 1> found;
    // Moving bodies have reached the end of their tick: that is where the hero is, too.
    const WorldQuery query{.triangles = harms, .begin = 1, .end = 1};
    if (world_.overlap(around, hero_.body.position, found, query) == 0) return;
    const MovingBody* const hazard = body_at(found[0].body);
    if (is_hazard(hazard))
        hurt(level_->bodies[hazard->plan].damage, Cause::hazard, hazard->now.position);
    else
        fall(Cause::deadly);
}

void Game::touch_pickups() {
    for (auto at = pickups_.begin(); at != pickups_.end(); ++at) {
        const PickupPlan& plan = level_->pickups[at->plan];
        if (!is_near(plan.place, hero_.body.position, take_reach, take_height)) continue;
        if (plan.kind == PickupKind::heart && hero_.health == most_health) continue;
        switch (plan.kind) {
            case PickupKind::coin:
                ++coins_;
                say(Happening::took_coin, plan.place, 0, std::uint32_t(coins_));
                break;
            case PickupKind::star:
                ++stars_;
                taken_stars_.push_back(at->plan);
                say(Happening::took_star, plan.place, 0, std::uint32_t(stars_));
                break;
            case PickupKind::heart:
                ++hero_.health;
                say(Happening::took_heart, plan.place, 0, std::uint32_t(hero_.health));
                break;
            case PickupKind::key:
                keys_.push_back(plan.door);
                say(Happening::took_key, plan.place);
                break;
        }
        pickups_.erase(at.handle());
    }
}

void Game::touch_checkpoints() {
    const double middle = feet_below(settings_, CharacterForm::standing);
    for (std::uint32_t i = checkpoint_ + 1; i < level_->checkpoints.size(); ++i) {
        const Checkpoint& checkpoint = level_->checkpoints[i];
        if (!is_near(checkpoint.feet + dvec3{0, middle, 0}, hero_.body.position, checkpoint_reach, checkpoint_reach))
            continue;
        checkpoint_ = i;
        say(Happening::checkpoint, checkpoint.feet, 0, i);
    }
    if (is_near(level_->goal + dvec3{0, middle, 0}, hero_.body.position, level_->goal_radius, 2)) {
        outcome_ = Outcome::won;
        say(Happening::won, level_->goal);
    }
}

}  // namespace surefoot::game
