// The parts that every sound is made of.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <set>

#include "platformer/sound/envelope.hpp"
#include "platformer/sound/filter.hpp"
#include "platformer/sound/instruments.hpp"
#include "platformer/sound/measure.hpp"
#include "platformer/sound/oscillator.hpp"
#include "platformer/sound/random.hpp"
#include "platformer/sound/reverb.hpp"

namespace surefoot::sound {
namespace {

TEST(SoundMaths, our_sine_and_powers_are_those_of_the_library) {
    for (double x = -3; x < 3; x += 0.0137) {
        EXPECT_NEAR(sine(x), std::sin(2 * std::numbers::pi * x), 1e-7) << x;
        EXPECT_NEAR(power_of_two(5 * x) / std::exp2(5 * x), 1, 1e-9) << x;
    }
    EXPECT_NEAR(hertz(69), 440, 1e-6);
    EXPECT_NEAR(decibels(-20), 0.1, 1e-9);
}

TEST(Oscillator, plays_the_frequency_that_it_is_told) {
    for (const Wave wave : {Wave::sine, Wave::triangle, Wave::saw, Wave::square}) {
        Oscillator oscillator(wave);
        const Samples tone = generate(0.5, [&](double) { return oscillator.next(660); });
        EXPECT_NEAR(strongest_frequency(tone), 660, 5);
        EXPECT_LE(peak(tone), 1.001);
    }
}

TEST(Oscillator, a_high_saw_has_little_of_what_would_be_mirrored_at_half_the_rate) {
    // The thirteenth overtone of 3,300 Hz lies at 42,900 Hz, and comes back at 1,200 Hz, where a saw has nothing.
    const double tone = 3300, mirror = rate - 13 * tone;
    Oscillator smooth(Wave::saw);
    double phase = 0;
    const Samples rounded = generate(0.5, [&](double) { return smooth.next(tone); });
    const Samples naive = generate(0.5, [&](double) {
        phase += tone / rate;
        if (phase >= 1) phase -= 1;
        return 2 * phase - 1;
    });
    EXPECT_GT(amount_of(naive, mirror), 0.03);
    EXPECT_LT(amount_of(rounded, mirror), 0.1 * amount_of(naive, mirror));
}

TEST(Filter, passes_what_it_should_and_holds_back_the_rest) {
    const auto through = [](double frequency, auto pick) {
        Filter filter(1000, 0.7);
        Oscillator tone(Wave::sine);
        const Samples out = generate(0.5, [&](double) { return pick(filter.next(tone.next(frequency))); });
        return amount_of(out, frequency);
    };
    const auto low = [](const Filter::Passed& p) { return p.low; };
    const auto band = [](const Filter::Passed& p) { return p.band; };
    const auto high = [](const Filter::Passed& p) { return p.high; };
    EXPECT_NEAR(through(100, low), 1, 0.02);
    EXPECT_LT(through(8000, low), 0.03);
    EXPECT_NEAR(through(1000, band), 1, 0.02);
    EXPECT_NEAR(through(8000, high), 1, 0.03);
    EXPECT_LT(through(100, high), 0.03);
}

TEST(Envelope, begins_and_ends_in_silence) {
    const Adsr form{.attack = 0.01, .decay = 0.05, .sustain = 0.6, .release = 0.1};
    Envelope envelope(form, 0.3);
    const Samples shape = generate(Envelope::length(form, 0.3), [&](double) { return envelope.next(); });
    EXPECT_EQ(shape.front(), 0);
    EXPECT_NEAR(shape.back(), 0, 1e-6);
    EXPECT_NEAR(shape[samples_in(0.29)], 0.61, 0.02);
    EXPECT_LT(steepest(shape), 0.01);
}

TEST(Reverb, fades_by_60_dB_in_the_time_it_is_told) {
    Reverb room(1.0);
    Samples tail = generate(1.2, [&](double t) { return room.next(t == 0 ? 1 : 0).left; });
    const std::span<const float> all(tail);
    const double early = rms(all.subspan(samples_in(0.05), samples_in(0.1)));
    const double late = rms(all.subspan(samples_in(0.95), samples_in(0.1)));
    EXPECT_LT(late, early * decibels(-48));
    EXPECT_GT(late, 0);
}

TEST(Instrument, every_one_that_has_a_pitch_plays_in_tune) {
    for (int i = 0; i < instrument_count; ++i) {
        const auto instrument = static_cast<Instrument>(i);
        if (is_drum(instrument)) continue;
        for (const double pitch : {45.0, 60.0, 76.0}) {
            const Samples note = play(instrument, {.pitch = pitch, .seconds = 0.6, .velocity = 0.8, .seed = 3});
            const double wanted = hertz(pitch);
            const double found = strongest_frequency(note, wanted * 0.8, wanted * 1.25);
            EXPECT_NEAR(12 * std::log2(found / wanted), 0, 0.2) << name_of(instrument) << " " << pitch;
        }
    }
}

TEST(Instrument, none_clips_and_none_clicks_at_its_ends) {
    for (int i = 0; i < instrument_count; ++i) {
        const auto instrument = static_cast<Instrument>(i);
        const Samples note = play(instrument, {.pitch = 64, .seconds = 0.4, .velocity = 1, .seed = 5});
        EXPECT_GT(peak(note), 0.05) << name_of(instrument);
        EXPECT_LE(peak(note), 1.1) << name_of(instrument);
        EXPECT_LT(std::abs(note.front()), 0.06) << name_of(instrument);
        EXPECT_LT(std::abs(note.back()), 0.003) << name_of(instrument);
    }
}

TEST(Instrument, is_known_by_its_name) {
    for (int i = 0; i < instrument_count; ++i) {
        const auto instrument = static_cast<Instrument>(i);
        EXPECT_EQ(instrument_named(name_of(instrument)), instrument);
    }
    EXPECT_FALSE(instrument_named("kazoo"));
}

TEST(Random, neighbouring_seeds_are_not_the_same_sequence_a_little_later) {
    std::set<std::uint64_t> seen;
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        Random random(seed);
        for (int i = 0; i < 50; ++i) EXPECT_TRUE(seen.insert(random.bits()).second) << seed;
    }
}

TEST(Random, is_the_same_everywhere_and_fills_its_range) {
    Random random(1), again(1);
    EXPECT_EQ(random.bits(), again.bits());
    double low = 1, high = -1, sum = 0;
    for (int i = 0; i < 10000; ++i) {
        const double value = random.noise();
        low = std::min(low, value);
        high = std::max(high, value);
        sum += value;
    }
    EXPECT_LT(low, -0.99);
    EXPECT_GT(high, 0.99);
    EXPECT_NEAR(sum / 10000, 0, 0.03);
}

}  // namespace
}  // namespace surefoot::sound
