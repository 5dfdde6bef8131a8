// How the navigator takes what hangs in the air: out to it with a jump, and down where there is something to stand on.
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "playtest/bots/navigator.hpp"
#include "playtest/vectors.hpp"

namespace surefoot::playtest {
namespace {

constexpr int between_tries = 8;        // ticks
constexpr int longest_wait = 60 * 20;   // ticks, on what moves
constexpr int longest_flight = 60 * 6;  // ticks
constexpr int steady = 8;               // ticks on its feet
constexpr int walking_tries = 2;        // before it jumps for what hangs over ground
constexpr double takes_aside = 0.8;     // from the middle of the hero; the rules are a little kinder [m]
constexpr double takes_high = 1.15;     // m

bool takes(const dvec3& middle, const dvec3& place) {
    return flat_length(middle - place) < takes_aside && std::abs(middle.y - place.y) < takes_high;
}

}  // namespace

bool Navigator::leads_on(const Stand& from) const {
    const game::Level& level = atlas_->level();
    const auto goal = passages_.stand_at(level.goal, std::max(1.5, level.goal_radius), 2.5);
    return goal && passages_.route(from, *goal);
}

// The next place to try it from; nothing if all were tried, or if it is for walking.
const Catch* Navigator::next_catch(std::uint32_t pickup) {
    const dvec3& place = atlas_->level().pickups[pickup].place;
    const bool on_foot = passages_.stand_at(place - dvec3{0, catch_height, 0}, 0.8, 1.4).has_value();
    const int tried = pickup_failures_[pickup] - (on_foot ? walking_tries : 0);
    if (tried < 0) return nullptr;
    auto known = catches_.find(pickup);
    if (known == catches_.end()) known = catches_.emplace(pickup, passages_.catches(place)).first;
    return std::size_t(tried) < known->second.size() ? &known->second[std::size_t(tried)] : nullptr;
}

void Navigator::begin_catch() {
    phase_ = Phase::catches;
    phase_ticks_ = 0;
    waited_ = 0;
    style_turn_ = 0;
    catch_end_.reset();
}

Intent Navigator::catch_it(const game::Game& game) {
    const Catch& how = *target_catch_;
    const dvec3 place = atlas_->level().pickups[*target_pickup_].place;
    if (catch_end_) return fly_to_catch(game, place);
    Intent intent = how.from.body == on_ground ? Intent{} : stay_on_body(game);
    if (++waited_ > longest_wait || (how.from.body == on_ground && style_turn_ > 24)) {
        thoughts_ = -1;  // that was a try
        phase_ = Phase::thinks;
        return {};
    }
    const std::size_t on = foresight_->body_of(game.hero().body.ground_body);
    const bool stands = game.hero().body.footing == Footing::ground;
    if (how.from.body == on_ground ? flat_length(how.from.place - game.feet()) > 2 : stands && on != how.from.body) {
        phase_ = Phase::thinks;  // knocked or carried away from it
        return {};
    }
    if (!stands || waited_ % between_tries != 0) return intent;
    const double gap = std::max(0.0, flat_length(place - game.feet()) - 0.9);
    const double rise = place.y - catch_height - game.feet().y;
    std::vector<HopStyle> styles = styles_for(gap, rise, false);
    styles.push_back({.air_jumps = 1, .late = true});
    styles.push_back({.air_jumps = 1});
    for (int i = 0; i < 2; ++i, ++style_turn_) {
        const HopStyle& style = styles[std::size_t(style_turn_) % styles.size()];
        for (const Stand& end : how.ends) {
            if (!catch_goes_well(game, style, place, end)) continue;
            hop_ = Hop(style);
            catch_end_ = end;
            phase_ticks_ = 0;
            stands_for_ = 0;
            foresight_->look(game);
            return fly_to_catch(game, place);
        }
    }
    foresight_->look(game);
    return intent;
}

// Until it is taken there, and then down.
Intent Navigator::fly_to_catch(const game::Game& game, const dvec3& place) {
    foresight_->look(game);
    const bool stands = hop_.is_under_way() && game.hero().body.footing == Footing::ground;
    stands_for_ = stands ? stands_for_ + 1 : 0;
    if (stands_for_ > steady || phase_ticks_ > longest_flight) {
        thoughts_ = -1;
        phase_ = Phase::thinks;
        return {};
    }
    const bool taken = std::ranges::none_of(game.pickups(),
                                            [&](const game::Pickup& pickup) { return pickup.plan == *target_pickup_; });
    const HopAim aim = taken ? aim_of(*catch_end_, game.feet()) : HopAim{.place = place - dvec3{0, catch_height, 0}};
    return hop_.tick(game.hero(), game.feet(), game.settings(), game.world(), aim);
}

bool Navigator::catch_goes_well(const game::Game& game, const HopStyle& style, const dvec3& place, const Stand& end) {
    for (std::uint64_t seed = 1; seed <= 2; ++seed) {
        foresight_->look(game);
        Hop trial(style);
        Hands hands(seed * 977);
        bool taken = false;
        int stood = 0;
        for (int i = 0; i < longest_flight && stood < steady; ++i) {
            const dvec3 feet = foresight_->feet();
            const HopAim aim = taken ? aim_of(end, feet) : HopAim{.place = place - dvec3{0, catch_height, 0}};
            const Intent intent = trial.tick(foresight_->hero(), feet, game.settings(), foresight_->world(), aim);
            if (!foresight_->tick(hands.act(intent))) return false;
            taken = taken || takes(foresight_->hero().body.position, place);
            const bool stands = trial.is_under_way() && foresight_->hero().body.footing == Footing::ground;
            if (stands && !taken) return false;
            if (!trial.is_under_way() && i > 75) return false;
            stood = stands ? stood + 1 : 0;
        }
        if (!taken || stood < steady) return false;
        // Down where the way goes on: on ground that it knows, or on what carries it.
        const std::size_t body = foresight_->body_of(foresight_->hero().body.ground_body);
        const Stand down{.body = std::uint32_t(body)};
        const auto known = body < foresight_->body_count() ? down : passages_.stand_at(foresight_->feet(), 0.8, 1.2);
        if (!known || !(passages_.route(*known, target_catch_->from) || leads_on(*known))) return false;
    }
    return true;
}

}  // namespace surefoot::playtest
