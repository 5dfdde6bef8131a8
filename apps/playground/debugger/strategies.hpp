/// One motion, three ways of asking whether it hits: look only where it ends, look at samples on the way, or solve for
/// the time. And when the second begins to tunnel.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <surefoot/math.hpp>
#include <surefoot/shapes.hpp>

#include "debugger/arena.hpp"

namespace surefoot::debugger {

/// What a strategy reports.
struct Finding {
    bool hit = false;
    dvec3 position{0, 0, 0};  ///< where it says that the shape touches; END if it says nothing [m]
    std::uint64_t looks = 0;  ///< how many places it looked at; 1 for the analytic question
    /// How far behind the true first touch that is, along the motion [m]; nothing where there is nothing to be late
    /// for.
    std::optional<double> late{};
    bool missed = false;  ///< there is a touch, and it does not know: it has tunnelled
    std::string text{};   ///< a sentence
};

/// One test, at END.
[[nodiscard]] Finding look_at_end(const Arena& arena, const Volume& volume, const Motion& motion,
                                  bool one_sided = false);

/// A test after each `step` [m, > 0], as a game does that moves and then looks; the last one at END, which may be
/// nearer. No more than `most_looks`: beyond that it says so, and reports no hit.
[[nodiscard]] Finding look_at_samples(const Arena& arena, const Volume& volume, const Motion& motion, double step,
                                      bool one_sided = false);
inline constexpr std::uint64_t most_looks = 100000;

/// The sweep.
[[nodiscard]] Finding solve(const Arena& arena, const Volume& volume, const Motion& motion, bool one_sided = false);

/// How far something moves in a frame [m]. Requires: both above 0.
[[nodiscard]] inline double step_of(double metres_per_second, double frames_per_second) {
    return metres_per_second / frames_per_second;
}

/// A stretch of the motion on which the shape touches something, as distances from START [m].
struct TouchingPart {
    double begin = 0;
    double end = 0;
};

/// All of them, in order, those that meet taken together. Each begins where the sweep stops and ends where a sweep
/// from END to START does.
[[nodiscard]] std::vector<TouchingPart> touching_parts(const Arena& arena, const Volume& volume, const Motion& motion,
                                                       bool one_sided = false);

/// When samples tunnel through everything that the motion meets.
struct Tunnelling {
    /// Every smaller step, and this one, finds something; just above it all is missed. Nothing if no step misses.
    std::optional<double> begins_above;
    /// Every larger step misses, save that END is always looked at.
    std::optional<double> always_above;
    std::string text;  ///< "Tunnelling begins at 0.83 m, below 14 frames a second at 12 m/s."
};

[[nodiscard]] Tunnelling tunnelling(const std::vector<TouchingPart>& parts, double length, double metres_per_second);

}  // namespace surefoot::debugger
