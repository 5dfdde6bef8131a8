/// What walks, hunts and flies by itself, a little ahead in time, as somebody knows it who has met it before: a chaser
/// comes straight, a guard walks his round, a jumper leaps from near, a shooter shoots when it has loaded.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include <surefoot/world.hpp>

#include "game/game.hpp"

namespace surefoot::playtest {

/// An enemy as it will be.
struct Foe {
    std::uint32_t plan = 0;  ///< of `Level::enemies`
    CharacterState body{};
    game::Enemy::Mood mood = game::Enemy::Mood::calm;
    double since = 0;        ///< in this mood [s]
    double reload = 0;       ///< [s]
    std::uint32_t stop = 0;  ///< of its round
    bool is_there = true;    ///< not stomped yet
};

/// A shot on its way.
struct Shot {
    dvec3 place{0, 0, 0};
    dvec3 velocity{0, 0, 0};
    double left = 0;  ///< until it is gone [s]
};

class Threats {
public:
    explicit Threats(std::shared_ptr<const game::Level> level);

    /// As it is now, as far as it can come near the hero soon.
    void look(const game::Game& game);
    void clear();

    enum class Meeting : std::uint8_t { nothing, stomped, harmed };
    /// One tick on, after the hero's. `rising`: how fast the hero rose when the tick began [m/s].
    [[nodiscard]] Meeting tick(const World& world, const game::Hero& hero, double rising,
                               const CharacterSettings& settings);

    [[nodiscard]] bool are_any() const { return !foes_.empty() || !shots_.empty(); }
    [[nodiscard]] std::span<const Foe> foes() const { return foes_; }
    [[nodiscard]] std::span<const Shot> shots() const { return shots_; }

private:
    void move(const World& world, const game::Hero& hero, const dvec3& feet, Foe& foe) const;
    void shoot(const World& world, const game::Hero& hero, Foe& foe);
    void walk(const World& world, const game::Hero& hero, const dvec3& feet, Foe& foe) const;
    [[nodiscard]] Meeting meet(const game::Hero& hero, const dvec3& feet, double rising,
                               const CharacterSettings& settings);

    std::shared_ptr<const game::Level> level_;
    CharacterSettings settings_;  ///< of enemies
    std::vector<Foe> foes_;
    std::vector<Shot> shots_;
    int ticks_ = 0;
};

}  // namespace surefoot::playtest
