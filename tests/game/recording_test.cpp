// Runs of the platformer that are kept, and what a player has done so far.
#include "game/recording.hpp"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <thread>

#include "game/campaign.hpp"
#include "game/file_lock.hpp"
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

// A level with a second section whose goal is near.
std::shared_ptr<const Level> two_sections() {
    LevelMaker maker;
    maker.level->checkpoints.push_back({.feet = {10, 0, 10}, .facing = {1, 0, 0}, .section = "the end", .order = 1});
    return maker.finish();
}

TEST(GameRecording, OneThatBeganAtACheckpointIsKeptAndGivesTheSameGame) {
    const auto level = two_sections();
    const auto game = *Game::start(level, {.checkpoint = 1});
    EXPECT_NEAR(game->feet().x, 10, 1e-9);
    EXPECT_EQ(game->checkpoint(), 1U);
    Recorder recorder(*level, "a test", game->begun_at());
    while (game->outcome() == Outcome::playing && game->seconds() < 10) {
        const HeroInput input{.move_x = 0.7F, .move_z = 0.7F};
        game->tick(input);
        recorder.tick(input, *game);
    }
    ASSERT_EQ(game->outcome(), Outcome::won);
    const std::string path = scratch("from_a_checkpoint.run");
    ASSERT_TRUE(write_recording(path, recorder.recording()));
    const auto read = read_recording(path);
    ASSERT_TRUE(read) << read.error().text;
    EXPECT_EQ(read->checkpoint, 1U);
    const auto again = start_of(level, *read);
    ASSERT_TRUE(again) << again.error().text;
    Player player(*read);
    while (player.tick(**again)) continue;
    EXPECT_EQ(player.diverged(), 0U);
    EXPECT_EQ((*again)->hash(), game->hash());
    Progress progress;
    EXPECT_FALSE(progress.add(*game)) << "half of the way is no best time";
    EXPECT_FALSE(progress.levels["made"].won);
}

TEST(GameRecording, NobodyBeginsAtACheckpointThatIsNotThere) {
    const auto level = two_sections();
    EXPECT_EQ(Game::start(level, {.checkpoint = 2}).error().code, ErrorCode::invalid);
    Recording recording;
    recording.checkpoint = 9;
    EXPECT_EQ(start_of(level, recording).error().code, ErrorCode::invalid);
    recording.checkpoint = 1;
    EXPECT_TRUE(start_of(level, recording));
    recording.level_hash = 7;
    EXPECT_EQ(start_of(level, recording).error().code, ErrorCode::invalid);
}

TEST(GameRecording, AFileOfTheFirstVersionIsReadAndBeginsAtTheSpawn) {
    const std::string header =
        R"({"level":"made","level_hash":0,"player":"A","ticks":2,"hashes":0,"won":false,"seconds":0.5,"decisions":[]})";
    std::string body(4, '\0');
    body[0] = char(header.size());
    body += header;
    body += std::string("\2\0\0\0", 4) + std::string(sizeof(HeroInput), '\0');
    std::string bytes = "SFRUN\x01\r\n";
    const std::uint64_t sum = hash_bytes(std::as_bytes(std::span(body)));
    bytes.append(reinterpret_cast<const char*>(&sum), sizeof sum);
    const std::string path = scratch("first_version.run");
    ASSERT_TRUE(write_whole(path, bytes + body));
    const auto read = read_recording(path);
    ASSERT_TRUE(read) << read.error().text;
    EXPECT_EQ(read->player, "A");
    EXPECT_EQ(read->inputs.size(), 2U);
    EXPECT_EQ(read->checkpoint, 0U);
    bytes[5] = 3;
    ASSERT_TRUE(write_whole(path, bytes + body));
    EXPECT_EQ(read_recording(path).error().code, ErrorCode::unsupported);
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
    progress.levels["secret"].won = true;
    EXPECT_TRUE(progress.is_open(secret, all)) << "begun from the command line, and won";
}

// The defect: it was locked until the last level of the campaign was won.
TEST(GameProgress, ALevelThatIsNoPartOfTheCampaignIsOpen) {
    Level first = *LevelMaker().level;
    Level own = first;
    first.id = "first";
    own.id = "own";
    own.order = 50;
    EXPECT_TRUE(Progress().is_open(own, std::vector<const Level*>{&first}));
}

TEST(GameProgress, WhatAnotherProgramDidMeanwhileIsMergedToTheBestOfBoth) {
    Progress ours;
    ours.levels["first"] = {
        .won = true, .best_seconds = 30, .medal = Medal::gold, .best_coins = 2, .stars = {0}, .runs = 3};
    Progress theirs;
    theirs.levels["first"] = {
        .won = true, .best_seconds = 50, .medal = Medal::silver, .best_coins = 5, .stars = {2}, .runs = 4};
    theirs.levels["second"] = {.won = true, .best_seconds = 70};
    theirs.levels["third"] = {.runs = 1};
    ours.levels["third"] = {.won = true, .best_seconds = 9};
    ours.merge(theirs);
    EXPECT_EQ(ours.levels["first"].best_seconds, 30);
    EXPECT_EQ(ours.levels["first"].medal, Medal::gold);
    EXPECT_EQ(ours.levels["first"].best_coins, 5);
    EXPECT_EQ(ours.levels["first"].stars, (std::set<std::uint32_t>{0, 2}));
    EXPECT_EQ(ours.levels["first"].runs, 4U);
    EXPECT_TRUE(ours.levels["second"].won);
    EXPECT_EQ(ours.levels["second"].best_seconds, 70);
    EXPECT_EQ(ours.levels["third"].best_seconds, 9) << "who has not won has no time";
}

TEST(GameFileLock, KeepsASecondOneOutUntilTheFirstIsGone) {
    const std::string path = scratch("locked/kept.json");
    int count = 0;  // not atomic: the lock is what orders them
    const auto work = [&] {
        for (int i = 0; i < 20; ++i) {
            const FileLock lock(path);
            EXPECT_TRUE(lock.is_held());
            const int before = count;
            std::this_thread::yield();
            count = before + 1;
        }
    };
    std::thread other(work);
    work();
    other.join();
    EXPECT_EQ(count, 40);
}

TEST(GameFileLock, OneThatWasLeftBehindIsTakenAway) {
    const std::string path = scratch("left/kept.json");
    std::filesystem::create_directories(path + ".lock");
    std::filesystem::last_write_time(path + ".lock",
                                     std::filesystem::file_time_type::clock::now() - std::chrono::minutes(1));
    const FileLock lock(path);
    EXPECT_TRUE(lock.is_held());
}

TEST(GameCampaign, IsWhatTheFolderSaysInItsOrder) {
    const std::string folder = scratch("campaign");
    std::filesystem::remove_all(folder);
    EXPECT_TRUE(campaign_in(folder).empty());
    ASSERT_TRUE(write_whole(folder + "/campaign.txt", "# a remark\n second \r\nfirst # and another\n\n"));
    EXPECT_EQ(campaign_in(folder), (std::vector<std::string>{"second", "first"}));
}

}  // namespace
}  // namespace surefoot::game
