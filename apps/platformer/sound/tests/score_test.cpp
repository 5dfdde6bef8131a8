// Music as it is written.
#include "platformer/sound/score.hpp"

#include <cstdlib>
#include <gtest/gtest.h>

#include "platformer/sound/chord.hpp"

namespace surefoot::sound {
namespace {

const std::string head =
    "tempo 60\npart tune flute gain 0.5\npart low bass\npart hands piano\npart beat kick\nsection a\n";

Score read(const std::string& text) {
    const Expected<Score> score = read_score(text);
    EXPECT_TRUE(score) << score.error().text;
    return score.value_or(Score{});
}

std::string complaint(const std::string& text) {
    const Expected<Score> score = read_score(text);
    return score ? "" : score.error().text;
}

TEST(Score, a_bar_is_shared_evenly_by_its_signs_and_a_dash_holds) {
    const Score score = read(head + "chords C | G\ntune c5 - e5 . | g5\norder a");
    ASSERT_EQ(score.notes.size(), 3U);
    EXPECT_EQ(score.length, 8);
    EXPECT_EQ(score.notes[0].pitch, 72);
    EXPECT_EQ(score.notes[0].length, 2);
    EXPECT_EQ(score.notes[1].start, 2);
    EXPECT_EQ(score.notes[1].length, 1);
    EXPECT_EQ(score.notes[2].start, 4);
    EXPECT_EQ(score.notes[2].length, 4);
}

TEST(Score, swing_delays_the_second_half_of_a_beat_and_nothing_else) {
    const Score score = read("swing 0.6\n" + head + "chords C\ntune c5 d5 e5 f5 g5 a5 b5 c6\norder a");
    ASSERT_EQ(score.notes.size(), 8U);
    EXPECT_NEAR(score.notes[1].start, 0.6, 1e-12);
    EXPECT_NEAR(score.notes[2].start, 1, 1e-12);
    EXPECT_NEAR(score.notes[0].length, 0.6, 1e-12);
    EXPECT_NEAR(score.notes[1].length, 0.4, 1e-12);
}

TEST(Score, degrees_are_those_of_the_chord_that_sounds) {
    const Score score = read(head + "chords Am7 F7\nlow 1 3 5 7\norder a");
    ASSERT_EQ(score.notes.size(), 4U);
    EXPECT_EQ(score.notes[0].pitch, 33);       // a
    EXPECT_EQ(score.notes[1].pitch, 33 + 3);   // its minor third
    EXPECT_EQ(score.notes[2].pitch, 29 + 7);   // f's fifth
    EXPECT_EQ(score.notes[3].pitch, 29 + 10);  // its minor seventh
}

TEST(Score, a_line_of_one_bar_goes_on_for_the_whole_section) {
    const Score score = read(head + "chords C | C | C | C\nbeat x . x .\norder a a");
    EXPECT_EQ(score.notes.size(), 16U);
    EXPECT_EQ(score.length, 32);
}

TEST(Score, x_is_one_stroke_of_a_drum_and_four_voices_of_a_chord) {
    EXPECT_EQ(read(head + "chords C\nbeat x!\norder a").notes.size(), 1U);
    EXPECT_EQ(read(head + "chords C\nhands x?\norder a").notes.size(), 4U);
    EXPECT_NE(complaint(head + "chords C\nbeat c5\norder a").find("a stroke is an x"), std::string::npos);
}

TEST(Score, a_section_can_be_like_another) {
    const Score score = read(head + "chords C\nbeat x\nsection b like a\ntune c5\norder b");
    EXPECT_EQ(score.notes.size(), 2U);
}

TEST(Score, what_cannot_be_read_is_told_by_its_line) {
    EXPECT_NE(complaint(head + "chords C\ntune c5 h5\norder a").find("Line 8"), std::string::npos);
    EXPECT_NE(complaint(head + "chords Cmaj19\norder a").find("\"Cmaj19\""), std::string::npos);
    EXPECT_NE(complaint(head + "chords C\ntune %\norder a").find("no bar before"), std::string::npos);
    EXPECT_NE(complaint(head + "chords C | | C\norder a").find("bar 2 is empty"), std::string::npos);
    EXPECT_NE(complaint("part x kazoo").find("kazoo"), std::string::npos);
    EXPECT_NE(complaint("tempo fast").find("not a number"), std::string::npos);
    EXPECT_NE(complaint("tempo -3").find("out of range"), std::string::npos);
    EXPECT_NE(complaint(head + "chords C").find("order"), std::string::npos);
    EXPECT_NE(complaint(head + "chords C\norder b").find("no section b"), std::string::npos);
    EXPECT_NE(complaint(head + "whistle c5\norder a").find("no part"), std::string::npos);
    EXPECT_NE(complaint(head + "tune c5\norder a").find("no chords"), std::string::npos);
    EXPECT_NE(complaint("").find("order"), std::string::npos);
}

TEST(Chord, symbols_are_those_of_lead_sheets) {
    EXPECT_EQ(chord_named("C")->degrees, (std::vector{0, 4, 7}));
    EXPECT_EQ(chord_named("F#m7b5")->root, 6);
    EXPECT_EQ(chord_named("Ebmaj7/G")->bass, 7);
    EXPECT_FALSE(chord_named("H7"));
    EXPECT_FALSE(chord_named("C7/"));
    EXPECT_EQ(chord_named("Cm7")->degree(3), 3);
    EXPECT_EQ(chord_named("C7sus4")->degree(4), 5);
    EXPECT_EQ(chord_named("Bm7b5")->degree(5), 6);
}

TEST(Chord, hands_move_little_and_play_only_what_belongs_to_it) {
    std::optional<Voicing> before;
    for (const char* const symbol : {"Fmaj9", "Em7b5", "A7", "Dm9", "Cm9", "F13", "Bbmaj9", "Gm9", "C9sus4", "C7"}) {
        const Chord chord = *chord_named(symbol);
        const Voicing now = voiced(chord, before);
        int moved = 0;
        for (std::size_t i = 0; i < now.size(); ++i) {
            if (before) moved += std::abs(now[i] - (*before)[i]);
            bool belongs = false;
            for (const int degree : chord.degrees) belongs = belongs || (now[i] - chord.root - degree) % 12 == 0;
            EXPECT_TRUE(belongs) << symbol << " " << now[i];
        }
        EXPECT_TRUE(now[0] < now[1] && now[1] < now[2] && now[2] < now[3]) << symbol;
        EXPECT_LE(moved, 12) << symbol;
        before = now;
    }
}

}  // namespace
}  // namespace surefoot::sound
