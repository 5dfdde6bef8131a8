/// What does going back cost? A crowd that jostles on lifts is played on, and after each frame the last few are played
/// again from a snapshot, as a network game does whose late inputs arrive every frame.
#pragma once

#include <cstddef>
#include <optional>

namespace surefoot::bench {

struct RollbackOptions {
    std::size_t characters = 64;
    std::size_t lifts = 8;       ///< that go up and down, every second one turning; one character in `lifts` on each
    std::size_t frames = 8;      ///< to go back
    std::size_t rounds = 101;    ///< how often
    std::size_t settling = 120;  ///< frames before that, in which they come to stand and press against each other
    bool restores_poses = true;  ///< false makes the mistake of bringing back the characters alone, so that tests can
                                 ///< see that it is found
};

struct RollbackReport {
    double frame = 0;          ///< median over the rounds, of a frame that was played again [ns]
    double slow_frame = 0;     ///< one round in ten was slower [ns a frame]
    double character = 0;      ///< median, of a character in such a frame [ns]
    double restoring = 0;      ///< median, of going back: states and poses [ns]
    double touching = 0;       ///< share of characters within two skins of another, at the end of all frames [0, 1]
    double riding = 0;         ///< share of characters that stand on a lift then [0, 1]
    std::size_t compared = 0;  ///< hashes
    /// The first frame, counted from the beginning, whose hash was another when it was played again.
    std::optional<std::size_t> first_differs;
};

/// Requires: numbers above 0. Ends at the first frame that differs.
[[nodiscard]] RollbackReport run_rollback(const RollbackOptions& options);

}  // namespace surefoot::bench
