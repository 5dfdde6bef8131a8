/// The parts of the page that are drawn.
#pragma once

#include <string>
#include <string_view>

#include "playtest/plan.hpp"
#include "playtest/report.hpp"

namespace surefoot::playtest {

/// As text in HTML: nothing in it is a tag.
[[nodiscard]] std::string escaped(std::string_view text);

/// The plan three times: with markers, with where they stood, with where they looked. Later parts refer to it by the
/// class `plan` and the level's number.
void add_plans(std::string& out, const Findings& of, const PlanFrame& frame, std::size_t level);

/// The incidents, each with a frame and its files; those to be looked at first.
void add_incidents(Report& report, const Findings& of, const PlanFrame& frame, std::size_t level,
                   const std::string& folder);

}  // namespace surefoot::playtest
