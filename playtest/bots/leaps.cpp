// Leaps: from island to island by two jumps. Found by where islands come near to each other, kept where a rehearsal
// gets over.
#include <algorithm>
#include <map>

#include "playtest/bots/passages.hpp"
#include "playtest/bots/rehearsal.hpp"
#include "playtest/vectors.hpp"

namespace surefoot::playtest {
namespace {

constexpr std::size_t tries = 4;  // from one island to another
constexpr double apart = 1.5;     // between two of them [m]
constexpr double inset = 0.45;    // of where it begins and ends, from the edge [m]

struct Candidate {
    Leap leap;
    double gap = 0;
    double effort = 0;
};

}  // namespace

std::vector<Leap> Passages::find_leaps(Foresight& foresight) const {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<Candidate>> found;
    std::map<std::pair<std::uint32_t, std::uint32_t>, bool> linked;
    for (const LinkEnds& link : links_) linked[{link.from_island, link.to_island}] = true;
    // Up through boards that let one pass from below: from right under them.
    std::vector<Border> begins = borders_;
    for (const Border& to : borders_) {
        const auto floor = atlas_->ground().ray({to.place + dvec3{0, 0.3, 0}, to.place - dvec3{0, 0.5, 0}});
        if (!floor || !is_one_way(floor->surface)) continue;
        const auto below = query_->under(to.place - dvec3{0, 0.5, 0}, 3.5, 0);
        if (below) begins.push_back({below->position, island_of(below->polygon)});
    }
    for (const Border& from : begins)
        for (const Border& to : borders_) {
            if (from.island == to.island) continue;
            const dvec3 way = to.place - from.place;
            if (std::abs(way.x) > 8 || std::abs(way.z) > 8 || way.y > 4 || way.y < -16) continue;
            const double gap = std::max(0.0, flat_length(way) - 0.7);
            if (!is_in_reach(gap, way.y) || linked.contains({from.island, to.island})) continue;
            const double effort = gap + 1.5 * std::max(0.0, way.y);
            auto& best = found[{from.island, to.island}];
            const auto near = std::ranges::find_if(
                best, [&](const Candidate& other) { return length(other.leap.from - from.place) < apart; });
            if (near != best.end() ? effort >= near->effort : best.size() >= tries && effort >= best.back().effort)
                continue;
            if (near != best.end()) best.erase(near);
            best.push_back({{from.place, to.place}, gap, effort});
            std::ranges::sort(best, {}, &Candidate::effort);
            if (best.size() > tries) best.pop_back();
        }
    std::vector<Leap> leaps;
    for (const auto& [islands, candidates] : found)
        for (const Candidate& candidate : candidates) {
            if (is_walled(candidate.leap.from, candidate.leap.to)) continue;
            const dvec3 way = unit(flat(candidate.leap.to - candidate.leap.from));
            const auto from = query_->nearest(candidate.leap.from - way * inset, 0.3, 0.5);
            const auto to = query_->nearest(candidate.leap.to + way * inset, 0.3, 0.5);
            if (!from || !to || island_of(from->polygon) != islands.first || island_of(to->polygon) != islands.second)
                continue;
            const Stand goal{.place = to->position, .island = islands.second};
            const auto gets_over = [&](const HopStyle& style) {
                return rehearse(
                    foresight, [&] { foresight.put(from->position); }, atlas_->settings(), {}, style, goal, false);
            };
            if (std::ranges::none_of(styles_for(candidate.gap, to->position.y - from->position.y, false), gets_over))
                continue;
            leaps.push_back({from->position, to->position});
            break;
        }
    return leaps;
}

void Passages::add_leaps() {
    for (const Leap& leap : atlas_->leaps()) {
        const auto from = stand_at(leap.from);
        const auto to = stand_at(leap.to);
        if (!from || !to) continue;
        const double gap = std::max(0.0, flat_length(leap.to - leap.from) - 0.9);
        all_.push_back(
            {Passage::How::leap, *from, *to, game::Manoeuvre::ride, gap, leap.to.y - leap.from.y, 2 + 0.3 * gap});
    }
}

}  // namespace surefoot::playtest
