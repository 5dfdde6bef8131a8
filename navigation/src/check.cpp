#include <algorithm>
#include <array>
#include <charconv>
#include <string>
#include <unordered_set>

#include <surefoot/navigation_check.hpp>
#include <surefoot/navigation_query.hpp>

#include "mesh_state.hpp"
#include "random_walks.hpp"

namespace surefoot {
inline namespace v0 {
namespace {

using navigation::RandomWalk;

constexpr std::size_t most_failed = 32;

/// Links between places that the feet get to and come back from.
std::vector<NavigationLink> links_used(const NavigationMesh& mesh, const NavigationFlood& flood) {
    std::vector<NavigationLink> used;
    for (std::size_t i = 0; i < mesh.links().size(); ++i)
        if (flood.links_used[i]) used.push_back(mesh.links()[i]);
    return used;
}

/// Which of the links that the feet use are still there, and begin and end on ground that is open.
void count_links(const NavigationMesh& mesh, std::span<const NavigationLink> used, NavigationCheck& check) {
    const NavigationQuery query(mesh, 16, NavigationDoors::open);
    const double aside = 2 * mesh.agent().radius;
    const double vertical = std::max(mesh.agent().climb, mesh.agent().radius);
    // They keep their order, whichever are dropped.
    auto kept = mesh.links().begin();
    for (const NavigationLink& link : used) {
        ++check.links_of_feet[static_cast<std::size_t>(link.kind)];
        const auto found = std::find_if(kept, mesh.links().end(), [&](const NavigationLink& there) {
            return there.from == link.from && there.to == link.to && there.kind == link.kind &&
                   there.speed == link.speed && there.takeoff == link.takeoff;
        });
        if (found == mesh.links().end()) continue;
        kept = found + 1;
        if (query.nearest(link.from, aside, vertical) && query.nearest(link.to, aside, vertical))
            ++check.links_kept[static_cast<std::size_t>(link.kind)];
    }
}

void count_walks(std::span<const RandomWalk> walks, double speed, NavigationCheck& check) {
    check.walks = walks.size();
    for (const RandomWalk& walk : walks) {
        check.links_walked += walk.report.links;
        if (!walk.report.arrived) {
            if (check.failed.size() < most_failed)
                check.failed.push_back({walk.from.position, walk.to.position, walk.report});
            continue;
        }
        ++check.arrived;
        check.length += walk.report.planned;
        check.seconds += walk.report.seconds;
        // Of a walk of a few steps the start and the stop are most.
        constexpr double long_enough = 5;
        if (walk.report.planned >= long_enough)
            check.slowest = std::max(check.slowest, walk.report.seconds * speed / walk.report.planned);
    }
}

/// The ground under a place to begin, or near it.
std::optional<NavigationPoint> ground_at(const NavigationQuery& query, const dvec3& place) {
    const NavigationAgent& agent = query.mesh().agent();
    const auto point = query.under(place, 2 * agent.height, agent.height);
    return point ? point : query.nearest(place, agent.radius * 4, agent.height);
}

}  // namespace

bool NavigationCheck::lost_a_kind() const noexcept {
    for (std::size_t kind = 0; kind < std::size(links_kept); ++kind)
        if (links_of_feet[kind] > 0 && links_kept[kind] == 0) return true;
    return false;
}

std::optional<dvec3> best_start(const NavigationMesh& mesh, std::span<const dvec3> places) noexcept {
    const NavigationQuery query(mesh, 16, NavigationDoors::open);
    std::optional<dvec3> best;
    double most = 0;
    std::unordered_set<std::uint32_t> known;
    const auto consider = [&](const std::optional<NavigationPoint>& point) {
        if (!point || known.contains(point->polygon.id)) return;
        const std::vector<NavigationPolygon> reached = query.reachable(*point);
        double area = 0;
        for (const NavigationPolygon polygon : reached) {
            known.insert(polygon.id);
            area += navigation::area_of(mesh.state(), polygon);
        }
        if (area <= most) return;
        most = area;
        best = point->position;
    };
    for (const dvec3& place : places) {
        consider(ground_at(query, place));
    }
    if (best) return best;
    std::vector<NavigationOutline> outlines(mesh.report().polygons);
    outlines.resize(std::min(mesh.outlines(outlines), outlines.size()));
    // The largest first: of each piece that is the place that is the likeliest to be good ground.
    std::stable_sort(outlines.begin(), outlines.end(), [&](const NavigationOutline& a, const NavigationOutline& b) {
        return navigation::area_of(mesh.state(), a.polygon) > navigation::area_of(mesh.state(), b.polygon);
    });
    for (const NavigationOutline& outline : outlines) {
        dvec3 middle{0, 0, 0};
        for (std::uint32_t i = 0; i < outline.corners; ++i)
            middle += outline.corner[i] / static_cast<double>(outline.corners);
        if (!outline.taken_out) consider(query.nearest(middle, mesh.agent().radius, mesh.agent().height));
    }
    return best;
}

Expected<dvec3> start_at(const NavigationMesh& mesh, const dvec3& place) {
    if (const auto point = ground_at(NavigationQuery(mesh, 16, NavigationDoors::open), place)) return point->position;
    const auto number = [](double value) {
        std::array<char, 32> text{};
        return std::string(text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr);
    };
    return tl::unexpected(Error{.code = ErrorCode::invalid,
                                .text = "navigation: there is no ground to begin on at " + number(place.x) + "," +
                                        number(place.y) + "," + number(place.z) +
                                        ": none under it to twice the "
                                        "character's height, and none near it",
                                .file = {}});
}

NavigationAgreement prove_by_feet(NavigationMesh& mesh, const World& world, const CharacterSettings& settings,
                                  const dvec3& start, const NavigationCheckOptions& options, NavigationCheck* check) {
    const auto told = [&](NavigationCheckPart part) {
        return [&options, part](std::size_t done, std::size_t all) { options.progress(part, done, all); };
    };
    const auto link_progress = told(NavigationCheckPart::links);
    NavigationLinkOptions link_options = options.links;
    link_options.threads = options.threads;
    link_options.regions = options.mesh.regions;
    link_options.surface_areas = options.mesh.surface_areas;
    link_options.progress = NavigationProgress(link_progress);
    NavigationLinkReport link_report;
    const std::vector<NavigationLink> links = find_links(world, settings, mesh, link_options, &link_report);
    // Too many for a tile's references is the one way to fail, and then there are none.
    if (!mesh.set_links(links)) static_cast<void>(mesh.set_links({}));

    const auto flood_progress = told(NavigationCheckPart::flood);
    NavigationFloodOptions flood_options = options.flood;
    flood_options.regions = options.mesh.regions;
    flood_options.surface_areas = options.mesh.surface_areas;
    flood_options.threads = options.threads;
    flood_options.progress = NavigationProgress(flood_progress);
    const NavigationFlood flood = flood_by_feet(world, settings, mesh, std::span(&start, 1), flood_options);
    const std::vector<NavigationLink> used = links_used(mesh, flood);
    NavigationAgreement agreement = keep_reached(mesh, flood, start);
    rehearse(mesh, world, settings, flood, start, options, agreement);
    if (check != nullptr) {
        check->links = link_report;
        check->flood_cells = flood.cells.size();
        check->flood_whole = flood.whole;
        check->agreement = agreement;
        count_links(mesh, used, *check);
    }
    return agreement;
}

Expected<NavigationCheck> check_navigation(const World& world, const CharacterSettings& settings,
                                           std::span<const dvec3> starts, const NavigationCheckOptions& options) {
    const auto build_progress = [&](std::size_t done, std::size_t all) {
        options.progress(NavigationCheckPart::build, done, all);
    };
    NavigationOptions mesh_options = options.mesh;
    mesh_options.threads = options.threads;
    mesh_options.progress = NavigationProgress(build_progress);
    Expected<NavigationMesh> mesh = NavigationMesh::build(world, settings, mesh_options);
    if (!mesh) return tl::unexpected(mesh.error());
    std::optional<dvec3> start;
    if (options.start) {
        const Expected<dvec3> given = start_at(*mesh, *options.start);
        if (!given) return tl::unexpected(given.error());
        start = *given;
    } else {
        start = best_start(*mesh, starts);
    }
    if (!start)
        return tl::unexpected(Error{.code = ErrorCode::invalid,
                                    .text =
                                        "navigation: nobody can stand anywhere in this level; look at its scale and at "
                                        "the character's size and slope limit",
                                    .file = {}});
    NavigationCheck check;
    check.mesh = mesh->report();
    check.least_covered = options.least_covered;
    static_cast<void>(prove_by_feet(*mesh, world, settings, *start, options, &check));
    const auto walk_progress = [&](std::size_t done, std::size_t all) {
        options.progress(NavigationCheckPart::walks, done, all);
    };
    count_walks(navigation::random_walks(world, settings, *mesh, options.walk, options.threads, options.walks,
                                         options.seed << 32, NavigationProgress(walk_progress)),
                options.walk.follow.speed, check);
    return check;
}

}  // namespace v0
}  // namespace surefoot
