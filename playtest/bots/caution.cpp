#include "playtest/bots/caution.hpp"

#include <algorithm>
#include <cmath>

#include "playtest/vectors.hpp"

namespace surefoot::playtest {
namespace {

constexpr int horizon = 66;       // ticks that it looks ahead
constexpr int between_looks = 8;  // ticks
constexpr int course_takes = 40;  // ticks; then it goes on
constexpr int jump_held = 20;     // ticks
constexpr int directions = 8;
constexpr int loses_patience = 120;  // ticks of not doing what it wanted to
constexpr int bold_for = 90;         // ticks; and then it looks ahead only
constexpr int bold_horizon = 36;     // so far
constexpr double stomps_from = 8;    // m
constexpr double walker_near = 11;   // m
constexpr double hazard_near = 5;    // m, beyond its box
constexpr double shot_near = 14;     // m
constexpr double deepest = 3;        // nobody careful jumps down farther where nothing was planned [m]

const Foe* foe_of(const Foresight& foresight, const Course& course) {
    for (const Foe& foe : foresight.threats().foes())
        if (foe.plan == course.foe) return &foe;
    return nullptr;
}

}  // namespace

Caution::Caution(std::shared_ptr<const game::Level> level, std::uint64_t seed)
    : level_(std::move(level)), gravity_(game::hero_settings(level_->rules).gravity), dice_(seed) {}

void Caution::forget() {
    course_ = {};
    at_ = 0;
    look_in_ = 0;
    held_up_ = 0;
    bold_for_ = 0;
}

int Caution::ahead() const {
    return bold_for_ > 0 ? bold_horizon : horizon;
}

bool Caution::is_near_anything(const game::Game& game) const {
    const dvec3 hero = game.hero().body.position;
    for (const game::Enemy& enemy : game.enemies()) {
        const game::EnemyPlan& plan = level_->enemies[enemy.plan];
        const double far = length(enemy.body.position - hero);
        const bool shoots = plan.kind == game::EnemyKind::shooter;
        if (shoots ? enemy.mood == game::Enemy::Mood::hunts && far < plan.sight
                   : far < walker_near && std::abs(enemy.body.position.y - hero.y) < 4)
            return true;
    }
    for (const game::Bullet& bullet : game.bullets())
        if (length(bullet.place - hero) < shot_near) return true;
    for (const game::MovingBody& body : game.bodies()) {
        const game::BodyPlan& plan = level_->bodies[body.plan];
        if (plan.kind != game::BodyKind::hazard) continue;
        const Bounds box = plan.mesh.bounds();
        const double wide = 0.5 * length(flat(box.max - box.min));
        if (length(body.now.position - hero) < wide + hazard_near) return true;
    }
    return false;
}

Intent Caution::follow(const Course& course, int at, const game::Hero& hero, const dvec3& feet, const Foe* foe,
                       const Steering& steering) const {
    Intent intent;
    if (course.how != Course::How::goes_on && hero.body.hold != Hold::none) {  // an edge: over it
        intent.move = unit(flat(hero.body.wall_normal)) * -1.0;
        return intent;
    }
    switch (course.how) {
        case Course::How::goes_on:
            intent = steering(hero);
            break;
        case Course::How::stands:
            break;
        case Course::How::runs:
            intent.move = course.way;
            break;
        case Course::How::stomps: {
            if (foe == nullptr || !foe->is_there) return steering(hero);
            const dvec3 way = flat(foe->body.position - feet);
            if (hero.body.footing == Footing::ground) {
                intent.move = unit(way);
                intent.jump = length(way) < course.reach;
                return intent;
            }
            // Down on its head: where it will be by then.
            const double above = feet.y - (foe->body.position.y + 0.3);
            const double rising = hero.body.velocity.y;
            const double squared = rising * rising + 2 * gravity_ * above;
            const double time = squared > 0 ? (rising + std::sqrt(squared)) / gravity_ : 0.1;
            const dvec3 to_go = way + flat(foe->body.velocity) * time;
            const double needed = length(to_go) / std::max(time, 0.05);
            intent.move = unit(to_go) * std::min(1.0, needed / game::run_speed);
            intent.jump = rising > 0.5;
            return intent;
        }
    }
    if (course.jump_at >= 0 && at >= course.jump_at && at < course.jump_at + jump_held) intent.jump = true;
    return intent;
}

Caution::Outlook Caution::look(const game::Game& game, Foresight& foresight, const Course& course, int at,
                               const dvec3& wish, const std::function<Steering()>& steering) const {
    foresight.look(game);
    const dvec3 from = foresight.feet();
    const Steering goes_on = steering();
    Hands hands(17);
    for (int i = 0; i < ahead(); ++i) {
        const Course now = at + i < course_takes ? course : Course{};
        const Intent intent = follow(now, at + i, foresight.hero(), foresight.feet(), foe_of(foresight, now), goes_on);
        if (!foresight.tick(hands.act(intent)) || foresight.feet().y < from.y - 6) return {.safe_for = i};
    }
    Outlook outlook{.safe_for = ahead()};
    const dvec3 feet = foresight.feet();
    const bool on_ground = foresight.hero().body.footing == Footing::ground;
    if (!on_ground && !foresight.hero().in_water &&
        !foresight.world().ray_any({feet + dvec3{0, 0.3, 0}, feet - dvec3{0, deepest, 0}}, {.begin = 1, .end = 1}))
        return {.safe_for = ahead() / 2};
    if (course.how != Course::How::goes_on && feet.y < from.y - deepest) return {.safe_for = ahead() / 2};
    outlook.worth = length(wish) > 0.1 ? dot(feet - from, unit(wish)) : -length(flat(feet - from));
    double nearest = 4;
    for (const Foe& foe : foresight.threats().foes()) {
        if (level_->enemies[foe.plan].kind == game::EnemyKind::shooter) continue;
        if (!foe.is_there)
            outlook.worth += 4;
        else
            nearest = std::min(nearest, length(foe.body.position - foresight.hero().body.position));
    }
    outlook.worth += nearest;
    return outlook;
}

Course Caution::choose(const game::Game& game, Foresight& foresight, const dvec3& wish,
                       const std::function<Steering()>& steering) const {
    Course best;
    Outlook best_outlook = look(game, foresight, best, 0, wish, steering);
    const auto consider = [&](const Course& course) {
        const Outlook outlook = look(game, foresight, course, 0, wish, steering);
        if (outlook.safe_for < best_outlook.safe_for ||
            (outlook.safe_for == best_outlook.safe_for && outlook.worth <= best_outlook.worth + 0.2))
            return;
        best = course;
        best_outlook = outlook;
    };
    consider({.how = Course::How::stands});
    consider({.how = Course::How::goes_on, .jump_at = 0});
    consider({.how = Course::How::goes_on, .jump_at = 10});
    consider({.how = Course::How::stands, .jump_at = 0});
    std::vector<std::uint32_t> near;
    for (const game::Enemy& enemy : game.enemies())
        if (level_->enemies[enemy.plan].kind != game::EnemyKind::shooter &&
            length(enemy.body.position - game.hero().body.position) < stomps_from)
            near.push_back(enemy.plan);
    for (const std::uint32_t foe : near)
        for (const double reach : {1.8, 2.6, 3.4, 4.2})
            consider({.how = Course::How::stomps, .reach = reach, .foe = foe});
    if (best_outlook.safe_for == ahead()) return best;
    for (int i = 0; i < directions; ++i) {
        const double turn = 6.283185307179586 * i / directions;
        const dvec3 way{std::sin(turn), 0, std::cos(turn)};
        consider({.how = Course::How::runs, .way = way});
        consider({.how = Course::How::runs, .way = way, .jump_at = 0});
    }
    return best;
}

Intent Caution::mind(const game::Game& game, Foresight& foresight, const Intent& intent,
                     const std::function<Steering()>& steering) {
    const bool in_air = game.hero().body.footing == Footing::air;
    if (!notices_.after(is_near_anything(game), dice_)) {
        if (!(in_air && is_busy())) forget();
        if (!is_busy()) return intent;
    }
    held_up_ = is_busy() ? held_up_ + 1 : std::max(0, held_up_ - 1);
    bold_for_ = std::max(0, bold_for_ - 1);
    ++at_;
    if (--look_in_ <= 0) {
        look_in_ = between_looks;
        if (held_up_ > loses_patience) {
            held_up_ = 0;
            bold_for_ = bold_for;
        }
        reconsider(game, foresight, intent.move, in_air, steering);
        foresight.look(game);
    }
    if (at_ >= course_takes && !in_air) course_ = {};
    if (!is_busy()) return intent;
    return follow(course_, at_, game.hero(), game.feet(), foe_of(foresight, course_),
                  [&](const game::Hero&) { return intent; });
}

void Caution::reconsider(const game::Game& game, Foresight& foresight, const dvec3& wish, bool in_air,
                         const std::function<Steering()>& steering) {
    const auto goes_well = [&](const Course& course, int at) {
        return look(game, foresight, course, at, wish, steering).safe_for == ahead();
    };
    // What was begun with a jump is brought to its end, if that still goes well.
    if (is_busy() && in_air && goes_well(course_, at_)) return;
    if (goes_well({}, 0)) {
        course_ = {};
        return;
    }
    if (is_busy() && at_ < course_takes && goes_well(course_, at_)) return;
    course_ = choose(game, foresight, wish, steering);
    at_ = 0;
}

}  // namespace surefoot::playtest
