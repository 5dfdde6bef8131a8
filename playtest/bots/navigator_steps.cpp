// How the navigator gets over one passage: waits for the moment, rehearses it, and does it.
#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

#include "playtest/bots/navigator.hpp"
#include "playtest/vectors.hpp"

namespace surefoot::playtest {
namespace {

constexpr int between_tries = 8;          // ticks
constexpr int longest_wait = 60 * 30;     // ticks
constexpr int longest_hop = 60 * 4;       // ticks
constexpr double longest_manoeuvre = 25;  // s
constexpr int longest_fear = 60 * 8;      // ticks; then it hops in spite of whoever hunts or shoots
constexpr int hops_kept = 3;              // styles that are rehearsed at a time

bool holds_crouch(game::Manoeuvre how) {
    return how == game::Manoeuvre::crouch;
}

}  // namespace

void Navigator::next_step(const game::Game& game) {
    phase_ticks_ = 0;
    waited_ = 0;
    stands_for_ = 0;
    style_turn_ = 0;
    if (step_ >= plan_.size() && target_catch_ != nullptr && target_->body != on_ground) {
        begin_catch();
        return;
    }
    if (step_ >= plan_.size()) {
        follower_.stop();
        follower_.go(passages_.query(), target_->place);
        phase_ = Phase::walks;
        return;
    }
    const Passage& passage = passages_.all()[plan_[step_]];
    if (passage.how == Passage::How::fly) {
        hop_ = Hop({.jumps = false, .air_jumps = 1, .late = false, .dashes = true});
        hop_to_ = passage.to;
        phase_ = Phase::hops;
        return;
    }
    if (passage.from.body == on_ground) {
        const dvec3 way = passage.from.place - game.feet();
        if (flat_length(way) > 0.5 || std::abs(way.y) > 1) {
            follower_.stop();
            follower_.go(passages_.query(), passage.from.place);
            phase_ = Phase::walks;
            return;
        }
    }
    if (passage.how == Passage::How::way && passage.manoeuvre != game::Manoeuvre::dash) {
        manoeuvring_ = Manoeuvring(passage.manoeuvre, passage.to.place);
        phase_ = Phase::manoeuvres;
        doing_ = fmt::format("does a manoeuvre: {}", game::name_of(passage.manoeuvre));
        return;
    }
    phase_ = Phase::waits;
    const std::uint32_t body = passage.to.body != on_ground ? passage.to.body : passage.from.body;
    if (body != on_ground) doing_ = fmt::format("waits for {}", atlas_->level().bodies[body].name);
}

Intent Navigator::walk(const game::Game& game) {
    const CharacterInput told =
        follower_.input(passages_.query(), game.hero().body, game.settings(), game::tick_seconds);
    if (follower_.status() == NavigationFollowStatus::arrived) {
        if (step_ < plan_.size()) {
            const Passage& passage = passages_.all()[plan_[step_]];
            if (flat_length(passage.from.place - game.feet()) < 1) {
                phase_ = Phase::waits;
                phase_ticks_ = 0;
                waited_ = 0;
                if (passage.how == Passage::How::way && passage.manoeuvre != game::Manoeuvre::dash) {
                    manoeuvring_ = Manoeuvring(passage.manoeuvre, passage.to.place);
                    phase_ = Phase::manoeuvres;
                }
                return {};
            }
        } else if (target_catch_ != nullptr) {
            begin_catch();
            return {};
        } else if (target_pickup_ && phase_ticks_ % 60 < 20) {
            Intent intent;  // it hangs a little higher than one reaches
            intent.move = flat(atlas_->level().pickups[*target_pickup_].place - game.feet());
            intent.jump = true;
            return intent;
        }
        if (!target_pickup_ || phase_ticks_ > 60 * 60 || phase_ticks_ % 60 == 59) phase_ = Phase::thinks;
        return {};
    }
    if (follower_.status() != NavigationFollowStatus::following || phase_ticks_ > 60 * 90) {
        fail(game);
        return find_back(game);
    }
    wet_for_ = game.hero().in_water ? wet_for_ + 1 : 0;
    if (wet_for_ > 30) {  // fell in: that is no walk any more
        wet_for_ = 0;
        phase_ = Phase::thinks;
    }
    Intent intent;
    intent.move = flat(told.wish) / game::run_speed;
    intent.jump = told.jump;
    intent.crouch = told.crouch;
    // Whoever was carried off by something that moves thinks again.
    if (game.hero().body.footing == Footing::ground && phase_ticks_ > 30 &&
        foresight_->body_of(game.hero().body.ground_body) < atlas_->level().bodies.size() && phase_ticks_ % 60 == 0)
        phase_ = Phase::thinks;
    return intent;
}

// Where it stands on something that moves, near the middle of it.
Intent Navigator::stay_on_body(const game::Game& game) const {
    const std::size_t body = foresight_->body_of(game.hero().body.ground_body);
    Intent intent;
    if (game.hero().body.footing != Footing::ground || body >= atlas_->level().bodies.size()) return intent;
    const auto spots = passages_.spots(body);
    const auto found = std::ranges::find(game.bodies(), std::uint32_t(body), &game::MovingBody::plan);
    if (spots.empty() || found == game.bodies().end()) return intent;
    dvec3 middle{0, 0, 0};
    for (const dvec3& spot : spots) middle += spot / double(spots.size());
    dvec3 nearest = to_world((*found).now, spots.front());
    const dvec3 there = to_world((*found).now, middle);
    for (const dvec3& spot : spots)
        if (const dvec3 at = to_world((*found).now, spot); length(at - there) < length(nearest - there)) nearest = at;
    const dvec3 way = flat(nearest - game.feet());
    if (length(way) > 0.35) intent.move = unit(way) * std::min(0.8, length(way));
    return intent;
}

Intent Navigator::wait(const game::Game& game) {
    const Passage& passage = passages_.all()[plan_[step_]];
    const game::Hero& hero = game.hero();
    if (++waited_ > longest_wait) {
        fail(game);
        return {};
    }
    if (hero.body.footing != Footing::ground) {
        if (waited_ % 120 == 119) phase_ = Phase::thinks;
        return save_oneself(game);
    }
    const std::size_t on = foresight_->body_of(hero.body.ground_body);
    if (passage.from.body != on_ground ? on != passage.from.body : on < atlas_->level().bodies.size()) {
        if (passage.to.body == on && passage.to.body != on_ground) {  // it came, and took it along
            ++step_;
            next_step(game);
            return {};
        }
        phase_ = Phase::thinks;
        return {};
    }
    Intent intent = passage.from.body == on_ground ? Intent{} : stay_on_body(game);
    if (passage.from.body == on_ground) {
        const dvec3 way = flat(passage.from.place - game.feet());
        if (length(way) > 2.5 || std::abs(passage.from.place.y - game.feet().y) > 1.2) {  // knocked away from it
            phase_ = Phase::thinks;
            return {};
        }
        if (length(way) > 0.6) intent.move = unit(way) * 0.5;
    }
    const dvec3 look =
        (passage.to.body == on_ground ? passage.to.place : foresight_->pose(passage.to.body).position) - game.feet();
    intent.look = look;
    if (passage.from.body != on_ground && waited_ % 2 == 0) avoid_what_comes(game, passage.from.body);
    if (phase_ == Phase::waits && waited_ % between_tries == 0) try_to_hop(game);
    return phase_ == Phase::waits ? intent : hop(game);
}

// In the air, and nobody meant to be: back to where there is something to stand on, with the jump that is left.
Intent Navigator::save_oneself(const game::Game& game) {
    Intent intent;
    const CharacterState& body = game.hero().body;
    if (body.hold != Hold::none) {
        intent.move = unit(flat(body.wall_normal)) * -1.0;
        return intent;
    }
    dvec3 nearest = game.feet();
    double least = 1e300;
    const auto offer = [&](const dvec3& place) {
        if (place.y > game.feet().y + 2 || length(place - game.feet()) >= least) return;
        least = length(place - game.feet());
        nearest = place;
    };
    if (const auto near = passages_.query().nearest(game.feet(), 4, 6)) offer(near->position);
    for (const game::MovingBody& moving : game.bodies()) {
        if (!moving.is_there || length(moving.now.position - game.feet()) > 15) continue;
        for (const dvec3& spot : passages_.spots(moving.plan)) offer(to_world(moving.now, spot));
    }
    const dvec3 way = flat(nearest - game.feet());
    intent.move = unit(way) * std::min(1.0, 2 * length(way));
    const bool below = game.feet().y < nearest.y + 0.3;
    if (body.velocity.y < -2 && body.air_jumps_left > 0 && (below || length(way) > 1)) save_for_ = 16;
    if (save_for_ > 0) {
        --save_for_;
        intent.jump = true;
    }
    return intent;
}

std::span<const dvec3> Navigator::spots_of(const Stand& stand) const {
    return stand.body < atlas_->level().bodies.size() ? passages_.spots(stand.body) : std::span<const dvec3>{};
}

HopAim Navigator::aim_of(const Stand& to, const dvec3& feet) const {
    return aim_at(*foresight_, spots_of(to), to, feet);
}

bool Navigator::is_on(const game::Hero& hero, const dvec3& feet, const Stand& to) const {
    return stands_on(*foresight_, spots_of(to), hero, feet, to);
}

bool Navigator::goes_well(const game::Game& game, const HopStyle& style, const Stand& to) {
    const bool throws = to.body != on_ground && atlas_->level().bodies[to.body].kind == game::BodyKind::bounce;
    const bool runs_for_it = waited_ > longest_fear;
    return rehearse(
        *foresight_,
        [&] {
            foresight_->look(game);
            if (runs_for_it) foresight_->ignore_threats();
        },
        game.settings(), spots_of(to), style, to, throws);
}

void Navigator::try_to_hop(const game::Game& game) {
    const Passage& passage = passages_.all()[plan_[step_]];
    foresight_->look(game);
    const HopAim aim = aim_of(passage.to, game.feet());
    const double gap = std::max(0.0, flat_length(aim.place - game.feet()) - 0.9);
    const double rise = aim.place.y - game.feet().y;
    const bool dashes = passage.how == Passage::How::way;
    const bool impatient = waited_ > longest_wait / 3;
    const bool stands = passage.from.body != on_ground;
    const auto moves = [&](std::uint32_t body) {
        if (body == on_ground) return false;
        const game::Route& route = atlas_->level().bodies[body].route;
        return !route.stops.empty() || route.deg_per_s != 0;
    };
    const bool still = !moves(passage.from.body) && !moves(passage.to.body);
    // Somebody who stands on a platform walks to its edge while hopping: what counts is how near the two come.
    const double room = stands ? 2.2 : 0.5;
    if (!dashes && !still &&
        (!is_in_reach(std::max(0.0, gap - room), rise) || (!impatient && gap > passage.gap + room + 1.2) ||
         (!impatient && std::abs(rise - passage.rise) > 1.6)))
        return;
    const std::vector<HopStyle> styles = styles_for(gap, rise, dashes);
    const int count = int(styles.size());
    for (int i = 0; i < std::min(hops_kept, count); ++i) {
        const HopStyle& style = styles[std::size_t((style_turn_ + i) % count)];
        if (!goes_well(game, style, passage.to)) continue;
        hop_ = Hop(style);
        hop_to_ = passage.to;
        phase_ = Phase::hops;
        phase_ticks_ = 0;
        stands_for_ = 0;
        foresight_->look(game);
        return;
    }
    style_turn_ += hops_kept;
    foresight_->look(game);
    // Whoever hunts or shoots goes away again, or it runs for it in the end.
    if (foresight_->threats().are_any() && waited_ <= longest_fear) style_turn_ %= count;
    // Nothing changes by itself where nothing moves: from another place, then.
    if (still && style_turn_ > 2 * count + hops_kept) fail(game);
}

// Something still will be where it is carried to: over it with a jump, and down on the same body again.
void Navigator::avoid_what_comes(const game::Game& game, std::uint32_t body) {
    foresight_->look(game);
    const auto found = std::ranges::find(game.bodies(), body, &game::MovingBody::plan);
    if (found == game.bodies().end()) return;
    const dvec3 velocity = ((*found).now.position - (*found).before.position) / game::tick_seconds;
    if (flat_length(velocity) < 0.3) return;
    const dvec3 from = game.hero().body.position + dvec3{0, 0.05, 0};
    const auto hit =
        game.world().sweep(game.settings().volume, {from, from + velocity * 0.6}, {.layers = 1, .begin = 1, .end = 1});
    if (!hit || dot(hit->normal, velocity) > -0.4 * length(velocity)) return;
    const Stand same{.body = body, .place = game.feet()};
    for (const HopStyle& style : {HopStyle{.takeoff = 1000}, HopStyle{.takeoff = 1000, .air_jumps = 1}}) {
        if (!goes_well(game, style, same)) continue;
        hop_ = Hop(style);
        hop_to_ = same;
        phase_ = Phase::hops;
        phase_ticks_ = 0;
        stands_for_ = 0;
        break;
    }
    foresight_->look(game);
}

Intent Navigator::hop(const game::Game& game) {
    foresight_->look(game);
    const game::Hero& hero = game.hero();
    const bool there = is_on(hero, game.feet(), hop_to_);
    const bool throws =
        hop_to_.body != on_ground && atlas_->level().bodies[hop_to_.body].kind == game::BodyKind::bounce;
    const bool same =
        hop_to_.body != on_ground && step_ < plan_.size() && passages_.all()[plan_[step_]].from.body == hop_to_.body;
    stands_for_ = there && (!same || hop_.is_under_way()) ? stands_for_ + 1 : 0;
    if (there && (throws || stands_for_ > 4) && (!same || stands_for_ > 2)) {
        if (same && passages_.all()[plan_[step_]].how != Passage::How::fly) {  // over what came; still on board
            phase_ = Phase::waits;
            return stay_on_body(game);
        }
        since_better_ = std::min(since_better_, options_.patience / 2);
        ++step_;
        next_step(game);
        return {};
    }
    const bool elsewhere = hop_.is_under_way() && !there && hero.body.footing == Footing::ground;
    const std::size_t on = foresight_->body_of(hero.body.ground_body);
    if (elsewhere && phase_ticks_ > 10 && on < atlas_->level().bodies.size() &&
        atlas_->level().bodies[on].kind == game::BodyKind::bounce) {
        fail(game);  // thrown up again: where to is decided now, not when it is in the air
        pause_ = 0;
        think_in_ = 0;
        think(game);
        return {};
    }
    lost_for_ = elsewhere ? lost_for_ + 1 : 0;
    if (phase_ticks_ > longest_hop || (lost_for_ > 15 && !throws)) {
        lost_for_ = 0;
        fail(game);
        return {};
    }
    return hop_.tick(hero, game.feet(), game.settings(), game.world(), aim_of(hop_to_, game.feet()));
}

Intent Navigator::manoeuvre(const game::Game& game) {
    const Passage& passage = passages_.all()[plan_[step_]];
    const game::Hero& hero = game.hero();
    const bool standing = hero.body.form == CharacterForm::standing;
    if (is_on(hero, game.feet(), passage.to)) {
        // Out from under the roof first, then up.
        if (standing && !holds_crouch(passage.manoeuvre)) {
            ++step_;
            next_step(game);
            return {};
        }
        if (flat_length(passage.to.place - game.feet()) < 0.4) {
            if (standing && ++stands_for_ > 3) {
                ++step_;
                next_step(game);
            }
            return {};
        }
    }
    if (manoeuvring_.seconds() > longest_manoeuvre) {
        fail(game);
        return {};
    }
    return manoeuvring_.tick(hero, game.feet(), game.world());
}

}  // namespace surefoot::playtest
