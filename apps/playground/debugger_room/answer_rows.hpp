/// A table of candidates as rows of two lines, so that it is read in a narrow panel: what was asked, and what became of
/// it.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "debugger/method_table.hpp"
#include "debugger/plane_table.hpp"
#include "view/colour.hpp"

namespace surefoot::playground {

struct AnswerRow {
    std::string name;
    std::string asked;   ///< the equation, or the plane
    std::string became;  ///< roots, and kept or why not
    view::Colour colour;
    bool kept = false;
    bool answer = false;
};

[[nodiscard]] std::vector<AnswerRow> rows_of(const debugger::MethodTable& table);
[[nodiscard]] std::vector<AnswerRow> rows_of(const debugger::PlaneTable& table);

/// Draws them; a click pins a row and unpins it. Returns the row under the pointer, else the pinned one.
[[nodiscard]] std::optional<std::size_t> answer_rows(const std::vector<AnswerRow>& rows,
                                                     std::optional<std::size_t>& pinned);

}  // namespace surefoot::playground
