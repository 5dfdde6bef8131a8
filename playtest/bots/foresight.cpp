#include "playtest/bots/foresight.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <surefoot/navigation_links.hpp>

#include "game/minds.hpp"
#include "game/route.hpp"

namespace surefoot::playtest {
namespace {

constexpr double stomp_bounce = 8;  // m/s

}  // namespace

std::vector<double> clocks_of(const game::BodyPlan& plan) {
    constexpr int samples = 32;
    double round = game::round_time(plan.route);
    if (round == 0 && plan.route.deg_per_s != 0) round = 360 / std::abs(plan.route.deg_per_s);
    std::vector<double> clocks{0};
    for (int i = 1; i < samples && round > 0; ++i) clocks.push_back(round * i / samples);
    return clocks;
}

Pose pose_at(const game::BodyPlan& plan, double clock) {
    Pose pose{plan.origin + game::place_on(plan.route, clock), {1, 0, 0, 0}};
    if (plan.route.deg_per_s != 0) {
        const double half = std::remainder(plan.route.deg_per_s * clock, 360.0) * (3.14159265358979323846 / 360);
        pose.orientation = {std::cos(half), 0, std::sin(half), 0};
    }
    return pose;
}

Foresight::Foresight(std::shared_ptr<const game::Level> level)
    : level_(std::move(level)),
      settings_(game::hero_settings(level_->rules)),
      bodies_(level_->bodies.size()),
      threats_(level_) {}

Expected<std::unique_ptr<Foresight>> Foresight::make(std::shared_ptr<const game::Level> level) {
    std::unique_ptr<Foresight> made(new Foresight(std::move(level)));
    const game::Level& from = *made->level_;
    if (const auto added = made->world_.add(from.ground, {.body = 0, .layers = game::still_layer}); !added)
        return tl::unexpected(added.error());
    for (std::size_t i = 0; i < from.bodies.size(); ++i) {
        const auto added = made->world_.add(
            from.bodies[i].mesh,
            {.pose = {from.bodies[i].origin, {1, 0, 0, 0}}, .body = number_of(i), .layers = game::moving_layer});
        if (!added) return tl::unexpected(added.error());
        made->bodies_[i].handle = *added;
    }
    made->has_harm_ = std::ranges::any_of(from.materials, &game::Material::deadly) ||
                      std::ranges::any_of(
                          from.bodies, [](const game::BodyPlan& body) { return body.kind == game::BodyKind::hazard; });
    return made;
}

void Foresight::look(const game::Game& game) {
    world_.begin_tick();
    for (const game::MovingBody& body : game.bodies()) {
        Body& mine = bodies_[body.plan];
        const auto differ = [](const Pose& one, const Pose& other) {
            return one.position != other.position || one.orientation != other.orientation;
        };
        // With the way of this tick, which says how fast it moves.
        if (differ(mine.now, body.now) || differ(body.before, body.now)) {
            mine.now = body.now;
            (void)world_.move(mine.handle, body.before, body.now);
        }
        mine.clock = body.clock;
        mine.runs = body.runs;
        if (mine.is_there != body.is_there) {
            mine.is_there = body.is_there;
            world_.set_layers(mine.handle, mine.is_there ? game::moving_layer : 0);
        }
    }
    hero_ = game.hero();
    threats_.look(game);
}

void Foresight::put(const dvec3& feet) {
    threats_.clear();
    hero_ = {};
    hero_.body = stand_at(world_, settings_, feet);
}

dvec3 Foresight::feet() const {
    return hero_.body.position - dvec3{0, game::feet_below(settings_, hero_.body.form), 0};
}

bool Foresight::tick(const game::HeroInput& input) {
    world_.begin_tick();
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        Body& body = bodies_[i];
        const game::BodyPlan& plan = level_->bodies[i];
        const bool moves = plan.kind == game::BodyKind::platform || plan.kind == game::BodyKind::turntable ||
                           plan.kind == game::BodyKind::hazard;
        if (!moves || !body.runs) continue;
        body.clock += game::tick_seconds;
        const dvec3 place = plan.origin + game::place_on(plan.route, body.clock);
        if (place == body.now.position && plan.route.deg_per_s == 0) continue;
        body.now.position = place;
        if (plan.route.deg_per_s != 0)
            body.now.orientation = game::turned(body.now.orientation, plan.route.deg_per_s * game::tick_seconds);
        (void)world_.move(body.handle, body.now);
    }
    const auto wet = [&](const dvec3& place) {
        return std::ranges::any_of(level_->waters, [&](const game::Zone& water) { return water.holds(place); });
    };
    hero_.safe_for = std::max(0.0, hero_.safe_for - game::tick_seconds);
    const double rising = hero_.body.velocity.y;
    const dvec3 middle = hero_.body.position;
    const game::HeroPlace place{.under_water = wet(middle), .near_surface = !wet(middle + dvec3{0, 0.7, 0})};
    const CharacterInput told = game::told(hero_, input, place, settings_);
    const StepResult result = step(world_, game::settings_now(settings_, hero_), told, game::tick_seconds, hero_.body);
    hero_.body = result.state;
    hero_.events = result.events;
    if (hero_.body.footing == Footing::ground) {
        const std::size_t on = body_of(hero_.body.ground_body);
        if (on < bodies_.size()) {
            bodies_[on].runs = true;
            if (level_->bodies[on].kind == game::BodyKind::bounce) hero_.bounce = level_->bodies[on].bounce;
        }
    }
    return !result.events.has(CharacterEvent::crushed) && hero_.body.position.y > level_->kill_y &&
           !(has_harm_ && is_harmed()) && !is_hunted_down(rising);
}

bool Foresight::is_hunted_down(double rising) {
    const Threats::Meeting met = threats_.tick(world_, hero_, rising, settings_);
    if (met == Threats::Meeting::stomped) hero_.bounce = stomp_bounce;
    return met == Threats::Meeting::harmed;
}

bool Foresight::is_harmed() const {
    Volume around = hero_.body.form == CharacterForm::crouched ? *settings_.crouched : settings_.volume;
    dvec3& radii = std::get<Ellipsoid>(around.shape).radii;
    radii = radii + dvec3{0.12, 0.12, 0.12};
    const auto harms = [&](std::uint32_t number, std::uint32_t, std::uint32_t surface) {
        const std::size_t body = body_of(number);
        return (surface < level_->materials.size() && level_->materials[surface].deadly) ||
               (hero_.safe_for <= 0 && body < bodies_.size() && level_->bodies[body].kind == game::BodyKind::hazard);
    };
    std::array<Overlap, 1> found;
    return world_.overlap(around, hero_.body.position, found, {.triangles = harms, .begin = 1, .end = 1}) > 0;
}

}  // namespace surefoot::playtest
