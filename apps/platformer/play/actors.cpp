#include "platformer/play/actors.hpp"

#include <algorithm>
#include <cmath>

#include "platformer/hero/props.hpp"

namespace surefoot::platformer {
namespace {

using game::Happening;

constexpr double enemy_feet = 0.6;  // below the middle of an enemy [m]
constexpr double take_time = 0.25;  // until what was taken is gone [s]
constexpr double raise_time = 0.6;  // until a flag is up [s]
constexpr double seen_from = 70;    // what is small is drawn from so near [m]

EnemyMood mood_of(game::Enemy::Mood mood) {
    switch (mood) {
        case game::Enemy::Mood::notices:
            return EnemyMood::notice;
        case game::Enemy::Mood::hunts:
            return EnemyMood::attack;
        case game::Enemy::Mood::calm:
        case game::Enemy::Mood::returns:
        case game::Enemy::Mood::stunned:
            break;
    }
    return EnemyMood::idle;
}

double distance(const dvec3& a, const dvec3& b) {
    const dvec3 way = a - b;
    return std::sqrt(way.x * way.x + way.y * way.y + way.z * way.z);
}

/// Beside whoever begins there: the pole is not in their way, nor in that of the camera.
dvec3 flag_place(const game::Checkpoint& checkpoint) {
    constexpr double aside = 0.7;  // [m]: a platform is 1.6 m wide at least
    return checkpoint.feet + dvec3{-checkpoint.facing.z, 0, checkpoint.facing.x} * aside;
}

}  // namespace

Actors::Actors(const game::Game& game)
    : pickups_(game.level().pickups.size(), 1.0), flags_(game.level().checkpoints.size(), 0.0) {
    for (const game::EnemyPlan& plan : game.level().enemies) {
        DrawnEnemy drawn;
        drawn.pose = enemy_at(static_cast<EnemyKind>(plan.kind), plan.feet, 0, double(enemies_.size()) * 0.37);
        drawn.before = drawn.pose;
        enemies_.push_back(drawn);
    }
}

void Actors::follow_enemies(const game::Game& game, bool reduced_motion) {
    for (DrawnEnemy& drawn : enemies_) drawn.is_alive = false;
    for (const game::Enemy& enemy : game.enemies()) {
        DrawnEnemy& drawn = enemies_[enemy.plan];
        const EnemySight sight{.soles = enemy.body.position - dvec3{0, enemy_feet, 0},
                               .velocity = enemy.body.velocity,
                               .looks_at = enemy.mood == game::Enemy::Mood::calm ? enemy.body.position + enemy.facing
                                                                                 : game.hero().body.position,
                               .on_ground = enemy.body.footing == Footing::ground,
                               .mood = mood_of(enemy.mood),
                               .fires = drawn.fires};
        drawn.before = drawn.pose;
        drawn.pose = distance(drawn.pose.soles, sight.soles) > 3
                         ? enemy_at(drawn.pose.kind, sight.soles, drawn.pose.facing, drawn.pose.clock)
                         : advance(drawn.pose, sight, reduced_motion, game::tick_seconds);
        drawn.is_alive = true;
        drawn.gone_for = 0;
        drawn.fires = false;
    }
    for (DrawnEnemy& drawn : enemies_) {
        if (drawn.is_alive || drawn.gone_for > stomped_time) continue;
        drawn.gone_for += game::tick_seconds;
        drawn.before = drawn.pose;
        drawn.pose = advance(drawn.pose, {.soles = drawn.pose.soles, .mood = EnemyMood::stomped}, reduced_motion,
                             game::tick_seconds);
    }
}

void Actors::tick(const game::Game& game, const HeroPose& pose, const CharacterState& before, bool reduced_motion) {
    clock_ += game::tick_seconds;
    reduced_motion_ = reduced_motion;
    particles_.reduced_motion = reduced_motion;
    std::vector<bool> is_there(pickups_.size(), false);
    for (const game::Pickup& pickup : game.pickups()) is_there[pickup.plan] = true;
    for (std::size_t i = 0; i < pickups_.size(); ++i)
        pickups_[i] = is_there[i] ? 1 : std::max(0.0, pickups_[i] - game::tick_seconds / take_time);
    for (std::size_t i = 0; i < flags_.size(); ++i)
        if (i <= game.checkpoint()) flags_[i] = std::min(1.0, flags_[i] + game::tick_seconds / raise_time);
    bool was_moved = false;
    for (const game::GameEvent& event : game.events()) {
        switch (event.what) {
            case Happening::took_coin:
                particles_.sparkle(event.place, view::rgb(0xFFD34D));
                break;
            case Happening::took_star:
                particles_.burst(event.place, view::rgb(0xFFE27A));
                break;
            case Happening::took_heart:
                particles_.sparkle(event.place, view::rgb(0xFF5D73));
                break;
            case Happening::took_key:
                particles_.sparkle(event.place, view::rgb(0xFFFFFF));
                break;
            case Happening::splashed_in:
            case Happening::splashed_out:
                particles_.splash(event.place, std::max(3.0, event.strength));
                break;
            case Happening::stomped:
                particles_.burst(event.place, view::rgb(0xB7E36B));
                break;
            case Happening::crumbled:
                particles_.burst(event.place, view::rgb(0xA99884));
                break;
            case Happening::shot_gone:
                particles_.sparkle(event.place, view::rgb(0x7AB8FF));
                break;
            case Happening::shot:
                if (event.number < enemies_.size()) enemies_[event.number].fires = true;
                break;
            case Happening::lost:
                particles_.burst(event.place, view::rgb(0xEE7F30));
                break;
            case Happening::respawned:
                was_moved = true;
                break;
            default:
                break;
        }
    }
    if (!was_moved) particles_.follow(pose, before, game.hero().body, game.hero().events, game::tick_seconds);
    particles_.advance(game::tick_seconds);
    follow_enemies(game, reduced_motion);
}

void Actors::draw(view::Renderer& renderer, const game::Game& game, double blend) const {
    const game::Level& level = game.level();
    const dvec3 eye = renderer.view().camera.eye;
    for (std::size_t i = 0; i < pickups_.size(); ++i) {
        const game::PickupPlan& plan = level.pickups[i];
        if (pickups_[i] <= 0 || distance(plan.place, eye) > seen_from) continue;
        const PropMoment moment{.clock = clock_, .shown = pickups_[i], .calm = reduced_motion_};
        switch (plan.kind) {
            case game::PickupKind::coin:
                draw_coin(renderer, plan.place, moment);
                break;
            case game::PickupKind::star:
                draw_star(renderer, plan.place, moment);
                break;
            case game::PickupKind::heart:
                draw_heart(renderer, plan.place, moment);
                break;
            case game::PickupKind::key:
                draw_key(renderer, plan.place, moment, key_colour(plan.door, colours_));
                break;
        }
    }
    const PropMoment moment{.clock = clock_, .calm = reduced_motion_};
    for (std::size_t i = 1; i < flags_.size(); ++i)
        draw_checkpoint(renderer, flag_place(level.checkpoints[i]), moment, flags_[i]);
    draw_goal(renderer, level.goal, moment, level.goal_radius);
    for (const DrawnEnemy& enemy : enemies_)
        if (enemy.is_alive || enemy.gone_for <= stomped_time)
            platformer::draw(renderer, enemy.before, enemy.pose, blend);
    for (const game::Bullet& bullet : game.bullets())
        draw_bullet(renderer, bullet.before + (bullet.place - bullet.before) * blend, bullet.velocity, 0.12);
    particles_.draw(renderer, blend);
}

}  // namespace surefoot::platformer
