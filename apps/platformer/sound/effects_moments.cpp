// What happens to the hero, what enemies do, and what the menus say.
#include "platformer/sound/effects_parts.hpp"
#include "platformer/sound/envelope.hpp"
#include "platformer/sound/filter.hpp"
#include "platformer/sound/oscillator.hpp"
#include "platformer/sound/reverb.hpp"

namespace surefoot::sound {

namespace {

Samples hurt(Random& random) {
    const double pitch = random.between(0.95, 1.05);
    Oscillator saw(Wave::saw), square(Wave::square);
    Filter soft(2200, 0.8);
    Envelope envelope({.attack = 0.004, .decay = 0.07, .sustain = 0.3, .release = 0.12}, 0.14);
    Samples made = generate(0.26, [&](double t) {
        const double frequency = pitch * mix(190, 470, power_of_two(-t / 0.05)) * (1 + 0.05 * sine(31 * t));
        return envelope.next() * soft.next(0.6 * saw.next(frequency) + 0.4 * square.next(0.5 * frequency)).low;
    });
    add(made, puff(random, 700, 0.6, 0.025, 0.2), 0, 0.8);
    add(made, thump(200, 70, 0.03, 0.2), 0, 0.8);
    return made;
}

/// Four notes down, the last of them sinking, and the ground.
Samples death(Random& random) {
    Samples dry;
    double at = 0;
    for (const double pitch : {74.0, 70.0, 67.0}) {
        add(dry, play(Instrument::reed, {pitch, 0.13, 0.8}), at);
        add(dry, play(Instrument::marimba, {pitch - 12, 0.2, 0.8}), at);
        at += 0.15;
    }
    Oscillator tone(Wave::triangle), under(Wave::square, 0, 0.4);
    Filter soft(1500, 0.8);
    Envelope envelope({.attack = 0.01, .decay = 0.3, .sustain = 0.4, .release = 0.35}, 0.4);
    add(dry,
        generate(0.75,
                 [&](double t) {
                     const double frequency = hertz(62 - 10 * t * t) * (1 + 0.012 * sine(6 * t));
                     return envelope.next() * soft.next(0.5 * tone.next(frequency) + 0.25 * under.next(frequency)).low;
                 }),
        at);
    add(dry, thump(120, 45, 0.09, 0.5), at + 0.05, 0.8);
    add(dry, puff(random, 350, 0.6, 0.06, 0.3), at + 0.05, 0.3);
    return in_room(dry, 0.8, 0.2);
}

/// "Ah?" and "ha!"
Samples enemy_notice(Random& random) {
    const double pitch = random.between(-0.5, 0.5);
    Samples made;
    add(made, play(Instrument::reed, {69 + pitch, 0.07, 0.7}));
    add(made, play(Instrument::reed, {76 + pitch, 0.16, 1}), 0.11);
    add(made, play(Instrument::reed, {81 + pitch, 0.16, 0.6}), 0.11);
    return made;
}

Samples shot(Random& random) {
    const double pitch = random.between(0.92, 1.08);
    Oscillator saw(Wave::saw);
    Filter soft(4000, 1.5);
    Decay fade(0.05);
    Samples made = generate(0.26, [&](double t) {
        const double fall = power_of_two(-t / 0.035);
        soft.sweep(600 + 4500 * fall, 1.5);
        return fade.next() * soft.next(saw.next(pitch * mix(170, 1300, fall))).low;
    });
    add(made, puff(random, 2500, 0.7, 0.015, 0.12), 0, 0.6);
    return made;
}

/// A rising call, the chord that it was after, and bells over it.
Samples win() {
    Samples dry;
    const auto call = [&](double at, double pitch, double seconds, double velocity) {
        add(dry, play(Instrument::brass, {pitch, seconds, velocity}), at, 0.7);
    };
    call(0.00, 67, 0.10, 0.8);
    call(0.14, 67, 0.10, 0.8);
    call(0.28, 67, 0.10, 0.8);
    call(0.42, 72, 0.28, 0.9);
    for (const double pitch : {63.0, 68.0, 72.0}) call(0.42, pitch - 12, 0.28, 0.6);
    for (const double pitch : {65.0, 70.0, 74.0}) call(0.77, pitch - 12, 0.26, 0.6);
    call(0.77, 74, 0.26, 0.9);
    for (const double pitch : {60.0, 64.0, 67.0, 72.0}) call(1.12, pitch, 1.1, 0.75);
    call(1.12, 76, 1.1, 1);
    add(dry, play(Instrument::bass, {36, 1.0, 1}), 1.12);
    double at = 1.12;
    for (const double pitch : {84.0, 88.0, 91.0, 96.0, 100.0, 103.0}) {
        add(dry, play(Instrument::bell, {pitch, 0.3, 0.5}), at);
        at += 0.07;
    }
    return in_room(dry, 1.4, 0.2);
}

/// Three chords down, in minor, none of them in a hurry.
Samples lose() {
    Samples dry;
    const auto chord = [&](double at, std::initializer_list<double> pitches, double seconds) {
        for (const double pitch : pitches) add(dry, play(Instrument::piano, {pitch, seconds, 0.7}), at);
    };
    chord(0.0, {53, 60, 68}, 0.4);
    chord(0.42, {51, 58, 67}, 0.4);
    chord(0.84, {48, 55, 63, 65}, 1.3);
    add(dry, play(Instrument::flute, {72, 0.38, 0.7}), 0.0);
    add(dry, play(Instrument::flute, {70, 0.38, 0.7}), 0.42);
    add(dry, play(Instrument::flute, {67, 1.2, 0.7}), 0.84);
    return in_room(dry, 1.4, 0.25);
}

Samples pair(Instrument instrument, double first, double second, double apart) {
    Samples made = play(instrument, {first, 0.08, 0.7});
    add(made, play(instrument, {second, 0.2, 0.8}), apart);
    return made;
}

}  // namespace

Samples make_of_moments(Effect effect, Random& random) {
    switch (effect) {
        case Effect::hurt:
            return hurt(random);
        case Effect::death:
            return death(random);
        case Effect::enemy_notice:
            return enemy_notice(random);
        case Effect::shot:
            return shot(random);
        case Effect::win:
            return win();
        case Effect::lose:
            return lose();
        case Effect::menu_move:
            return play(Instrument::marimba, {79 + 0.3 * random.noise(), 0.1, 0.7});
        case Effect::menu_choose:
            return pair(Instrument::marimba, 76, 83, 0.07);
        default:
            return pair(Instrument::vibraphone, 76, 69, 0.11);
    }
}

}  // namespace surefoot::sound
