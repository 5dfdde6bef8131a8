/// What a level looks like: its meshes with the colours of their materials, its water and its sky.
#pragma once

#include <memory>
#include <vector>

#include "game/game.hpp"
#include "view/model.hpp"
#include "view/renderer.hpp"

namespace surefoot::platformer {

/// Of the hour that a level names: "day", "dusk", "night", "cave"; the day for any other word.
[[nodiscard]] view::Sky sky_of(const std::string& name);

class LevelLook {
public:
    /// Reads the level's meshes once. Requires: the level outlives it.
    explicit LevelLook(const game::Level& level);

    /// Draws what stands, and what moves where it is `blend` of the way through the tick.
    void draw(view::Renderer& renderer, const game::Game& game, double blend) const;

    [[nodiscard]] const game::Level& level() const { return level_; }

private:
    const game::Level& level_;
    std::shared_ptr<const view::Model> ground_;
    std::shared_ptr<const view::Model> decor_;
    std::vector<std::shared_ptr<const view::Model>> bodies_;  // one a plan
};

}  // namespace surefoot::platformer
