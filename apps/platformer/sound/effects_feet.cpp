// What feet do to the ground: steps, landings, slides, and water.
#include <array>
#include <vector>

#include "platformer/sound/effects_parts.hpp"
#include "platformer/sound/envelope.hpp"
#include "platformer/sound/filter.hpp"

namespace surefoot::sound {

namespace {

/// What a foot meets: the scrape of the sole, the thump of the weight, what rings, and what crunches.
struct Footing {
    double scrape;  ///< [Hz]
    double q;
    double scrape_half_life;
    double scrape_gain;
    double thump;  ///< [Hz]
    double thump_half_life;
    double thump_gain;
    std::vector<double> rings;  ///< [Hz]
    double ring_half_life;
    double ring_gain;
    int grains;  ///< small bursts within the first 70 ms: blades, crystals
    double grain_pitch;
    double grain_gain;
};

Footing footing(Ground ground) {
    switch (ground) {
        case Ground::grass:
            return {2600, 0.6, 0.018, 0.45, 75, 0.018, 0.35, {}, 0, 0, 14, 4200, 0.5};
        case Ground::wood:
            return {1100, 0.8, 0.006, 0.4, 110, 0.022, 0.7, {212, 391, 655}, 0.022, 0.35, 0, 0, 0};
        case Ground::metal:
            return {2400, 0.9, 0.005, 0.4, 95, 0.015, 0.45, {523, 1187, 1893, 3270}, 0.045, 0.16, 0, 0, 0};
        case Ground::ice:
            return {5200, 1.2, 0.006, 0.5, 120, 0.010, 0.25, {2890, 4710}, 0.012, 0.12, 9, 6800, 0.45};
        case Ground::water:  // its drops come from `drops`
            return {900, 0.7, 0.03, 0.6, 80, 0.02, 0.3, {}, 0, 0, 0, 0, 0};
        case Ground::stone:
            break;
    }
    return {1700, 0.7, 0.009, 0.7, 90, 0.016, 0.55, {}, 0, 0, 3, 3400, 0.3};
}

/// One touch of heel or toe.
Samples touch(const Footing& ground, Random& random, double weight) {
    const double pitch = random.between(0.9, 1.12);
    Samples made = thump(ground.thump * 1.9 * pitch, ground.thump * pitch, ground.thump_half_life, 0.16);
    for (float& sample : made) sample *= static_cast<float>(ground.thump_gain * weight);
    add(made, puff(random, ground.scrape * pitch, ground.q, ground.scrape_half_life * random.between(0.8, 1.3), 0.16),
        0, ground.scrape_gain);
    for (const double ring : ground.rings) {
        Decay fade(ground.ring_half_life * random.between(0.7, 1.2));
        const double frequency = ring * pitch * random.between(0.98, 1.02), share = random.between(0.5, 1);
        double phase = 0;
        Samples tone = generate(0.3, [&](double) {
            phase += frequency / rate;
            return share * fade.next() * sine(phase);
        });
        fade_ends(tone, 0, 0.1);
        add(made, tone, 0, ground.ring_gain);
    }
    for (int i = 0; i < ground.grains; ++i) {
        const double at = random.between(0, 0.07), gain = ground.grain_gain * random.between(0.3, 1);
        add(made, puff(random, ground.grain_pitch * random.between(0.7, 1.4), 2, 0.004, 0.03), at, gain);
    }
    return made;
}

/// Bubbles: short sines that rise as the bubble shrinks (van den Doel, Physically based models for liquid sounds).
Samples drops(Random& random, int count, double within, double low, double high) {
    Samples made;
    for (int i = 0; i < count; ++i) {
        const double late = random.between(0, 1), at = within * late * late;  // most of them early
        const double start = random.between(low, high), rise = random.between(4, 14);
        Decay fade(random.between(0.006, 0.02));
        double phase = 0;
        Samples drop = generate(0.09, [&](double t) {
            phase += start * (1 + rise * t) / rate;
            return fade.next() * sine(phase);
        });
        fade_ends(drop, 0.001, 0.01);
        add(made, drop, at, random.between(0.2, 1));
    }
    return made;
}

Samples step(Ground ground, Random& random) {
    const Footing footed = footing(ground);
    Samples made = touch(footed, random, 1);
    const double at = random.between(0.035, 0.06), gain = random.between(0.35, 0.55);
    add(made, touch(footed, random, 0.5), at, gain);
    if (ground == Ground::water) add(made, drops(random, 7, 0.14, 500, 1500), 0.01, 0.35);
    return made;
}

Samples landing(bool hard, Random& random) {
    Samples made = step(Ground::stone, random);
    const double pitch = random.between(0.93, 1.07);
    add(made, thump(hard ? 190 * pitch : 150 * pitch, hard ? 52 * pitch : 70 * pitch, hard ? 0.06 : 0.03, 0.4), 0,
        hard ? 1.8 : 0.9);
    add(made, puff(random, hard ? 500 : 900, 0.6, hard ? 0.05 : 0.025, 0.35), 0, hard ? 1.1 : 0.5);
    if (hard) {  // what it shook loose
        for (int i = 0; i < 8; ++i) {
            const double at = random.between(0.06, 0.3);
            add(made, puff(random, random.between(1500, 4500), 3, 0.006, 0.05), at, 0.25 * (1 - at * 2.5));
        }
    }
    return made;
}

Samples slide(Random& random) {
    Filter low(1500, 0.8), rough(38, 1);
    Samples made = generate(0.5, [&](double t) {
        low.sweep(1300 + 500 * sine(2.1 * t + 0.2), 0.8);
        // A slow noise makes the fast one uneven, as ground is.
        const double grip = 0.7 + 4 * rough.next(random.noise()).low;
        return grip * low.next(random.noise()).band;
    });
    fade_ends(made, 0.15, 0.2);
    return made;
}

Samples splash(Random& random) {
    Filter filter(2000, 0.6);
    Decay close(0.09), fade(0.1);
    Samples made = generate(0.9, [&](double t) {
        filter.sweep(500 + 3500 * close.next(), 0.6);
        const double swell = t < 0.02 ? t / 0.02 : 1;
        return swell * fade.next() * filter.next(random.noise()).band;
    });
    add(made, thump(160, 60, 0.05, 0.3), 0, 0.7);
    add(made, drops(random, 26, 0.75, 350, 1600), 0.06, 0.3);
    return made;
}

}  // namespace

Samples make_of_feet(Effect effect, Random& random) {
    switch (effect) {
        case Effect::land_soft:
            return landing(false, random);
        case Effect::land_hard:
            return landing(true, random);
        case Effect::slide:
            return slide(random);
        case Effect::splash:
            return splash(random);
        default:
            return step(static_cast<Ground>(static_cast<int>(effect) - static_cast<int>(Effect::step_stone)), random);
    }
}

}  // namespace surefoot::sound
