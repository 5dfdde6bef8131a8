/// A filter that gives low, band and high pass at once and may be swept at every sample.
#pragma once

#include <algorithm>

#include "platformer/sound/maths.hpp"

namespace surefoot::sound {

/// A state variable filter with trapezoidal integrators, 12 dB an octave (Zavalishin, The Art of VA Filter Design;
/// Simper's form of it). Stable at any sweep.
class Filter {
public:
    struct Passed {
        double low, band, high;  ///< `band` has a peak of 1, whatever the resonance
    };

    /// `frequency` in Hz, kept within 10 and 0.45 `rate`; `q`: 0.5 is dull, 0.7 flat, 10 rings.
    Filter(double frequency, double q) { tune(frequency, q); }

    void tune(double frequency, double q) {
        const double turns = std::clamp(frequency, 10.0, 0.45 * rate) / rate / 2;
        const double g = sine(turns) / sine(turns + 0.25);
        damping_ = 1 / q;
        a1_ = 1 / (1 + g * (g + damping_));
        a2_ = g * a1_;
        a3_ = g * a2_;
    }

    /// `tune`, for sweeps: at every sixteenth call, which nobody hears and which saves most of the work.
    void sweep(double frequency, double q) {
        if (calls_++ % 16 == 0) tune(frequency, q);
    }

    [[nodiscard]] Passed next(double in) {
        const double v3 = in - second_;
        const double band = a1_ * first_ + a2_ * v3;
        const double low = second_ + a2_ * first_ + a3_ * v3;
        first_ = 2 * band - first_;
        second_ = 2 * low - second_;
        return {low, damping_ * band, in - damping_ * band - low};
    }

private:
    double damping_ = 1, a1_ = 0, a2_ = 0, a3_ = 0;
    double first_ = 0, second_ = 0;
    unsigned calls_ = 0;
};

}  // namespace surefoot::sound
