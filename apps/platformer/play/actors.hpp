/// Everything in a level that is not its ground: what is collected, who hunts, what flies about, and the dust of it.
#pragma once

#include <vector>

#include "game/game.hpp"
#include "platformer/hero/enemy.hpp"
#include "platformer/hero/particles.hpp"
#include "platformer/hero/pose.hpp"
#include "platformer/screens/palette.hpp"
#include "view/renderer.hpp"

namespace surefoot::platformer {

class Actors {
public:
    explicit Actors(const game::Game& game);

    /// After each tick; `before` is the hero's state when it began.
    void tick(const game::Game& game, const HeroPose& pose, const CharacterState& before, bool reduced_motion);

    void draw(view::Renderer& renderer, const game::Game& game, double blend) const;

    /// Keys have the colours that these eyes tell apart.
    void set_colours(ColourVision colours) { colours_ = colours; }

    [[nodiscard]] const Particles& particles() const { return particles_; }

private:
    struct DrawnEnemy {
        EnemyPose before{};
        EnemyPose pose{};
        bool is_alive = true;
        double gone_for = 0;  // [s]
        bool fires = false;
    };
    void follow_enemies(const game::Game& game, bool reduced_motion);

    std::vector<DrawnEnemy> enemies_;  // one a plan
    std::vector<double> pickups_;      // one a plan: 1 while it is there, shrinking once it is taken
    std::vector<double> flags_;        // of the checkpoints: how high each is raised
    Particles particles_;
    double clock_ = 0;
    bool reduced_motion_ = false;
    ColourVision colours_ = ColourVision::usual;
};

}  // namespace surefoot::platformer
