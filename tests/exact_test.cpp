// Exact numbers and reals, against integers and against what is known.
#include <cstdint>
#include <gtest/gtest.h>

#include "exact/number.hpp"
#include "exact/products.hpp"
#include "exact/real.hpp"
#include "splitmix.hpp"

namespace surefoot::internal {
namespace {

using Number = ExactNumber<64>;

TEST(ExactNumber, adds_multiplies_and_compares_like_integers) {
    tests::SplitMix random(1);
    for (int i = 0; i < 20000; ++i) {
        const auto a = static_cast<std::int64_t>(random.next() >> 34) - (std::int64_t{1} << 29);
        const auto b = static_cast<std::int64_t>(random.next() >> 34) - (std::int64_t{1} << 29);
        const Number x(static_cast<double>(a));
        const Number y(static_cast<double>(b));
        EXPECT_EQ(compare(x + y, Number(static_cast<double>(a + b))), 0);
        EXPECT_EQ(compare(x - y, Number(static_cast<double>(a - b))), 0);
        // 60 bits do not fit a double: split the expected product instead.
        const std::int64_t product = a * b;
        const std::int64_t high = product / (std::int64_t{1} << 30);
        const std::int64_t low = product % (std::int64_t{1} << 30);
        const Number expected = Number(static_cast<double>(high)) * Number(0x1p30) + Number(static_cast<double>(low));
        EXPECT_EQ(compare(x * y, expected), 0);
        EXPECT_EQ(compare(x, y), a < b ? -1 : (a > b ? 1 : 0));
    }
}

TEST(ExactNumber, loses_nothing_between_the_largest_and_the_smallest_double) {
    const Number huge(1e9);
    const Number tiny(5e-324);
    const Number sum = huge + tiny;
    EXPECT_EQ(compare(sum, huge), 1);
    EXPECT_EQ(compare(sum - huge, tiny), 0);
    EXPECT_EQ((sum - huge - tiny).sign(), 0);
    EXPECT_FALSE(sum.overflowed());
}

TEST(ExactNumber, says_when_a_result_has_no_room) {
    ExactNumber<8> number(1.0 / 3.0);
    for (int i = 0; i < 4; ++i) number = number * number;
    EXPECT_TRUE(number.overflowed());
    EXPECT_TRUE((number + ExactNumber<8>(1.0)).overflowed());
}

TEST(ExactNumber, a_ratio_is_right_beyond_the_range_of_doubles) {
    const Number tiny(0x1p-1000);
    const Number product = tiny * tiny * Number(3.0);
    EXPECT_EQ(ratio(product, tiny * tiny * Number(4.0)), 0.75);
    EXPECT_EQ(ratio(-product, product), -1.0);
}

TEST(Real, division_and_roots_undo_multiplication_to_four_hundred_and_seventy_digits) {
    tests::SplitMix random(2);
    for (int i = 0; i < 300; ++i) {
        const Real a(random.in(-1e9, 1e9));
        const Real b(random.in(1e-9, 10.0));
        const Real back = a / b * b - a;
        const Real limit = Real(1e9 * 0x1p-470);
        EXPECT_TRUE(back < limit && -back < limit);
        const Real root = square_root(b);
        const Real square = root * root - b;
        EXPECT_TRUE(square < limit && -square < limit);
    }
}

TEST(Real, the_wide_one_tells_an_ulp_of_zero_from_nothing_next_to_a_thousand_million) {
    const auto rest = []<typename Scalar>(Scalar large) {
        const Scalar sum = large + Scalar(5e-324);
        return sign_of(square_root(sum * sum) / large - Scalar(1.0));
    };
    EXPECT_EQ(rest(WideReal(1e9)), 1);
    EXPECT_NE(rest(Real(1e9)), 1);
}

TEST(Real, the_root_of_two_is_between_its_neighbours) {
    const Real root = square_root(Real(2.0));
    EXPECT_TRUE(root > Real(1.4142135623730949));
    EXPECT_TRUE(root < Real(1.4142135623730952));
}

TEST(AccurateCross, keeps_the_direction_of_nearly_parallel_vectors) {
    // The true cross product is (0, 0, 2^-60), far below what plain products can see.
    const Vec a{1 + 0x1p-30, 1, 0};
    const Vec b{1, 1 - 0x1p-30, 0};
    EXPECT_EQ(accurate_cross(a, b).z, -0x1p-60);
}

}  // namespace
}  // namespace surefoot::internal
