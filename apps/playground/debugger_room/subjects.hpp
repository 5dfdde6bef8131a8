/// Which triangles of a world are worth a close look: all of a few, and of a level those that the sweep asked.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "playground/debugger_room/panel.hpp"

namespace surefoot::playground {

struct Subject {
    std::uint32_t id = 0;
    Triangle triangle;
};

/// No more than this many of a level.
inline constexpr std::size_t most_subjects = 12;

/// In the order of their ids; the one that was hit is always among them.
[[nodiscard]] std::vector<Subject> subjects_of(const Inquiry& inquiry);

/// Which of them comes first to mind: the one that was hit, else the one that the motion comes nearest to.
/// Requires: there is one, and a valid question.
[[nodiscard]] std::size_t foremost(const std::vector<Subject>& subjects, const Inquiry& inquiry);

/// Why there is no answer to take apart, in words; nothing if there is one.
[[nodiscard]] std::optional<std::string> why_no_answer(const Inquiry& inquiry);

}  // namespace surefoot::playground
