#include "playtest/report/incident_groups.hpp"

#include <gtest/gtest.h>

#include "made_levels.hpp"

namespace surefoot::playtest {
namespace {

using Kind = Incident::Kind;

// Runs that have no inputs cannot be played again.
PlayedRun run_of(std::vector<Incident> incidents, bool can_be_played = true) {
    PlayedRun run;
    run.telemetry.incidents = std::move(incidents);
    if (can_be_played) run.recording.inputs.resize(60);
    return run;
}

Incident at(Kind kind, double x, double y = 0, std::uint64_t tick = 60) {
    return {.kind = kind, .tick = tick, .place = {x, y, 0}};
}

Findings findings(std::vector<PlayedRun> runs) {
    return {.level = test::LevelMaker().finish(), .runs = std::move(runs)};
}

TEST(IncidentGroups, are_of_one_kind_and_one_place) {
    const auto of = findings({run_of(
        {at(Kind::death, 0), at(Kind::death, 3), at(Kind::death, 9), at(Kind::death, 0, 20), at(Kind::stuck, 0)})});
    EXPECT_EQ(group_incidents(of).size(), 4U);
    EXPECT_EQ(group_incidents(of)[1].members.size(), 2U) << "after the stuck one, the place where most died";
}

TEST(IncidentGroups, come_in_the_order_in_which_they_have_to_be_looked_at) {
    const auto of = findings({run_of({at(Kind::death, 0), at(Kind::death, 1), at(Kind::failed_jump, 50, 0, 500),
                                      at(Kind::stuck, 0), at(Kind::not_a_number, 0), at(Kind::escape, 0)})});
    std::vector<Kind> kinds;
    for (const IncidentGroup& group : group_incidents(of)) kinds.push_back(incident_of(of, group.shown).kind);
    EXPECT_EQ(kinds, (std::vector{Kind::not_a_number, Kind::escape, Kind::stuck, Kind::death, Kind::failed_jump}));
}

TEST(IncidentGroups, tell_of_a_death_once_if_it_was_a_failed_jump) {
    const auto of =
        findings({run_of({at(Kind::failed_jump, 0, 0, 90), at(Kind::death, 4, -9, 90), at(Kind::death, 30, 0, 200)})});
    const auto groups = group_incidents(of);
    ASSERT_EQ(groups.size(), 2U);
    EXPECT_EQ(incident_of(of, groups[0].shown).kind, Kind::failed_jump);
    EXPECT_EQ(incident_of(of, groups[1].shown).tick, 200U);
}

TEST(IncidentGroups, are_shown_from_as_few_runs_as_will_do) {
    // Each place has its own run, and the last run has been everywhere.
    const auto of = findings({run_of({at(Kind::death, 0)}), run_of({at(Kind::death, 20)}),
                              run_of({at(Kind::death, 0), at(Kind::death, 20), at(Kind::death, 40)})});
    for (const IncidentGroup& group : group_incidents(of)) EXPECT_EQ(group.shown.run, 2U);
}

TEST(IncidentGroups, are_shown_from_a_run_that_can_be_played_again) {
    const auto of = findings({run_of({at(Kind::stuck, 0), at(Kind::stuck, 20)}, false), run_of({at(Kind::stuck, 1)})});
    const auto groups = group_incidents(of);
    ASSERT_EQ(groups.size(), 2U);
    EXPECT_EQ(groups[0].shown, (IncidentAt{1, 0}));
    EXPECT_EQ(groups[1].shown, (IncidentAt{0, 1}));
}

}  // namespace
}  // namespace surefoot::playtest
