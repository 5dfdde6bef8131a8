#include <algorithm>
#include <cmath>
#include <limits>

#include <surefoot/navigation_follow.hpp>

#include "follow_line.hpp"
#include "follow_sight.hpp"

namespace surefoot {
inline namespace v0 {
namespace {

using navigation::dot;
using navigation::length;
using navigation::level;
using Status = NavigationFollowStatus;
using Reason = NavigationFollowReason;

constexpr double between_checks = 0.25;  ///< looks for shut doors so often [s]
constexpr double hand_over = 0.5;        ///< so far from a link's beginning the driver takes over [m]
constexpr double counts = 0.25;          ///< the least progress that counts [m]
constexpr double counts_anew = 1;        ///< so much nearer to the goal than ever, attempts are counted anew [m]
constexpr double gentle = 0.25;          ///< of the deceleration, before a link
constexpr double hold_before = 1.5;      ///< so far before a link that is taken it waits [m]
constexpr double slowest = 0.5;          ///< before a link [m/s]
constexpr double back = 0.5;             ///< it may be pushed back along the line so far without a new plan [m]
constexpr double at_place_back = 0.1;    ///< on the way back to the mesh [m]
constexpr double patience_led = 20;      ///< times `patience` for that way

}  // namespace

std::string_view sentence(NavigationFollowReason reason) noexcept {
    switch (reason) {
        case Reason::none:
            return "it did not give up";
        case Reason::off_mesh:
            return "the navigation mesh has no ground near the character";
        case Reason::goal_off_mesh:
            return "the navigation mesh has no ground near the goal";
        case Reason::no_path:
            return "no path leads from the character to the goal";
        case Reason::stuck:
            return "the character ran on and got no nearer to the goal, however often it planned";
        case Reason::local_minimum:
            return "the potential has a minimum here that is not the goal";
        case Reason::link_failed:
            return "a link was tried again and again and did not lead to its end";
    }
    return "unknown";
}

void NavigationFollower::give_up(NavigationFollowReason reason) noexcept {
    status_ = Status::gave_up;
    reason_ = reason;
}

void NavigationFollower::stop() noexcept {
    status_ = Status::idle;
    reason_ = Reason::none;
    drives_ = false;
    place_ = {};
}

void NavigationFollower::arrive() noexcept {
    if (status_ == Status::following) status_ = Status::arrived;
    drives_ = false;
}

bool NavigationFollower::locate(const NavigationQuery& query, const CharacterState& state, const dvec3& feet) {
    const NavigationAgent& agent = query.mesh().agent();
    const dvec3& up = query.mesh().up();
    const std::optional<NavigationPoint> moved = navigation::moved_along(query.state(), place_, feet);
    if (moved) {
        const dvec3 off = feet - moved->position;
        const bool is_near = length(level(off, up)) <= agent.radius / 2;
        const bool is_level = std::abs(dot(off, up)) <= agent.climb + agent.radius;
        if (is_near && (is_level || state.footing == Footing::air)) {
            place_ = *moved;
            return true;
        }
    }
    const std::optional<NavigationPoint> found = query.nearest(feet, options_.beside_mesh, agent.height);
    if (!found) return false;
    // It may have been pushed a little over the border; only what is clearly nearer is another place.
    const bool same = moved && length(feet - moved->position) <= length(feet - found->position) + agent.radius / 4;
    place_ = same ? *moved : *found;
    if (!same) wants_plan_ = true;
    return true;
}

void NavigationFollower::move_along(const NavigationQuery& query) {
    const double stop = navigation::next_stop(line_, begin_);
    const navigation::NearestOnLine nearest =
        navigation::nearest_on(line_, place_.position, query.mesh().up(), std::max(begin_, along_ - back),
                               std::min(stop, along_ + options_.look_ahead + 1));
    along_ = nearest.along;
    if (nearest.distance > options_.off_path) wants_plan_ = true;
}

CharacterInput NavigationFollower::find_back(const NavigationQuery& query, const CharacterState& state,
                                             const dvec3& feet, double dt) {
    const dvec3& up = query.mesh().up();
    CharacterInput input{.up = up};
    // Ground that was taken out, or was shut while somebody stood there, leads back to what is left, mostly.
    for (const dvec3& place : query.way_back(feet)) {
        const dvec3 way = level(place - feet, up);
        if (length(way) < at_place_back) continue;
        aim_ = place;
        input.wish = way * (options_.speed / 2 / length(way));
        break;
    }
    const bool is_led = length(input.wish) > 0;
    lost_ += is_led ? dt / patience_led : state.footing == Footing::air ? dt / 4 : dt;
    if (lost_ > options_.patience) give_up(Reason::off_mesh);
    return input;
}

void NavigationFollower::try_again(NavigationFollowReason reason) noexcept {
    ++tried_;
    wants_plan_ = true;
    without_ = 0;
    if (tried_ > options_.attempts) give_up(reason);
}

void NavigationFollower::watch(const CharacterState& state, double dt) {
    if (along_ > best_along_ + std::min(counts, counts * options_.speed * options_.patience)) {
        best_along_ = along_;
        without_ = 0;
    } else {
        // Falling is no running on, but nobody falls for ever.
        without_ += state.footing == Footing::air ? dt / 4 : dt;
    }
    if (left() < least_left_ - counts_anew) {
        least_left_ = left();
        tried_ = 0;
    }
    if (without_ > options_.patience) try_again(Reason::stuck);
}

double NavigationFollower::aim_along(const NavigationQuery& query) const {
    const double stop = navigation::next_stop(line_, begin_);
    const double farthest = std::min(stop, along_ + options_.look_ahead);
    const auto is_seen = [&](double along) {
        return navigation::sees(query.state(), place_, navigation::place_on(line_, along));
    };
    if (is_seen(farthest)) return farthest;
    double near = farthest;
    for (const NavigationLine::Point& point : line_.points)
        if (point.along > along_) {
            near = std::min(near, point.along);
            break;
        }
    double far = farthest;
    for (int i = 0; i < 4; ++i) {
        const double middle = (near + far) / 2;
        if (is_seen(middle))
            near = middle;
        else
            far = middle;
    }
    // At a corner the line itself is the way on: it lies on the mesh.
    return std::min(std::max(near, along_ + query.mesh().agent().radius / 2), stop);
}

CharacterInput NavigationFollower::walk(const NavigationQuery& query, const CharacterState& state,
                                        const CharacterSettings& settings, double dt) {
    const NavigationAgent& agent = query.mesh().agent();
    const dvec3& up = query.mesh().up();
    const double stop = navigation::next_stop(line_, begin_);
    const double aim = aim_along(query);
    aim_ = navigation::place_on(line_, aim);
    const dvec3 feet = state.position - up * agent.feet;
    const dvec3 way = level(aim_ - feet, up);
    const double distance = length(way);
    // Ice gives feet less to brake by, and air less still. A fifth is kept for what is not foreseen.
    const double grip = state.footing == Footing::air ? settings.air_acceleration / std::max(settings.braking, 1e-9)
                                                      : settings.surfaces[state.ground_surface].grip;
    const double deceleration = std::max(0.8 * grip * std::min(settings.braking, settings.acceleration), 0.1);
    // Beside the line's end, or pushed past it, there is still a way to go.
    const double ahead = aim >= stop ? std::max(stop - along_, distance) : stop - along_;
    double speed =
        navigation::speed_here(line_, up, along_, along_ + ahead, deceleration, agent.radius / 2, options_.speed);
    // Links begin at edges, where ground is rough and an early drop would carry it past: it comes up to them gently.
    if (stop < line_.length()) speed = std::min(speed, std::sqrt(2 * gentle * deceleration * ahead) + slowest);
    if (holds_) speed = std::min(speed, std::sqrt(2 * gentle * deceleration * std::max(ahead - hold_before, 0.0)));
    // From one tick to the next it goes no farther than to where it stops.
    if (aim >= stop) speed = std::min(speed, distance / dt);
    CharacterInput input{.up = up};
    if (!(distance > 1e-9)) return input;
    // Pushed over the mesh's border it comes back on the way.
    const dvec3 heading = way / distance + level(place_.position - feet, up) / agent.radius;
    const double size = length(heading);
    if (size > 1e-9) input.wish = heading * (speed / size);
    return input;
}

std::optional<std::uint32_t> NavigationFollower::next_link(double within) const noexcept {
    if (status_ != Status::following) return std::nullopt;
    if (drives_) return link_id_;
    for (const NavigationLine::Point& point : line_.points)
        if (point.link && point.along >= begin_ - 1e-6)
            return point.along - along_ <= within ? point.link : std::nullopt;
    return std::nullopt;
}

bool NavigationFollower::begin_link(const NavigationQuery& query) {
    const double stop = navigation::next_stop(line_, begin_);
    if (holds_ || stop - along_ > hand_over) return false;
    const auto point = std::find_if(line_.points.begin(), line_.points.end(),
                                    [&](const NavigationLine::Point& p) { return p.link && p.along >= stop - 1e-6; });
    if (point == line_.points.end() || point->along > stop + 1e-6) return false;
    const std::span<const NavigationLink> links = query.mesh().links();
    if (*point->link >= links.size()) {
        wants_plan_ = true;
        return false;
    }
    const NavigationLink& link = links[*point->link];
    link_ = {.from = link.from,
             .to = link.to,
             .takeoff = link.takeoff,
             .kind = link.kind,
             .speed = link.speed,
             .air_jumps = link.air_jumps,
             .seconds = link.seconds,
             .tick = link.tick,
             .inputs = {}};
    drive_ = {.up = query.mesh().up(), .feet = query.mesh().agent().feet};
    link_id_ = *point->link;
    drive_.careful = std::find(careful_.begin(), careful_.end(), *point->link) != careful_.end();
    drives_ = true;
    begin_ = (point + 1)->along;
    return true;
}

void NavigationFollower::fail_link() {
    const auto holds = [&](const std::vector<std::uint32_t>& links) {
        return std::find(links.begin(), links.end(), link_id_) != links.end();
    };
    if (!drive_.careful) careful_.push_back(link_id_);
    if (!drive_.careful || holds(failed_)) return try_again(Reason::link_failed);
    failed_.push_back(link_id_);
    for (const NavigationCorner& corner : path_.corners)
        if (corner.link == link_id_) avoided_.push_back(corner.polygon);
    // The way without it may be longer, and has attempts of its own.
    least_left_ = std::numeric_limits<double>::infinity();
    tried_ = 0;
    wants_plan_ = true;
    without_ = 0;
}

CharacterInput NavigationFollower::drive_link(const NavigationQuery& query, const CharacterState& state,
                                              const CharacterSettings& settings, double dt) {
    aim_ = link_.to;
    const CharacterInput input = drive(link_, drive_, state, settings, dt);
    const bool failed = drive_.status == NavigationDriveStatus::failed;
    if (!failed && drive_.status != NavigationDriveStatus::arrived) return input;
    drives_ = false;
    place_ = {};
    along_ = best_along_ = begin_;
    without_ = 0;
    if (failed) {
        fail_link();
        return {.up = query.mesh().up()};
    }
    ++links_;
    // The plan holds beyond the link; `locate` asks for another one if this is not where the link ends.
    const double vertical = query.mesh().agent().climb + query.mesh().agent().radius;
    if (const auto found = query.nearest(link_.to, query.mesh().agent().radius, vertical)) place_ = *found;
    return this->input(query, state, settings, dt);
}

CharacterInput NavigationFollower::input(const NavigationQuery& query, const CharacterState& state,
                                         const CharacterSettings& settings, double dt) {
    const NavigationAgent& agent = query.mesh().agent();
    const dvec3& up = query.mesh().up();
    const CharacterInput still{.up = up};
    if (status_ != Status::following || !(dt > 0) || !refresh(query)) return still;
    if (drives_) return drive_link(query, state, settings, dt);

    const dvec3 feet = state.position - up * agent.feet;
    if (!locate(query, state, feet)) return find_back(query, state, feet, dt);
    lost_ = 0;
    since_check_ += dt;
    if (since_check_ > between_checks) {
        since_check_ = 0;
        const bool is_open = std::all_of(path_.polygons.begin(), path_.polygons.end(),
                                         [&](NavigationPolygon polygon) { return query.state().knows(polygon); });
        if (!is_open) {
            wants_plan_ = true;
            least_left_ = std::numeric_limits<double>::infinity();  // the way round may be longer
        }
    }
    if (wants_plan_ && !plan(query)) return still;
    move_along(query);

    const dvec3 off = goal_.position - feet;
    if (length(level(off, up)) <= options_.arrival && std::abs(dot(off, up)) <= agent.climb + agent.radius &&
        state.footing != Footing::air) {
        status_ = Status::arrived;
        return still;
    }
    if (path_.partial && left() <= options_.arrival) {
        give_up(Reason::no_path);
        return still;
    }
    if (begin_link(query)) return drive_link(query, state, settings, dt);
    watch(state, holds_ ? dt / 8 : dt);  // a queue takes its time
    if (status_ != Status::following) return still;
    return walk(query, state, settings, dt);
}

}  // namespace v0
}  // namespace surefoot
