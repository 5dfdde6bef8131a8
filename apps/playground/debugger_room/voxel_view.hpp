/// The voxel lesson as it is seen: the wrong method and the right one on the same blocks, beside each other.
#pragma once

#include <memory>
#include <utility>

#include "playground/debugger_room/voxel_play.hpp"
#include "view/renderer.hpp"

namespace surefoot::playground {

[[nodiscard]] view::Colour colour_of_axis(int axis);

class VoxelView {
public:
    void draw(view::Renderer& renderer, const VoxelPlay& play);

    /// What a camera should look at, as a ball. It lies to the right of it all, for there a panel is in the way.
    [[nodiscard]] static std::pair<dvec3, double> frame(const VoxelPlay& play);

private:
    void build(const debugger::VoxelScene& scene);
    void draw_side(view::Renderer& renderer, const VoxelPlay& play, const VoxelTale& tale) const;

    std::shared_ptr<const view::Model> floor_;
    std::size_t built_ = 0;  // for which story
};

}  // namespace surefoot::playground
