#include "platformer/sound/drums.hpp"

#include <array>

#include "platformer/sound/envelope.hpp"
#include "platformer/sound/filter.hpp"
#include "platformer/sound/oscillator.hpp"
#include "platformer/sound/random.hpp"

namespace surefoot::sound {

namespace {

Samples kick() {
    Decay fall(0.012), level(0.07), click(0.002);
    double phase = 0;
    Samples made = generate(0.45, [&](double) {
        phase += (48 + 130 * fall.next()) / rate;
        return 0.85 * level.next() * sine(phase) + 0.12 * click.next();
    });
    fade_ends(made, 0.001, 0.05);
    return made;
}

Samples snare(Random& random) {
    Decay rattle(0.04), skin(0.025);
    Filter filter(3200, 0.6);
    double phase = 0;
    Samples made = generate(0.3, [&](double) {
        phase += 190.0 / rate;
        const Filter::Passed noise = filter.next(random.noise());
        return 0.5 * rattle.next() * (noise.band + 0.4 * noise.high) + 0.4 * skin.next() * sine(phase);
    });
    fade_ends(made, 0.0008, 0.05);
    return made;
}

/// A wire brush that sweeps: it swells before it strikes.
Samples brush(Random& random) {
    Filter filter(2600, 0.6);
    Decay fade(0.06);
    Samples made = generate(0.36, [&](double t) {
        const double swell = t < 0.05 ? t / 0.05 : fade.next();
        return 0.5 * swell * filter.next(random.noise()).band;
    });
    fade_ends(made, 0.002, 0.06);
    return made;
}

/// Six squares that do not fit together, as in the first drum machines, and noise; only what is high of it.
Samples cymbal(Random& random, double seconds, double half_life, double above, double metal) {
    constexpr std::array<double, 6> frequencies{2053, 3071, 3689, 4423, 5417, 6143};
    std::array<Oscillator, 6> squares{Oscillator(Wave::square), Oscillator(Wave::square), Oscillator(Wave::square),
                                      Oscillator(Wave::square), Oscillator(Wave::square), Oscillator(Wave::square)};
    Filter filter(above, 0.8), again(above, 0.8);
    Decay fade(half_life);
    Samples made = generate(seconds, [&](double) {
        double sum = (1 - metal) * random.noise();
        for (std::size_t i = 0; i < squares.size(); ++i) sum += metal / 3 * squares[i].next(frequencies[i]);
        return 0.5 * fade.next() * again.next(filter.next(sum).high).high;
    });
    fade_ends(made, 0.0005, 0.02);
    return made;
}

Samples shaker(Random& random) {
    Filter filter(6500, 1.2);
    Samples made = generate(0.09, [&](double t) {
        const double swell = t < 0.035 ? t / 0.035 : (0.09 - t) / 0.055;
        return 0.6 * swell * swell * filter.next(random.noise()).band;
    });
    fade_ends(made, 0.001, 0.005);
    return made;
}

/// Three pairs of hands, not quite together.
Samples clap(Random& random) {
    Filter filter(1500, 1.1);
    Samples made = generate(0.25, [&](double t) {
        const double since = t < 0.011 ? t : t < 0.023 ? t - 0.011 : t - 0.023;
        const double level = power_of_two(-since / (t < 0.023 ? 0.004 : 0.03));
        return 0.9 * level * filter.next(random.noise()).band;
    });
    fade_ends(made, 0.001, 0.04);
    return made;
}

}  // namespace

Samples drum(Instrument instrument, const Strike& strike) {
    Random random(strike.seed);
    switch (instrument) {
        case Instrument::snare:
            return snare(random);
        case Instrument::brush:
            return brush(random);
        case Instrument::hat:
            return cymbal(random, 0.12, 0.014, 7000, 0.6);
        case Instrument::open_hat:
            return cymbal(random, 0.5, 0.09, 6500, 0.6);
        case Instrument::ride:
            return cymbal(random, 0.7, 0.13, 5200, 0.8);
        case Instrument::shaker:
            return shaker(random);
        case Instrument::clap:
            return clap(random);
        default:
            return kick();
    }
}

}  // namespace surefoot::sound
