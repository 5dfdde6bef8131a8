#include <algorithm>
#include <cmath>

#include <surefoot/navigation_drive.hpp>

#include "frame.hpp"

namespace surefoot {
inline namespace v0 {
namespace {

using navigation::dot;
using navigation::length;
using Status = NavigationDriveStatus;

/// So near to a place is at it [m].
constexpr double at_place = 0.15;
/// Of the place and of the speed of those who begin with care [m and m/s].
constexpr double at_rest = 0.03;
/// Somebody who runs aims at the line so far ahead [m].
constexpr double look_ahead = 0.5;
/// Whoever is so slow when the link begins can be going anywhere [m/s].
constexpr double slow = 1;

constexpr double longest_approach = 4;  ///< [s]
/// Above twice the time that the simulated character took [s].
constexpr double spare = 2;
constexpr double longest_unknown = 15;  ///< of a link whose time is not known [s]
constexpr double longest_stall = 0.5;   ///< [s]

/// The link as seen by whoever is on it.
class Way {
public:
    Way(const NavigationLink& link, const NavigationDrive& drive, const CharacterState& state)
        : up_(drive.up / length(drive.up)), feet_(state.position - up_ * drive.feet), link_(link) {
        dvec3 way = level(link.takeoff - link.from);
        run_ = length(way);
        if (run_ < 1e-9) {
            run_ = 0;
            way = level(link.to - link.from);
        }
        const double size = length(way);
        if (size > 1e-9) forward_ = way / size;
    }

    [[nodiscard]] dvec3 level(const dvec3& v) const { return v - up_ * dot(v, up_); }
    [[nodiscard]] dvec3 to(const dvec3& place) const { return level(place - feet_); }
    /// How far a place is above the feet.
    [[nodiscard]] double above(const dvec3& place) const { return dot(place - feet_, up_); }
    [[nodiscard]] double rising(const CharacterState& state) const { return dot(state.velocity, up_); }
    /// How far along the run the feet are.
    [[nodiscard]] double along() const { return dot(feet_ - link_.from, forward_); }
    [[nodiscard]] double run() const { return run_; }
    [[nodiscard]] const dvec3& forward() const { return forward_; }

    /// Back to the line and along it.
    [[nodiscard]] dvec3 on_line(double speed) const {
        const dvec3 off = level(feet_ - link_.from);
        const dvec3 aim = forward_ * look_ahead - (off - forward_ * dot(off, forward_));
        const double size = length(aim);
        return size > 0 ? aim * (speed / size) : dvec3{0, 0, 0};
    }

private:
    dvec3 up_;
    dvec3 feet_;
    const NavigationLink& link_;
    dvec3 forward_{0, 0, 0};
    double run_ = 0;
};

dvec3 at_speed(const dvec3& way, double speed) {
    const double size = length(way);
    return size > 1e-9 ? way * (speed / size) : dvec3{0, 0, 0};
}

/// Towards a place, so slowly at last that half the braking stops there.
dvec3 to_stop_at(const dvec3& way, double speed, const CharacterSettings& settings, double dt) {
    const double distance = length(way);
    return at_speed(way, std::min({speed, std::sqrt(settings.braking * distance), distance / dt}));
}

/// How many jumps in the air are still to come.
std::uint32_t air_jumps_left(const NavigationLink& link, const NavigationDrive& drive, const CharacterState& state) {
    if (link.kind != NavigationLinkKind::jump || drive.landed || drive.air_jumps >= link.air_jumps) return 0;
    return std::min(link.air_jumps - drive.air_jumps, state.air_jumps_left);
}

/// With the velocity that comes down on the place, as far as the speed allows.
dvec3 to_land_at(const Way& way, const NavigationLink& link, const NavigationDrive& drive, const CharacterState& state,
                 const CharacterSettings& settings, double dt) {
    const dvec3 aside = way.to(link.to);
    double rising = way.rising(state);
    double above = way.above(link.to);
    double time = 0;
    if (!(settings.gravity > 0)) return at_speed(aside, link.speed);
    // Each jump in the air begins at the top of the one before.
    for (std::uint32_t left = air_jumps_left(link, drive, state); left > 0; --left) {
        const double top = std::max(rising, 0.0);
        time += top / settings.gravity;
        above -= top * top / (2 * settings.gravity);
        rising = std::sqrt(2 * settings.gravity * settings.jump_height);
    }
    const double squared = rising * rising - 2 * settings.gravity * above;
    if (!(squared > 0)) return at_speed(aside, link.speed);
    time = std::max(time + (rising + std::sqrt(squared)) / settings.gravity, dt);
    return at_speed(aside, std::min(link.speed, length(aside) / time));
}

bool is_at(const Way& way, const dvec3& place, const CharacterSettings& settings) {
    return length(way.to(place)) <= at_place && std::abs(way.above(place)) <= std::max(settings.step_up, at_place);
}

/// Is the place out of reach for feet that stand, or fall?
bool is_far_above(const Way& way, const dvec3& place, const CharacterState& state, const CharacterSettings& settings) {
    const double hands = settings.ledge_reach > 0 ? settings.hands_height : 0;
    const double above = way.above(place) - std::max(settings.step_up, hands) - at_place;
    if (state.footing == Footing::ground) return above > 2 * length(way.to(place));
    const double rising = std::max(0.0, way.rising(state));
    return state.footing == Footing::air && settings.gravity > 0 && above > rising * rising / (2 * settings.gravity);
}

bool may_begin(const Way& way, const NavigationLink& link, const CharacterState& state, bool careful) {
    if (careful && (length(way.to(link.from)) > at_rest || length(state.velocity) > at_rest)) return false;
    if (state.footing != Footing::ground || length(way.to(link.from)) > at_place) return false;
    const dvec3 velocity = way.level(state.velocity);
    const double speed = length(velocity);
    return speed <= slow || dot(velocity, way.forward()) > 0.8 * speed;
}

/// A jump in the air is a press anew: it was let go at the top, where that costs no height.
bool jumps_again(const Way& way, const NavigationLink& link, const NavigationDrive& drive,
                 const CharacterState& state) {
    return drive.pressed && drive.airborne && state.jump_held == 0 && way.rising(state) <= 0 &&
           air_jumps_left(link, drive, state) > 0;
}

/// Off the edge, then down the face that is behind; held all the way, as `step` wants it.
void climb_down(const Way& way, const NavigationLink& link, const CharacterState& state, CharacterInput& input) {
    if (state.footing == Footing::ground) {
        input.wish = way.forward() * std::min(link.speed, slow);
        return;
    }
    input.wish = way.forward() * -std::min(link.speed, 2 * slow);
    input.crouch = true;
}

void become(NavigationDrive& drive, Status status) {
    drive.status = status;
    drive.seconds = 0;
}

void watch(NavigationDrive& drive, const Way& way, const NavigationLink& link, const CharacterState& state,
           const CharacterSettings& settings) {
    const double longest = link.seconds > 0 ? 2 * link.seconds + spare : longest_unknown;
    if (state.footing == Footing::air) {
        drive.airborne = true;
        drive.landed = false;
    } else if (drive.airborne && state.footing == Footing::ground) {
        drive.landed = true;
    }
    const bool may_rise = link.kind == NavigationLinkKind::ladder || state.hold != Hold::none ||
                          (link.kind == NavigationLinkKind::jump && !drive.pressed) ||
                          air_jumps_left(link, drive, state) > 0;
    const bool is_stranded = (state.footing == Footing::air ? drive.airborne : drive.grounded > 0.25) && !may_rise &&
                             is_far_above(way, link.to, state, settings);
    const bool is_over = way.along() >= way.run() && (!drive.pressed || drive.airborne);
    if (state.footing == Footing::ground && is_over && is_at(way, link.to, settings))
        become(drive, Status::arrived);
    else if (drive.seconds > longest || drive.stalled > longest_stall || is_stranded)
        become(drive, Status::failed);
}

}  // namespace

CharacterInput drive(const NavigationLink& link, NavigationDrive& drive, const CharacterState& state,
                     const CharacterSettings& settings, double dt) noexcept {
    const Way way(link, drive, state);
    CharacterInput input{.up = drive.up};
    if (drive.status == Status::approaching) {
        if (may_begin(way, link, state, drive.careful))
            become(drive, Status::under_way);
        else if (drive.seconds > longest_approach)
            become(drive, Status::failed);
    }
    if (drive.status == Status::under_way) watch(drive, way, link, state, settings);
    drive.seconds += dt;
    drive.grounded = drive.landed ? drive.grounded + dt : 0;
    const bool rests = state.hold == Hold::none && length(state.velocity) < 0.02 * link.speed;
    drive.stalled = drive.status == Status::under_way && rests ? drive.stalled + dt : 0;

    switch (drive.status) {
        case Status::approaching:
            input.wish = to_stop_at(way.to(link.from), link.speed, settings, dt);
            break;
        case Status::under_way: {
            const bool jumps = link.kind == NavigationLinkKind::jump;
            const double next = std::max(0.0, dot(way.level(state.velocity), way.forward())) * dt;
            if (jumps && !drive.pressed && way.along() + next / 2 >= way.run()) drive.pressed = input.jump = true;
            // Held while it rises: a jump that is let go is a low one.
            if (drive.pressed && !drive.landed && (!drive.airborne || way.rising(state) > 0)) input.jump = true;
            if (jumps_again(way, link, drive, state)) {
                ++drive.air_jumps;
                input.jump = true;
            }
            const bool goes_down = link.kind == NavigationLinkKind::ladder && dot(link.to - link.from, drive.up) < 0;
            if (drive.landed)
                input.wish = to_stop_at(way.to(link.to), link.speed, settings, dt);
            else if (goes_down)
                climb_down(way, link, state, input);
            else if (link.kind == NavigationLinkKind::ladder || link.kind == NavigationLinkKind::step_up)
                input.wish = way.along() < way.run() ? way.on_line(link.speed) : at_speed(way.to(link.to), link.speed);
            else if (state.footing == Footing::air)
                input.wish = to_land_at(way, link, drive, state, settings, dt);
            else
                input.wish = way.along() < way.run() + look_ahead ? way.on_line(link.speed)
                                                                  : at_speed(way.to(link.to), link.speed);
            break;
        }
        case Status::arrived:
        case Status::failed:
            break;
    }
    return input;
}

}  // namespace v0
}  // namespace surefoot
