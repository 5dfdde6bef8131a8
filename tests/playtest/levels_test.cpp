// The bot finishes every level of the game: one test a level, each found by its file.
#include <algorithm>
#include <filesystem>
#include <gtest/gtest.h>

#include "playtest/bots/navigator.hpp"
#include "playtest/run.hpp"

namespace surefoot::playtest {
namespace {

class PlatformerLevel : public testing::TestWithParam<std::string> {};

TEST_P(PlatformerLevel, is_finished_by_the_bot_that_knows_its_way_and_by_its_recording) {
    auto read = game::read_level(GetParam());
    ASSERT_TRUE(read) << read.error().text;
    const auto level = std::make_shared<const game::Level>(std::move(*read));
    const auto atlas = Atlas::make(level);
    ASSERT_TRUE(atlas) << atlas.error().text;
    // One who fails is human; one in three who does not is a level that can be finished.
    std::string reasons;
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        auto bot = Navigator::make(*atlas, {.seed = seed});
        ASSERT_TRUE(bot) << bot.error().text;
        const auto run = play(level, **bot, {.most_seconds = 900});
        ASSERT_TRUE(run) << run.error().text;
        for (const auto kind : {Incident::Kind::escape, Incident::Kind::not_a_number, Incident::Kind::overflow})
            EXPECT_EQ(run->telemetry.count(kind), 0U) << name_of(kind);
        reasons += level->checkpoints[run->telemetry.section].section + ": " + (*bot)->doing() + "; " +
                   (*bot)->gave_up() + "\n";
        if (!run->telemetry.won) continue;
        std::uint64_t diverged = 0;
        const auto again = replay(level, run->recording, &diverged);
        ASSERT_TRUE(again) << again.error().text;
        EXPECT_TRUE(again->won);
        EXPECT_EQ(diverged, 0U);
        return;
    }
    FAIL() << reasons;
}

std::string name_of_level(const testing::TestParamInfo<std::string>& info) {
    std::string name = std::filesystem::path(info.param).stem().string();
    std::ranges::replace(name, '-', '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Of, PlatformerLevel,
                         testing::ValuesIn(game::levels_in(std::string(SUREFOOT_LEVELS_DIR) + "/platformer")),
                         name_of_level);

}  // namespace
}  // namespace surefoot::playtest
