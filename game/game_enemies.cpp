// What enemies see, decide and do, and what comes of meeting them.
#include <algorithm>
#include <array>
#include <cmath>

#include <surefoot/hitboxes.hpp>
#include <surefoot/pair.hpp>

#include "game/enemy_habits.hpp"
#include "game/game.hpp"
#include "game/minds.hpp"
#include "game/vectors.hpp"

namespace surefoot::game {
namespace {

constexpr double forget_time = 3;   // without a sight of the hero [s]
constexpr double sleeps_from = 60;  // who is calm so far from the hero stands still: nobody sees it [m]
constexpr double stomp_bounce = 8;  // [m/s]

double speed_of(EnemyKind kind, Enemy::Mood mood) {
    return enemy_speed(kind, mood == Enemy::Mood::hunts);
}

Cause cause_of(EnemyKind kind) {
    if (kind == EnemyKind::chaser) return Cause::chaser;
    return kind == EnemyKind::patroller ? Cause::patroller : Cause::jumper;
}

}  // namespace

void Game::move_enemies() {
    const CharacterSettings& settings = minds_ ? minds_->settings() : settings_;
    const dvec3 hero = hero_.body.position;
    for (auto at = enemies_.begin(); at != enemies_.end(); ++at) {
        Enemy& enemy = *at;
        const EnemyPlan& plan = level_->enemies[enemy.plan];
        enemy.before = enemy.body;
        enemy.since += tick_seconds;
        enemy.reload = std::max(0.0, enemy.reload - tick_seconds);

        const dvec3 eye = enemy.body.position + dvec3{0, 0.3, 0};
        const double far = length(hero - eye);
        if (enemy.mood == Enemy::Mood::calm && far > std::max(sleeps_from, plan.sight)) continue;
        const bool sees = outcome_ == Outcome::playing && far <= plan.sight && !world_.ray_any({eye, hero});
        const bool strayed = length(enemy.body.position - plan.feet) > plan.leash;
        const auto become = [&](Enemy::Mood mood) {
            enemy.mood = mood;
            enemy.since = 0;
        };
        if (sees && (enemy.mood == Enemy::Mood::calm || (enemy.mood == Enemy::Mood::returns && !strayed))) {
            become(Enemy::Mood::notices);
            enemy.reload = std::max(enemy.reload, notice_time);
            say(Happening::enemy_noticed, eye, 0, enemy.plan);
        }
        if (enemy.mood == Enemy::Mood::notices && enemy.since >= notice_time) become(Enemy::Mood::hunts);
        if (enemy.mood == Enemy::Mood::hunts) {
            if (sees) enemy.since = 0;
            if (strayed || enemy.since > forget_time) become(Enemy::Mood::returns);
        }
        if (enemy.mood == Enemy::Mood::stunned && enemy.since > stun_time) become(Enemy::Mood::returns);

        if (plan.kind == EnemyKind::shooter) {
            if (sees && length(flat(hero - eye)) > 1e-6) enemy.facing = flat(hero - eye) / length(flat(hero - eye));
            if (enemy.mood == Enemy::Mood::hunts && sees && enemy.reload == 0) {
                // It leads by half of what it would take: who keeps running in one direction is hit now and then.
                const dvec3 aim = hero + hero_.body.velocity * (0.5 * far / bullet_speed);
                const dvec3 way = aim - eye;
                if (const double size = length(way); size > 1e-6 && bullets_.size() < bullets_.capacity()) {
                    (void)bullets_.insert(Bullet{.before = eye, .place = eye, .velocity = way * (bullet_speed / size)});
                    say(Happening::shot, eye, 0, enemy.plan);
                }
                enemy.reload = reload_time;
            }
            if (enemy.mood == Enemy::Mood::returns) become(Enemy::Mood::calm);
            continue;
        }

        CharacterInput input;
        if (minds_ && enemy.mood == Enemy::Mood::hunts) {
            input = minds_->go(enemy, feet(), speed_of(plan.kind, enemy.mood));
            const bool may_leap = plan.kind == EnemyKind::jumper && enemy.reload == 0 && far < leap_from &&
                                  enemy.body.footing == Footing::ground;
            if (may_leap) {
                input.jump = true;
                enemy.reload = reload_time;
                say(Happening::enemy_jumped, eye, 0, enemy.plan);
            }
            // In a leap of its own it flies at the hero.
            if (plan.kind == EnemyKind::jumper && enemy.reload > reload_time - 0.9 && far < 2 * leap_from) {
                input.jump = true;
                const dvec3 way = flat(hero - enemy.body.position);
                if (length(way) > 0.1) input.wish = way * (leap_speed / length(way));
            }
        } else if (minds_ && (enemy.mood == Enemy::Mood::calm || enemy.mood == Enemy::Mood::returns)) {
            const bool walks_round = plan.route.size() > 1 && enemy.mood == Enemy::Mood::calm;
            const dvec3 stop = walks_round ? plan.route[enemy.stop % plan.route.size()] : plan.feet;
            if (length(flat(stop - enemy.body.position)) > 0.6) {
                input = minds_->go(enemy, stop, speed_of(plan.kind, enemy.mood));
                if (minds_->gave_up(enemy)) ++enemy.stop;
            } else {
                if (walks_round) ++enemy.stop;
                if (enemy.mood == Enemy::Mood::returns) become(Enemy::Mood::calm);
            }
        }
        // Who stands on still ground and wants nothing stands there in the next tick, too.
        const bool rests = input.wish == dvec3{0, 0, 0} && !input.jump && enemy.body.footing == Footing::ground &&
                           enemy.body.velocity == dvec3{0, 0, 0} && enemy.body.ground_body == ground_body_;
        if (!rests) {
            const StepResult result = step(world_, settings, input, tick_seconds, enemy.body);
            enemy.body = result.state;
            enemy.events = result.events;
        }
        const dvec3 goes = enemy.mood == Enemy::Mood::notices ? flat(hero - eye) : flat(enemy.body.velocity);
        if (length(goes) > 0.3) enemy.facing = goes / length(goes);
        if (enemy.body.position.y < level_->kill_y) enemies_.erase(at.handle());
    }
}

void Game::touch_enemies() {
    const Volume& body = hero_.body.form == CharacterForm::crouched ? *settings_.crouched : settings_.volume;
    const Volume enemy_body = minds_ ? minds_->settings().volume : enemy_settings(level_->rules).volume;
    for (auto at = enemies_.begin(); at != enemies_.end(); ++at) {
        Enemy& enemy = *at;
        const EnemyKind kind = level_->enemies[enemy.plan].kind;
        if (!pair_overlap(body, hero_.body.position, enemy_body, enemy.body.position)) continue;
        const bool from_above = feet().y > enemy.body.position.y && hero_before_.body.velocity.y < -0.5;
        if (from_above && hero_.health > 0) {
            say(Happening::stomped, enemy.body.position, 0, enemy.plan);
            hero_.bounce = stomp_bounce;
            enemies_.erase(at.handle());
            continue;
        }
        if (enemy.mood == Enemy::Mood::stunned || hero_.safe_for > 0) continue;
        if (kind == EnemyKind::shooter) continue;  // it is a flower: only its shots hurt
        hurt(1, cause_of(kind), enemy.body.position);
        enemy.mood = Enemy::Mood::stunned;
        enemy.since = 0;
        if (outcome_ != Outcome::playing) return;
    }
}

void Game::move_bullets() {
    // What shots meet is the body, not the ellipsoid that walks: there is room beside the head and between the feet.
    const bool crouched = hero_.body.form == CharacterForm::crouched;
    const double low = crouched ? -0.2 : -0.45;
    const double high = crouched ? 0.2 : 0.5;
    const std::array<HitPart, 4> parts{{
        {.volume = Sphere{0.22},
         .start = {{0, high, 0}, {1, 0, 0, 0}},
         .end = {{0, high, 0}, {1, 0, 0, 0}},
         .number = 0},
        {.volume = Capsule{.radius = 0.24, .half_height = crouched ? 0.05 : 0.2}, .number = 1},
        {.volume = Sphere{0.14},
         .start = {{0.14, low, 0}, {1, 0, 0, 0}},
         .end = {{0.14, low, 0}, {1, 0, 0, 0}},
         .number = 2},
        {.volume = Sphere{0.14},
         .start = {{-0.14, low, 0}, {1, 0, 0, 0}},
         .end = {{-0.14, low, 0}, {1, 0, 0, 0}},
         .number = 3},
    }};
    // The parts turn with the face: about +Y from -Z to where it looks, by the mean of the two directions.
    const dvec3 face = hero_.facing;
    dquat turn{1 - face.z, 0, -face.x, 0};
    if (turn.w < 1e-9) turn = {0, 0, 1, 0};
    const Hitboxes hero(parts, {hero_before_.body.position, turn}, {hero_.body.position, turn});
    for (auto at = bullets_.begin(); at != bullets_.end(); ++at) {
        Bullet& bullet = *at;
        bullet.before = bullet.place;
        const Motion motion{bullet.place, bullet.place + bullet.velocity * tick_seconds};
        const auto wall = world_.sweep(Sphere{bullet_radius}, motion);
        const auto part = outcome_ == Outcome::playing ? hero.sweep(Sphere{bullet_radius}, motion) : std::nullopt;
        bullet.place = motion.to;
        bullet.age += tick_seconds;
        if (part && (!wall || part->t <= wall->t)) {
            hurt(1, Cause::shot, bullet.before);
            bullets_.erase(at.handle());
        } else if (wall || bullet.age > bullet_life) {
            say(Happening::shot_gone, bullet.place);
            bullets_.erase(at.handle());
        }
    }
}

}  // namespace surefoot::game
