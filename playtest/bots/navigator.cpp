// What the navigator wants and how it plans; how it gets over single passages is in navigator_steps.cpp.
#include "playtest/bots/navigator.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "playtest/vectors.hpp"

namespace surefoot::playtest {
namespace {

constexpr int failures_until_banned = 4;
constexpr int tries_for_key = 40;
constexpr int tries_for_coin = 2;
constexpr int thoughts_a_try = 4;  // at most
constexpr int reaction = 9;        // ticks
constexpr int longest_held = 100;  // against something, on foot [ticks]
constexpr int longest_hang = 75;   // on an edge, without getting up [ticks]
constexpr int between_plans = 20;  // that found no way [ticks]

}  // namespace

Navigator::Navigator(std::shared_ptr<const Atlas> atlas, const NavigatorOptions& options, Passages passages,
                     std::unique_ptr<Foresight> foresight)
    : atlas_(std::move(atlas)),
      options_(options),
      passages_(std::move(passages)),
      foresight_(std::move(foresight)),
      hands_(options.seed * 3 + 1),
      dice_(options.seed * 7 + 5),
      follower_(NavigationFollowOptions{.speed = game::run_speed, .arrival = 0.35}),
      caution_(std::shared_ptr<const game::Level>(atlas_, &atlas_->level()), options.seed * 13 + 9) {}

Expected<std::unique_ptr<Navigator>> Navigator::make(std::shared_ptr<const Atlas> atlas,
                                                     const NavigatorOptions& options) {
    auto passages = Passages::make(*atlas);
    if (!passages) return tl::unexpected(passages.error());
    auto trial = Passages::make(*atlas);
    if (!trial) return tl::unexpected(trial.error());
    auto foresight = Foresight::make(std::shared_ptr<const game::Level>(atlas, &atlas->level()));
    if (!foresight) return tl::unexpected(foresight.error());
    std::unique_ptr<Navigator> made(
        new Navigator(std::move(atlas), options, std::move(*passages), std::move(*foresight)));
    made->gave_up_ = made->why_unreachable(*trial);
    return made;
}

// Opens whatever door there is a key for, until nothing changes; then the goal is within reach or never will be.
std::string Navigator::why_unreachable(Passages& passages) const {
    const game::Level& level = atlas_->level();
    const auto begin = passages.stand_at(level.checkpoints.front().feet, 2, 3);
    if (!begin) return "goal unreachable: there is no ground to stand on near the spawn";
    std::vector<bool> opened(level.bodies.size(), false);
    for (;;) {
        const auto goal = passages.stand_at(level.goal, std::max(1.5, level.goal_radius), 2.5);
        if (goal && passages.route(*begin, *goal)) return {};
        bool changed = false;
        const auto can_take = [&](const game::PickupPlan& pickup) {
            const auto at = passages.stand_at(pickup.place - dvec3{0, 0.8, 0}, 1.5, 2.5);
            return at && passages.route(*begin, *at);
        };
        const auto coins = [&] {
            return std::ranges::count_if(level.pickups, [&](const game::PickupPlan& pickup) {
                return pickup.kind == game::PickupKind::coin && can_take(pickup);
            });
        };
        for (std::size_t i = 0; i < level.bodies.size(); ++i) {
            const game::BodyPlan& door = level.bodies[i];
            if (door.kind != game::BodyKind::door || opened[i]) continue;
            const bool may =
                door.door.empty() ? coins() >= door.coins : std::ranges::any_of(level.pickups, [&](const auto& pickup) {
                    return pickup.kind == game::PickupKind::key && pickup.door == door.door && can_take(pickup);
                });
            if (!may) continue;
            passages.open_door(atlas_->door_area(i));
            opened[i] = true;
            changed = true;
        }
        if (changed) continue;
        if (!goal) return "goal unreachable: there is no ground to stand on near the goal";
        std::string last = level.checkpoints.front().section;
        for (const game::Checkpoint& checkpoint : level.checkpoints)
            if (const auto at = passages.stand_at(checkpoint.feet, 2, 2); at && passages.route(*begin, *at))
                last = checkpoint.section;
        return fmt::format(
            "goal unreachable: from the spawn no way leads there, neither on foot, by links or jumps, nor on anything "
            "that "
            "moves; the last section within reach is {}",
            last);
    }
}

game::HeroInput Navigator::decide(const game::Game& game) {
    notice(game);
    ++phase_ticks_;
    Intent intent;
    if (pause_ > 0) {
        --pause_;
    } else if (gave_up_.empty()) {
        if (phase_ == Phase::thinks) think(game);
        switch (phase_) {
            case Phase::thinks:
                intent = find_back(game);
                if (caution_.is_busy() || game.hero().body.footing == Footing::ground) intent = mind(game, intent);
                break;
            case Phase::walks:
                intent = walk(game);
                intent = mind(game, intent);
                break;
            case Phase::waits:
                intent = mind(game, wait(game));
                break;
            case Phase::hops:
                intent = hop(game);
                break;
            case Phase::manoeuvres:
                intent = manoeuvre(game);
                break;
            case Phase::catches:
                intent = catch_it(game);
                if (!catch_end_) intent = mind(game, intent);
                break;
        }
    }
    return hands_.act(let_go(game, shake_loose(game, intent)));
}

// Who walks and gets nowhere jumps, this way and that, as anybody would.
Intent Navigator::shake_loose(const game::Game& game, const Intent& intent) {
    const bool walks = phase_ == Phase::walks || phase_ == Phase::thinks;
    if (shakes_for_ == 0 && (!walks || length(intent.move) < 0.3 || length(game.feet() - held_at_) > 0.4)) {
        held_at_ = game.feet();
        held_for_ = 0;
        return intent;
    }
    if (shakes_for_ == 0 && ++held_for_ < longest_held) return intent;
    if (shakes_for_ == 0) {
        held_for_ = 0;
        shakes_for_ = dice_.whole(30, 60);
        const double turn = dice_.in(0, 6.283185307179586);
        shakes_to_ = {std::sin(turn), 0, std::cos(turn)};
    }
    --shakes_for_;
    return {.move = shakes_to_, .jump = shakes_for_ % 30 > 10};
}

// Who hangs on an edge and does not get over it lets go of it.
Intent Navigator::let_go(const game::Game& game, const Intent& intent) {
    const CharacterState& body = game.hero().body;
    hangs_for_ = body.footing == Footing::ledge && game.feet().y <= hung_at_ + 1e-6 ? hangs_for_ + 1 : 0;
    hung_at_ = game.feet().y;
    if (hangs_for_ < longest_hang) return intent;
    return {.move = unit(flat(body.wall_normal)), .crouch = true};
}

// What happened that changes what it wants.
void Navigator::notice(const game::Game& game) {
    since_better_ += game::tick_seconds;
    if (since_better_ > options_.patience && gave_up_.empty()) gave_up_ = "got nowhere any more: " + doing_;
    for (const game::GameEvent& event : game.events()) {
        switch (event.what) {
            case game::Happening::respawned:
            case game::Happening::lost:
                if (phase_ == Phase::hops || phase_ == Phase::waits || phase_ == Phase::manoeuvres) fail(game);
                caution_.forget();
                phase_ = Phase::thinks;
                pause_ = reaction + dice_.whole(0, 12);
                break;
            case game::Happening::took_key:
            case game::Happening::door_opened:
            case game::Happening::took_coin:
                for (const game::MovingBody& body : game.bodies()) {
                    const game::BodyPlan& plan = atlas_->level().bodies[body.plan];
                    if (plan.kind != game::BodyKind::door || atlas_->door_area(body.plan) == 0) continue;
                    const bool opens =
                        !body.is_there ||
                        (plan.door.empty() ? game.coins() >= plan.coins
                                           : std::ranges::find(game.keys(), plan.door) != game.keys().end());
                    if (opens && passages_.query().mesh().areas()[atlas_->door_area(body.plan)].closed) {
                        passages_.open_door(atlas_->door_area(body.plan));
                        if (phase_ == Phase::walks) phase_ = Phase::thinks;
                    }
                }
                if (event.what != game::Happening::took_coin) since_better_ = 0;
                break;
            case game::Happening::bounced:
                if (phase_ != Phase::walks) break;
                phase_ = Phase::thinks;  // while it touches ground, which is now
                pause_ = think_in_ = 0;
                break;
            case game::Happening::checkpoint:
                best_left_ = 1e300;
                since_better_ = 0;
                if (phase_ == Phase::walks && step_ >= plan_.size()) phase_ = Phase::thinks;
                break;
            case game::Happening::took_star:
                since_better_ = 0;
                break;
            default:
                break;
        }
    }
    const bool flies = phase_ == Phase::catches && catch_end_;  // it comes down first
    if (target_pickup_ && !flies && std::ranges::none_of(game.pickups(), [&](const game::Pickup& pickup) {
            return pickup.plan == *target_pickup_;
        })) {
        target_pickup_.reset();
        since_better_ = 0;
        if (phase_ == Phase::walks || phase_ == Phase::catches) phase_ = Phase::thinks;
    }
}

std::optional<Stand> Navigator::here(const game::Game& game) const {
    const game::Hero& hero = game.hero();
    if (hero.body.footing == Footing::ground) {
        const std::size_t body = foresight_->body_of(hero.body.ground_body);
        if (body < atlas_->level().bodies.size()) return Stand{.body = std::uint32_t(body), .place = game.feet()};
    } else if (!hero.in_water) {
        return std::nullopt;
    }
    if (hero.in_water)
        if (const auto water = passages_.water_at(hero.body.position)) return water;
    return passages_.stand_at(game.feet(), 0.8, 1.2);
}

void Navigator::think(const game::Game& game) {
    if (think_in_ > 0) {
        --think_in_;
        return;
    }
    const auto from = here(game);
    if (!from) return;
    if (!choose_target(game, *from)) {
        think_in_ = between_plans;
        if (!banned_.empty()) {  // better once more over what failed than not at all
            banned_.clear();
            failures_.clear();
        }
        return;
    }
    lost_for_ = 0;
    step_ = 0;
    next_step(game);
}

bool Navigator::plan_to(const Stand& from, const Stand& to) {
    auto route = passages_.route(from, to, banned_);
    if (!route) return false;
    target_ = to;
    plan_ = std::move(route->passages);
    if (route->seconds < best_left_ - 2) {
        best_left_ = route->seconds;
        since_better_ = 0;
    }
    return true;
}

// The goal; where a door bars the way a key first, or coins; for a collector what lies nearest.
bool Navigator::choose_target(const game::Game& game, const Stand& from) {
    const game::Level& level = atlas_->level();
    const auto goal = passages_.stand_at(level.goal, std::max(1.5, level.goal_radius), 2.5);
    const bool reaches = goal && passages_.route(from, *goal, banned_).has_value();
    std::optional<std::uint32_t> best;
    double nearest = 1e300;
    for (const game::Pickup& pickup : game.pickups()) {
        const game::PickupPlan& plan = level.pickups[pickup.plan];
        const bool wanted =
            options_.collects ? plan.kind != game::PickupKind::heart
                              : !reaches && (plan.kind == game::PickupKind::key || plan.kind == game::PickupKind::coin);
        if (!wanted) continue;
        const double far =
            length(plan.place - game.feet()) + (plan.kind == game::PickupKind::key && !options_.collects ? -1000 : 0);
        if (far >= nearest) continue;
        const auto at = stand_for(pickup.plan);
        if (!at || !passages_.route(from, *at, banned_)) continue;
        nearest = far;
        best = pickup.plan;
    }
    if (best) {
        const auto at = stand_for(*best);
        // Who only thought again on the way there has not tried yet.
        thoughts_ = target_pickup_ == best ? thoughts_ + 1 : 0;
        target_pickup_ = best;
        target_catch_ = options_.collects ? next_catch(*best) : nullptr;
        if (thoughts_ % thoughts_a_try == 0) ++pickup_failures_[*best];
        // So often it may try, however far it gets.
        if (target_catch_ != nullptr) since_better_ = std::min(since_better_, options_.patience / 2);
        doing_ = fmt::format("goes for a {}", game::name_of(level.pickups[*best].kind));
        return at && plan_to(from, *at);
    }
    target_pickup_.reset();
    target_catch_ = nullptr;
    // By way of the next checkpoint: whoever cuts corners begins anew from far back.
    if (reaches)
        for (std::uint32_t i = game.checkpoint() + 1; i < level.checkpoints.size(); ++i) {
            if (checkpoint_tries_[i] > 12) continue;
            const auto at = passages_.stand_at(level.checkpoints[i].feet, 1.5, 1.5);
            if (!at || !passages_.route(*at, *goal, banned_) || !plan_to(from, *at)) continue;
            ++checkpoint_tries_[i];
            doing_ = fmt::format("goes for the checkpoint of {}", level.checkpoints[i].section);
            return true;
        }
    doing_ = "goes for the goal";
    return reaches && plan_to(from, *goal);
}

// Where to go for the next try to take it; nothing if it has tried often enough.
std::optional<Stand> Navigator::stand_for(std::uint32_t pickup) {
    const game::PickupPlan& plan = atlas_->level().pickups[pickup];
    if (options_.collects)
        if (const Catch* const how = next_catch(pickup)) return how->from;
    if (pickup_failures_[pickup] >= (plan.kind == game::PickupKind::key ? tries_for_key : tries_for_coin))
        return std::nullopt;
    return passages_.stand_at(plan.place - dvec3{0, catch_height, 0}, 0.8, 1.4);
}

void Navigator::fail(const game::Game&) {
    if (step_ < plan_.size() && ++failures_[plan_[step_]] >= failures_until_banned) banned_.push_back(plan_[step_]);
    phase_ = Phase::thinks;
    pause_ = std::max(pause_, dice_.whole(2, 8));
}

// Where there is no ground that it knows: to the nearest, and with a jump if that does not help.
Intent Navigator::find_back(const game::Game& game) {
    const bool in_air = game.hero().body.footing == Footing::air || game.hero().body.footing == Footing::ledge;
    if (in_air && !game.hero().in_water) return save_oneself(game);
    Intent intent;
    if (++lost_for_ < 20) return intent;
    const auto near = passages_.query().nearest(game.feet(), 6, 6);
    const dvec3 way = near ? flat(near->position - game.feet()) : dvec3{0, 0, 0};
    if (length(way) > 0.1) intent.move = unit(way);
    if (lost_for_ % 90 > 60) intent.jump = lost_for_ % 90 < 80;
    if (lost_for_ % 400 > 340) {
        const double turn = dice_.in(0, 6.28);
        intent.move = {std::sin(turn), 0, std::cos(turn)};
    }
    return intent;
}

// Past what moves and harms, on foot and where it waits.
Intent Navigator::mind(const game::Game& game, const Intent& intent) {
    const bool in_air = game.hero().body.footing == Footing::air;
    if (phase_ == Phase::walks && !(follower_.on_link() && in_air))
        return caution_.mind(game, *foresight_, intent, [&]() -> Caution::Steering {
            return [this, follower = follower_, &game](const game::Hero& hero) mutable {
                const CharacterInput told =
                    follower.input(passages_.query(), hero.body, game.settings(), game::tick_seconds);
                return Intent{.move = flat(told.wish) / game::run_speed, .jump = told.jump, .crouch = told.crouch};
            };
        });
    if (phase_ == Phase::waits || phase_ == Phase::thinks || phase_ == Phase::catches)
        return caution_.mind(game, *foresight_, intent, [] { return [](const game::Hero&) { return Intent{}; }; });
    return intent;
}

}  // namespace surefoot::playtest
