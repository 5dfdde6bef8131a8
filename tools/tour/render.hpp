/// Draws a level and figures on the CPU, with rays of our own: sun, sky, shadows, and corners that are darker.
#pragma once

#include <functional>
#include <vector>

#include <surefoot/mesh.hpp>

#include "tour/camera.hpp"
#include "tour/canvas.hpp"
#include "tour/scene.hpp"

namespace surefoot::tools {

struct RenderInput {
    const Mesh* mesh = nullptr;
    Camera camera;
    std::vector<Figure> figures;
    std::vector<Colour> surfaces;  ///< what each surface looks like, linear
    bool one_sided = false;        ///< look through the backs of triangles, so that a roof does not hide the rooms
    double unit = 1;               ///< the size of a body: how far corners darken, how wide lines are [m]
    dvec3 focus{0, 0, 0};          ///< what the picture is about
    double focus_reach = 10;       ///< how far from the focus the level begins to fade into the distance [m]
    std::function<void(double)> progress;  ///< called with the share done [0, 1], from the calling thread
};

[[nodiscard]] Canvas render(const RenderInput& input);

}  // namespace surefoot::tools
