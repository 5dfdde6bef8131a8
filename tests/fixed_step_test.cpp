#include <cmath>
#include <gtest/gtest.h>

#include <surefoot/fixed_step.hpp>

namespace surefoot::tests {
namespace {

int due(FixedStep& clock, double seconds) {
    clock.add(seconds);
    int steps = 0;
    while (clock.due()) ++steps;
    return steps;
}

TEST(FixedStep, TakesAsManyStepsAsTimeHasPassedWhateverTheFrames) {
    FixedStep clock{.step = 0.25};
    EXPECT_EQ(due(clock, 0.125), 0);
    EXPECT_DOUBLE_EQ(clock.blend(), 0.5);
    EXPECT_EQ(due(clock, 0.125), 1);
    EXPECT_DOUBLE_EQ(clock.blend(), 0);
    FixedStep fine{.step = 1.0 / 64};
    int steps = 0;
    for (int frame = 0; frame < 100; ++frame) steps += due(fine, frame % 2 == 0 ? 0.0078125 : 0.0234375);
    EXPECT_EQ(steps, 100);
}

TEST(FixedStep, AFrameThatTookTooLongLetsTheGameFallBehind) {
    FixedStep clock{.step = 0.01, .most = 0.1};
    EXPECT_LE(due(clock, 60), 10);
    EXPECT_LT(clock.blend(), 1);
}

TEST(FixedStep, NumbersThatMakeNoSenseTakeNoSteps) {
    FixedStep clock{};
    EXPECT_EQ(due(clock, -1), 0);
    EXPECT_EQ(due(clock, std::nan("")), 0);
    FixedStep broken{.step = 0};
    EXPECT_EQ(due(broken, 1), 0);
    EXPECT_EQ(broken.blend(), 0);
}

}  // namespace
}  // namespace surefoot::tests
