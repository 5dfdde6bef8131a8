#include "playtest/run.hpp"

namespace surefoot::playtest {

Expected<Run> play(const std::shared_ptr<const game::Level>& level, Bot& bot, const RunOptions& options) {
    auto started = game::Game::start(level, {.checkpoint = options.checkpoint});
    if (!started) return tl::unexpected(started.error());
    game::Game& game = **started;
    game::Recorder recorder(*level, bot.name(), options.checkpoint);
    Observer observer(*level, bot.name(), options.checkpoint);
    const auto goes_on = [&] {
        return game.outcome() != game::Outcome::won && bot.gave_up().empty() && game.seconds() < options.most_seconds &&
               !(options.one_section && game.checkpoint() != options.checkpoint);
    };
    while (goes_on()) {
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
    auto started = game::start_of(level, recording);
    if (!started) return tl::unexpected(started.error());
    game::Game& game = **started;
    game::Player player(recording);
    Observer observer(*level, recording.player, recording.checkpoint);
    while (player.tick(game)) observer.tick(recording.inputs[player.ticks() - 1], game);
    if (diverged != nullptr) *diverged = player.diverged();
    return std::move(observer.telemetry());
}

}  // namespace surefoot::playtest
