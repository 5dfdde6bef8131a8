/// Steps of one length whatever the frame rate: the accumulator that every game rewrites.
#pragma once

namespace surefoot {
inline namespace v0 {

/// Tell it how much time a frame took and take the steps that are due; draw in between with `blend`.
///
///     FixedStep clock{.step = 1.0 / 60};
///     clock.add(seconds_of_this_frame);
///     while (clock.due()) { before = after; after = step(world, hero, input, clock.step, after).state; }
///     draw(before, after, clock.blend());
struct FixedStep {
    double step = 1.0 / 60;  ///< [s, > 0]
    /// The most time that one frame may ask for [s]. A frame that took longer (a debugger, a loading screen) lets the
    /// game fall behind instead of making the next frame longer still.
    double most = 0.25;
    double waiting = 0;  ///< time that has passed and was not stepped yet [s]

    /// A frame took so long [s]; what is negative or NaN counts as none.
    constexpr void add(double seconds) noexcept {
        if (!(seconds > 0)) return;
        waiting += seconds < most ? seconds : most;
        if (waiting > most + step) waiting = most + step;
    }

    /// Takes one step of the time that waits, if there is enough for one.
    [[nodiscard]] constexpr bool due() noexcept {
        if (!(step > 0) || waiting < step) return false;
        waiting -= step;
        return true;
    }

    /// How far the time is between the last step and the next [0, 1].
    [[nodiscard]] constexpr double blend() const noexcept { return step > 0 ? waiting / step : 0; }
};

}  // namespace v0
}  // namespace surefoot
