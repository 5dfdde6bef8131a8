/// What of a question and its answer is drawn into the world.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "playground/debugger_room/grips.hpp"
#include "playground/debugger_room/investigation.hpp"
#include "view/model.hpp"
#include "view/renderer.hpp"

namespace surefoot::playground {

/// What is to be seen.
struct SceneLook {
    bool start = true;
    bool end = true;
    bool hit = true;
    bool result = true;
    bool contact = true;  ///< the point, the normal and the feature
    bool ways = true;     ///< the arrows from START to HIT and on
    bool labels = true;
};

/// The section in which that is chosen.
void look_ui(SceneLook& look);

class Scene {
public:
    SceneLook look;

    /// The world, both ends and the answer; `t` is the moment that is looked at.
    void draw(view::Renderer& renderer, const Investigation& asked, double t);

    /// What can be taken hold of. `selected` shows its arrows and its box, `hovered` is under the pointer.
    void draw_grips(view::Renderer& renderer, const debugger::Question& question, const std::optional<Target>& selected,
                    const std::optional<Grip>& hovered) const;

private:
    void draw_world(view::Renderer& renderer, const Investigation& asked);

    std::shared_ptr<view::Model> model_;
    std::uint64_t model_is_ = 0;  // of which version of the world
};

/// All of a question that one wants to see at once: the motion, the answer, and the world if it is a few triangles.
[[nodiscard]] std::vector<dvec3> places_of(const Investigation& asked);

}  // namespace surefoot::playground
