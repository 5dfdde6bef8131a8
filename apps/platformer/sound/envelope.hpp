/// How loud a note is from its beginning to its end.
#pragma once

#include <algorithm>

#include "platformer/sound/maths.hpp"

namespace surefoot::sound {

/// All in seconds but `sustain`, a share of the peak.
struct Adsr {
    double attack = 0.005;
    double decay = 0.1;  ///< half of the way from the peak to `sustain`
    double sustain = 0.5;
    double release = 0.1;  ///< from the moment the note is let go until there is nothing
};

/// Attack, decay, sustain, release; the end is zero exactly, so that nothing clicks.
class Envelope {
public:
    Envelope(const Adsr& form, double held) : form_(form), held_(held), decay_(half_in(std::max(form.decay, 1e-4))) {}

    [[nodiscard]] static double length(const Adsr& form, double held) { return held + form.release; }

    [[nodiscard]] double next() {
        const double t = double(sample_++) / rate;
        if (t < held_) {
            if (t < form_.attack) return level_ = t / form_.attack;
            above_ = above_ * decay_;
            return level_ = form_.sustain + (1 - form_.sustain) * above_;
        }
        const double left = 1 - (t - held_) / form_.release;
        return left > 0 ? level_ * left * left * left : 0;
    }

private:
    Adsr form_;
    double held_;
    double decay_;
    double above_ = 1;
    double level_ = 0;
    int sample_ = 0;
};

/// Struck and left alone: 1 at first, a half after so many seconds.
class Decay {
public:
    explicit Decay(double half_life) : factor_(half_in(half_life)) {}
    [[nodiscard]] double next() {
        const double now = value_;
        value_ *= factor_;
        return now;
    }

private:
    double factor_;
    double value_ = 1;
};

}  // namespace surefoot::sound
