// Runs of the platformer that are kept, and what a player has done so far.
#include "game/recording.hpp"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>

#include "game/progress.hpp"
#include "game/whole_file.hpp"
#include "level_maker.hpp"

namespace surefoot::game {
namespace {

using test::LevelMaker;

std::string scratch(const char* name) {
    return (std::filesystem::path(testing::TempDir()) / name).string();
}

// To the goal, with jumps, and a fall and a retry on the way.
Recording run() {
    const auto game = LevelMaker().start();
    Recorder recorder(game->level(), "a test");
    const auto tick = [&](HeroInput input) {
        game->tick(input);
        recorder.tick(input, *game);
    };
    for (int i = 0; i < 100; ++i) tick({.move_x = 1, .move_z = 0.2F, .buttons = std::uint8_t(i % 30 < 10 ? 1 : 0)});
    recorder.decide(RunDecision::Kind::retry);
    game->retry();
    for (int i = 0; i < 600 && game->outcome() == Outcome::playing; ++i) tick({.move_x = 0.7F, .move_z = 0.7F});
    EXPECT_EQ(game->outcome(), Outcome::won);
    return recorder.recording();
}

TEST(GameRecording, PlayedAgainItGivesTheSameGame) {
    const Recording recording = run();
    const auto game = LevelMaker().start();
    Player player(recording);
    while (player.tick(*game)) continue;
    EXPECT_EQ(player.diverged(), 0U);
    EXPECT_EQ(game->outcome(), Outcome::won);
    EXPECT_EQ(game->seconds(), recording.seconds);
}

TEST(GameRecording, AChangedInputIsNoticedWithinASecond) {
    Recording recording = run();
    recording.inputs[20].move_x = -1;
    const auto game = LevelMaker().start();
    Player player(recording);
    while (player.tick(*game)) continue;
    EXPECT_EQ(player.diverged(), 60U);
}

TEST(GameRecording, AFileGivesBackWhatWasWritten) {
    const Recording recording = run();
    const std::string path = scratch("written.run");
    ASSERT_TRUE(write_recording(path, recording));
    const auto read = read_recording(path);
    ASSERT_TRUE(read) << read.error().text;
    EXPECT_EQ(read->inputs, recording.inputs);
    EXPECT_EQ(read->hashes, recording.hashes);
    EXPECT_EQ(read->level, "made");
    EXPECT_EQ(read->decisions.size(), 1U);
    EXPECT_TRUE(read->won);
}

TEST(GameRecording, IsShorterInAFileThanInMemoryAndCanBeEmpty) {
    Recording recording = run();
    for (std::uint32_t i = 0; i < 600; ++i) {
        HeroInput input;
        input.move_x = 0.001F * float(i);
        input.look_yaw_deg = 0.37F * float(i);
        recording.inputs.push_back(input);
    }
    const std::string bytes = to_bytes(recording);
    EXPECT_LT(bytes.size(), recording.inputs.size() * sizeof(HeroInput) / 2);
    const auto read = recording_of(bytes, "memory");
    ASSERT_TRUE(read) << read.error().text;
    EXPECT_EQ(read->inputs, recording.inputs);
    const auto nothing = recording_of(to_bytes({}), "memory");
    ASSERT_TRUE(nothing) << nothing.error().text;
    EXPECT_TRUE(nothing->inputs.empty());
}

TEST(GameRecording, NoDamagedFileIsTakenForARun) {
    const std::string path = scratch("damaged.run");
    ASSERT_TRUE(write_recording(path, run()));
    const std::string whole = read_whole(path).value();
    for (std::size_t i = 0; i < whole.size(); i += 1 + whole.size() / 97) {
        std::string damaged = whole;
        damaged[i] = char(damaged[i] ^ 0x10);
        ASSERT_TRUE(write_whole(path, damaged));
        const auto read = read_recording(path);
        EXPECT_FALSE(read) << "byte " << i;
        ASSERT_TRUE(write_whole(path, whole.substr(0, i)));
        EXPECT_FALSE(read_recording(path)) << "cut to " << i;
    }
    EXPECT_EQ(read_recording(scratch("nothing.run")).error().code, ErrorCode::not_found);
}

TEST(GameProgress, ABetterTimeIsKeptAndAWorseOneIsNot) {
    LevelMaker maker;
    maker.level->medals = {.gold = 4.5, .silver = 5, .bronze = 6};
    maker.level->pickups.push_back({PickupKind::star, {9, 1, 9}});
    const auto play = [&](double wait) {
        auto game = maker.start();
        test::play(*game, wait);
        test::run_to(*game, {18, 0, 18});
        EXPECT_EQ(game->outcome(), Outcome::won);
        return game;
    };
    Progress progress;
    EXPECT_TRUE(progress.add(*play(1)));
    EXPECT_FALSE(progress.add(*play(2)));
    EXPECT_TRUE(progress.add(*play(0)));
    EXPECT_EQ(progress.levels["made"].medal, Medal::gold);
    EXPECT_EQ(progress.levels["made"].runs, 3U);
    EXPECT_EQ(progress.stars(), 1);

    const std::string path = scratch("progress/kept.json");
    ASSERT_TRUE(write_progress(path, progress));
    const auto read = read_progress(path);
    ASSERT_TRUE(read);
    EXPECT_EQ(read->levels.at("made").best_seconds, progress.levels["made"].best_seconds);
    ASSERT_TRUE(write_whole(path, "{\"levels\": {\"made\": 7}}"));
    EXPECT_EQ(read_progress(path).error().code, ErrorCode::unreadable);
}

TEST(GameProgress, LevelsOpenOneAfterTheOtherAndTheSecretOneByItsStars) {
    Level first = *LevelMaker().level;
    Level second = first;
    Level secret = first;
    first.id = "first";
    second.id = "second";
    secret.id = "secret";
    secret.secret = true;
    secret.stars_needed = 2;
    const std::vector<const Level*> all{&first, &second, &secret};
    Progress progress;
    EXPECT_TRUE(progress.is_open(first, all));
    EXPECT_FALSE(progress.is_open(second, all));
    progress.levels["first"].won = true;
    progress.levels["first"].stars = {0, 2};
    EXPECT_TRUE(progress.is_open(second, all));
    EXPECT_TRUE(progress.is_open(secret, all));
    progress.levels["first"].stars = {0};
    EXPECT_FALSE(progress.is_open(secret, all));
}

}  // namespace
}  // namespace surefoot::game
