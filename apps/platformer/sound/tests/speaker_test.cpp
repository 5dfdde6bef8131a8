// The thread between the game and OpenAL.
#include "platformer/sound/speaker.hpp"

#include <algorithm>
#include <chrono>
#include <gtest/gtest.h>

namespace surefoot::sound {
namespace {

void use_everything(Speaker& speaker) {
    speaker.set_volumes({.master = 0.5});
    speaker.listen({.place = {1, 2, 3}});
    for (int i = 0; i < effect_count; ++i) speaker.play(static_cast<Effect>(i), {.place = dvec3(i, 0, 0)});
    speaker.music(Piece::calm);
    speaker.pause(true);
    speaker.music(Piece::lively, 0.2);
    speaker.pause(false);
    speaker.music({});
}

TEST(Speaker, without_a_device_everything_is_silent_and_nothing_fails) {
    Speaker speaker(Output::nothing);
    use_everything(speaker);
    EXPECT_EQ(speaker.wait_until_open(), Speaker::State::silent);
    use_everything(speaker);
}

TEST(Speaker, says_once_that_there_is_no_device) {
    Speaker speaker(Output::nothing);
    (void)speaker.wait_until_open();
    EXPECT_NE(speaker.take_notice().find("No sound"), std::string::npos);
    EXPECT_EQ(speaker.take_notice(), "");
}

TEST(Speaker, plays_on_a_device) {
    Speaker speaker;
    use_everything(speaker);
    ASSERT_EQ(speaker.wait_until_open(), Speaker::State::playing) << speaker.take_notice();
    use_everything(speaker);
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    EXPECT_EQ(speaker.state(), Speaker::State::playing);
    EXPECT_EQ(speaker.take_notice(), "");
}

TEST(Speaker, ends_at_any_moment) {
    for (int i = 0; i < 4; ++i) {
        Speaker speaker;
        speaker.music(Piece::lively);
        speaker.play(Effect::star);
    }
}

TEST(Speaker, a_frame_waits_for_nothing) {
    // While the thread opens the device and makes the sounds, which takes tenths of a second, a thousand frames ask.
    // The middle one of them is measured: a busy machine may put any single one to sleep.
    Speaker speaker;
    speaker.music(Piece::calm);
    std::vector<double> taken;
    for (int frame = 0; frame < 1000; ++frame) {
        const auto begin = std::chrono::steady_clock::now();
        speaker.listen({.place = dvec3(frame, 0, 0)});
        speaker.play(Effect::step_stone, {.place = dvec3(frame, 0, 1)});
        taken.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    }
    std::nth_element(taken.begin(), taken.begin() + 500, taken.end());
    EXPECT_LT(taken[500], 0.0005);
}

}  // namespace
}  // namespace surefoot::sound
