// Where to jump from, and where to, for what hangs in the air: between islands, beside them, over what moves.
#include <algorithm>
#include <limits>

#include "playtest/bots/foresight.hpp"
#include "playtest/bots/passages.hpp"
#include "playtest/vectors.hpp"

namespace surefoot::playtest {
namespace {

constexpr std::size_t most_catches = 8;  // of one thing
constexpr std::size_t most_ends = 3;     // from one place
constexpr double farthest = 6.5;         // from the ground to what hangs, or on to the ground [m]
constexpr double highest = 2.9;          // above where it is jumped from [m]
constexpr double deepest = 14;           // and below [m]
constexpr double falls = 60;             // so deep it is looked for ground under what hangs [m]
constexpr double apart = 1.6;            // between two places to jump from [m]
constexpr double inset = 0.4;            // from the edge [m]

}  // namespace

std::vector<Catch> Passages::catches(const dvec3& place) const {
    const dvec3 feet = place - dvec3{0, catch_height, 0};
    std::vector<Catch> found;
    std::vector<Stand> ends;
    const auto offer_end = [&](const dvec3& at) {
        if (const auto stand = stand_at(at, 0.6, 1)) ends.push_back(*stand);
    };
    const auto offer = [&](const Stand& from, double gap, double rise) {
        if (gap > farthest || rise > highest || rise < -deepest) return;
        found.push_back({.from = from, .ends = {}, .effort = gap + 1.5 * std::max(0.0, rise) + 0.1 * std::abs(rise)});
    };
    // The edges around it, a step in from where they end.
    for (const Border& border : borders_) {
        const dvec3 way = flat(feet - border.place);
        if (length(way) > farthest + 1 || border.place.y > feet.y + deepest || border.place.y < feet.y - falls)
            continue;
        const auto in = query_->nearest(border.place - unit(way) * inset, 0.5, 0.8);
        const Stand stand{.place = in ? in->position : border.place, .island = border.island};
        offer(stand, length(way), feet.y - border.place.y);
        if (border.place.y < feet.y + 2) ends.push_back(stand);
    }
    // The ground under it, however deep.
    if (const auto floor = atlas_->ground().ray({feet, feet - dvec3{0, falls, 0}})) {
        offer_end(floor->point);
        if (const auto stand = stand_at(floor->point, 0.6, 1)) offer(*stand, 0, feet.y - stand->place.y);
    }
    // What comes by.
    for (std::size_t body = 0; body < rims_.size(); ++body) {
        const game::BodyPlan& plan = atlas_->level().bodies[body];
        if (rims_[body].empty() || plan.kind == game::BodyKind::bounce) continue;
        double nearest = std::numeric_limits<double>::max();
        double rise = 0;
        for (const double clock : clocks_of(plan)) {
            const Pose pose = pose_at(plan, clock);
            for (const dvec3& spot : spots_[body]) {
                const dvec3 at = to_world(pose, spot);
                if (flat_length(feet - at) + std::abs(feet.y - at.y) >= nearest) continue;
                nearest = flat_length(feet - at) + std::abs(feet.y - at.y);
                rise = feet.y - at.y;
            }
        }
        const Stand stand{.body = std::uint32_t(body), .place = plan.origin};
        if (nearest - std::abs(rise) < 4) offer(stand, std::max(0.0, nearest - std::abs(rise)), rise);
    }

    std::ranges::stable_sort(found, {}, &Catch::effort);
    std::vector<Catch> kept;
    for (Catch& one : found) {
        const auto is_near = [&](const Catch& other) {
            return other.from.body == one.from.body &&
                   (one.from.body != on_ground || length(other.from.place - one.from.place) < apart);
        };
        if (kept.size() >= most_catches || std::ranges::any_of(kept, is_near)) continue;
        // On straight ahead rather than back, and not far; and back where there is nothing else.
        const dvec3 way = unit(flat(feet - one.from.place));
        std::vector<std::pair<double, Stand>> order;
        for (const Stand& end : ends) {
            const dvec3 on = flat(end.place - feet);
            if (length(on) > farthest) continue;
            order.push_back({length(on) - 1.5 * dot(way, unit(on)) + 0.2 * std::abs(end.place.y - feet.y), end});
        }
        std::ranges::stable_sort(order, {}, &std::pair<double, Stand>::first);
        for (const auto& choice : order) {
            const Stand& end = choice.second;
            if (one.ends.size() >= most_ends) break;
            const auto is_there = [&](const Stand& other) { return length(other.place - end.place) < apart; };
            if (std::ranges::none_of(one.ends, is_there)) one.ends.push_back(end);
        }
        one.ends.push_back(one.from);
        kept.push_back(std::move(one));
    }
    return kept;
}

}  // namespace surefoot::playtest
