// The effects, by what can be measured of them.
#include "platformer/sound/effects.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <numeric>

#include "platformer/sound/measure.hpp"
#include "platformer/sound/wav.hpp"

namespace surefoot::sound {
namespace {

template <typename Look>
void for_every_effect(Look&& look) {
    for (int i = 0; i < effect_count; ++i) {
        const auto effect = static_cast<Effect>(i);
        SCOPED_TRACE(std::string(name_of(effect)));
        look(effect, make(effect));
    }
}

std::span<const float> part_of(const Samples& samples, double from, double seconds) {
    return std::span(samples).subspan(samples_in(from), samples_in(seconds));
}

TEST(Effects, none_clips_and_none_is_silent) {
    for_every_effect([](Effect, const Samples& samples) {
        EXPECT_LE(peak(samples), 0.9001);
        EXPECT_GT(loudest(samples, 0.05), decibels(-35));
        for (const float sample : samples) ASSERT_TRUE(std::isfinite(sample));
    });
}

TEST(Effects, none_clicks_at_its_ends) {
    for_every_effect([](Effect, const Samples& samples) {
        EXPECT_EQ(samples.front(), 0);
        EXPECT_EQ(samples.back(), 0);
        EXPECT_LT(steepest(std::span(samples).first(8)), 0.05);
        EXPECT_LT(steepest(std::span(samples).last(64)), 0.01);
    });
}

TEST(Effects, none_pushes_the_membrane_to_one_side) {
    for_every_effect([](Effect, const Samples& samples) {
        const double mean = std::accumulate(samples.begin(), samples.end(), 0.0) / double(samples.size());
        EXPECT_LT(std::abs(mean), 0.01 * peak(samples) + 1e-4);
    });
}

TEST(Effects, are_short_where_they_come_often) {
    for_every_effect([](Effect effect, const Samples& samples) {
        const double seconds = double(samples.size()) / rate;
        const double most = effect <= Effect::step_ice ? 0.4 : effect == Effect::jump ? 0.3 : 3.5;
        EXPECT_LT(seconds, most);
    });
}

TEST(Effects, a_coin_rises_in_pitch) {
    const Samples coin = make(Effect::coin);
    const double first = strongest_frequency(part_of(coin, 0.005, 0.055), 600, 4000);
    const double second = strongest_frequency(part_of(coin, 0.12, 0.2), 600, 4000);
    EXPECT_NEAR(12 * std::log2(second / first), 5, 0.5) << first << " Hz, then " << second << " Hz";
}

TEST(Effects, jumps_go_up_and_deaths_go_down) {
    const Samples jump = make(Effect::jump), death = make(Effect::death);
    EXPECT_GT(strongest_frequency(part_of(jump, 0.1, 0.06), 150, 1500),
              1.3 * strongest_frequency(part_of(jump, 0.005, 0.05), 150, 1500));
    EXPECT_LT(strongest_frequency(part_of(death, 0.7, 0.2), 150, 1500),
              0.7 * strongest_frequency(part_of(death, 0.01, 0.12), 350, 1500));
}

TEST(Effects, a_hard_landing_is_louder_and_deeper_than_a_soft_one) {
    const Samples soft = make(Effect::land_soft), hard = make(Effect::land_hard);
    EXPECT_GT(loudest(hard, 0.05), 1.8 * loudest(soft, 0.05));
    EXPECT_LT(brightness(hard), brightness(soft));
}

TEST(Effects, what_is_underfoot_is_heard) {
    const auto bright = [](Ground ground) { return brightness(make(step_on(ground))); };
    EXPECT_LT(bright(Ground::wood), bright(Ground::stone));
    EXPECT_LT(bright(Ground::stone), bright(Ground::metal));
    EXPECT_LT(bright(Ground::metal), bright(Ground::grass));
    EXPECT_LT(bright(Ground::grass), bright(Ground::ice));
}

TEST(Effects, two_steps_are_not_alike_but_as_loud) {
    const Samples one = make(Effect::step_stone, 0), other = make(Effect::step_stone, 1);
    EXPECT_NE(one, other);
    EXPECT_NEAR(loudest(one, 0.05) / loudest(other, 0.05), 1, 0.2);
}

TEST(Effects, the_same_number_is_the_same_sound) {
    for_every_effect([](Effect effect, const Samples& samples) { EXPECT_EQ(samples, make(effect)); });
}

TEST(Effects, a_slide_can_be_played_again_over_its_own_end) {
    Samples long_slide;
    for (int i = 0; i < 4; ++i) add(long_slide, make(Effect::slide, i), 0.3 * i);
    double quietest = 1;
    for (double t = 0.3; t < 0.9; t += 0.02) quietest = std::min(quietest, rms(part_of(long_slide, t, 0.1)));
    EXPECT_GT(quietest, 0.25 * loudest(long_slide, 0.1));
}

TEST(Effects, are_known_by_their_names) {
    for_every_effect([](Effect effect, const Samples&) { EXPECT_EQ(effect_named(name_of(effect)), effect); });
    EXPECT_FALSE(effect_named("applause"));
    EXPECT_EQ(step_on(Ground::ice), Effect::step_ice);
}

/// Fowler, Noll and Vo's hash of the samples as 16 bits.
std::uint64_t hash_of_all_effects() {
    std::uint64_t hash = 0xCBF29CE484222325U;
    for (int i = 0; i < effect_count; ++i) {
        for (const float sample : make(static_cast<Effect>(i))) {
            hash = (hash ^ static_cast<std::uint16_t>(to_16_bits(sample))) * 0x100000001B3U;
        }
    }
    return hash;
}

TEST(Effects, are_the_same_samples_in_every_build) {
    // Whoever changes a sound on purpose writes the new number here.
    EXPECT_EQ(hash_of_all_effects(), 18098892155856321205U);
}

TEST(Wav, keeps_what_was_made) {
    const std::string path = testing::TempDir() + "surefoot-one.wav";
    const Samples samples{0, 0.5F, -0.5F, 1};
    ASSERT_TRUE(write_wav(path, samples, 1));
    std::FILE* const file = std::fopen(path.c_str(), "rb");
    ASSERT_NE(file, nullptr);
    unsigned char bytes[64];
    const std::size_t size = std::fread(bytes, 1, sizeof bytes, file);
    std::fclose(file);
    std::remove(path.c_str());
    ASSERT_EQ(size, 44U + 8U);
    EXPECT_EQ(std::string(bytes, bytes + 4), "RIFF");
    EXPECT_EQ(bytes[40], 8);
    EXPECT_EQ(bytes[46] | bytes[47] << 8, 16384);
    EXPECT_EQ(bytes[50] | bytes[51] << 8, 32767);
    EXPECT_FALSE(write_wav("/nowhere/at/all.wav", samples, 1));
}

}  // namespace
}  // namespace surefoot::sound
