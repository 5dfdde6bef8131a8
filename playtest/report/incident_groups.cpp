#include "playtest/report/incident_groups.hpp"

#include <algorithm>
#include <array>
#include <set>

#include "playtest/vectors.hpp"

namespace surefoot::playtest {
namespace {

constexpr double one_place = 4;  // so near to the first of a group it is the same place, seen from above [m]
constexpr double one_floor = 6;  // and so near in height [m]

// Whose rank is lower is looked at first.
int rank_of(Incident::Kind kind) {
    switch (kind) {
        case Incident::Kind::not_a_number:
            return 0;
        case Incident::Kind::escape:
            return 1;
        case Incident::Kind::overflow:
            return 2;
        case Incident::Kind::stuck:
            return 3;
        case Incident::Kind::failed_jump:
        case Incident::Kind::death:
            break;
    }
    return 4;
}

bool belongs(const Incident& incident, const Incident& first) {
    return incident.kind == first.kind && incident.cause == first.cause &&
           flat_length(incident.place - first.place) < one_place &&
           std::abs(incident.place.y - first.place.y) < one_floor;
}

// Is it the death of a jump that is an incident of its own?
bool is_told_already(const Telemetry& told, const Incident& incident) {
    return incident.kind == Incident::Kind::death && std::ranges::any_of(told.incidents, [&](const Incident& other) {
               return other.kind == Incident::Kind::failed_jump && other.tick == incident.tick;
           });
}

// Groups in turn, each from a run that others are shown from already, if it can; else from the run that most of the
// groups that are left have a part in.
void choose_shown(std::vector<IncidentGroup>& groups, const Findings& findings) {
    std::vector<std::size_t> parts(findings.runs.size(), 0);
    for (const IncidentGroup& group : groups) {
        std::set<std::size_t> runs;
        for (const IncidentAt& at : group.members) runs.insert(at.run);
        for (const std::size_t run : runs) ++parts[run];
    }
    std::vector<bool> is_used(findings.runs.size(), false);
    const auto worth = [&](const IncidentAt& at) {
        const bool can_be_played = !findings.runs[at.run].recording.inputs.empty();
        return std::array<std::size_t, 3>{can_be_played ? 1U : 0U, is_used[at.run] ? 1U : 0U, parts[at.run]};
    };
    for (IncidentGroup& group : groups) {
        group.shown = *std::ranges::max_element(group.members, {}, worth);
        is_used[group.shown.run] = true;
    }
}

}  // namespace

const Incident& incident_of(const Findings& findings, const IncidentAt& at) {
    return findings.runs[at.run].telemetry.incidents[at.incident];
}

std::vector<IncidentGroup> group_incidents(const Findings& findings) {
    std::vector<IncidentGroup> groups;
    for (std::size_t run = 0; run < findings.runs.size(); ++run) {
        const Telemetry& told = findings.runs[run].telemetry;
        for (std::size_t i = 0; i < told.incidents.size(); ++i) {
            if (is_told_already(told, told.incidents[i])) continue;
            const auto group = std::ranges::find_if(groups, [&](const IncidentGroup& of) {
                return belongs(told.incidents[i], incident_of(findings, of.members.front()));
            });
            if (group != groups.end())
                group->members.push_back({run, i});
            else
                groups.push_back({.members = {{run, i}}, .shown = {run, i}});
        }
    }
    std::ranges::stable_sort(groups, [&](const IncidentGroup& a, const IncidentGroup& b) {
        const int rank_a = rank_of(incident_of(findings, a.members.front()).kind);
        const int rank_b = rank_of(incident_of(findings, b.members.front()).kind);
        return rank_a != rank_b ? rank_a < rank_b : a.members.size() > b.members.size();
    });
    choose_shown(groups, findings);
    return groups;
}

}  // namespace surefoot::playtest
