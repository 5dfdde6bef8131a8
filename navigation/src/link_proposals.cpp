#include "link_proposals.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "forbidden.hpp"

namespace surefoot::navigation {
namespace {

/// The longest way to come to speed before an edge [m].
constexpr double run_up = 0.8;
/// So far from the border a link ends, where there is so much ground [m].
constexpr double inset = 0.4;
/// Of those that look alike only so many are simulated from one place.
constexpr std::size_t most_crossings = 10;
/// The least cosine between the way and what leads off the border, or on to the other.
constexpr double least_facing = 0.3;

}  // namespace

double jump_range(const CharacterSettings& settings, double speed, double rise, std::uint32_t air_jumps) {
    if (!(settings.gravity > 0)) return 0;
    const double jumps = 1.0 + air_jumps;
    const double squared = 2 * settings.gravity * (jumps * settings.jump_height - rise);
    if (!(squared >= 0)) return 0;
    const double up = std::sqrt(2 * settings.gravity * settings.jump_height);
    return speed * (jumps * up + std::sqrt(squared)) / settings.gravity;
}

double highest_jump(const CharacterSettings& settings, double radius, std::uint32_t air_jumps) {
    // A round body gets over an edge a little before its feet do; hands pull it up.
    const double over = settings.ledge_reach > 0 ? std::max(settings.hands_height, radius / 2) : radius / 2;
    return std::max((1.0 + air_jumps) * settings.jump_height + over, settings.vault_height);
}

double longest_jump(const CharacterSettings& settings, const NavigationLinkOptions& options) {
    // Whoever falls for longer gets farther, but a way down is taken nearer by.
    return std::max({1.0, 1.25 * jump_range(settings, options.run_speed, 0, most_air_jumps(settings)) + 2 * inset,
                     highest_jump(settings, 1, most_air_jumps(settings))});
}

std::uint32_t most_air_jumps(const CharacterSettings& settings) {
    // Whoever jumps more often than that flies, and of flying no mesh is made.
    return std::min<std::uint32_t>(settings.air_jumps, 4);
}

LinkProposer::LinkProposer(const LinkGround& ground)
    : ground_(ground),
      agent_(ground.mesh.agent()),
      up_(ground.mesh.up()),
      query_(ground.mesh, 4096, NavigationDoors::open) {}

double LinkProposer::above(const dvec3& from, const dvec3& to) const {
    return dot(to - from, up_);
}
dvec3 LinkProposer::level(const dvec3& v) const {
    return v - up_ * dot(v, up_);
}

dvec3 LinkProposer::along_ground(const dvec3& place, const dvec3& way, double most) {
    const auto start = query_.nearest(place, agent_.radius, std::max(agent_.climb, 0.2));
    if (!start) return place;
    const auto ray = query_.ray(*start, start->position + way * most);
    // Not quite to where the ground ends.
    const double got = !ray ? 0 : ray->hit ? 0.9 * ray->t : 1;
    const dvec3 end = start->position + way * (most * got);
    const auto ground = query_.under(end, 1, 1);
    return ground ? ground->position : start->position;
}

void LinkProposer::add(NavigationLinkKind kind, const BorderPlace& place, const dvec3& to, std::uint32_t to_island,
                       double behind, double rank, std::uint32_t air_jumps) {
    dvec3 way = level(to - place.place);
    const double size = length(way);
    if (!(size > 1e-6)) return;
    way /= size;
    LinkProposal proposal{.link = {}, .from_island = place.island, .to_island = to_island, .rank = rank + behind};
    NavigationLink& link = proposal.link;
    link.kind = kind;
    link.air_jumps = air_jumps;
    link.to = to;
    link.takeoff = along_ground(place.place, -way, behind);
    link.from = kind == NavigationLinkKind::step_up ? link.takeoff : along_ground(link.takeoff, -way, run_up);
    const double fall = std::max(0.0, above(to, place.place));
    for (const double share : {1.0, 0.5}) {
        link.speed = ground_.options.run_speed * share;
        link.seconds = (length(link.to - link.from)) / link.speed + 1.0 + air_jumps +
                       (ground_.settings.gravity > 0 ? std::sqrt(2 * fall / ground_.settings.gravity) : 0);
        found_.push_back(proposal);
        proposal.rank += 2;
    }
}

void LinkProposer::add_drops(const BorderPlace& place) {
    const NavigationLinkOptions& options = ground_.options;
    double last = 0;
    for (const double beyond : {0.3, 0.9, 1.8, 3.0}) {
        const dvec3 over = place.place + place.out * (agent_.radius + beyond);
        const auto below = query_.under(over, options.deepest_drop, 0);
        if (!below) continue;
        const double drop = above(below->position, place.place);
        // What is hardly more than a step is walked.
        const double step = agent_.climb + ground_.mesh.state().plan.cell_height;
        if (drop <= step || std::abs(drop - last) < 0.05) continue;
        last = drop;
        if (is_walled(place.place, over, false)) break;
        add(NavigationLinkKind::drop, place, below->position, ground_.islands.of(below->polygon.id), 0, beyond);
    }
}

void LinkProposer::add_crossing(const BorderPlace& place, const BorderPlace& goal) {
    const dvec3 to = along_ground(goal.place, -goal.out, inset);
    const double rise = above(place.place, goal.place);
    const double distance = length(level(goal.place - place.place));
    const double rank = distance + std::abs(rise);
    if (std::abs(rise) <= agent_.climb + ground_.mesh.state().plan.cell_height && distance < 2 * agent_.radius + 1 &&
        !is_walled(place.place, goal.place, false))
        add(NavigationLinkKind::step_up, place, to, goal.island, 0, rank);
    if (!is_walled(place.place, goal.place, true)) add_jumps(place, goal, to, rank + 0.5);
}

void LinkProposer::add_jumps(const BorderPlace& place, const BorderPlace& goal, const dvec3& to, double rank) {
    const CharacterSettings& settings = ground_.settings;
    const double rise = above(place.place, goal.place);
    const double distance = length(level(goal.place - place.place)) - 2 * agent_.radius;
    for (std::uint32_t air = 0; air <= most_air_jumps(settings); ++air) {
        if (rise > highest_jump(settings, agent_.radius, air)) continue;
        const double height = (1.0 + air) * settings.jump_height;
        if (distance > jump_range(settings, ground_.options.run_speed, std::min(rise, height), air)) continue;
        // One jump is the surest, where it gets there.
        const double worse = rank + 4.0 * air;
        add(NavigationLinkKind::jump, place, to, goal.island, 0, worse, air);
        // Whoever is late must not step on to forbidden ground.
        if (Forbidden{ground_.options.regions, ground_.options.surface_areas}.any())
            add(NavigationLinkKind::jump, place, to, goal.island, ground_.options.margins.along + 0.1, worse, air);
        if (rise <= agent_.climb) continue;
        // Up a wall there may be more way to rise on from farther back.
        for (const double behind : {0.6, 1.2})
            add(NavigationLinkKind::jump, place, to, goal.island, behind, worse, air);
    }
}

bool LinkProposer::is_walled(const dvec3& from, const dvec3& to, bool jumps) const {
    const auto is_blocked = [&](const dvec3& a, const dvec3& b) {
        return ground_.world.ray_any({a, b}, {.layers = ground_.mesh.state().plan.layers});
    };
    const dvec3 middle = up_ * agent_.feet;
    if (!is_blocked(from + middle, to + middle)) return false;
    if (!jumps) return true;
    const double rise = above(from, to);
    const double least = std::max(rise, 0.0);
    const double most = std::max((1.0 + most_air_jumps(ground_.settings)) * ground_.settings.jump_height, least);
    for (const double lift : {least, (least + most) / 2, most})
        if (!is_blocked(from + middle + up_ * lift, to + middle + up_ * (lift - rise))) return false;
    return true;
}

void LinkProposer::add_crossings(const BorderPlace& place) {
    const NavigationLinkOptions& options = ground_.options;
    struct Goal {
        double rank = 0;
        std::uint32_t number = 0;
    };
    std::vector<Goal> goals;
    const std::uint32_t air = most_air_jumps(ground_.settings);
    const double highest = highest_jump(ground_.settings, agent_.radius, air);
    const double height = (1.0 + air) * ground_.settings.jump_height;
    ground_.spots.any_near(place.place, [&](std::uint32_t number) {
        const BorderPlace& goal = ground_.places[number];
        const double rise = above(place.place, goal.place);
        if (rise < -options.deepest_drop || rise > highest) return false;
        const dvec3 way = level(goal.place - place.place);
        const double distance = length(way);
        const double range = jump_range(ground_.settings, options.run_speed, std::min(rise, height), air);
        if (distance > range + 2 * agent_.radius || distance < 1e-3) return false;
        // Close by, at the two sides of a thin gap, directions say little.
        if (distance > agent_.radius &&
            (dot(way, place.out) < least_facing * distance || dot(way, goal.out) > -least_facing * distance))
            return false;
        goals.push_back({distance + std::abs(rise) + (goal.island == place.island ? 1000 : 0), number});
        return false;
    });
    std::sort(goals.begin(), goals.end(),
              [](const Goal& a, const Goal& b) { return a.rank != b.rank ? a.rank < b.rank : a.number < b.number; });
    goals.erase(
        std::unique(goals.begin(), goals.end(), [](const Goal& a, const Goal& b) { return a.number == b.number; }),
        goals.end());
    if (goals.size() > most_crossings) goals.resize(most_crossings);
    for (const Goal& goal : goals) add_crossing(place, ground_.places[goal.number]);
}

std::vector<LinkProposal> LinkProposer::from(const BorderPlace& place) {
    found_.clear();
    add_drops(place);
    add_crossings(place);
    std::stable_sort(found_.begin(), found_.end(), [](const auto& a, const auto& b) {
        const bool a_joins = a.from_island != a.to_island;
        const bool b_joins = b.from_island != b.to_island;
        return a_joins != b_joins ? a_joins : a.rank < b.rank;
    });
    return std::move(found_);
}

bool LinkProposer::is_far(const dvec3& from, const dvec3& to, const NavigationLink& link) {
    const double vertical = std::max(agent_.climb, 0.2);
    const auto start = query_.nearest(from, agent_.radius, vertical);
    const auto end = query_.nearest(to, agent_.radius, vertical);
    if (!start || !end) return false;
    const auto walk = query_.path(*start, *end);
    const double direct = length(link.to - link.from);
    return walk && (walk->partial || walk->length > ground_.options.shortcut * direct + ground_.options.least_saving);
}

bool LinkProposer::is_useful(const LinkProposal& proposal, std::span<const LinkProposal> others) {
    const NavigationLink& link = proposal.link;
    const auto replaces = [&](const LinkProposal& other) {
        return other.to_island == proposal.to_island && !is_far(other.link.to, link.to, link);
    };
    return std::none_of(others.begin(), others.end(), replaces) &&
           (proposal.from_island != proposal.to_island || is_far(link.from, link.to, link));
}

}  // namespace surefoot::navigation
