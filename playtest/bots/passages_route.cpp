// The quickest way through the graph: Dijkstra over the beginnings of passages.
#include <algorithm>
#include <limits>

#include "game/hero.hpp"
#include "playtest/bots/passages.hpp"
#include "playtest/vectors.hpp"

namespace surefoot::playtest {
namespace {

constexpr double never = std::numeric_limits<double>::max();

// The straight way is shorter than the one that is walked.
double walk_time(const dvec3& from, const dvec3& to) {
    return 1.2 * length(to - from) / game::run_speed;
}

}  // namespace

std::optional<Itinerary> Passages::route(const Stand& from, const Stand& to,
                                         std::span<const std::uint32_t> without) const {
    // Nodes: the ends of links, then those of passages, and the goal last. A node is where somebody stands who has just
    // gone over it; -1 is where the way begins.
    const std::size_t links = links_.size();
    const std::size_t goal = links + all_.size();
    std::vector<double> time(goal + 1, never);
    std::vector<std::size_t> before(goal + 1, goal + 1);
    std::vector<bool> done(goal + 1, false);
    const auto reach = [&](std::size_t node, double at, std::size_t by) {
        if (at >= time[node]) return;
        time[node] = at;
        before[node] = by;
    };
    const auto go_on = [&](const Stand& stand, double at, std::size_t by) {
        if (stand.body == on_ground) {
            for (std::size_t i = 0; i < links; ++i)
                if (!done[i] && links_[i].from_island == stand.island)
                    reach(i, at + walk_time(stand.place, links_[i].from) + links_[i].seconds, by);
            if (to.body == on_ground && to.island == stand.island)
                reach(goal, at + walk_time(stand.place, to.place), by);
        } else if (to.body == stand.body) {
            reach(goal, at, by);
        }
        for (std::size_t i = 0; i < all_.size(); ++i) {
            const Stand& begin = all_[i].from;
            if (done[links + i] || begin.body != stand.body ||
                (begin.body == on_ground && begin.island != stand.island))
                continue;
            const double walk = begin.body == on_ground ? walk_time(stand.place, begin.place) : 0;
            reach(links + i, at + walk + all_[i].seconds, by);
        }
    };
    for (const std::uint32_t passage : without) done[links + passage] = true;
    go_on(from, 0, goal + 1);
    for (;;) {
        std::size_t next = goal + 1;
        for (std::size_t i = 0; i <= goal; ++i)
            if (!done[i] && time[i] < never && (next > goal || time[i] < time[next])) next = i;
        if (next > goal) return std::nullopt;
        done[next] = true;
        if (next == goal) break;
        if (next < links)
            go_on(Stand{.place = links_[next].to, .island = links_[next].to_island}, time[next], next);
        else
            go_on(all_[next - links].to, time[next], next);
    }
    Itinerary found{.passages = {}, .seconds = time[goal]};
    for (std::size_t at = before[goal]; at <= goal; at = before[at])
        if (at >= links) found.passages.push_back(std::uint32_t(at - links));
    std::ranges::reverse(found.passages);
    return found;
}

}  // namespace surefoot::playtest
