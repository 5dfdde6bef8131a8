#include "playtest/run.hpp"

namespace surefoot::playtest {

Expected<Run> play(const std::shared_ptr<const game::Level>& level, Bot& bot, const RunOptions& options) {
    auto started = game::Game::start(level);
    if (!started) return tl::unexpected(started.error());
    game::Game& game = **started;
    game::Recorder recorder(*level, bot.name());
    Observer observer(*level, bot.name());
    while (game.outcome() != game::Outcome::won && bot.gave_up().empty() && game.seconds() < options.most_seconds) {
        if (game.outcome() == game::Outcome::lost) {
            if (game.cause() == game::Cause::time) break;
            recorder.decide(game::RunDecision::Kind::retry);
            game.retry();
        }
        const game::HeroInput input = bot.decide(game);
        game.tick(input);
        recorder.tick(input, game);
        observer.tick(input, game);
    }
    observer.telemetry().gave_up = bot.gave_up();
    return Run{recorder.recording(), std::move(observer.telemetry())};
}

Expected<Telemetry> replay(const std::shared_ptr<const game::Level>& level, const game::Recording& recording,
                           std::uint64_t* diverged) {
    if (recording.level_hash != level->hash)
        return tl::unexpected(Error{ErrorCode::invalid,
                                    "the recording was made on another version of the level " + recording.level +
                                        ": it cannot be played on this one",
                                    {},
                                    0});
    auto started = game::Game::start(level);
    if (!started) return tl::unexpected(started.error());
    game::Game& game = **started;
    game::Player player(recording);
    Observer observer(*level, recording.player);
    while (player.tick(game)) observer.tick(recording.inputs[player.ticks() - 1], game);
    if (diverged != nullptr) *diverged = player.diverged();
    return std::move(observer.telemetry());
}

}  // namespace surefoot::playtest
