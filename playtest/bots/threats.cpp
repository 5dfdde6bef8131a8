#include "playtest/bots/threats.hpp"

#include <algorithm>

#include <surefoot/pair.hpp>

#include "game/enemy_habits.hpp"
#include "game/minds.hpp"
#include "playtest/vectors.hpp"

namespace surefoot::playtest {
namespace {

using Mood = game::Enemy::Mood;

// Enemies as a player knows them from having met them.
using game::bullet_life;
using game::bullet_radius;
using game::bullet_speed;
using game::leap_from;
using game::leap_speed;
using game::notice_time;
using game::reload_time;

constexpr double comes_near = 16;    // who is farther from the hero is of no concern yet [m]
constexpr double seen_after = 0.15;  // nobody dodges a shot that has only just been fired [s]
constexpr double room = 0.12;        // that is kept from whoever harms [m]
constexpr double shot_room = 0.3;    // and from shots
constexpr double ledge = 1.2;        // who walks does not step down farther [m]
constexpr double steps_within = 6;   // of the hero, it is moved as it will be, and not only roughly [m]
constexpr int between_looks = 12;    // ticks

// How far a shot flies until something still is in its way [s].
double life_of(const World& world, const Shot& shot, double most) {
    const auto hit = world.sweep(Sphere{bullet_radius}, {shot.place, shot.place + shot.velocity * most});
    return hit ? hit->t * most : most;
}

}  // namespace

Threats::Threats(std::shared_ptr<const game::Level> level)
    : level_(std::move(level)), settings_(game::enemy_settings(level_->rules)) {}

void Threats::clear() {
    foes_.clear();
    shots_.clear();
    ticks_ = 0;
}

void Threats::look(const game::Game& game) {
    clear();
    const dvec3 hero = game.hero().body.position;
    for (const game::Enemy& enemy : game.enemies()) {
        const game::EnemyPlan& plan = level_->enemies[enemy.plan];
        const bool shoots = plan.kind == game::EnemyKind::shooter;
        if (length(enemy.body.position - hero) > (shoots ? plan.sight + 2 : comes_near)) continue;
        foes_.push_back({.plan = enemy.plan,
                         .body = enemy.body,
                         .mood = enemy.mood,
                         .since = enemy.since,
                         .reload = enemy.reload,
                         .stop = enemy.stop});
    }
    for (const game::Bullet& bullet : game.bullets()) {
        const dvec3 to_hero = hero - bullet.place;
        if (bullet.age < seen_after || dot(to_hero, bullet.velocity) < 0) continue;
        Shot shot{.place = bullet.place, .velocity = bullet.velocity};
        shot.left = life_of(game.world(), shot, std::min(2.0, bullet_life - bullet.age));
        shots_.push_back(shot);
    }
}

Threats::Meeting Threats::tick(const World& world, const game::Hero& hero, double rising,
                               const CharacterSettings& settings) {
    if (foes_.empty() && shots_.empty()) return Meeting::nothing;
    ++ticks_;
    const dvec3 feet = hero.body.position - dvec3{0, game::feet_below(settings, hero.body.form), 0};
    for (Foe& foe : foes_) {
        if (!foe.is_there) continue;
        foe.since += game::tick_seconds;
        foe.reload = std::max(0.0, foe.reload - game::tick_seconds);
        move(world, hero, feet, foe);
        if (level_->enemies[foe.plan].kind == game::EnemyKind::shooter) shoot(world, hero, foe);
    }
    return meet(hero, feet, rising, settings);
}

// What it is about; and where it goes, if it goes anywhere.
void Threats::move(const World& world, const game::Hero& hero, const dvec3& feet, Foe& foe) const {
    const game::EnemyPlan& plan = level_->enemies[foe.plan];
    const dvec3 eye = foe.body.position + dvec3{0, 0.3, 0};
    const auto become = [&](Mood mood) {
        foe.mood = mood;
        foe.since = 0;
    };
    if (foe.mood == Mood::calm && ticks_ % between_looks == 0 && length(hero.body.position - eye) < plan.sight &&
        !world.ray_any({eye, hero.body.position})) {
        become(Mood::notices);
        foe.reload = std::max(foe.reload, notice_time);
    }
    if (foe.mood == Mood::notices && foe.since >= notice_time) become(Mood::hunts);
    if (foe.mood == Mood::hunts && length(foe.body.position - plan.feet) > plan.leash) become(Mood::returns);
    if (foe.mood == Mood::stunned && foe.since > game::stun_time) become(Mood::returns);
    if (plan.kind != game::EnemyKind::shooter) walk(world, hero, feet, foe);
}

void Threats::shoot(const World& world, const game::Hero& hero, Foe& foe) {
    const dvec3 eye = foe.body.position + dvec3{0, 0.3, 0};
    const double far = length(hero.body.position - eye);
    if (foe.mood != Mood::hunts || foe.reload > 0 || far > level_->enemies[foe.plan].sight) return;
    if (world.ray_any({eye, hero.body.position})) return;
    foe.reload = reload_time;
    const dvec3 aim = hero.body.position + hero.body.velocity * (0.5 * far / bullet_speed);
    Shot shot{.place = eye, .velocity = unit(aim - eye) * bullet_speed};
    shot.left = life_of(world, shot, 2);
    shots_.push_back(shot);
}

// Straight to where it wants to be; who walks on a mesh does not fall off its edges.
void Threats::walk(const World& world, const game::Hero& hero, const dvec3& feet, Foe& foe) const {
    const game::EnemyPlan& plan = level_->enemies[foe.plan];
    const bool hunts = foe.mood == Mood::hunts;
    const bool on_ground = foe.body.footing == Footing::ground;
    CharacterInput input;
    if (hunts || foe.mood == Mood::calm || foe.mood == Mood::returns) {
        const bool rounds = plan.route.size() > 1 && foe.mood == Mood::calm;
        const dvec3 to = hunts ? feet : rounds ? plan.route[foe.stop % plan.route.size()] : plan.feet;
        const dvec3 way = flat(to - foe.body.position);
        if (length(way) > 0.6 || hunts) input.wish = unit(way) * game::enemy_speed(plan.kind, hunts);
        if (length(way) <= 0.6 && rounds) ++foe.stop;
    }
    const double far = length(hero.body.position - foe.body.position);
    if (plan.kind == game::EnemyKind::jumper && hunts) {
        if (foe.reload == 0 && far < leap_from && on_ground) foe.reload = reload_time;
        if (foe.reload > reload_time - 0.9 && far < 2 * leap_from) {
            input.jump = true;
            input.wish = unit(flat(hero.body.position - foe.body.position)) * leap_speed;
        }
    }
    if (on_ground && !input.jump && length(input.wish) > 0) {
        const dvec3 ahead = foe.body.position + unit(input.wish) * 0.5;
        if (!world.ray_any({ahead, ahead - dvec3{0, 0.6 + ledge, 0}}, {.begin = 1, .end = 1})) input.wish = {0, 0, 0};
    }
    // Far away, where it goes is enough.
    if (far > steps_within && on_ground) {
        foe.body.position = foe.body.position + input.wish * game::tick_seconds;
        return;
    }
    const bool rests = length(input.wish) == 0 && !input.jump && on_ground && length(foe.body.velocity) == 0;
    if (!rests) foe.body = step(world, settings_, input, game::tick_seconds, foe.body).state;
}

Threats::Meeting Threats::meet(const game::Hero& hero, const dvec3& feet, double rising,
                               const CharacterSettings& settings) {
    const bool crouched = hero.body.form == CharacterForm::crouched;
    const Volume& body = crouched ? *settings.crouched : settings.volume;
    Volume around = body;
    dvec3& radii = std::get<Ellipsoid>(around.shape).radii;
    radii = radii + dvec3{room, room, room};
    const dvec3 at = hero.body.position;
    for (Foe& foe : foes_) {
        if (!foe.is_there || length(foe.body.position - at) > 2.2) continue;
        if (!pair_overlap(around, at, settings_.volume, foe.body.position)) continue;
        const bool from_above = feet.y > foe.body.position.y && rising < -0.5;
        if (from_above) {
            if (!pair_overlap(body, at, settings_.volume, foe.body.position)) continue;
            foe.is_there = false;
            return Meeting::stomped;
        }
        const bool harms = level_->enemies[foe.plan].kind != game::EnemyKind::shooter && foe.mood != Mood::stunned;
        if (harms && hero.safe_for <= 0) return Meeting::harmed;
    }
    for (Shot& shot : shots_) {
        if (shot.left <= 0) continue;
        shot.left -= game::tick_seconds;
        shot.place = shot.place + shot.velocity * game::tick_seconds;
        const double low = crouched ? -0.2 : -0.45;
        const double high = crouched ? 0.2 : 0.5;
        dvec3 nearest = at;
        nearest.y += std::clamp(shot.place.y - at.y, low, high);
        if (length(shot.place - nearest) < 0.24 + bullet_radius + shot_room && hero.safe_for <= 0)
            return Meeting::harmed;
    }
    return Meeting::nothing;
}

}  // namespace surefoot::playtest
