/// A saved moment in words: what was asked, what came out, and why. For the command line and the debugger.
#pragma once

#include <optional>
#include <string>

#include <surefoot/capture.hpp>

namespace surefoot::tools {

/// The question, in a sentence or two.
[[nodiscard]] std::string question_text(const Capture& capture);

/// An answer, in lines.
[[nodiscard]] std::string moment_answer_text(const CapturedQuestion& question, const std::optional<Hit>& hit);

/// Which parts of the two answers have other bits: "t and normal".
[[nodiscard]] std::string difference_text(const AnswerDifference& differs);

/// Why this build answers as it does: which triangle stopped the motion, and which plane; or what keeps all of them
/// apart. Plain sentences, each a line.
[[nodiscard]] std::string why_text(const Capture& capture, const std::optional<Hit>& answer);

/// Saves, or ends the command as a file that cannot be written does.
void save_moment(const Capture& capture, const std::string& path);

}  // namespace surefoot::tools
