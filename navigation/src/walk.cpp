#include <algorithm>
#include <cmath>

#include <surefoot/navigation_walk.hpp>

#include "follow_line.hpp"
#include "frame.hpp"

namespace surefoot {
inline namespace v0 {
namespace {

constexpr double longest_settling = 1;  ///< before the walk begins [s]
constexpr double at_least = 10;         ///< time for every walk [s]
constexpr double patience = 4;          ///< times what the plan takes at full speed

/// What kept a character from going, the worst last.
enum class Halt { none, blocked, overflow };

Halt halt_of(const CharacterEvents& events) {
    if (events.has(CharacterEvent::overflow)) return Halt::overflow;
    return events.has(CharacterEvent::blocked) ? Halt::blocked : Halt::none;
}

CharacterState at_rest(const World& world, const CharacterSettings& settings, const NavigationQuery& query,
                       const dvec3& from, double tick) {
    const dvec3& up = query.mesh().up();
    CharacterState state{.position = from + up * (query.mesh().agent().feet + settings.skin)};
    for (double time = 0; time < longest_settling; time += tick) {
        state = step(world, settings, {.up = up}, tick, state).state;
        if (state.footing == Footing::ground && navigation::length(state.velocity) < 1e-3) break;
    }
    return state;
}

}  // namespace

WalkReport walk_path(const World& world, const CharacterSettings& settings, const NavigationQuery& query,
                     const dvec3& from, const dvec3& to, const WalkOptions& options) {
    WalkReport report;
    const dvec3& up = query.mesh().up();
    const dvec3 feet = up * query.mesh().agent().feet;
    report.end = from;
    if (!(options.tick > 0) || !(options.follow.speed > 0)) return report;
    CharacterState state = at_rest(world, settings, query, from, options.tick);
    NavigationFollower follower(options.follow);
    follower.go(query, to);
    double most = options.most_seconds > 0 ? options.most_seconds : at_least;
    Halt worst = Halt::none;
    while (follower.status() == NavigationFollowStatus::following && report.seconds < most) {
        const CharacterInput input = follower.input(query, state, settings, options.tick);
        if (report.planned == 0 && follower.plans() > 0) {
            report.planned = follower.line().length();
            if (!(options.most_seconds > 0)) most = at_least + patience * report.planned / options.follow.speed;
        }
        const StepResult result = step(world, settings, input, options.tick, state);
        const Halt halt = halt_of(result.events);
        if (navigation::length(input.wish) > 0 && halt >= worst) {
            report.stuck = WalkMoment{.before = state, .input = input};
            worst = halt;
        }
        report.walked += navigation::length(navigation::level(result.state.position - state.position, up));
        report.seconds += options.tick;
        state = result.state;
    }
    report.arrived = follower.status() == NavigationFollowStatus::arrived;
    report.reason = follower.reason();
    report.out_of_time = follower.status() == NavigationFollowStatus::following;
    report.plans = follower.plans();
    report.links = follower.links();
    report.end = state.position - feet;
    report.failed_links.assign(follower.failed_links().begin(), follower.failed_links().end());
    report.last_polygon = follower.place().polygon;
    const std::vector<NavigationPolygon>& way = follower.path().polygons;
    const auto here = std::find(way.begin(), way.end(), report.last_polygon);
    if (here != way.end() && here + 1 != way.end()) report.next_polygon = here[1];
    if (report.arrived) report.stuck.reset();
    return report;
}

WalkReport walk_path(const World& world, const CharacterSettings& settings, const NavigationMesh& mesh,
                     const dvec3& from, const dvec3& to, const WalkOptions& options) {
    return walk_path(world, settings, NavigationQuery(mesh), from, to, options);
}

}  // namespace v0
}  // namespace surefoot
