/// A run, kept: the inputs of every tick, what it was made on, and what came of it. Played again it gives the same
/// game, bit for bit.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <surefoot/error.hpp>

#include "game/game.hpp"

namespace surefoot::game {

/// What happened between ticks that a player decided: to be done before the tick of this number.
struct RunDecision {
    enum class Kind : std::uint8_t { retry, give_up } kind = Kind::retry;
    std::uint64_t tick = 0;
};

struct Recording {
    std::string level;              ///< `Level::id`
    std::uint64_t level_hash = 0;   ///< `Level::hash`
    std::string player;             ///< a name, or a bot's
    std::uint32_t checkpoint = 0;   ///< where it begins, of `Level::checkpoints`
    std::vector<HeroInput> inputs;  ///< one a tick
    std::vector<RunDecision> decisions;
    std::vector<std::uint64_t> hashes;  ///< of the game after every 60th tick
    bool won = false;
    double seconds = 0;
};

/// Keeps a run as it is played: call `tick` with what the game is told, after the game was.
class Recorder {
public:
    /// `checkpoint`: at which the game was started.
    Recorder(const Level& level, std::string player, std::uint32_t checkpoint = 0);
    void tick(const HeroInput& input, const Game& game);
    void decide(RunDecision::Kind kind);
    [[nodiscard]] const Recording& recording() const { return recording_; }

private:
    Recording recording_;
};

/// A game as the recording begins: to be played by a `Player`. Fails as `Game::start` does, and with `invalid` for a
/// recording that was made on another version of the level.
[[nodiscard]] Expected<std::unique_ptr<Game>> start_of(const std::shared_ptr<const Level>& level,
                                                       const Recording& recording);

/// Plays a recording tick by tick.
class Player {
public:
    /// Requires: the recording outlives it.
    explicit Player(const Recording& recording) : recording_(&recording) {}
    /// One tick of `game`; false when there is no more.
    bool tick(Game& game);
    [[nodiscard]] std::uint64_t ticks() const { return at_; }
    /// The first tick after which the game was another than the one recorded, by its hash; 0: none so far.
    [[nodiscard]] std::uint64_t diverged() const { return diverged_; }

private:
    const Recording* recording_;
    std::uint64_t at_ = 0;
    std::size_t decision_ = 0;
    std::uint64_t diverged_ = 0;
};

/// The bytes of a small file (".run"), versioned and checked, and back; those of version 1, which all begin at the
/// spawn, are read, too. `file` is what errors name. Reading fails with `unreadable` for damaged bytes, with the place,
/// and with `unsupported` for another version.
[[nodiscard]] std::string to_bytes(const Recording& recording);
[[nodiscard]] Expected<Recording> recording_of(std::string_view bytes, const std::string& file);

/// Fails with `write_failed`; nothing half-written is left.
[[nodiscard]] Expected<void> write_recording(const std::string& path, const Recording& recording);

/// Fails with `not_found`, and as above.
[[nodiscard]] Expected<Recording> read_recording(const std::string& path);

}  // namespace surefoot::game
