// Every seeded fault is caught: the core is compiled a second time with SUREFOOT_SEEDED_FAULTS, one fault is switched
// on at a time, and the judge must refuse answers that it does not refuse without it. Prints which families catch what;
// the table stands in docs/proof.md.
#include <algorithm>
#include <cstdio>
#include <gtest/gtest.h>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "fault.hpp"
#include "judge/runner.hpp"
#include "prove/bridge.hpp"
#include "prove/failure.hpp"

namespace surefoot::tools {
namespace {

using internal::Fault;

struct Named {
    Fault fault;
    const char* name;
};

constexpr Named all_faults[] = {
    {Fault::first_edge_dropped, "first_edge_dropped"},
    {Fault::vertices_dropped, "vertices_dropped"},
    {Fault::face_dropped, "face_dropped"},
    {Fault::larger_root, "larger_root"},
    {Fault::absolute_epsilon, "absolute_epsilon"},
    {Fault::one_ulp_late, "one_ulp_late"},
    {Fault::mirrored_normal, "mirrored_normal"},
    {Fault::padding_along_velocity, "padding_along_velocity"},
    {Fault::parallel_skipped, "parallel_skipped"},
    {Fault::start_in_touch_ignored, "start_in_touch_ignored"},
    {Fault::start_in_touch_always_blocks, "start_in_touch_always_blocks"},
    {Fault::approach_in_doubles, "approach_in_doubles"},
    {Fault::far_end_ignored, "far_end_ignored"},
    {Fault::squash_without_rotation, "squash_without_rotation"},
    {Fault::world_normal_not_unsquashed, "world_normal_not_unsquashed"},
    {Fault::hair_too_thick, "hair_too_thick"},
    {Fault::guess_believed, "guess_believed"},
    {Fault::one_sided_by_rounding, "one_sided_by_rounding"},
};

struct Caught {
    std::uint64_t failures = 0;
    std::map<std::string, std::uint64_t> verdicts;
};

/// Failures by family, with this fault switched on.
std::map<std::string, Caught> failures_with(Fault fault) {
    internal::active_fault() = fault;
    judge::Plan plan;
    plan.queries_per_shape = 4000;
    plan.seed = 7;
    std::map<std::string, Caught> caught;
    plan.record = [&](const judge::Record& record) {
        Caught& family = caught[record.family.name];
        ++family.failures;
        ++family.verdicts[judge::name_of(record.judgement.verdict)];
    };
    (void)judge::run(plan, [] { return judge::Sweep(ask); });
    internal::active_fault() = Fault::none;
    return caught;
}

const std::map<std::string, Caught>& failures_without() {
    static const std::map<std::string, Caught> sound = failures_with(Fault::none);
    return sound;
}

class Faults : public testing::TestWithParam<Named> {};

INSTANTIATE_TEST_SUITE_P(Seeded, Faults, testing::ValuesIn(all_faults),
                         [](const auto& fault) { return std::string(fault.param.name); });

TEST_P(Faults, is_caught) {
    const auto& sound = failures_without();
    std::uint64_t more = 0;
    std::vector<std::pair<std::uint64_t, std::string>> by_family;
    std::map<std::string, std::uint64_t> verdicts;
    for (const auto& [family, caught] : failures_with(GetParam().fault)) {
        const auto before = sound.find(family);
        const std::uint64_t already = before == sound.end() ? 0 : before->second.failures;
        if (caught.failures <= already) continue;
        more += caught.failures - already;
        by_family.emplace_back(caught.failures - already, family);
        for (const auto& [verdict, count] : caught.verdicts) verdicts[verdict] += count;
    }
    std::sort(by_family.rbegin(), by_family.rend());
    std::string line = std::string("| `") + GetParam().name + "` | ";
    for (std::size_t i = 0; i < std::min<std::size_t>(by_family.size(), 4); ++i)
        line += (i == 0 ? "" : ", ") + by_family[i].second + ' ' + std::to_string(by_family[i].first);
    line += " | " + std::to_string(by_family.size()) + " | ";
    std::vector<std::pair<std::uint64_t, std::string>> by_verdict;
    for (const auto& [verdict, count] : verdicts) by_verdict.emplace_back(count, verdict);
    std::sort(by_verdict.rbegin(), by_verdict.rend());
    for (std::size_t i = 0; i < std::min<std::size_t>(by_verdict.size(), 3); ++i)
        line += (i == 0 ? "" : ", ") + by_verdict[i].second + ' ' + std::to_string(by_verdict[i].first);
    std::printf("%s |\n", line.c_str());
    EXPECT_GT(more, 0U) << "the judge was fooled";
}

// What `prove --save-failures` writes: the moment replays as it was judged in the build that was wrong, and differs in
// the one that is right.
TEST(SavedFailures, replay_to_the_wrong_answer_where_the_fault_is_and_differ_elsewhere) {
    internal::active_fault() = Fault::mirrored_normal;
    judge::Plan plan;
    plan.queries_per_shape = 400;
    std::vector<std::string> texts;
    plan.record = [&](const judge::Record& record) { texts.push_back(capture_text(capture_from(record))); };
    (void)judge::run(plan, [] { return judge::Sweep(ask); });
    ASSERT_GT(texts.size(), 100U);
    std::size_t differing = 0;
    for (const std::string& text : texts) {
        const auto capture = parse_capture(text);
        ASSERT_TRUE(capture.has_value()) << capture.error().text;
        EXPECT_FALSE(capture->note.empty());
        internal::active_fault() = Fault::mirrored_normal;
        EXPECT_TRUE(replay(*capture).is_same()) << text;
        internal::active_fault() = Fault::none;
        differing += replay(*capture).differs.normal ? 1 : 0;
    }
    EXPECT_EQ(differing, texts.size());
}

}  // namespace
}  // namespace surefoot::tools
