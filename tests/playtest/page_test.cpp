// The code of docs/playtesting.md, as it stands there.
#include <cstdio>
#include <gtest/gtest.h>

#include "game/level.hpp"
#include "playtest/bots/atlas.hpp"
#include "playtest/bots/navigator.hpp"
#include "playtest/run.hpp"

namespace {

TEST(PlaytestPage, ABotPlaysALevelInAFewLines) {
    const std::string file = SUREFOOT_LEVELS_DIR "/platformer/first-steps.glb";
    // [bot]
    const auto level = std::make_shared<const surefoot::game::Level>(*surefoot::game::read_level(file));
    const auto atlas = *surefoot::playtest::Atlas::make(level);
    const auto bot = *surefoot::playtest::Navigator::make(atlas, {.seed = 7});
    const auto run = *surefoot::playtest::play(level, *bot);
    std::printf("%s in %.1f s\n", run.telemetry.won ? "finished" : bot->gave_up().c_str(), run.telemetry.seconds);
    // [/bot]
    EXPECT_TRUE(run.telemetry.won);
}

}  // namespace
