/// What is read off the outings of a scene. Each is a function from outings to the largest number found, so that "at
/// most" is all that a bar has to say.
#pragma once

#include <functional>
#include <optional>

#include "course/scene.hpp"

namespace surefoot::course {

using Measure = std::function<Worst(std::span<const Outing>)>;

/// Of each run on its own; the largest counts.
[[nodiscard]] Measure each(std::function<double(const Outing&)> of_one);

/// How far the height leaves that at the script's beginning, up or down [m].
[[nodiscard]] double height_change(const Outing& outing);

/// The worst tick's level speed against the one asked for, as a share of it; the first tick of the script is not
/// counted. Ticks without a wish are not either.
[[nodiscard]] double speed_error(const Outing& outing);

/// How far it is off the straight way that was asked for, sideways, as a share of that way. For constant wishes.
[[nodiscard]] double drift(const Outing& outing);

/// The share of the script's ticks that end in the air.
[[nodiscard]] double airborne(const Outing& outing);

/// The longest move of a tick in the last `seconds` [m].
[[nodiscard]] double unrest(const Outing& outing, double seconds);

/// The longest move of a tick from the second on after it was stopped, that is, after the first tick that covered less
/// than a twentieth of what was asked for; infinite if it was never stopped [m].
[[nodiscard]] double motion_once_stopped(const Outing& outing);

/// How deep the body is in any triangle after any tick [m]. Asked of the core's exact overlap.
[[nodiscard]] double depth(const Outing& outing);

/// How far it rises in any one tick of the script [m].
[[nodiscard]] double rise_in_a_tick(const Outing& outing);

/// The highest point of the script above its beginning [m].
[[nodiscard]] double climbed(const Outing& outing);

/// How much a closed level's winding number about the centre differs from that of its free space, after any tick: 0
/// where it belongs, 1 inside of a wall or outside.
[[nodiscard]] double outside(const Outing& outing);

/// How far the ways of runs that differ in their rate alone are apart where both end a tick, beyond `allowed` by the
/// slower of the two rates; the run with the highest rate is what the others are compared with [m].
[[nodiscard]] Measure divergence(std::function<double(const Run&)> allowed);

/// How far it is along a direction at the end, from where it began [m].
[[nodiscard]] double gone(const Outing& outing, const dvec3& direction);

/// What is missing to at least so much: a bar of "at least" turned into one of "at most".
[[nodiscard]] constexpr double short_of(double least, double measured) {
    return measured >= least ? 0 : least - measured;
}

// Bars that many scenes share, with their reasons.
[[nodiscard]] Bar level_bar(double noise = 0);
[[nodiscard]] Bar speed_bar(double most = 1e-3);
[[nodiscard]] Bar drift_bar();
[[nodiscard]] Bar ground_bar();
[[nodiscard]] Bar depth_bar(double scale = 1);
[[nodiscard]] Bar rest_bar(double seconds = 1);
[[nodiscard]] Bar stop_bar();
[[nodiscard]] Bar inside_bar();

}  // namespace surefoot::course
