// Who is heard when there are more sounds than sources.
#include "platformer/sound/voices.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace surefoot::sound {
namespace {

const dvec3 here{0, 0, 0};

std::vector<double> gains(const Voices& voices) {
    std::vector<double> found;
    for (const Voice& voice : voices.playing()) found.push_back(voice.gain);
    std::sort(found.begin(), found.end());
    return found;
}

TEST(Voices, more_voices_than_sources_steal_the_quietest) {
    Voices voices(4);
    for (const double gain : {0.8, 0.3, 0.9, 0.5}) ASSERT_TRUE(voices.admit({Effect::coin, gain, {}}, here));
    ASSERT_TRUE(voices.admit({Effect::star, 0.6, {}}, here));
    EXPECT_EQ(gains(voices), (std::vector{0.5, 0.6, 0.8, 0.9}));
}

TEST(Voices, one_that_is_quieter_than_all_is_not_heard) {
    Voices voices(4);
    for (int i = 0; i < 4; ++i) ASSERT_TRUE(voices.admit({Effect::coin, 0.8, {}}, here));
    EXPECT_FALSE(voices.admit({Effect::coin, 0.1, {}}, here));
    EXPECT_EQ(voices.playing().size(), 4U);
}

TEST(Voices, far_away_is_quiet) {
    Voices voices(2);
    ASSERT_TRUE(voices.admit({Effect::shot, 1, dvec3(0, 0, 50)}, here));
    ASSERT_TRUE(voices.admit({Effect::shot, 0.5, dvec3(0, 0, 2)}, here));
    ASSERT_TRUE(voices.admit({Effect::coin, 0.3, {}}, here));
    EXPECT_EQ(gains(voices), (std::vector{0.3, 0.5}));
    EXPECT_EQ(heard({Effect::shot, 1, dvec3(3, 0, 0)}, here), 1);
    EXPECT_DOUBLE_EQ(heard({Effect::shot, 1, dvec3(8, 0, 0)}, here), 0.5);
}

TEST(Voices, a_newcomer_as_loud_as_the_rest_takes_the_place_of_one) {
    Voices voices(2);
    const auto first = voices.admit({Effect::coin, 1, {}}, here);
    (void)voices.admit({Effect::coin, 1, {}}, here);
    ASSERT_TRUE(voices.admit({Effect::coin, 1, {}}, here));
    EXPECT_FALSE(voices.playing().contains(*first));
}

TEST(Voices, slots_stay_below_the_number_of_sources) {
    Voices voices(8);
    for (int i = 0; i < 100; ++i) {
        const auto voice = voices.admit({Effect::coin, 1, {}}, here);
        ASSERT_TRUE(voice);
        EXPECT_LT(voice->index, voices.capacity());
        if (i % 3 == 0) voices.end(*voice);
        voices.end(*voice);  // twice is no harm
    }
}

}  // namespace
}  // namespace surefoot::sound
