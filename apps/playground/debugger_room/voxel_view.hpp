/// The voxel lesson as it is seen: the wrong method and the right one on the same blocks, beside each other.
#pragma once

#include <memory>

#include "playground/debugger_room/voxel_play.hpp"
#include "view/renderer.hpp"

namespace surefoot::playground {

namespace voxel_paint {
inline constexpr view::Colour looked_at = view::paint::face;
inline constexpr view::Colour stopper = view::paint::hit;
inline constexpr view::Colour trap = view::rgb(0xB3122E);  ///< what it stands in
}  // namespace voxel_paint

[[nodiscard]] view::Colour colour_of_axis(int axis);

class VoxelView {
public:
    void draw(view::Renderer& renderer, const VoxelPlay& play);

    /// The corners of all that is drawn.
    [[nodiscard]] static std::vector<dvec3> places(const VoxelPlay& play);

private:
    void build(const debugger::VoxelScene& scene);
    void draw_side(view::Renderer& renderer, const VoxelPlay& play, const VoxelTale& tale) const;

    std::shared_ptr<const view::Model> floor_;
    std::size_t built_ = 0;  // for which story
};

}  // namespace surefoot::playground
