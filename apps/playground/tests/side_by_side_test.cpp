#include "debugger/side_by_side.hpp"

#include <cmath>
#include <cstring>
#include <gtest/gtest.h>
#include <string>

namespace surefoot::debugger {
namespace {

constexpr double degree = 3.14159265358979323846 / 180;
constexpr double margin = 0.01;  // that geometry leaves on either side of a limit [m]
const double skin = CharacterSettings{}.skin;
const double step_up = CharacterSettings{}.step_up;

bool is_same(const CharacterState& a, const CharacterState& b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

void expect_never_inside(const Shape& shape, const std::vector<Triangle>& triangles,
                         const std::vector<CharacterState>& places, const std::string& what) {
    const Arena arena(triangles);
    for (const CharacterState& state : places)
        ASSERT_FALSE(arena.touches(shape, state.position)) << what << " got into it";
}

TEST(SideBySide, stands_off_a_slope_by_the_closed_form_of_each_shape) {
    for (const auto& [width, height] : {std::pair(0.4, 0.9), std::pair(0.25, 0.3), std::pair(0.5, 0.5)}) {
        for (const Contestant& contestant : contestants(width, height)) {
            for (const double degrees : {0.0, 5.0, 15.0, 30.0, 45.0, 55.0}) {
                const SlopeReading reading = read_slope(contestant.shape, degrees * degree);
                ASSERT_TRUE(reading.landed) << contestant.name << " at " << degrees;
                EXPECT_NEAR(reading.gap, reading.expected, 1e-9) << contestant.name << " at " << degrees;
                // The body that is kept off everything is larger by the skin all round: what has corners, or a tip, is
                // then farther off along a slope's normal.
                const bool has_tip = contestant.name == "cone";
                const double most = skin * (has_tip ? std::hypot(1, 2 * height / width) : std::sqrt(2.0));
                EXPECT_GT(reading.clearance, skin - 1e-9) << contestant.name << " at " << degrees;
                EXPECT_LT(reading.clearance, most + 1e-9) << contestant.name << " at " << degrees;
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

TEST(SideBySide, is_the_step_called_by_hand) {
    for (const Contestant& contestant : contestants()) {
        const StairsReading reading = read_stairs(contestant.shape, {}, 2, 60);
        const Arena arena(stairs());
        CharacterSettings settings;
        settings.volume = contestant.shape;
        CharacterState state;
        state.position = {-1.5, settings.skin - foot_of(contestant.shape), 0};
        ASSERT_EQ(reading.places.size(), 61U);
        for (const CharacterState& place : reading.places) {
            EXPECT_TRUE(is_same(place, state)) << contestant.name;
            state = step(arena.world(), settings, {.wish = {2, 0, 0}}, 1.0 / 60, state).state;
        }
    }
}

TEST(SideBySide, climbs_stairs_of_twenty_centimetres_in_all_bodies) {
    for (const Contestant& contestant : contestants()) {
        const StairsReading reading = read_stairs(contestant.shape);
        EXPECT_GT(reading.climbed, 8 * 0.2) << contestant.name;
        EXPECT_EQ(reading.places.back().footing, Footing::ground) << contestant.name;
        EXPECT_GT(reading.reached, 6) << contestant.name;
        expect_never_inside(contestant.shape, stairs(), reading.places, contestant.name);
    }
}

TEST(SideBySide, climbs_what_is_a_centimetre_lower_than_its_step_height_and_not_what_is_one_higher) {
    for (const Shape& shape :
         {Shape(Ellipsoid{{0.4, 0.9, 0.4}}), Shape(Cylinder{0.4, 0.9}), Shape(Box{{0.4, 0.9, 0.4}})}) {
        const std::string name = "shape " + std::to_string(shape.index());
        const Stairs low{.count = 4, .rise = step_up - margin, .run = 0.6};
        const StairsReading over = read_stairs(shape, low);
        EXPECT_GT(over.climbed, low.count * low.rise) << name;
        EXPECT_EQ(over.places.back().footing, Footing::ground) << name;
        EXPECT_GT(over.reached, low.count * low.run) << name;
        expect_never_inside(shape, stairs(low), over.places, name);
        const Stairs high{.count = 4, .rise = step_up + margin, .run = 0.6};
        const StairsReading before = read_stairs(shape, high);
        EXPECT_LT(before.climbed, 2 * skin) << name;
        EXPECT_LT(before.reached, 0) << name;
        expect_never_inside(shape, stairs(high), before.places, name);
    }
}

TEST(SideBySide, stays_below_stairs_a_centimetre_too_high_however_round_it_is) {
    for (const Contestant& contestant : contestants()) {
        const StairsReading reading = read_stairs(contestant.shape, {.rise = step_up + margin});
        EXPECT_LT(reading.climbed, 0.15) << contestant.name;
        EXPECT_LT(reading.reached, 0) << contestant.name;
    }
}

TEST(SideBySide, lets_each_body_sink_over_a_ledge_where_geometry_says) {
    // How far it goes on at this speed while it falls as far as it has to have sunk.
    const double speed = 0.25;
    const double falls = std::sqrt(2 * (0.05 + skin) / CharacterSettings{}.gravity) * speed;
    for (const Contestant& contestant : contestants()) {
        const LedgeReading reading = read_ledge(contestant.shape, 0.05, speed, 720);
        ASSERT_TRUE(reading.overhang) << contestant.name;
        const double form = overhang(contestant.shape, 0.05);
        EXPECT_GT(*reading.overhang, form) << contestant.name;
        EXPECT_LT(*reading.overhang, form + falls + skin + 2 * speed * contest_tick) << contestant.name;
        expect_never_inside(contestant.shape, ledge(), reading.places, contestant.name);
    }
}

TEST(SideBySide, leaves_a_ledge_once_and_cleanly) {
    for (const double speed : {0.5, 1.0, 4.0}) {
        for (const Contestant& contestant : contestants()) {
            const std::string what = contestant.name + " at " + std::to_string(speed);
            const LedgeReading reading = read_ledge(contestant.shape, 0.05, speed, 180);
            std::size_t times = 0;
            for (std::size_t i = 31; i < reading.places.size(); ++i) {
                const CharacterState& before = reading.places[i - 1];
                const CharacterState& now = reading.places[i];
                times += before.footing == Footing::ground && now.footing != Footing::ground && now.position.x > -0.1;
                ASSERT_LE(now.position.y, before.position.y + 1e-9) << what << " is thrown up";
                ASSERT_GT(now.position.x, before.position.x) << what << " is held back";
                if (now.footing == Footing::air) {
                    ASSERT_GT(now.velocity.x, speed - 1e-9) << what;
                }
            }
            EXPECT_EQ(times, 1U) << what;
            EXPECT_LT(reading.places.back().position.y, reading.places.front().position.y - 0.05) << what;
        }
    }
}

TEST(SideBySide, gives_the_same_bits_again) {
    for (const Contestant& contestant : contestants()) {
        const StairsReading one = read_stairs(contestant.shape);
        const StairsReading other = read_stairs(contestant.shape);
        ASSERT_EQ(one.places.size(), other.places.size());
        for (std::size_t i = 0; i < one.places.size(); ++i) EXPECT_TRUE(is_same(one.places[i], other.places[i]));
    }
}

}  // namespace
}  // namespace surefoot::debugger
