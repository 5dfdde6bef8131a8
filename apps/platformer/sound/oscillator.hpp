/// Waves that repeat. Saws and squares are rounded off at their jumps, so that they do not whistle.
#pragma once

#include "platformer/sound/maths.hpp"

namespace surefoot::sound {

enum class Wave { sine, triangle, saw, square };

/// One oscillator. Its jumps are smoothed over two samples by a polynomial (Välimäki and Huovilainen's PolyBLEP), which
/// takes away most of what would be mirrored at half the sample rate.
class Oscillator {
public:
    /// `width` is the share of a square that is high. (0, 1)
    explicit Oscillator(Wave wave, double phase = 0, double width = 0.5) : wave_(wave), phase_(phase), width_(width) {}

    /// The next sample, -1 to 1, at this frequency. [Hz, 0 to a quarter of `rate`]
    [[nodiscard]] double next(double frequency) {
        const double step = frequency / rate;
        const double value = sample(step);
        phase_ += step;
        if (phase_ >= 1) phase_ -= 1;
        return value;
    }

private:
    [[nodiscard]] double sample(double step) const {
        switch (wave_) {
            case Wave::sine:
                return sine(phase_);
            case Wave::triangle:  // bends instead of jumping: its overtones fall so fast that nothing need be done
                return phase_ < 0.25 ? 4 * phase_ : phase_ < 0.75 ? 2 - 4 * phase_ : 4 * phase_ - 4;
            case Wave::saw:
                return 2 * phase_ - 1 - jump(phase_, step);
            case Wave::square:
                break;
        }
        const double fall = phase_ < width_ ? phase_ + 1 - width_ : phase_ - width_;
        return (phase_ < width_ ? 1 : -1) + jump(phase_, step) - jump(fall, step);
    }

    /// What a jump upward by 2 at phase 0 is to be corrected by near it.
    [[nodiscard]] static double jump(double phase, double step) {
        if (phase < step) {
            const double x = phase / step;
            return x + x - x * x - 1;
        }
        if (phase > 1 - step) {
            const double x = (phase - 1) / step;
            return x * x + x + x + 1;
        }
        return 0;
    }

    Wave wave_;
    double phase_;
    double width_;
};

}  // namespace surefoot::sound
