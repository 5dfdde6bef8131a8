/// A level being played: all of its rules, sixty times a second. No window, no sound, no clock: the same level and the
/// same inputs give the same game, bit for bit, so that a run is its inputs.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <surefoot/slab.hpp>
#include <surefoot/world.hpp>

#include "game/event.hpp"
#include "game/hero.hpp"
#include "game/level.hpp"
#include "game/things.hpp"

namespace surefoot::game {

class EnemyMinds;

enum class Outcome : std::uint8_t {
    playing,
    won,
    lost,  ///< no health is left, or no time; `Game::retry` goes on from the checkpoint
};

struct GameStart {
    /// Where the hero begins, of `Level::checkpoints`; nothing before it was done or taken.
    std::uint32_t checkpoint = 0;
    /// Once it is true, a start that takes long ends soon and fails with `invalid`; null: nobody stops it.
    const std::atomic<bool>* stop = nullptr;
};

/// Threads: one at a time. Memory: made at the start; `tick` allocates only where enemies plan their ways.
class Game {
public:
    /// Fails as `World::add` does, and with `invalid` for a checkpoint that the level does not have. The first start of
    /// a level with enemies who jump takes seconds: their ways are looked for, and kept for the next time.
    [[nodiscard]] static Expected<std::unique_ptr<Game>> start(std::shared_ptr<const Level> level,
                                                               const GameStart& how = {});
    ~Game();
    Game(const Game&) = delete;
    Game& operator=(const Game&) = delete;

    /// One tick of `tick_seconds`. What happened is in `events` until the next. Does nothing once it is won or lost.
    void tick(const HeroInput& input);

    /// From the last checkpoint: what was taken stays taken, the clock goes on. After `lost` with all hearts; whenever
    /// the player has had enough of where they are with those that are left, so that it heals nothing. Does nothing
    /// where it cannot go on.
    void retry();
    /// Not after it was won, nor once the time is up: then there is only the beginning.
    [[nodiscard]] bool can_retry() const;

    /// The player has had enough: lost.
    void give_up();

    [[nodiscard]] const Level& level() const { return *level_; }
    [[nodiscard]] const std::shared_ptr<const Level>& level_pointer() const { return level_; }
    [[nodiscard]] Outcome outcome() const { return outcome_; }
    [[nodiscard]] Cause cause() const { return cause_; }  ///< of the last loss of a heart, or of the game
    [[nodiscard]] std::span<const GameEvent> events() const { return events_; }
    [[nodiscard]] std::uint64_t ticks() const { return ticks_; }
    [[nodiscard]] double seconds() const { return double(ticks_) * tick_seconds; }

    [[nodiscard]] const World& world() const { return world_; }
    [[nodiscard]] const CharacterSettings& settings() const { return settings_; }
    [[nodiscard]] const Hero& hero() const { return hero_; }
    [[nodiscard]] const Hero& hero_before() const { return hero_before_; }  ///< when the tick began, to draw between
    [[nodiscard]] dvec3 feet() const;

    [[nodiscard]] const Slab<MovingBody>& bodies() const { return bodies_; }
    [[nodiscard]] const Slab<Pickup>& pickups() const { return pickups_; }
    [[nodiscard]] const Slab<Enemy>& enemies() const { return enemies_; }
    [[nodiscard]] const Slab<Bullet>& bullets() const { return bullets_; }

    [[nodiscard]] int coins() const { return coins_; }
    [[nodiscard]] int stars() const { return stars_; }
    [[nodiscard]] bool has_star(std::uint32_t plan) const;  ///< of `Level::pickups`
    [[nodiscard]] const std::vector<std::string>& keys() const { return keys_; }
    [[nodiscard]] std::uint32_t checkpoint() const { return checkpoint_; }  ///< of `Level::checkpoints`
    [[nodiscard]] std::uint32_t begun_at() const { return begun_at_; }      ///< the checkpoint at which it was started
    [[nodiscard]] std::uint32_t deaths() const { return deaths_; }          ///< hearts lost by falls and games lost
    [[nodiscard]] const Prompt* prompt() const;                             ///< of the zone the hero stands in

    /// What the hero was told in the last tick, as `step` saw it: for captures of a moment that went wrong.
    [[nodiscard]] const CharacterInput& last_input() const { return last_input_; }

    /// Over everything that the next tick depends on.
    [[nodiscard]] std::uint64_t hash() const;

private:
    explicit Game(std::shared_ptr<const Level> level);
    [[nodiscard]] Expected<void> build(const std::atomic<bool>* stop);

    void move_bodies();
    void move_hero(const HeroInput& input);
    [[nodiscard]] CharacterInput told(const HeroInput& input);
    void say_what_the_hero_did();
    void touch_bodies();
    void touch_harm();
    void touch_pickups();
    void touch_checkpoints();
    void open_doors();
    void move_enemies();
    void touch_enemies();
    void move_bullets();
    void hurt(int hearts, Cause cause, const dvec3& from);
    void fall(Cause cause);
    void stand_at_checkpoint();
    void lose(Cause cause);
    void say(Happening what, const dvec3& place, double strength = 0, std::uint32_t number = 0,
             Cause cause = Cause::none);

    std::shared_ptr<const Level> level_;
    World world_;
    std::uint32_t ground_body_ = 0;  // of the still ground, its number in the world
    CharacterSettings settings_;
    Hero hero_;
    Hero hero_before_;
    CharacterInput last_input_{};
    Slab<MovingBody> bodies_;
    Slab<Pickup> pickups_;
    Slab<Enemy> enemies_;
    Slab<Bullet> bullets_;
    std::unique_ptr<EnemyMinds> minds_;
    bool has_harm_ = false;  // anything deadly, or a hazard
    std::vector<std::uint32_t> taken_stars_;
    std::vector<std::string> keys_;
    std::vector<GameEvent> events_;
    Outcome outcome_ = Outcome::playing;
    Cause cause_ = Cause::none;
    std::uint64_t ticks_ = 0;
    int coins_ = 0;
    int stars_ = 0;
    std::uint32_t begun_at_ = 0;
    std::uint32_t checkpoint_ = 0;
    std::uint32_t deaths_ = 0;
};

}  // namespace surefoot::game
