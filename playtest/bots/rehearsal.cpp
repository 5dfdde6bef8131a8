#include "playtest/bots/rehearsal.hpp"

#include <algorithm>

#include <surefoot/pose.hpp>

#include "playtest/vectors.hpp"

namespace surefoot::playtest {
namespace {

constexpr int longest_hop = 60 * 4;  // ticks
constexpr int longest_run_up = 75;   // ticks

}  // namespace

HopAim aim_at(const Foresight& foresight, std::span<const dvec3> spots, const Stand& to, const dvec3& feet) {
    if (to.body == on_ground) return {.place = to.place};
    const Pose pose = foresight.pose(to.body);
    if (spots.empty()) return {.place = pose.position};
    dvec3 middle{0, 0, 0};
    for (const dvec3& spot : spots) middle += spot / double(spots.size());
    middle = to_world(pose, middle);
    dvec3 nearest = to_world(pose, spots.front());
    for (const dvec3& spot : spots)
        if (const dvec3 at = to_world(pose, spot); flat_length(at - feet) < flat_length(nearest - feet)) nearest = at;
    const dvec3 in = flat(middle - nearest);
    const double inset = flat_length(nearest - feet) < 0.4 ? 0 : std::min(0.6, length(in));
    const dvec3 place = nearest + unit(in) * inset;
    return {.place = place, .velocity = foresight.velocity(to.body, place)};
}

bool stands_on(const Foresight& foresight, std::span<const dvec3> spots, const game::Hero& hero, const dvec3& feet,
               const Stand& to) {
    if (to.body != on_ground && to.body >= foresight.body_count()) return hero.in_water;
    if (hero.body.footing != Footing::ground) return false;
    const std::size_t body = foresight.body_of(hero.body.ground_body);
    if (to.body != on_ground) {
        // On its top, and not on a rim below it.
        return body == to.body && (spots.empty() || feet.y > aim_at(foresight, spots, to, feet).place.y - 0.3);
    }
    return body >= foresight.body_count() && flat_length(feet - to.place) < 1.5 && std::abs(feet.y - to.place.y) < 1.2;
}

bool rehearse(Foresight& foresight, const std::function<void()>& reset, const CharacterSettings& settings,
              std::span<const dvec3> spots, const HopStyle& style, const Stand& to, bool throws) {
    constexpr int steady = 8;  // ticks on its feet
    for (std::uint64_t seed = 1; seed <= 2; ++seed) {
        reset();
        const double start = foresight.feet().y;
        Hop trial(style);
        Hands hands(seed * 977);
        int stood = 0;
        int fell_short = 0;
        for (int i = 0; i < longest_hop && stood < steady; ++i) {
            const Intent intent = trial.tick(foresight.hero(), foresight.feet(), settings, foresight.world(),
                                             aim_at(foresight, spots, to, foresight.feet()));
            if (!foresight.tick(hands.act(intent))) return false;
            const bool there = stands_on(foresight, spots, foresight.hero(), foresight.feet(), to);
            if (there && throws) return true;
            // Whoever never left the ground it stood on has not got anywhere yet.
            stood = there && (trial.is_under_way() || to.body != on_ground || i > 10) ? stood + 1 : 0;
            if (!trial.is_under_way() && stood == 0 && i > longest_run_up) return false;
            const double low = std::min(
                to.body == on_ground ? to.place.y : aim_at(foresight, spots, to, foresight.feet()).place.y, start);
            const CharacterState& body = foresight.hero().body;
            const bool sinks = body.footing == Footing::air && body.velocity.y < -4 && body.air_jumps_left == 0;
            if (foresight.feet().y < low - (sinks ? 1.8 : 3.5)) return false;
            const bool elsewhere = trial.is_under_way() && !there && foresight.hero().body.footing == Footing::ground;
            fell_short = elsewhere ? fell_short + 1 : 0;
            if (fell_short > 25) return false;
        }
        if (stood < steady) return false;
    }
    return true;
}

std::vector<HopStyle> styles_for(double gap, double rise, bool dashes) {
    std::vector<HopStyle> styles;
    const auto add = [&](const HopStyle& style) { styles.push_back(style); };
    if (dashes) {
        for (const bool late : {true, false}) add({.air_jumps = 1, .late = late, .dashes = true});
        add({.air_jumps = 0, .dashes = true});
    }
    if (rise < 0.35) add({.jumps = false});
    if (rise < 1.4) add({});
    for (const double takeoff : {1.0, 1.7, 2.4})
        if (rise > 0.2) add({.takeoff = takeoff});
    if (gap > 2 || rise > 1) {
        add({.air_jumps = 1, .late = true});
        add({.air_jumps = 1});
        for (const double takeoff : {1.2, 2.0, 2.8})
            if (rise > 0.2) add({.takeoff = takeoff, .air_jumps = 1});
    }
    return styles;
}

}  // namespace surefoot::playtest
