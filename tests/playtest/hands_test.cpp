#include <gtest/gtest.h>

#include "made_levels.hpp"
#include "playtest/bots/explorer.hpp"

namespace surefoot::playtest {
namespace {

// The most presses of all buttons together within any one second.
int most_in_a_second(const std::vector<game::HeroInput>& inputs) {
    std::vector<int> presses;
    std::uint8_t before = 0;
    for (const game::HeroInput& input : inputs) {
        const auto fresh = std::uint8_t(input.buttons & ~before);
        before = input.buttons;
        presses.push_back((fresh & 1) + (fresh >> 1 & 1) + (fresh >> 2 & 1));
    }
    int most = 0;
    for (std::size_t i = 0; i < presses.size(); ++i) {
        int sum = 0;
        for (std::size_t k = i; k < std::min(presses.size(), i + 60); ++k) sum += presses[k];
        most = std::max(most, sum);
    }
    return most;
}

TEST(Hands, press_no_more_than_ten_times_a_second_whatever_is_wanted) {
    Hands hands(1);
    Dice dice(2);
    std::vector<game::HeroInput> inputs;
    for (int i = 0; i < 6000; ++i)
        inputs.push_back(hands.act({.jump = dice.chance(0.5), .crouch = dice.chance(0.5), .dash = dice.chance(0.5)}));
    EXPECT_LE(most_in_a_second(inputs), 10);
    EXPECT_GE(most_in_a_second(inputs), 8) << "and come near to it";
}

TEST(Hands, of_bots_that_play_press_no_more_than_ten_times_a_second) {
    const auto level = test::LevelMaker().finish();
    Explorer bot(3);
    const auto run = play(level, bot, {.most_seconds = 300});
    ASSERT_TRUE(run);
    EXPECT_LE(most_in_a_second(run->recording.inputs), 10);
}

TEST(Hands, are_up_to_two_ticks_late_and_hold_what_they_press) {
    for (std::uint64_t seed = 1; seed < 30; ++seed) {
        Hands hands(seed);
        int late = 0;
        while (!holds(hands.act({.jump = late == 0}), game::Button::jump)) ASSERT_LE(++late, 2);
        int held = 1;
        while (holds(hands.act({}), game::Button::jump)) ++held;
        EXPECT_GE(held, 3);
    }
}

TEST(Reaction, takes_about_150_ms) {
    Dice dice(5);
    for (int i = 0; i < 50; ++i) {
        Reaction reaction;
        int ticks = 1;
        while (!reaction.after(true, dice)) ++ticks;
        EXPECT_GE(ticks, 7);
        EXPECT_LE(ticks, 14);
        EXPECT_FALSE(reaction.after(false, dice));
    }
}

}  // namespace
}  // namespace surefoot::playtest
