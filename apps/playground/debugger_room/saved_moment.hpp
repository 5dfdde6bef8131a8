/// A saved moment as the debugger shows it, and the debugger's question as a moment to save.
#pragma once

#include <optional>
#include <string>

#include <surefoot/capture.hpp>
#include <surefoot/error.hpp>

#include "debugger/question.hpp"

namespace surefoot::playground {

struct Moment {
    std::string file;
    Capture capture;
    Replay replay;                ///< asked again by this build
    debugger::Question question;  ///< the same, with its triangles where they are at the beginning of the tick
    std::string remark;           ///< what of the capture the question cannot say; empty if it says all
};

/// Reads a file that `surefoot sweep --save`, the debugger or a game wrote.
[[nodiscard]] Expected<Moment> open_moment(const std::string& file);

/// What a file holds; a `question`, if it cannot be read.
[[nodiscard]] SavedKind kind_of_file(const std::string& file);

/// A question that is asked of a few triangles.
[[nodiscard]] Capture capture_of(const debugger::Question& question, const std::optional<Hit>& answer);

/// Is it the answer of the same build's bits? In a sentence, for people.
[[nodiscard]] std::string verdict_text(const Moment& moment);

/// A name in `folder` that no file has yet: "moment-1.json", "moment-2.json", ...
[[nodiscard]] std::string free_name(const std::string& folder);

}  // namespace surefoot::playground
