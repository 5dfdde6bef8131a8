/// A saved step as a question: the body before it is START, what it wanted leads to END, and its own triangles are the
/// world.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <surefoot/capture_step.hpp>
#include <surefoot/error.hpp>

#include "debugger/question.hpp"

namespace surefoot::debugger {

struct SavedStep {
    std::string file;
    StepCapture capture;
    std::string differs;  ///< from what this build makes of it, first; empty if no bit does
    Question question;
    std::string remark;  ///< what of it the question cannot say; empty if it says all
};

/// Reads a file that `capture_step` was written to.
[[nodiscard]] Expected<SavedStep> open_step(const std::string& file);

/// The same of such a file's text.
[[nodiscard]] Expected<SavedStep> step_from_text(std::string_view text, std::string_view file);

/// Does this build make the same bits of it? In a sentence, for people.
[[nodiscard]] std::string verdict_text(const SavedStep& step);

/// Is the body anywhere else than at its source's own places, or does it move?
[[nodiscard]] bool is_placed(const CapturedBody& body);

/// Where a captured triangle is in the world, at a time of the tick [0, 1].
[[nodiscard]] Triangle placed(std::span<const CapturedBody> bodies, const CapturedTriangle& one, double at);

/// Where it is when the tick begins; none if the capture has no such triangle.
[[nodiscard]] std::optional<Triangle> triangle_at_start(const StepCapture& capture, std::uint32_t body,
                                                        std::uint32_t triangle);

}  // namespace surefoot::debugger
