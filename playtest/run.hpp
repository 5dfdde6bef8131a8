/// One run: a bot plays a level from its spawn or a checkpoint, and it is recorded and noted down.
#pragma once

#include <memory>

#include "game/recording.hpp"
#include "playtest/bots/bot.hpp"
#include "playtest/telemetry.hpp"

namespace surefoot::playtest {

struct RunOptions {
    double most_seconds = 600;     ///< of play; then it is over
    std::uint32_t checkpoint = 0;  ///< where it begins, of `Level::checkpoints`
    bool one_section = false;      ///< it is over, too, once another checkpoint is reached
};

struct Run {
    game::Recording recording;
    Telemetry telemetry;
};

/// Plays until it is won, until the bot gives up, or until time is up; after a loss it goes on from the checkpoint.
/// Fails as `Game::start` does.
[[nodiscard]] Expected<Run> play(const std::shared_ptr<const game::Level>& level, Bot& bot,
                                 const RunOptions& options = {});

/// What an observer would have noted down, from the recording alone. `diverged` as `Player` says.
[[nodiscard]] Expected<Telemetry> replay(const std::shared_ptr<const game::Level>& level,
                                         const game::Recording& recording, std::uint64_t* diverged = nullptr);

}  // namespace surefoot::playtest
