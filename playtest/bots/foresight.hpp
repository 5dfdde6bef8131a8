/// What will be, if nobody does anything else: a copy of the level's bodies that is moved ahead in time, and a hero in
/// it, with those who hunt it. People see a lift come; this is how a bot does.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <surefoot/world.hpp>

#include "game/game.hpp"
#include "playtest/bots/hands.hpp"
#include "playtest/bots/threats.hpp"

namespace surefoot::playtest {

class Foresight {
public:
    /// Fails as `World::add` does.
    [[nodiscard]] static Expected<std::unique_ptr<Foresight>> make(std::shared_ptr<const game::Level> level);

    /// As it is now.
    void look(const game::Game& game);

    /// A hero who has come to stand here, alone; the bodies are where they are.
    void put(const dvec3& feet);

    /// One tick on. False if the hero was harmed in it, crushed, or fell out of the level.
    [[nodiscard]] bool tick(const game::HeroInput& input);

    [[nodiscard]] const game::Hero& hero() const { return hero_; }
    [[nodiscard]] dvec3 feet() const;
    [[nodiscard]] const World& world() const { return world_; }
    [[nodiscard]] Pose pose(std::size_t body) const { return bodies_[body].now; }  ///< of `Level::bodies`
    [[nodiscard]] bool is_there(std::size_t body) const { return bodies_[body].is_there; }
    [[nodiscard]] const Threats& threats() const { return threats_; }

    /// Nobody in it hunts or shoots any more, until it looks again: for whoever has waited long enough.
    void ignore_threats() { threats_.clear(); }

    /// How fast it moves at a place in this tick [m/s].
    [[nodiscard]] dvec3 velocity(std::size_t body, const dvec3& place) const {
        return world_.velocity_at(bodies_[body].handle, place, game::tick_seconds);
    }

    /// The number in the world of one of `Level::bodies`, and back; `bodies` of them for what is none.
    [[nodiscard]] static std::uint32_t number_of(std::size_t body) { return std::uint32_t(body) + 1; }
    [[nodiscard]] std::size_t body_count() const { return bodies_.size(); }
    [[nodiscard]] std::size_t body_of(std::uint32_t number) const {
        return number >= 1 && number <= bodies_.size() ? number - 1 : bodies_.size();
    }

private:
    struct Body {
        BodyHandle handle{};
        Pose now{};
        double clock = 0;
        bool runs = true;
        bool is_there = true;
    };

    explicit Foresight(std::shared_ptr<const game::Level> level);
    [[nodiscard]] bool is_harmed() const;
    [[nodiscard]] bool is_hunted_down(double rising);

    std::shared_ptr<const game::Level> level_;
    World world_;
    CharacterSettings settings_;
    std::vector<Body> bodies_;
    Threats threats_;
    game::Hero hero_;
    bool has_harm_ = false;
};

/// Moments all through a round of its route, or its one moment [s].
[[nodiscard]] std::vector<double> clocks_of(const game::BodyPlan& plan);

/// Where one of the level's bodies is after `clock` seconds of its route.
[[nodiscard]] Pose pose_at(const game::BodyPlan& plan, double clock);

}  // namespace surefoot::playtest
