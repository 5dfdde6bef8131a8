#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <mutex>

#include <surefoot/navigation_links.hpp>

#include "link_ladders.hpp"
#include "link_proof.hpp"
#include "link_proposals.hpp"
#include "threads.hpp"

namespace surefoot {

namespace navigation {
namespace {

bool is_valid(const NavigationLinkOptions& options) {
    const NavigationLinkMargins& margins = options.margins;
    const auto is_length = [](double length) { return length >= 0 && std::isfinite(length); };
    return options.run_speed > 0 && std::isfinite(options.run_speed) && options.tick >= 0.001 && options.tick <= 0.1 &&
           is_length(options.deepest_drop) && options.spacing > 0 && std::isfinite(options.spacing) &&
           is_length(options.shortcut) && is_length(options.least_saving) && is_length(margins.along) &&
           is_length(margins.aside) && is_length(margins.begin) && margins.begin <= 0.15 && is_length(margins.speed) &&
           margins.speed <= 0.9 && options.threads >= 1 && options.threads <= 64;
}

/// What came of one place.
struct Found {
    std::vector<LinkProposal> done;
    NavigationLinkReport report;
};

class Finder {
public:
    explicit Finder(const LinkGround& ground)
        : tiles_(ground.mesh.state()),
          proposer_(ground),
          proof_(ground.world, ground.settings, ground.mesh, ground.islands, ground.options) {}

    [[nodiscard]] Found from(const BorderPlace& place) { return proven(proposer_.from(place)); }

    [[nodiscard]] Found proven(std::vector<LinkProposal> proposals) {
        Found found;
        const std::uint64_t before = proof_.ticks();
        for (LinkProposal& proposal : proposals) {
            if (!proposer_.is_useful(proposal, found.done)) continue;
            if (!tiles_.are_near(proposal.link.from, proposal.link.to)) {
                ++found.report.too_long;
                continue;
            }
            const auto kind = static_cast<std::size_t>(proposal.link.kind);
            ++found.report.tried[kind];
            if (!proof_.holds(proposal.link, proposal.to_island)) continue;
            ++found.report.done[kind];
            found.done.push_back(std::move(proposal));
        }
        found.report.ticks = proof_.ticks() - before;
        return found;
    }

private:
    const MeshState& tiles_;
    LinkProposer proposer_;
    LinkProof proof_;
};

std::vector<Found> find_all(const LinkGround& ground, const std::vector<LinkProposal>& ladders) {
    const std::size_t places = ground.places.size();
    std::vector<Found> found(places + ladders.size());
    std::atomic<std::size_t> next = 0;
    std::mutex telling;
    std::size_t done = 0;
    const std::atomic<bool>* const stop = ground.options.stop;
    const auto work = [&] {
        Finder finder(ground);
        for (std::size_t i = next++; i < found.size() && (stop == nullptr || !*stop); i = next++) {
            found[i] = i < places ? finder.from(ground.places[i]) : finder.proven({ladders[i - places]});
            const std::lock_guard lock(telling);
            ground.options.progress(++done, found.size());
        }
    };
    on_threads(ground.options.threads, found.size(), work);
    return found;
}

/// Of many that are alike a few, those first that join what walking does not.
std::vector<NavigationLink> thinned(std::vector<LinkProposal> proposals, double spacing) {
    std::stable_sort(proposals.begin(), proposals.end(), [](const LinkProposal& a, const LinkProposal& b) {
        const bool a_joins = a.from_island != a.to_island;
        const bool b_joins = b.from_island != b.to_island;
        return a_joins != b_joins ? a_joins : a.rank < b.rank;
    });
    std::vector<std::uint32_t> kept;
    Spots spots(spacing);
    std::vector<NavigationLink> links;
    for (std::uint32_t i = 0; i < proposals.size(); ++i) {
        const LinkProposal& proposal = proposals[i];
        const auto is_alike = [&](std::uint32_t other) {
            const LinkProposal& there = proposals[other];
            return there.link.kind == proposal.link.kind && there.from_island == proposal.from_island &&
                   there.to_island == proposal.to_island &&
                   length(there.link.takeoff - proposal.link.takeoff) < 0.9 * spacing &&
                   length(there.link.to - proposal.link.to) < 2 * spacing;
        };
        if (spots.any_near(proposal.link.takeoff, is_alike)) continue;
        spots.add(proposal.link.takeoff, i);
        kept.push_back(i);
    }
    std::sort(kept.begin(), kept.end());
    for (const std::uint32_t i : kept) links.push_back(std::move(proposals[i].link));
    return links;
}

}  // namespace
}  // namespace navigation

inline namespace v0 {

std::vector<NavigationLink> find_links(const World& world, const CharacterSettings& settings,
                                       const NavigationMesh& mesh, const NavigationLinkOptions& options,
                                       NavigationLinkReport* report) {
    using namespace navigation;
    const auto start = std::chrono::steady_clock::now();
    NavigationLinkReport all;
    std::vector<NavigationLink> links;
    if (surefoot::is_valid(settings) && navigation::is_valid(options)) {
        const Islands islands(*mesh.state().detour);
        const std::vector<BorderPlace> places = border_places(mesh.state(), islands, options.spacing);
        Spots spots(longest_jump(settings, options));
        for (std::uint32_t i = 0; i < places.size(); ++i) spots.add(places[i].place, i);
        const LinkGround ground{world, settings, mesh, options, islands, places, spots};
        std::vector<LinkProposal> done;
        for (Found& found : find_all(ground, ladder_proposals(ground))) {
            std::move(found.done.begin(), found.done.end(), std::back_inserter(done));
            for (std::size_t kind = 0; kind < std::size(all.tried); ++kind) {
                all.tried[kind] += found.report.tried[kind];
                all.done[kind] += found.report.done[kind];
            }
            all.too_long += found.report.too_long;
            all.ticks += found.report.ticks;
        }
        if (options.stop != nullptr && *options.stop) done.clear();
        links = thinned(std::move(done), options.spacing);
        for (const NavigationLink& link : links) ++all.kept[static_cast<std::size_t>(link.kind)];
    }
    all.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (report != nullptr) *report = all;
    return links;
}

}  // namespace v0
}  // namespace surefoot
