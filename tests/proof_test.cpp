// About 1e5 queries of every family and shape, each answer judged in exact numbers. `surefoot prove` runs as many as
// you like; docs/proof.md has the counts of the long runs.
#include <gtest/gtest.h>

#include "judge/runner.hpp"
#include "prove/bridge.hpp"
#include "prove/lines.hpp"

namespace surefoot::tools {
namespace {

class Proof : public testing::TestWithParam<judge::Kind> {};

INSTANTIATE_TEST_SUITE_P(OfEach, Proof,
                         testing::Values(judge::Kind::sphere, judge::Kind::ellipsoid, judge::Kind::capsule,
                                         judge::Kind::box, judge::Kind::cylinder, judge::Kind::cone),
                         [](const auto& shape) { return std::string(judge::name_of(shape.param)); });

TEST_P(Proof, every_answer_of_every_family_is_proved_right) {
    judge::Plan plan;
    plan.queries_per_shape = 17000;
    plan.kinds = {GetParam()};
    plan.threads = 1;  // ctest runs the shapes side by side
    std::string failures;
    int shown = 0;
    plan.record = [&](const judge::Record& record) {
        if (++shown > 5) return;
        append_record(failures, record);
        failures += '\n';
    };
    std::uint64_t failed = 0, asked = 0;
    for (const judge::Row& row : judge::run(plan, [] { return judge::Sweep(ask); })) {
        asked += row.tally.queries;
        failed += row.tally.failures();
        EXPECT_LE(row.tally.worst_gap, 1) << row.family->name;
        if (std::string(row.family->name) != "still") {
            EXPECT_GT(row.tally.hits, row.tally.queries / 20)
                << row.family->name << ": a family without hits proves little";
        }
    }
    EXPECT_GE(asked, plan.queries_per_shape);
    EXPECT_EQ(failed, 0U) << "the first of them:\n" << failures;
}

}  // namespace
}  // namespace surefoot::tools
