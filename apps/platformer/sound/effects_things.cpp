// What lies in the level: coins, stars, keys, doors, hearts, and floors that give way.
#include <array>

#include "platformer/sound/effects_parts.hpp"
#include "platformer/sound/envelope.hpp"
#include "platformer/sound/filter.hpp"
#include "platformer/sound/reverb.hpp"

namespace surefoot::sound {

namespace {

/// One note of a little tune.
struct Tone {
    double at;
    Strike strike;
    Instrument instrument = Instrument::bell;
};

template <std::size_t count>
Samples tune(const std::array<Tone, count>& tones) {
    Samples made;
    for (const Tone& tone : tones) add(made, play(tone.instrument, tone.strike), tone.at);
    return made;
}

/// Two bells, a fourth apart, the second left to ring.
Samples coin(Random& random) {
    const double pitch = 88 + 0.06 * random.noise();
    const Samples dry = tune(std::array{Tone{0, {pitch, 0.05, 0.6}}, Tone{0.065, {pitch + 5, 0.35, 0.9}}});
    return in_room(dry, 0.5, 0.12);
}

/// A chord broken upwards and a shimmer over it: rare, and worth it.
Samples star() {
    Samples dry;
    double at = 0;
    for (const double pitch : {72.0, 76.0, 79.0, 83.0, 86.0, 91.0}) {
        add(dry, play(Instrument::bell, {pitch, 0.7, 0.8}), at);
        add(dry, play(Instrument::vibraphone, {pitch - 12, 0.6, 0.5}), at);
        at += 0.075;
    }
    for (int i = 0; i < 10; ++i) {
        const double pitch = std::array{91.0, 95.0, 98.0, 103.0}[static_cast<std::size_t>(i % 4)];
        add(dry, play(Instrument::bell, {pitch, 0.2, 0.3 - 0.025 * i}), at + 0.06 * i);
    }
    return in_room(dry, 1.2, 0.25);
}

/// Three bits of metal on a ring.
Samples key(Random& random) {
    Samples dry;
    double at = 0;
    for (const double pitch : {99.0, 104.0, 101.0, 106.0}) {
        const double bent = pitch + random.between(-0.3, 0.3), gain = random.between(0.6, 1);
        add(dry, play(Instrument::bell, {bent, 0.12, 0.8}), at, gain);
        add(dry, puff(random, 7000, 2, 0.006, 0.05), at, 0.25);
        at += random.between(0.05, 0.08);
    }
    add(dry, play(Instrument::bell, {87, 0.4, 0.7}), at);
    return in_room(dry, 0.5, 0.12);
}

/// Stone on stone, and a thud where it stops.
Samples door(Random& random) {
    Filter low(220, 1.2), grit(1400, 0.8), rough(24, 1);
    Samples dry = generate(1.1, [&](double t) {
        const double level = (t < 0.12 ? t / 0.12 : 1) * (t > 1 ? (1.1 - t) * 10 : 1);
        const double grind = 0.6 + 6 * rough.next(random.noise()).low;
        const double noise = random.noise();
        return level * grind * (low.next(noise).band + 0.25 * grit.next(noise).band);
    });
    add(dry, thump(130, 48, 0.07, 0.45), 1.05, 1.6);
    add(dry, puff(random, 600, 0.6, 0.04, 0.3), 1.05, 0.7);
    return in_room(dry, 0.8, 0.15);
}

Samples checkpoint() {
    using enum Instrument;
    const Samples dry = tune(std::array{Tone{0, {67, 0.3, 0.7}, vibraphone}, Tone{0, {74, 0.3, 0.6}, vibraphone},
                                        Tone{0.13, {72, 0.9, 0.8}, vibraphone}, Tone{0.13, {76, 0.9, 0.7}, vibraphone},
                                        Tone{0.13, {79, 0.9, 0.7}, vibraphone}, Tone{0.13, {91, 0.4, 0.4}, bell},
                                        Tone{0.21, {86, 0.4, 0.35}, bell}});
    return in_room(dry, 1, 0.2);
}

/// Warm, and up.
Samples heart() {
    using enum Instrument;
    const Samples dry = tune(std::array{Tone{0, {65, 0.14, 0.8}, flute}, Tone{0, {69, 0.14, 0.6}, flute},
                                        Tone{0.13, {72, 0.4, 0.9}, flute}, Tone{0.13, {77, 0.4, 0.6}, flute},
                                        Tone{0.13, {84, 0.4, 0.4}, bell}});
    return in_room(dry, 0.7, 0.18);
}

/// Stones that part, more of them as time goes on, over a rumble.
Samples crumble(Random& random) {
    Filter low(140, 0.9);
    Samples dry = generate(0.9, [&](double t) {
        const double level = t < 0.15 ? t / 0.15 : (0.9 - t) / 0.75;
        return 1.6 * level * low.next(random.noise()).low;
    });
    for (int i = 0; i < 34; ++i) {
        const double at = 0.75 * random.between(0, 1), size = random.between(0.2, 1);
        add(dry, puff(random, mix(3800, 700, size), 1.6, 0.004 + 0.014 * size, 0.12), at,
            (0.4 + 0.6 * size) * (1 - 0.5 * at));
        if (size > 0.75) add(dry, thump(200, 90, 0.014, 0.1), at, 0.7);
    }
    return dry;
}

}  // namespace

Samples make_of_things(Effect effect, Random& random) {
    switch (effect) {
        case Effect::coin:
            return coin(random);
        case Effect::star:
            return star();
        case Effect::key:
            return key(random);
        case Effect::door:
            return door(random);
        case Effect::checkpoint:
            return checkpoint();
        case Effect::heart:
            return heart();
        default:
            return crumble(random);
    }
}

}  // namespace surefoot::sound
