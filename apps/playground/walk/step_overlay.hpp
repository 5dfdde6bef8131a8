/// What a step was told about: contacts, planes, the ground, probes and the triangles that were asked, in the world.
#pragma once

#include <surefoot/capture_step.hpp>

#include "playground/walk/walker.hpp"
#include "view/renderer.hpp"

namespace surefoot::playground {

class StepOverlay {
public:
    bool contacts = false;   ///< what was touched, where
    bool planes = false;     ///< what is obeyed, and why it is another plane than the triangle's
    bool ground = true;      ///< the normal of what is stood on
    bool probes = false;     ///< for steps and ledges
    bool triangles = false;  ///< that the step asked for
    bool trail = true;       ///< where the body was
    bool velocity = false;   ///< what is wished and what it has
    bool why = true;         ///< in words

    /// Draws the step that led to what `walker` looks at; the body is drawn at `position`.
    void draw(view::Renderer& renderer, const Walker& walker, const dvec3& position);

    /// A check box for each.
    void ui();

    /// Does something need to be seen through the body?
    [[nodiscard]] bool looks_inside() const { return contacts || planes || probes; }

private:
    void draw_triangles(view::Renderer& renderer, const Walker& walker);

    std::vector<CapturedTriangle> asked_;
    const ToldStep* asked_by_ = nullptr;
    CharacterState asked_before_{};
};

/// "step refused: 0.52 of 0.40 m", for a record that decides something; empty for one that does not.
[[nodiscard]] std::string label_of(const StepRecord& record);

}  // namespace surefoot::playground
