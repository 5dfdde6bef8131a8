// What OpenAL makes of it, mixed into memory.
#include "platformer/sound/mixer.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "platformer/sound/measure.hpp"

namespace surefoot::sound {
namespace {

class MixedInMemory : public testing::Test {
protected:
    void SetUp() override {
        Expected<Mixer> opened = Mixer::open(Output::memory);
        ASSERT_TRUE(opened) << opened.error().text;
        mixer_.emplace(std::move(*opened));
    }

    struct Ears {
        Samples left, right;
    };
    /// The next seconds, looked after as a game does.
    [[nodiscard]] Ears hear(double seconds) {
        Ears ears;
        for (double t = 0; t < seconds - 1e-9; t += 0.02) {
            mixer_->update(0.02);
            std::vector<float> block(2 * samples_in(0.02));
            mixer_->mixed(block);
            for (std::size_t i = 0; i < block.size(); i += 2) {
                ears.left.push_back(block[i]);
                ears.right.push_back(block[i + 1]);
            }
        }
        return ears;
    }

    std::optional<Mixer> mixer_;
};

TEST_F(MixedInMemory, is_silent_until_something_is_played) {
    EXPECT_EQ(peak(hear(0.2).left), 0);
    mixer_->play(Effect::coin, {});
    EXPECT_GT(peak(hear(0.2).left), 0.01);
}

TEST_F(MixedInMemory, a_sound_on_the_right_is_heard_on_the_right) {
    mixer_->play(Effect::stomp, {.place = dvec3(6, 0, 0)});
    const Ears ears = hear(0.3);
    EXPECT_GT(rms(ears.right), 1.5 * rms(ears.left));
}

TEST_F(MixedInMemory, a_sound_follows_the_listener_who_turns) {
    mixer_->listen({.forward = {1, 0, 0}});
    mixer_->play(Effect::stomp, {.place = dvec3(0, 0, -6)});
    const Ears ears = hear(0.3);
    EXPECT_GT(rms(ears.left), 1.5 * rms(ears.right));
}

TEST_F(MixedInMemory, far_from_the_origin_is_as_at_home) {
    const dvec3 far{1e7, 0, -3e6};
    mixer_->listen({.place = far});
    mixer_->play(Effect::stomp, {.place = far + dvec3(0.5, 0, 0)});
    const Ears ears = hear(0.3);
    EXPECT_GT(rms(ears.right), 1.2 * rms(ears.left));
}

TEST_F(MixedInMemory, distance_makes_quiet) {
    mixer_->play(Effect::hurt, {.place = dvec3(0, 0, -2)});
    const double close = rms(hear(0.3).left);
    mixer_->play(Effect::hurt, {.place = dvec3(0, 0, -40)});
    EXPECT_LT(rms(hear(0.3).left), 0.25 * close);
}

TEST_F(MixedInMemory, volumes_reach_what_is_playing) {
    mixer_->play(Effect::win, {});
    (void)hear(0.5);
    mixer_->set_volumes({.master = 1, .effects = 0, .music = 1});
    (void)hear(0.1);
    EXPECT_LT(peak(hear(0.5).left), 1e-3);
    mixer_->set_volumes({.master = 1, .effects = 1, .music = 1});
    EXPECT_GT(peak(hear(0.5).left), 0.01);
}

TEST_F(MixedInMemory, music_begins_within_three_tenths_of_a_second) {
    for (const Piece piece : {Piece::calm, Piece::lively}) {
        mixer_->music(piece, 1.5);
        EXPECT_GT(peak(hear(0.3).left), 0.003) << name_of(piece);
        mixer_->music({}, 0.1);
        (void)hear(0.5);
        EXPECT_LT(peak(hear(0.1).left), 1e-4) << name_of(piece);
    }
}

TEST_F(MixedInMemory, music_goes_on_without_a_gap) {
    mixer_->music(Piece::lively, 0.1);
    const Samples heard = hear(4).left;
    for (double t = 0.3; t < 3.8; t += 0.1) {
        EXPECT_GT(rms(std::span(heard).subspan(samples_in(t), samples_in(0.2))), 1e-3) << t;
    }
}

TEST_F(MixedInMemory, pieces_cross_without_a_hole_and_without_a_step) {
    mixer_->music(Piece::calm, 0.1);
    (void)hear(2);
    mixer_->music(Piece::lively, 1);
    const Samples heard = hear(1.5).left;
    for (double t = 0; t < 1.4; t += 0.1) {
        EXPECT_GT(rms(std::span(heard).subspan(samples_in(t), samples_in(0.1))), 5e-4) << t;
    }
    mixer_->music(Piece::calm, 1);  // and back, in the midst of it
    mixer_->music(Piece::lively, 1);
    mixer_->music({}, 0.3);
    (void)hear(0.6);
    EXPECT_LT(peak(hear(0.1).left), 1e-4);
}

TEST_F(MixedInMemory, a_pause_holds_the_world_but_not_the_menu) {
    mixer_->play(Effect::door, {.place = dvec3(0, 0, -2)});
    (void)hear(0.3);
    mixer_->pause(true);
    (void)hear(0.1);
    EXPECT_LT(peak(hear(0.3).left), 1e-3);
    mixer_->play(Effect::menu_choose, {});
    EXPECT_GT(peak(hear(0.2).left), 0.01);
    (void)hear(1);
    mixer_->play(Effect::hurt, {.place = dvec3(0, 0, -2)});
    EXPECT_LT(peak(hear(0.2).left), 1e-3) << "a pause also holds what comes after it began";
    mixer_->pause(false);
    EXPECT_GT(peak(hear(0.3).left), 0.01) << "and both go on afterwards";
}

TEST_F(MixedInMemory, what_has_ended_does_not_begin_again_after_a_pause) {
    mixer_->play(Effect::jump, {.place = dvec3(0, 0, -2)});
    std::vector<float> all_of_it(2 * samples_in(0.5));
    mixer_->mixed(all_of_it);  // and nobody has noticed yet that it is over
    mixer_->pause(true);
    mixer_->pause(false);
    (void)hear(0.1);
    EXPECT_LT(peak(hear(0.3).left), 1e-4);
    EXPECT_EQ(mixer_->playing(), 0U);
}

TEST_F(MixedInMemory, a_hundred_sounds_at_once_are_thirty_two) {
    for (int i = 0; i < 100; ++i) mixer_->play(Effect::coin, {.gain = 0.5});
    EXPECT_EQ(mixer_->playing(), 32U);
    const Samples heard = hear(1.2).left;
    EXPECT_LE(peak(heard), 1.0) << "and they do not clip";
    EXPECT_EQ(mixer_->playing(), 0U);
}

TEST_F(MixedInMemory, numbers_that_are_none_are_not_played_and_do_no_harm) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    mixer_->play(Effect::coin, {.place = dvec3(nan, 0, 0)});
    mixer_->play(Effect::coin, {.gain = nan});
    mixer_->play(Effect::coin, {.velocity = dvec3(0, nan, 0)});
    mixer_->listen({.place = dvec3(0, 0, nan)});
    EXPECT_EQ(mixer_->playing(), 0U);
    mixer_->play(Effect::coin, {.gain = 7, .pitch = 1000});
    EXPECT_GT(peak(hear(0.2).left), 0.01);
}

TEST_F(MixedInMemory, all_effects_are_prepared_one_after_the_other) {
    int made = 0, wanted = 0;
    for (int i = 0; i < effect_count; ++i) wanted += variations_of(static_cast<Effect>(i));
    while (mixer_->prepare_one()) ++made;
    EXPECT_EQ(made, wanted);
}

}  // namespace
}  // namespace surefoot::sound
