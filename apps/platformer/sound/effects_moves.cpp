// What the hero does with the whole body: jumps, dashes, climbs, bounces, and lands on somebody.
#include "platformer/sound/effects_parts.hpp"
#include "platformer/sound/envelope.hpp"
#include "platformer/sound/filter.hpp"
#include "platformer/sound/oscillator.hpp"

namespace surefoot::sound {

namespace {

/// A voice without a mouth: a triangle that slides up, with a little air.
Samples hop(Random& random, double from, double to, double seconds) {
    const double pitch = random.between(0.96, 1.05);
    Oscillator tone(Wave::triangle), octave(Wave::sine);
    Filter air(2400, 0.8);
    Envelope envelope({.attack = 0.012, .decay = seconds / 3, .sustain = 0.2, .release = seconds * 0.45},
                      seconds * 0.55);
    return generate(seconds, [&](double t) {
        const double share = t / seconds, frequency = pitch * mix(from, to, 1 - (1 - share) * (1 - share));
        const double level = envelope.next();
        return level *
               (0.6 * tone.next(frequency) + 0.15 * octave.next(2 * frequency) + 0.22 * air.next(random.noise()).band);
    });
}

/// Air that is torn: noise whose band rises and falls.
Samples whoosh(Random& random, double low, double high, double seconds) {
    Filter band(low, 1.4);
    Samples made = generate(seconds, [&](double t) {
        const double share = t / seconds, arch = 4 * share * (1 - share);
        band.sweep(mix(low, high, arch * arch), 1.4);
        return arch * (1 - 0.5 * share) * band.next(random.noise()).band;
    });
    return made;
}

Samples dash(Random& random) {
    Samples made = whoosh(random, 350, 3200 * random.between(0.9, 1.1), 0.34);
    add(made, hop(random, 700, 180, 0.16), 0, 0.35);
    return made;
}

Samples grab(Random& random) {
    Samples made = puff(random, 1300 * random.between(0.9, 1.1), 0.7, 0.012, 0.12);
    add(made, thump(210, 120, 0.018, 0.12), 0, 0.8);
    const double at = random.between(0.03, 0.045);
    add(made, puff(random, 2400, 0.9, 0.008, 0.08), at, 0.5);
    return made;
}

Samples climb(Random& random) {
    Samples made = whoosh(random, 700, 1500 * random.between(0.85, 1.15), 0.16);
    add(made, puff(random, 1000, 0.8, 0.012, 0.1), 0.11, 0.9);
    add(made, thump(170, 100, 0.015, 0.1), 0.11, 0.45);
    return made;
}

/// A spring: the pitch leaps up and then shivers.
Samples bounce(Random& random) {
    const double pitch = random.between(0.95, 1.06);
    Decay shiver(0.11), fade(0.13);
    double phase = 0, bend = 0;
    return generate(0.6, [&](double t) {
        const double rise = t < 0.09 ? t / 0.09 : 1;
        const double frequency = pitch * mix(150, 430, rise) * (1 + 0.16 * shiver.next() * sine(17 * t));
        phase += frequency / rate;
        bend += 2.01 * frequency / rate;
        return fade.next() * (0.8 * sine(phase + 0.12 * sine(bend)) + 0.1 * sine(3 * phase));
    });
}

Samples stomp(Random& random) {
    const double pitch = random.between(0.93, 1.08);
    Samples made = thump(420 * pitch, 70 * pitch, 0.05, 0.3);
    add(made, puff(random, 900 * pitch, 0.6, 0.03, 0.2), 0, 0.8);
    // The squeak of whom it happened to.
    Oscillator squeak(Wave::square, 0, 0.3);
    Filter soft(2500, 0.8);
    Envelope envelope({.attack = 0.01, .decay = 0.05, .sustain = 0.3, .release = 0.09}, 0.08);
    add(made,
        generate(0.17,
                 [&](double t) {
                     const double frequency = pitch * (900 - 3600 * t + 6000 * t * t);
                     return envelope.next() * soft.next(squeak.next(frequency)).low;
                 }),
        0.03, 0.35);
    return made;
}

}  // namespace

Samples make_of_moves(Effect effect, Random& random) {
    switch (effect) {
        case Effect::jump:
            return hop(random, 240, 520, 0.2);
        case Effect::double_jump: {
            Samples made = hop(random, 360, 840, 0.22);
            add(made, hop(random, 720, 1260, 0.16), 0.05, 0.4);
            return made;
        }
        case Effect::wall_jump: {
            Samples made = hop(random, 280, 640, 0.2);
            add(made, puff(random, 1200, 0.7, 0.012, 0.1), 0, 1.1);
            add(made, thump(180, 90, 0.02, 0.12), 0, 0.9);
            return made;
        }
        case Effect::dash:
            return dash(random);
        case Effect::grab:
            return grab(random);
        case Effect::climb:
            return climb(random);
        case Effect::bounce:
            return bounce(random);
        default:
            return stomp(random);
    }
}

}  // namespace surefoot::sound
