#include <algorithm>
#include <set>

#include "agreement.hpp"
#include "mesh_state.hpp"
#include "random_walks.hpp"

namespace surefoot {
inline namespace v0 {
namespace {

using navigation::RandomWalk;

/// Of the ground that the feet reach, no more is taken out.
constexpr double most_out = 0.01;
constexpr std::size_t most_rounds = 12;
/// Far from the seeds of any check.
constexpr std::uint64_t first_seed = 0x9e3779b97f4a7c15;

/// What a round of walks failed at.
struct Failures {
    std::set<std::uint32_t> links;
    std::vector<NavigationPolygon> polygons;

    [[nodiscard]] bool any() const { return !links.empty() || !polygons.empty(); }
};

Failures failures_of(const NavigationMesh& mesh, std::span<const RandomWalk> walks) {
    Failures failures;
    for (const RandomWalk& walk : walks) {
        const WalkReport& report = walk.report;
        failures.links.insert(report.failed_links.begin(), report.failed_links.end());
        if (report.arrived || !report.failed_links.empty()) continue;
        // Of where it was and of what it wanted to get on to, the smaller is the likelier to be wrong.
        const double here = navigation::area_of(mesh.state(), report.last_polygon);
        const double ahead = navigation::area_of(mesh.state(), report.next_polygon);
        const NavigationPolygon out =
            ahead > 0 && (ahead <= here || !(here > 0)) ? report.next_polygon : report.last_polygon;
        if (out && std::find(failures.polygons.begin(), failures.polygons.end(), out) == failures.polygons.end())
            failures.polygons.push_back(out);
    }
    return failures;
}

/// Takes out what is small enough for `left` [m^2]; how much that is.
double take_out_small(NavigationMesh& mesh, std::span<const NavigationPolygon> polygons, double left,
                      std::size_t& count) {
    double taken = 0;
    for (const NavigationPolygon& polygon : polygons) {
        const double area = navigation::area_of(mesh.state(), polygon);
        if (taken + area > left) continue;
        mesh.take_out(std::span(&polygon, 1));
        taken += area;
        ++count;
    }
    return taken;
}

void drop_links(NavigationMesh& mesh, const std::set<std::uint32_t>& dropped) {
    if (dropped.empty()) return;
    std::vector<NavigationLink> kept;
    for (std::uint32_t i = 0; i < mesh.links().size(); ++i)
        if (!dropped.contains(i)) kept.push_back(mesh.links()[i]);
    // Fewer than there were need no more room.
    static_cast<void>(mesh.set_links(kept));
}

}  // namespace

void rehearse(NavigationMesh& mesh, const World& world, const CharacterSettings& settings, const NavigationFlood& flood,
              const dvec3& start, const NavigationCheckOptions& options, NavigationAgreement& agreement) {
    if (options.rehearsals == 0) return;
    const auto told = [&](std::size_t done, std::size_t all) {
        options.progress(NavigationCheckPart::rehearsal, done, all);
    };
    const NavigationProgress progress(told);
    const double most = most_out * agreement.kept;
    for (std::size_t round = 0; round < most_rounds; ++round) {
        const std::vector<RandomWalk> walks =
            navigation::random_walks(world, settings, mesh, options.walk, options.threads, options.rehearsals,
                                     first_seed + 2 * round * options.rehearsals, progress);
        agreement.rehearsed += walks.size();
        const Failures failures = failures_of(mesh, walks);
        if (!failures.any()) return;
        const double taken =
            take_out_small(mesh, failures.polygons, most - agreement.failed_area, agreement.failed_polygons);
        agreement.failed_area += taken;
        agreement.failed_links += failures.links.size();
        if (!(taken > 0) && failures.links.empty()) return;
        drop_links(mesh, failures.links);
        navigation::keep_joined(mesh, flood, start, agreement);
    }
}

}  // namespace v0
}  // namespace surefoot
