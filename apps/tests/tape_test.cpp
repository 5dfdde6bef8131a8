#include "playground/walk/tape.hpp"

#include <gtest/gtest.h>

namespace surefoot::playground {
namespace {

TEST(Tape, measures_distance_height_and_slope_along_any_up) {
    const Measured m = measure({0, 0, 0}, {3, 4, 0}, {0, 1, 0});
    EXPECT_DOUBLE_EQ(m.distance, 5);
    EXPECT_DOUBLE_EQ(m.height, 4);
    EXPECT_DOUBLE_EQ(m.flat, 3);
    EXPECT_NEAR(m.slope_deg, 53.130102, 1e-6);
    const Measured down = measure({0, 0, 2}, {1, 0, 1}, {0, 0, 1});
    EXPECT_NEAR(down.slope_deg, -45, 1e-9);
}

}  // namespace
}  // namespace surefoot::playground
