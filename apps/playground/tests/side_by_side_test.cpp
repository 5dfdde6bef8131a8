#include "debugger/side_by_side.hpp"

#include <cmath>
#include <cstring>
#include <gtest/gtest.h>

namespace surefoot::debugger {
namespace {

constexpr double degree = 3.14159265358979323846 / 180;

TEST(SideBySide, stands_off_a_slope_by_the_closed_form_of_each_shape) {
    for (const auto& [width, height] : {std::pair(0.4, 0.9), std::pair(0.25, 0.3), std::pair(0.5, 0.5)}) {
        for (const Contestant& contestant : contestants(width, height)) {
            for (const double degrees : {0.0, 5.0, 15.0, 30.0, 45.0, 55.0}) {
                const SlopeReading reading = read_slope(contestant.shape, degrees * degree);
                ASSERT_TRUE(reading.landed) << contestant.name << " at " << degrees;
                EXPECT_NEAR(reading.gap, reading.expected, 1e-9) << contestant.name << " at " << degrees;
                EXPECT_NEAR(reading.clearance, SlideSettings{}.skin, 1e-8) << contestant.name << " at " << degrees;
            }
        }
    }
}

TEST(SideBySide, has_the_closed_forms_that_one_knows) {
    const double angle = 30 * degree;
    const auto of = [&](const Shape& shape) { return stand_off(shape, angle); };
    EXPECT_NEAR(of(Box{{0.4, 0.9, 0.4}}), 0.4 * std::tan(angle), 1e-15);
    EXPECT_EQ(of(Cylinder{0.4, 0.9}), of(Box{{0.4, 0.9, 0.4}}));
    EXPECT_EQ(of(Cone{0.4, 1.8}), 0);
    EXPECT_NEAR(of(Capsule{0.4, 0.5}), 0.4 / std::cos(angle) - 0.4, 1e-15);
    EXPECT_NEAR(of(Ellipsoid{{0.4, 0.4, 0.4}}), of(Sphere{0.4}), 1e-15);
    // The ellipsoid keeps closest, of those that do not stand on a point.
    EXPECT_LT(of(Ellipsoid{{0.4, 0.9, 0.4}}), of(Capsule{0.4, 0.5}));
    EXPECT_LT(of(Capsule{0.4, 0.5}), of(Box{{0.4, 0.9, 0.4}}));
    // A slope that is steeper than the cone's side is touched by its rim.
    EXPECT_NEAR(stand_off(Cone{0.4, 0.3}, 45 * degree), 0.1, 1e-12);
}

TEST(SideBySide, lets_a_flat_cone_on_a_steep_slope_touch_with_its_rim) {
    const SlopeReading reading = read_slope(Cone{0.5, 0.4}, 50 * degree);
    ASSERT_TRUE(reading.landed);
    EXPECT_GT(reading.gap, 0.15);
    EXPECT_NEAR(reading.gap, reading.expected, 1e-9);
}

TEST(SideBySide, stops_what_has_a_foot_of_its_full_width_at_the_first_stair) {
    for (const Contestant& contestant : contestants()) {
        const StairsReading reading = read_stairs(contestant.shape);
        const bool broad = contestant.name == "box" || contestant.name == "cylinder";
        if (broad) {
            EXPECT_NEAR(reading.reached, -0.4 - SlideSettings{}.skin, 1e-9) << contestant.name;
            EXPECT_LT(reading.climbed, 0.01) << contestant.name;
        }
        if (contestant.name == "ellipsoid" || contestant.name == "capsule") {
            EXPECT_GT(reading.climbed, 8 * 0.2 - 0.01) << contestant.name;
        }
        const Arena arena(stairs());
        for (const Mover& mover : reading.places)
            ASSERT_FALSE(arena.touches(contestant.shape, mover.position)) << contestant.name << " got into a stair";
    }
}

TEST(SideBySide, lets_each_shape_sink_over_a_ledge_where_geometry_says) {
    for (const Contestant& contestant : contestants()) {
        const LedgeReading reading = read_ledge(contestant.shape, 0.05, 0.25, 720);
        ASSERT_TRUE(reading.overhang) << contestant.name;
        // To within what it moves in a few ticks, and the skin.
        EXPECT_NEAR(*reading.overhang, overhang(contestant.shape, 0.05), 0.03) << contestant.name;
        const Arena arena(ledge());
        for (const Mover& mover : reading.places)
            ASSERT_FALSE(arena.touches(contestant.shape, mover.position)) << contestant.name << " got into the ledge";
    }
}

TEST(SideBySide, gives_the_same_bits_again) {
    for (const Contestant& contestant : contestants()) {
        const StairsReading one = read_stairs(contestant.shape);
        const StairsReading other = read_stairs(contestant.shape);
        ASSERT_EQ(one.places.size(), other.places.size());
        for (std::size_t i = 0; i < one.places.size(); ++i)
            EXPECT_EQ(std::memcmp(&one.places[i].position, &other.places[i].position, sizeof(dvec3)), 0);
    }
}

TEST(Slide, stops_a_skin_short_along_the_normal_and_slides_on) {
    // A wall across x, met at 45 degrees.
    const Arena arena(std::vector<Triangle>{{{5, -9, -50}, {5, 9, -50}, {5, 0, 50}}});
    const SlideSettings settings;
    const Slid slid = slide(arena, Sphere{0.5}, {0, 0, 0}, {8, 0, 8}, settings);
    ASSERT_EQ(slid.normals.size(), 1U);
    EXPECT_NEAR(slid.position.x, 4.5 - settings.skin, 1e-9);
    EXPECT_NEAR(slid.position.z, 8, 1e-9);
}

TEST(Slide, goes_nowhere_into_a_corner) {
    const Arena arena(
        std::vector<Triangle>{{{5, -9, -50}, {5, 9, -50}, {5, 0, 50}}, {{-50, -9, 5}, {50, -9, 5}, {0, 9, 5}}});
    const Slid slid = slide(arena, Sphere{0.5}, {4, 0, 4}, {3, 0, 2});
    EXPECT_LT(slid.position.x, 4.5);
    EXPECT_LT(slid.position.z, 4.5);
    EXPECT_EQ(slid.normals.size(), 2U);
}

}  // namespace
}  // namespace surefoot::debugger
