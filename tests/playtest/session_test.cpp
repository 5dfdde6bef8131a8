#include "playtest/session.hpp"

#include <filesystem>
#include <gtest/gtest.h>

#include "game/whole_file.hpp"

namespace surefoot::playtest {
namespace {

class SessionFolder : public testing::Test {
protected:
    std::string root = testing::TempDir() + "surefoot_sessions_test";
    void TearDown() override { std::filesystem::remove_all(root); }
};

TEST_F(SessionFolder, is_read_as_it_was_written) {
    const Session written{
        .folder = root + "/b",
        .start = {.player = "B", .plays_games = "often", .device = "gamepad", .played_before = true, .consent = true},
        .notes = {{.run = "first-steps", .seconds = 12.5, .text = "laughs"}},
        .answers = {.fun = 4, .difficulty = 3, .control = 5, .way = 2, .again = 1, .remark = "the ferries"},
        .runs = {"first-steps"}};
    ASSERT_TRUE(write_session(written));
    ASSERT_TRUE(
        write_session({.folder = root + "/a", .start = {.player = "A"}, .notes = {}, .answers = {}, .runs = {}}));
    const auto read = read_sessions(root);
    ASSERT_TRUE(read) << read.error().text;
    ASSERT_EQ(read->size(), 2U);
    EXPECT_EQ((*read)[0].start.player, "A");
    const Session& b = (*read)[1];
    EXPECT_EQ(b.start.device, "gamepad");
    EXPECT_TRUE(b.start.played_before);
    EXPECT_TRUE(b.start.consent);
    ASSERT_EQ(b.notes.size(), 1U);
    EXPECT_EQ(b.notes[0].text, "laughs");
    EXPECT_EQ(b.notes[0].seconds, 12.5);
    EXPECT_EQ(b.answers.control, 5);
    EXPECT_EQ(b.answers.way, 2);
    EXPECT_EQ(b.answers.again, 1);
    EXPECT_EQ(b.answers.remark, "the ferries");
    EXPECT_EQ(b.runs, std::vector<std::string>{"first-steps"});
}

TEST_F(SessionFolder, that_is_damaged_or_leads_elsewhere_is_refused_in_words) {
    ASSERT_TRUE(game::write_whole(root + "/a/session.json", "{\"format\":\"surefoot session 1\""));
    const auto damaged = read_session(root + "/a");
    ASSERT_FALSE(damaged);
    EXPECT_EQ(damaged.error().code, ErrorCode::unreadable);
    ASSERT_TRUE(game::write_whole(root + "/a/session.json",
                                  R"({"format":"surefoot session 1","start":{"player":"A"},"runs":["../../x"]})"));
    EXPECT_FALSE(read_session(root + "/a"));
    EXPECT_FALSE(read_sessions(root + "/nowhere"));
}

}  // namespace
}  // namespace surefoot::playtest
