/// What a level looks like: its meshes with the colours of their materials, its water and its sky.
#pragma once

#include <memory>
#include <vector>

#include "game/game.hpp"
#include "platformer/play/halos.hpp"
#include "platformer/play/sky_look.hpp"
#include "view/model.hpp"
#include "view/renderer.hpp"

namespace surefoot::platformer {

class LevelLook {
public:
    /// Reads the level's meshes once. Requires: the level outlives it.
    explicit LevelLook(const game::Level& level);

    /// Draws the sky, what stands, and what moves where it is `blend` of the way through the tick.
    void draw(view::Renderer& renderer, const game::Game& game, double blend) const;

    [[nodiscard]] const game::Level& level() const { return level_; }

private:
    const game::Level& level_;
    SkyLook sky_;
    std::shared_ptr<const view::Model> ground_;
    std::shared_ptr<const view::Model> decor_;
    std::vector<std::shared_ptr<const view::Model>> bodies_;  // one a plan
    std::vector<view::Disc> halos_;
};

}  // namespace surefoot::platformer
