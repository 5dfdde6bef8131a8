/// A frame: what a player sees of a game at one moment, drawn by the library's own rays. No window and no graphics
/// card; the same game gives the same picture, whatever the threads.
#pragma once

#include <span>

#include "playtest/report/frame_camera.hpp"
#include "playtest/report/frame_figures.hpp"
#include "playtest/report/picture.hpp"

namespace surefoot::playtest {

struct FrameSize {
    int width = 480;
    int height = 270;
};

class FramePainter {
public:
    /// Requires: the level outlives it.
    explicit FramePainter(const game::Level& level) : level_(level), figures_(level) {}

    /// `trail`: where the hero has been, drawn as dots. Requires: `camera` is finite.
    [[nodiscard]] Picture paint(const game::Game& game, const FrameCamera& camera, std::span<const dvec3> trail,
                                const FrameSize& size = {}) const;

private:
    const game::Level& level_;
    Figures figures_;
};

}  // namespace surefoot::playtest
