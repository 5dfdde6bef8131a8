// The benchmark of agents measures agents that get somewhere.
#include <gtest/gtest.h>

#include "agents.hpp"

namespace surefoot::tests {
namespace {

// Broken variants: goals inside of houses; agents that stand in each other's way for ever.
TEST(BenchAgents, AgentsOfTheTownArriveAndNobodyGivesUp) {
    const bench::AgentsReport report = bench::run_agents({.agents = 60, .ticks = 600, .settling = 60, .blocks = 4});
    EXPECT_GT(report.arrivals, 60U);
    EXPECT_EQ(report.gave_up, 0U);
    EXPECT_GT(report.speed, 4);
    EXPECT_LT(report.touching, 0.1);
}

}  // namespace
}  // namespace surefoot::tests
