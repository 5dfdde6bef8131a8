#include "platformer/sound/instruments.hpp"

#include <array>

#include "platformer/sound/drums.hpp"
#include "platformer/sound/envelope.hpp"
#include "platformer/sound/filter.hpp"
#include "platformer/sound/oscillator.hpp"
#include "platformer/sound/random.hpp"

namespace surefoot::sound {

namespace {

constexpr std::array<std::string_view, instrument_count> names{
    "flute", "reed", "brass", "pad",   "piano", "vibraphone", "marimba", "ukulele", "bell",
    "bass",  "kick", "snare", "brush", "hat",   "open_hat",   "shaker",  "ride",    "clap"};

/// Five and a half times a second, from a quarter of a second on: what a player does to a long note.
double vibrato(double t, double depth) {
    const double share = t < 0.25 ? 0 : t < 0.75 ? (t - 0.25) * 2 : 1;
    return 1 + depth * share * sine(5.5 * t);
}

Samples flute(const Strike& strike) {
    const Adsr form{.attack = 0.05, .decay = 0.2, .sustain = 0.8, .release = 0.12};
    const double base = hertz(strike.pitch);
    Envelope envelope(form, strike.seconds);
    Random random(strike.seed);
    Filter breath(2 * base, 1.5);
    double phase = 0;
    return generate(Envelope::length(form, strike.seconds), [&](double t) {
        const double level = envelope.next();
        phase += base * vibrato(t, 0.006) / rate;
        // Blown harder, it has more of its overtones; the breath is strongest where the note begins.
        const double tone = sine(phase) + level * (0.28 * sine(2 * phase) + 0.12 * sine(3 * phase));
        const double air = breath.next(random.noise()).band * (0.05 + (t < 0.08 ? 0.25 * (1 - t / 0.08) : 0));
        return 0.5 * level * (tone + air);
    });
}

Samples reed(const Strike& strike) {
    const Adsr form{.attack = 0.012, .decay = 0.12, .sustain = 0.7, .release = 0.06};
    const double base = hertz(strike.pitch);
    Envelope envelope(form, strike.seconds);
    Oscillator square(Wave::square, 0, 0.42), octave(Wave::triangle);
    Filter filter(2000, 0.8);
    return generate(Envelope::length(form, strike.seconds), [&](double t) {
        const double level = envelope.next(), frequency = base * vibrato(t, 0.005);
        filter.sweep(base * 2 + 2600 * level * strike.velocity, 0.8);
        return level * (0.38 * filter.next(square.next(frequency)).low + 0.12 * octave.next(2 * frequency));
    });
}

Samples brass(const Strike& strike) {
    const Adsr form{.attack = 0.03, .decay = 0.15, .sustain = 0.75, .release = 0.12};
    const double base = hertz(strike.pitch);
    Envelope envelope(form, strike.seconds);
    Oscillator one(Wave::saw), other(Wave::saw, 0.37);
    Filter filter(1000, 0.9);
    return generate(Envelope::length(form, strike.seconds), [&](double t) {
        const double level = envelope.next();
        // It scoops up to its pitch, and grows bright as it grows loud.
        const double frequency = base * (1 - 0.02 * (t < 0.04 ? 1 - t / 0.04 : 0)) * vibrato(t, 0.004);
        filter.sweep(base + (500 + 3800 * strike.velocity) * level * level, 0.9);
        return 0.38 * level * filter.next(one.next(frequency) + other.next(frequency * 1.003)).low;
    });
}

Samples pad(const Strike& strike) {
    const Adsr form{.attack = 0.35, .decay = 0.6, .sustain = 0.8, .release = 0.9};
    const double base = hertz(strike.pitch);
    Random random(strike.seed);
    Envelope envelope(form, strike.seconds);
    Oscillator low(Wave::saw, random.between(0, 1)), middle(Wave::saw, random.between(0, 1)),
        high(Wave::saw, random.between(0, 1));
    Filter filter(900, 0.7);
    return generate(Envelope::length(form, strike.seconds), [&](double t) {
        const double level = envelope.next();
        filter.sweep(500 + 500 * level + 150 * sine(0.31 * t), 0.7);
        const double saws = low.next(base * 0.9955) + middle.next(base) + high.next(base * 1.0045);
        return 0.25 * level * filter.next(saws).low;
    });
}

/// Two operators: the tone, and for a moment a tine of fourteen times its frequency.
Samples piano(const Strike& strike) {
    const Adsr form{.attack = 0.004, .decay = 1.1, .sustain = 0, .release = 0.18};
    const double base = hertz(strike.pitch);
    Envelope envelope(form, strike.seconds);
    Decay tine(0.08), body(0.5);
    double phase = 0;
    return generate(Envelope::length(form, strike.seconds), [&](double) {
        phase += base / rate;
        const double bend = 0.16 * (0.3 + strike.velocity) * body.next() * sine(phase);
        const double strikes = tine.next() * 0.02 * strike.velocity;
        return 0.5 * envelope.next() * (sine(phase + bend) + 4 * strikes * sine(14 * phase));
    });
}

/// Sines that fade, each at its own pace: what bars, bells and bottles do when struck.
struct Mode {
    double ratio;  ///< of its frequency to the note's
    double share;
    double half_life;
};
template <std::size_t count>
Samples struck(const Strike& strike, double seconds, double attack, const std::array<Mode, count>& modes,
               double swell = 0) {
    const double base = hertz(strike.pitch);
    Samples made(samples_in(seconds));
    for (const Mode& mode : modes) {
        const double step = base * mode.ratio / rate;
        if (step > 0.45) continue;
        // A vector that turns and shrinks: four products a sample instead of a sine.
        const double shrink = half_in(mode.half_life), c = shrink * sine(step + 0.25), s = shrink * sine(step);
        double x = mode.share, y = 0;
        for (float& sample : made) {
            const double turned = x * c - y * s;
            y = x * s + y * c;
            x = turned;
            sample += static_cast<float>(y);
        }
    }
    for (std::size_t i = 0; swell > 0 && i < made.size(); ++i) {
        made[i] *= static_cast<float>(1 + swell * sine(4.6 * double(i) / rate));
    }
    fade_ends(made, attack, 0.12);
    return made;
}

Samples vibraphone(const Strike& strike) {
    return struck(strike, strike.seconds + 0.9, 0.002,
                  std::array{Mode{1, 0.42, 0.55}, Mode{3.98, 0.10 * strike.velocity, 0.12},
                             Mode{10.1, 0.05 * strike.velocity, 0.02}},
                  0.22);
}

Samples marimba(const Strike& strike) {
    return struck(strike, 0.7, 0.001,
                  std::array{Mode{1, 0.6, 0.085}, Mode{3.93, 0.22 * strike.velocity, 0.03},
                             Mode{9.6, 0.12 * strike.velocity, 0.009}});
}

Samples bell(const Strike& strike) {
    return struck(strike, strike.seconds + 0.6, 0.001,
                  std::array{Mode{1, 0.4, 0.16}, Mode{2.002, 0.16, 0.11}, Mode{3.01, 0.09 * strike.velocity, 0.06},
                             Mode{5.43, 0.10 * strike.velocity, 0.025}});
}

/// A string: noise that goes round a delay line and loses its high part each time (Karplus and Strong; tuned by an
/// allpass as Jaffe and Smith do).
Samples string(const Strike& strike, double loss, double release, double pick) {
    const double period = rate / hertz(strike.pitch);
    const auto whole = static_cast<std::size_t>(period - 0.6);
    const double rest = period - 0.5 - double(whole), allpass = (1 - rest) / (1 + rest);
    Random random(strike.seed);
    Filter soft(1200 + pick * strike.velocity, 0.7);
    std::vector<double> line(whole);
    double mean = 0;
    for (double& value : line) mean += value = soft.next(random.noise()).low;
    for (double& value : line) value -= mean / double(whole);
    const double keep = decibels(-loss * period / rate);
    const Adsr form{.attack = 0.001, .decay = 1, .sustain = 1, .release = release};
    Envelope envelope(form, strike.seconds);
    std::size_t at = 0;
    double before = 0, in = 0, out = 0;
    return generate(Envelope::length(form, strike.seconds), [&](double) {
        const double now = line[at];
        const double averaged = keep * 0.5 * (now + before);
        before = now;
        out = allpass * (averaged - out) + in;
        in = averaged;
        line[at] = out;
        at = at + 1 == whole ? 0 : at + 1;
        return envelope.next() * now;
    });
}

Samples ukulele(const Strike& strike) {
    Samples made = string(strike, 26, 0.07, 5000);
    for (float& sample : made) sample *= 0.9F;
    return made;
}

Samples bass(const Strike& strike) {
    const Adsr form{.attack = 0.004, .decay = 0.35, .sustain = 0.35, .release = 0.07};
    const double base = hertz(strike.pitch);
    Envelope envelope(form, strike.seconds);
    Oscillator saw(Wave::saw);
    Filter filter(400, 0.8);
    Decay pluck(0.05);
    double phase = 0;
    return generate(Envelope::length(form, strike.seconds), [&](double) {
        phase += base / rate;
        filter.sweep(1.5 * base + (900 * strike.velocity) * pluck.next(), 0.9);
        return envelope.next() * (0.55 * sine(phase) + 0.28 * filter.next(saw.next(base)).low);
    });
}

}  // namespace

std::string_view name_of(Instrument instrument) {
    return names[static_cast<std::size_t>(instrument)];
}

std::optional<Instrument> instrument_named(std::string_view name) {
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (names[i] == name) return static_cast<Instrument>(i);
    }
    return std::nullopt;
}

Samples play(Instrument instrument, const Strike& strike) {
    Samples made;
    switch (instrument) {
        case Instrument::flute:
            made = flute(strike);
            break;
        case Instrument::reed:
            made = reed(strike);
            break;
        case Instrument::brass:
            made = brass(strike);
            break;
        case Instrument::pad:
            made = pad(strike);
            break;
        case Instrument::piano:
            made = piano(strike);
            break;
        case Instrument::vibraphone:
            made = vibraphone(strike);
            break;
        case Instrument::marimba:
            made = marimba(strike);
            break;
        case Instrument::ukulele:
            made = ukulele(strike);
            break;
        case Instrument::bell:
            made = bell(strike);
            break;
        case Instrument::bass:
            made = bass(strike);
            break;
        default:
            made = drum(instrument, strike);
    }
    for (float& sample : made) sample *= static_cast<float>(strike.velocity);
    return made;
}

}  // namespace surefoot::sound
