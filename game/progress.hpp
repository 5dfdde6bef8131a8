/// What a player has done so far: best times, stars, what is open. Kept as JSON, whole or not at all.
#pragma once

#include <map>
#include <set>
#include <span>
#include <string>

#include <surefoot/error.hpp>

#include "game/game.hpp"

namespace surefoot::game {

struct LevelProgress {
    bool won = false;
    double best_seconds = 0;  ///< 0: none yet
    Medal medal = Medal::none;
    int best_coins = 0;
    std::set<std::uint32_t> stars{};  ///< which, by their order among the level's stars
    std::uint32_t runs = 0;
    std::uint32_t deaths = 0;
};

struct Progress {
    std::map<std::string, LevelProgress> levels;  ///< by `Level::id`
    std::set<std::string> taught{};               ///< what the player was told when it first happened

    [[nodiscard]] int stars() const;
    /// The first level of the campaign is open; each next when the one before it is won; a secret one, or any that asks
    /// for stars, by its stars. What is no part of the campaign is open, and so is what was won, however it was begun.
    /// `campaign` is in the order of playing.
    [[nodiscard]] bool is_open(const Level& level, std::span<const Level* const> campaign) const;
    /// A game is over, or left. Returns whether its time is a new best. One that was started at a checkpoint wins
    /// nothing.
    bool add(const Game& game);
    /// What another program made of the same progress: the best of both.
    void merge(const Progress& other);
};

/// Empty progress if there is no file. Fails with `unreadable` for one that is damaged; the text says what to do.
[[nodiscard]] Expected<Progress> read_progress(const std::string& path);
[[nodiscard]] Expected<void> write_progress(const std::string& path, const Progress& progress);

}  // namespace surefoot::game
