/// An afternoon with people, from the side of the game: forms, the observer's notes, and everything of one player kept
/// in a folder. docs/playtesting.md tells how it goes; `surefoot playtest --sessions` reads it.
#pragma once

#include <optional>
#include <string>

#include "game/recording.hpp"
#include "platformer/screens/form.hpp"
#include "playtest/session.hpp"
#include "playtest/telemetry.hpp"

namespace surefoot::platformer {

class PlaySession {
public:
    /// The folder of the afternoon: each player gets one in it, named by day and player.
    explicit PlaySession(std::string afternoon) : afternoon_(std::move(afternoon)) {}

    [[nodiscard]] static Form start_form();
    [[nodiscard]] static Form note_form();
    [[nodiscard]] static Form end_form();

    // All that keep something fail with `write_failed`. What is kept is whole at any time: who closes the window loses
    // no more than the run at hand.

    /// The start form is filled in: makes the player's folder. `day` is as 2026-11-27.
    [[nodiscard]] Expected<void> begin(const Form& start, const std::string& day);
    [[nodiscard]] bool has_begun() const { return !session_.folder.empty(); }
    [[nodiscard]] const std::string& folder() const { return session_.folder; }
    [[nodiscard]] const playtest::Session& session() const { return session_; }

    /// Nothing, unless it has begun.
    void begin_run(const game::Level& level);
    /// After each tick of it.
    void tick(const game::HeroInput& input, const game::Game& game);
    /// It is over, or left.
    [[nodiscard]] Expected<void> keep_run(const game::Recording& recording);

    /// `seconds` of the run, if there is one.
    [[nodiscard]] Expected<void> note(const std::string& text, double seconds);
    [[nodiscard]] Expected<void> answer(const Form& end);

private:
    [[nodiscard]] bool is_taken(const std::string& run) const;

    std::string afternoon_;
    playtest::Session session_{};
    std::string run_;  // the name of its file; empty: nothing is played
    std::optional<playtest::Observer> observer_;
};

/// Today, by this machine, as 2026-11-27.
[[nodiscard]] std::string today();

}  // namespace surefoot::platformer
