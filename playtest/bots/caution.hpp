/// How somebody careful gets past what moves: looks a second ahead, and goes on, waits, steps aside, jumps over it, or
/// jumps on it.
#pragma once

#include <functional>

#include "playtest/bots/foresight.hpp"
#include "playtest/bots/hands.hpp"

namespace surefoot::playtest {

/// What is done about a danger. The same controller is rehearsed and done.
struct Course {
    enum class How : std::uint8_t { goes_on, stands, runs, stomps } how = How::goes_on;
    dvec3 way{0, 0, 0};     ///< of who runs; level, unit
    int jump_at = -1;       ///< of who goes on or runs: after so many ticks; before 0: not at all
    double reach = 2.2;     ///< of who stomps: jumps from so near [m]
    std::uint32_t foe = 0;  ///< whom; of `Level::enemies`
};

class Caution {
public:
    /// How it would go on from where it is, tick by tick.
    using Steering = std::function<Intent(const game::Hero&)>;

    Caution(std::shared_ptr<const game::Level> level, std::uint64_t seed);

    /// What to do instead of `intent`, if anything. `steering` makes a fresh copy of how it would go on.
    [[nodiscard]] Intent mind(const game::Game& game, Foresight& foresight, const Intent& intent,
                              const std::function<Steering()>& steering);

    /// Does something else than it wanted to.
    [[nodiscard]] bool is_busy() const { return course_.how != Course::How::goes_on || course_.jump_at >= 0; }

    /// Has begun anew somewhere else.
    void forget();

private:
    struct Outlook {
        int safe_for = 0;  ///< ticks until it is harmed; the horizon if it is not
        double worth = 0;
    };
    [[nodiscard]] int ahead() const;  ///< ticks
    [[nodiscard]] bool is_near_anything(const game::Game& game) const;
    [[nodiscard]] Intent follow(const Course& course, int at, const game::Hero& hero, const dvec3& feet, const Foe* foe,
                                const Steering& steering) const;
    [[nodiscard]] Outlook look(const game::Game& game, Foresight& foresight, const Course& course, int at,
                               const dvec3& wish, const std::function<Steering()>& steering) const;
    void reconsider(const game::Game& game, Foresight& foresight, const dvec3& wish, bool in_air,
                    const std::function<Steering()>& steering);
    [[nodiscard]] Course choose(const game::Game& game, Foresight& foresight, const dvec3& wish,
                                const std::function<Steering()>& steering) const;

    std::shared_ptr<const game::Level> level_;
    double gravity_;  ///< [m/s²]
    Dice dice_;
    Reaction notices_;
    Course course_;
    int at_ = 0;        ///< ticks on this course
    int look_in_ = 0;   ///< ticks until it looks again
    int held_up_ = 0;   ///< ticks for which it has not done what it wanted
    int bold_for_ = 0;  ///< ticks in which it minds only what is about to happen
};

}  // namespace surefoot::playtest
