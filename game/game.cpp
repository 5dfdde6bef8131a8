// The order of a tick, and what holds the game together. Its parts: game_bodies.cpp, game_hero.cpp, game_touch.cpp,
// game_enemies.cpp.
#include "game/game.hpp"

#include <algorithm>
#include <cmath>

#include "game/minds.hpp"

namespace surefoot::game {

Expected<std::unique_ptr<Game>> Game::start(std::shared_ptr<const Level> level, const GameStart& how) {
    if (how.checkpoint >= level->checkpoints.size())
        return tl::unexpected(
            Error{ErrorCode::invalid, level->id + " has no checkpoint of this number", level->file, 0});
    std::unique_ptr<Game> game(new Game(std::move(level)));
    game->begun_at_ = how.checkpoint;
    game->checkpoint_ = how.checkpoint;
    if (auto built = game->build(how.stop); !built) return tl::unexpected(built.error());
    return game;
}

Game::Game(std::shared_ptr<const Level> level)
    : level_(std::move(level)),
      settings_(hero_settings(level_->rules)),
      bodies_(std::uint32_t(level_->bodies.size())),
      pickups_(std::uint32_t(level_->pickups.size())),
      enemies_(std::uint32_t(level_->enemies.size())),
      bullets_(64) {
    events_.reserve(64);
}

Game::~Game() = default;

Expected<void> Game::build(const std::atomic<bool>* stop) {
    const auto ground = world_.add(level_->ground, {.layers = still_layer});
    if (!ground) return tl::unexpected(ground.error());
    ground_body_ = world_.poses(*ground).body;
    for (std::uint32_t plan = 0; plan < level_->bodies.size(); ++plan) {
        const BodyPlan& body = level_->bodies[plan];
        const Pose pose{body.origin, {1, 0, 0, 0}};
        const auto handle = world_.add(body.mesh, {.pose = pose, .layers = moving_layer});
        if (!handle) return tl::unexpected(handle.error());
        (void)bodies_.insert(MovingBody{.plan = plan,
                                        .handle = *handle,
                                        .body = world_.poses(*handle).body,
                                        .before = pose,
                                        .now = pose,
                                        .clock = body.route.phase,
                                        .runs = !body.route.waits});
    }
    has_harm_ = std::ranges::any_of(level_->materials, &Material::deadly) ||
                std::ranges::any_of(level_->bodies, [](const BodyPlan& body) { return body.kind == BodyKind::hazard; });
    for (std::uint32_t plan = 0; plan < level_->pickups.size(); ++plan) (void)pickups_.insert(Pickup{plan});
    auto minds = EnemyMinds::make(*level_, world_, stop);
    if (!minds) return tl::unexpected(minds.error());
    minds_ = std::move(*minds);
    for (std::uint32_t plan = 0; plan < level_->enemies.size(); ++plan) {
        Enemy enemy{.plan = plan};
        enemy.body.position = level_->enemies[plan].feet + dvec3{0, 0.61, 0};
        enemy.before = enemy.body;
        if (minds_ && level_->enemies[plan].kind != EnemyKind::shooter) enemy.mind = minds_->add(plan);
        (void)enemies_.insert(enemy);
    }
    stand_at_checkpoint();
    hero_before_ = hero_;
    return {};
}

void Game::tick(const HeroInput& input) {
    events_.clear();
    hero_before_ = hero_;
    if (outcome_ != Outcome::playing) return;
    ++ticks_;
    move_bodies();
    move_hero(input);
    if (outcome_ == Outcome::playing) touch_bodies();
    if (outcome_ == Outcome::playing) touch_harm();
    if (outcome_ == Outcome::playing) touch_pickups();
    if (outcome_ == Outcome::playing) open_doors();
    move_enemies();
    if (outcome_ == Outcome::playing) touch_enemies();
    move_bullets();
    if (outcome_ == Outcome::playing) touch_checkpoints();
    if (outcome_ == Outcome::playing && seconds() >= level_->time_limit) lose(Cause::time);
}

void Game::retry() {
    if (!can_retry()) return;
    if (outcome_ == Outcome::lost) hero_.health = most_health;
    outcome_ = Outcome::playing;
    stand_at_checkpoint();
    hero_before_ = hero_;
}

bool Game::can_retry() const {
    return outcome_ != Outcome::won && seconds() < level_->time_limit;
}

void Game::give_up() {
    events_.clear();
    if (outcome_ == Outcome::playing) lose(Cause::gave_up);
}

void Game::stand_at_checkpoint() {
    const Checkpoint& checkpoint = level_->checkpoints[checkpoint_];
    const double safe_for = 1.5;
    hero_.body = CharacterState{};
    hero_.body.position =
        checkpoint.feet + dvec3{0, feet_below(settings_, CharacterForm::standing) + 2 * settings_.skin, 0};
    hero_.body.air_jumps_left = settings_.air_jumps;
    hero_.events = {};
    hero_.facing = checkpoint.facing;
    hero_.safe_for = safe_for;
    hero_.bounce = 0;
    hero_.knock = {0, 0, 0};
    hero_.leaps_for = 0;
    hero_.stuck_for = 0;
    hero_.in_water = false;
    hero_.slides = false;
    bullets_.clear();
    // Whoever hunted goes home, and what goes once is where it begins: nothing lies in wait, nothing is out of reach.
    for (Enemy& enemy : enemies_) {
        const EnemyPlan& plan = level_->enemies[enemy.plan];
        enemy.body = CharacterState{};
        enemy.body.position = plan.feet + dvec3{0, 0.61, 0};
        enemy.before = enemy.body;
        enemy.mood = Enemy::Mood::calm;
        enemy.since = 0;
        enemy.stop = 0;
        enemy.reload = 0;
        if (minds_ && plan.kind != EnemyKind::shooter) minds_->forget(enemy);
    }
    for (MovingBody& body : bodies_) {
        const Route& route = level_->bodies[body.plan].route;
        if (!route.waits && route.loop != PathLoop::once) continue;
        body.clock = route.phase;
        body.runs = !route.waits;
    }
}

void Game::say(Happening what, const dvec3& place, double strength, std::uint32_t number, Cause cause) {
    events_.push_back({what, cause, place, strength, number, hero_.body.ground_surface});
}

void Game::hurt(int hearts, Cause cause, const dvec3& from) {
    if (hero_.safe_for > 0 || hearts <= 0) return;
    constexpr double push = 5;
    hero_.health -= hearts;
    hero_.safe_for = 1.5;
    cause_ = cause;
    dvec3 away = hero_.body.position - from;
    away.y = 0;
    const double length = std::sqrt(away.x * away.x + away.z * away.z);
    if (length > 1e-6) hero_.knock = away * (push / length) + dvec3{0, push, 0};
    say(Happening::hurt, from, 0, std::uint32_t(hearts), cause);
    if (hero_.health <= 0) lose(cause);
}

void Game::fall(Cause cause) {
    --hero_.health;
    cause_ = cause;
    say(Happening::fell, hero_.body.position, 0, 1, cause);
    if (hero_.health <= 0) {
        lose(cause);
        return;
    }
    ++deaths_;
    stand_at_checkpoint();
    say(Happening::respawned, hero_.body.position);
}

void Game::lose(Cause cause) {
    ++deaths_;
    outcome_ = Outcome::lost;
    cause_ = cause;
    hero_.health = std::max(0, hero_.health);
    say(Happening::lost, hero_.body.position, 0, 0, cause);
}

dvec3 Game::feet() const {
    return hero_.body.position - dvec3{0, feet_below(settings_, hero_.body.form), 0};
}

bool Game::has_star(std::uint32_t plan) const {
    return std::ranges::find(taken_stars_, plan) != taken_stars_.end();
}

const Prompt* Game::prompt() const {
    const auto found = std::ranges::find_if(
        level_->prompts, [&](const Prompt& prompt) { return prompt.zone.holds(hero_.body.position); });
    return found == level_->prompts.end() ? nullptr : &*found;
}

std::uint64_t Game::hash() const {
    std::uint64_t sum = ticks_;
    const auto mix = [&](const auto& value) { sum = hash_bytes(std::as_bytes(std::span(&value, 1)), sum); };
    mix(surefoot::hash(hero_.body));
    mix(hero_.health);
    mix(hero_.safe_for);
    mix(coins_);
    mix(stars_);
    mix(checkpoint_);
    mix(outcome_);
    for (const MovingBody& body : bodies_) {
        mix(body.now.position);
        mix(body.clock);
        mix(body.since);
        mix(body.phase);
    }
    for (const Enemy& enemy : enemies_) {
        mix(surefoot::hash(enemy.body));
        mix(enemy.mood);
        mix(enemy.since);
        mix(enemy.reload);
    }
    for (const Bullet& bullet : bullets_) mix(bullet.place);
    return sum;
}

}  // namespace surefoot::game
