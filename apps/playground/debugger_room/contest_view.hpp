/// The contest as it is seen: each contestant on a piece of the course of its own, beside the others.
#pragma once

#include <memory>

#include "playground/debugger_room/contest.hpp"
#include "view/renderer.hpp"

namespace surefoot::playground {

[[nodiscard]] view::Colour colour_of_contestant(std::size_t i);

/// How a gap under a shape on a slope follows from its size and the angle, in letters.
[[nodiscard]] const char* formula_of_contestant(std::size_t i);

class ContestView {
public:
    void draw(view::Renderer& renderer, const Contest& contest);

    /// The corners of all that is drawn, whatever the angle of a slope.
    [[nodiscard]] static std::vector<dvec3> places(const Contest& contest);

    /// From where a place of the course is seen: contestants share one course, and are drawn beside each other.
    [[nodiscard]] static dvec3 placed(const Contest& contest, std::size_t i, const dvec3& place);

private:
    void build(const Contest& contest);

    std::shared_ptr<const view::Model> model_;
    Course built_course_ = Course::slope;  // for which the model was made
    double built_angle_ = 0;
};

}  // namespace surefoot::playground
