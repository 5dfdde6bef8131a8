/// The incidents of many runs put together by kind and place: where twenty fell off one edge, one of them is looked at.
#pragma once

#include <cstddef>
#include <vector>

#include "playtest/campaign.hpp"

namespace surefoot::playtest {

/// An incident, by the places of its run in the findings and of itself in the run.
struct IncidentAt {
    std::size_t run = 0;
    std::size_t incident = 0;

    friend bool operator==(const IncidentAt&, const IncidentAt&) = default;
};

struct IncidentGroup {
    std::vector<IncidentAt> members{};  ///< in the order of the runs
    IncidentAt shown{};                 ///< one of them
};

[[nodiscard]] const Incident& incident_of(const Findings& findings, const IncidentAt& at);

/// What has to be looked at first: what should never be, then what is stuck, then what happens most often. A death of a
/// jump that failed is told by the failed jump. Who is shown is from a run that can be replayed, and from as few runs
/// as will do.
[[nodiscard]] std::vector<IncidentGroup> group_incidents(const Findings& findings);

}  // namespace surefoot::playtest
