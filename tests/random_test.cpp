#include <gtest/gtest.h>

#include <surefoot/random.hpp>

namespace surefoot::tests {
namespace {

TEST(Random, is_the_row_that_its_paper_gives) {
    std::uint64_t state = 1234567;
    for (const std::uint64_t expected : {6457827717110365317U, 3203168211198807973U, 9817491932198370423U,
                                         4593380528125082431U, 16408922859458223821U})
        EXPECT_EQ(next_random(state), expected);
    state = 0;
    EXPECT_EQ(next_random(state), 0xe220a8397b1dcdafU);
}

TEST(Random, goes_back_with_its_state) {
    std::uint64_t state = 7;
    static_cast<void>(next_random(state));
    const std::uint64_t kept = state;
    const std::uint64_t then = next_random(state);
    state = kept;
    EXPECT_EQ(next_random(state), then);
}

TEST(Random, has_shares_that_are_spread_evenly_below_one) {
    std::uint64_t state = 3;
    int tenths[10] = {};
    for (int i = 0; i < 100000; ++i) {
        const double share = next_share(state);
        ASSERT_GE(share, 0);
        ASSERT_LT(share, 1);
        ++tenths[static_cast<int>(share * 10)];
    }
    for (const int count : tenths) EXPECT_NEAR(count, 10000, 400);
}

}  // namespace
}  // namespace surefoot::tests
