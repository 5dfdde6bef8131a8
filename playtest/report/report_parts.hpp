/// The parts of the page that are drawn.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "playtest/report/plan.hpp"
#include "playtest/report/report.hpp"

namespace surefoot::playtest {

/// As text in HTML: nothing in it is a tag.
[[nodiscard]] std::string escaped(std::string_view text);

/// The plan three times: with markers, with where they stood, with where they looked. Later parts refer to it by the
/// class `plan` and the level's number.
void add_plans(std::string& out, const Findings& of, const PlanFrame& frame, std::size_t level);

[[nodiscard]] std::string colour_of(Incident::Kind kind);

/// "failed jump: fell out of the level, in The ferries".
[[nodiscard]] std::string title_of(const Findings& of, const Incident& incident);

/// Where it happened, from near by and above, with the trail that led there.
[[nodiscard]] std::string from_above(const Incident& incident, const PlanFrame& plan, std::size_t level);

struct IncidentsPart {
    std::size_t level = 0;
    std::string folder{};  ///< of files beside the page
    int framed = 10;       ///< places of which frames are drawn
    std::size_t room = 0;  ///< for pictures and replays [bytes]
    std::function<void(double)> progress{};
};

/// The incidents by place, those to be looked at first in front: frames, the last seconds, the replay.
void add_incidents(Report& report, const Findings& of, const PlanFrame& frame, const IncidentsPart& part);

}  // namespace surefoot::playtest
