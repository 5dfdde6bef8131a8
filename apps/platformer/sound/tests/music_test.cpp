// The two pieces, as the band plays them.
#include <algorithm>
#include <cmath>
#include <ctime>
#include <gtest/gtest.h>

#include "platformer/sound/band.hpp"
#include "platformer/sound/measure.hpp"
#include "platformer/sound/pieces.hpp"

namespace surefoot::sound {
namespace {

class Music : public testing::TestWithParam<Piece> {
protected:
    [[nodiscard]] static const Score& score() { return score_of(GetParam()); }
};

INSTANTIATE_TEST_SUITE_P(Pieces, Music, testing::Values(Piece::calm, Piece::lively),
                         [](const auto& piece) { return std::string(name_of(piece.param)); });

TEST_P(Music, can_be_read_and_lasts_a_minute_or_a_little_more) {
    const Expected<Score> read = read_score(text_of(GetParam()));
    ASSERT_TRUE(read) << read.error().text;
    EXPECT_GE(read->length, 60);
    EXPECT_LE(read->length, 90);
    EXPECT_GT(read->notes.size(), 500U);
    EXPECT_FALSE(read->title.empty());
}

TEST_P(Music, everybody_in_the_band_plays) {
    for (std::size_t part = 0; part < score().parts.size(); ++part) {
        const bool plays = std::any_of(score().notes.begin(), score().notes.end(),
                                       [&](const Note& note) { return note.part == part; });
        EXPECT_TRUE(plays) << score().parts[part].name;
    }
}

TEST_P(Music, loops_without_a_click_and_never_clips) {
    Band band(score());
    std::vector<float> first(2 * band.round()), again(2 * samples_in(6.0));
    band.play(first);
    band.play(again);
    EXPECT_LE(peak(first), 0.95);
    // A click is a step out of nowhere.
    EXPECT_LT(std::abs(double(again[0]) - first[first.size() - 2]), 0.03);
    // What rings at the end rings on: the second round is the first with that added, until it has faded.
    std::vector<float> ringing;
    for (std::size_t i = 0; i < again.size(); ++i) ringing.push_back(again[i] - first[i]);
    EXPECT_GT(rms(std::span(ringing).first(2 * samples_in(0.05))), 0.003);
    EXPECT_LT(std::abs(double(ringing[0]) - first[first.size() - 2]), 0.01);
    EXPECT_LT(rms(std::span(ringing).last(2 * samples_in(0.5))), 1e-4);
}

TEST_P(Music, the_first_of_it_is_there_long_before_it_is_wanted) {
    const std::clock_t begin = std::clock();
    Band band(score());
    std::vector<float> block(2 * 4096);
    band.play(block);
    EXPECT_LT(double(std::clock() - begin) / CLOCKS_PER_SEC, 0.3);
    EXPECT_GT(peak(block), 0.01) << "the first tenth of a second is not silent";
}

TEST_P(Music, is_the_same_however_it_is_cut_into_blocks) {
    Band whole(score()), pieces(score());
    std::vector<float> one(2 * samples_in(2.0)), other(one.size());
    whole.play(one);
    std::span<float> rest(other);
    for (std::size_t count = 2; !rest.empty(); count = 2 * ((count * 7 + 11) % 977 + 1)) {
        const std::size_t taken = std::min(count, rest.size());
        pieces.play(rest.first(taken));
        rest = rest.subspan(taken);
    }
    EXPECT_EQ(one, other);
}

TEST_P(Music, the_tune_belongs_to_its_chords_on_most_strong_beats) {
    // Measured as consonance with what the hands play: at the first beat of each bar the bass and the melody are no
    // semitone and no tritone apart more often than jazz allows.
    int clashes = 0, bars = 0;
    for (const Note& note : score().notes) {
        if (score().parts[note.part].name != "melody") continue;
        for (const Note& other : score().notes) {
            if (other.start > note.start) break;
            if (score().parts[other.part].name != "bass" || other.start < note.start - 1e-9) continue;
            ++bars;
            clashes += (static_cast<int>(note.pitch - other.pitch) % 12 == 1) ? 1 : 0;
        }
    }
    EXPECT_GT(bars, 20);
    EXPECT_LE(clashes, bars / 20);
}

std::uint64_t hash_of_the_beginning(Piece piece) {
    Band band(score_of(piece));
    std::vector<float> samples(2 * samples_in(8));
    band.play(samples);
    std::uint64_t hash = 0xCBF29CE484222325U;
    for (const float sample : samples) {
        hash = (hash ^ static_cast<std::uint16_t>(to_16_bits(sample))) * 0x100000001B3U;
    }
    return hash;
}

TEST(Pieces, are_the_same_samples_in_every_build) {
    // Whoever changes the music on purpose writes the new numbers here.
    EXPECT_EQ(hash_of_the_beginning(Piece::calm), 7815519882142446928U);
    EXPECT_EQ(hash_of_the_beginning(Piece::lively), 2272564587006384580U);
}

}  // namespace
}  // namespace surefoot::sound
