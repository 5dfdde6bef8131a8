// What a shot meets of a body.
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include <surefoot/surefoot.hpp>

#include "splitmix.hpp"

namespace surefoot::tests {
namespace {

enum Part : std::uint32_t { head, trunk, left_arm, right_arm, left_leg, right_leg };

// A person who stands with arms and legs spread a little, 1.8 m tall, about its middle.
std::vector<HitPart> person() {
    const auto part = [](const Volume& volume, const dvec3& place, Part number) {
        return HitPart{volume, {.position = place}, {.position = place}, number};
    };
    return {part(Sphere{0.12}, {0, 0.75, 0}, head),
            part(Box{{0.18, 0.3, 0.11}}, {0, 0.3, 0}, trunk),
            part(Capsule{0.05, 0.25}, {-0.27, 0.3, 0}, left_arm),
            part(Capsule{0.05, 0.25}, {0.27, 0.3, 0}, right_arm),
            part(Cylinder{0.07, 0.42}, {-0.13, -0.45, 0}, left_leg),
            part(Cylinder{0.07, 0.42}, {0.13, -0.45, 0}, right_leg)};
}

Motion towards_z(double x, double y) {
    return {.from = {x, y, -5}, .to = {x, y, 5}};
}

TEST(Hitboxes, AShotThroughTheMovementVolumeMissesTheBody) {
    const std::vector<HitPart> parts = person();
    const Hitboxes body(parts, {});
    const Ellipsoid walks{{0.4, 0.9, 0.4}};
    const auto meets_volume = [&](const Motion& shot) {
        return pair_sweep(Sphere{1e-6}, shot, walks, dvec3(0, 0, 0)).has_value();
    };
    const Motion between_the_legs = towards_z(0, -0.5);
    const Motion over_the_shoulder = towards_z(0.2, 0.7);
    for (const Motion& shot : {between_the_legs, over_the_shoulder}) {
        EXPECT_TRUE(meets_volume(shot));
        EXPECT_FALSE(body.ray(shot).has_value());
    }
    EXPECT_EQ(body.ray(towards_z(0, 0.75))->number, head);
    EXPECT_EQ(body.ray(towards_z(-0.13, -0.5))->number, left_leg);
    // And the feet stick out where the ellipsoid is round: a shot that misses it may still hit.
    const Motion foot{.from = {0.16, -0.84, -5}, .to = {0.16, -0.84, 5}};
    EXPECT_FALSE(meets_volume({.from = {0.3, -0.86, -5}, .to = {0.3, -0.86, 5}}));
    EXPECT_EQ(body.ray(foot)->number, right_leg);
}

TEST(Hitboxes, TheFirstPartOnTheWayIsTold) {
    const std::vector<HitPart> parts = person();
    const Hitboxes body(parts, {});
    const auto from_left = body.ray({.from = {-3, 0.3, 0}, .to = {3, 0.3, 0}});
    ASSERT_TRUE(from_left);
    EXPECT_EQ(from_left->number, left_arm);
    EXPECT_NEAR(from_left->t, (3 - 0.32) / 6, 1e-12);
    EXPECT_NEAR(from_left->point.x, -0.32, 1e-12);
    EXPECT_NEAR(from_left->normal.x, -1, 1e-12);
    EXPECT_EQ(body.ray({.from = {3, 0.3, 0}, .to = {-3, 0.3, 0}})->number, right_arm);
    EXPECT_FALSE(body.ray({.from = {-3, 0.3, 0}, .to = {-1, 0.3, 0}}).has_value()) << "it ends before";
}

TEST(Hitboxes, TheBodyIsWhereItsPoseSays) {
    const std::vector<HitPart> parts = person();
    const Pose lying{.position = {100, 5, -7}, .orientation = {std::sqrt(0.5), 0, 0, std::sqrt(0.5)}};
    const Hitboxes body(parts, lying);  // its up is -x
    const auto hit = body.ray({.from = {99.25, 10, -7}, .to = {99.25, 0, -7}});
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->number, head);
    EXPECT_NEAR(hit->point.y, 5.12, 1e-9);
    EXPECT_NEAR(hit->normal.y, 1, 1e-9);
}

TEST(Hitboxes, WhoRunsIsHitWhereItIsWhenTheShotArrives) {
    const std::vector<HitPart> parts = person();
    // 4 m in one tick, and a bullet that is fired at where it will be half way.
    const Hitboxes body(parts, {.position = {-2, 0, 0}}, {.position = {2, 0, 0}});
    const auto hit = body.ray({.from = {0, 0.75, -5}, .to = {0, 0.75, 5}});
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->number, head);
    EXPECT_LT(hit->t, 0.5);
    EXPECT_GT(hit->t, 0.48);
    EXPECT_FALSE(body.ray({.from = {-2, 0.75, -5}, .to = {-2, 0.75, 5}}).has_value()) << "it has left";
    const HitboxQuery at_once{.begin = 0, .end = 0};
    EXPECT_TRUE(body.ray({.from = {-2, 0.75, -5}, .to = {-2, 0.75, 5}}, at_once).has_value());
    const HitboxQuery late{.begin = 1, .end = 1};
    EXPECT_EQ(body.ray({.from = {2, 0.75, -5}, .to = {2, 0.75, 5}}, late)->number, head);
}

TEST(Hitboxes, AnArmThatSwingsDuringTheTickMeetsAShotThatBothItsPosesMiss) {
    // Straight up at the start, to the side at the end; half way it is at 45 degrees.
    const HitPart arm{Capsule{0.05, 0.4},
                      {.position = {0, 0, 0}},
                      {.position = {0, 0, 0}, .orientation = {std::sqrt(0.5), 0, 0, std::sqrt(0.5)}},
                      7};
    const Hitboxes body({&arm, 1}, {});
    const Motion shot{.from = {-0.28, 0.28, -5}, .to = {-0.28, 0.28, 5}};
    EXPECT_FALSE(body.ray(shot, {.begin = 0, .end = 0}).has_value());
    EXPECT_FALSE(body.ray(shot, {.begin = 1, .end = 1}).has_value());
    const auto hit = body.ray(shot);
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->number, 7U);
    EXPECT_NEAR(hit->t, 0.5, 0.02);
}

Pose random_pose(SplitMix& random, double size, double angle) {
    const dvec3 axis = random.point(1);
    return {.position = random.point(size),
            .orientation = glm::normalize(dquat(1, axis.x * angle, axis.y * angle, axis.z * angle))};
}

// Where a part is at a time of the tick, by the words of the header alone.
Pose part_at(const HitPart& part, const Pose& start, const Pose& end, double time) {
    const Pose body = pose_between(start, end, time);
    const Pose own = pose_between(part.start, part.end, time);
    return {.position = to_world(body, own.position),
            .orientation = glm::normalize(body.orientation) * glm::normalize(own.orientation)};
}

Volume random_volume(SplitMix& random, std::size_t index, double size) {
    const double a = random.in(0.3, 1) * size, b = random.in(0.3, 1) * size, c = random.in(0.3, 1) * size;
    const Shape shapes[] = {Sphere{a}, Ellipsoid{{a, b, c}}, Capsule{a, b}, Box{{a, b, c}}, Cylinder{a, b}, Cone{a, b}};
    return {shapes[index % 6], random.turn()};
}

TEST(Hitboxes, RaysAgainstPartsThatTurnAgreeWithADenseSearchInTime) {
    SplitMix random(21);
    int hits = 0;
    for (int i = 0; i < 600; ++i) {
        HitPart part{random_volume(random, static_cast<std::size_t>(i), 0.3), random_pose(random, 0.4, 0.5),
                     random_pose(random, 0.4, 0.5), 3};
        const Pose start = random_pose(random, 0.5, 0.6), end = random_pose(random, 0.5, 0.6);
        const Hitboxes body({&part, 1}, start, end);
        const Motion shot{.from = random.point(1.5), .to = random.point(0.7)};
        const HitboxQuery query{.begin = 0.1, .end = 0.9};
        const auto hit = body.ray(shot, query);
        // A point that goes is a ball of no size: the first of many moments at which it is inside.
        double first = 2;
        const int moments = 2000;
        for (int k = 0; k <= moments && first > 1; ++k) {
            const double t = k / static_cast<double>(moments);
            const Pose pose = part_at(part, start, end, 0.1 + 0.8 * t);
            const dvec3 place = shot.from + (shot.to - shot.from) * t;
            const Volume there(part.volume.shape, pose.orientation * glm::normalize(part.volume.orientation));
            if (pair_overlap(Sphere{1e-6}, place, there, pose.position)) first = t;
        }
        if (first <= 1) {
            ++hits;
            ASSERT_TRUE(hit.has_value()) << i;
            ASSERT_LE(hit->t, first + 1e-9) << i;
        }
        if (!hit || hit->started_inside) continue;
        // And what it says is true to the gap.
        const Pose pose = part_at(part, start, end, 0.1 + 0.8 * hit->t);
        const Volume there(part.volume.shape, pose.orientation * glm::normalize(part.volume.orientation));
        const dvec3 place = shot.from + (shot.to - shot.from) * hit->t;
        ASSERT_TRUE(pair_overlap(Sphere{query.turn_gap * 1.01 + 1e-6}, place, there, pose.position)) << i;
        ASSERT_LE(glm::length(hit->point - place), query.turn_gap * 1.01) << i;
        ASSERT_NEAR(glm::length(hit->normal), 1, 1e-9);
    }
    EXPECT_GT(hits, 40);
}

TEST(Hitboxes, SweepsAgainstPartsThatTurnAgreeWithADenseSearchInTime) {
    SplitMix random(22);
    int hits = 0;
    for (int i = 0; i < 300; ++i) {
        HitPart part{random_volume(random, static_cast<std::size_t>(i), 0.3), random_pose(random, 0.4, 0.3),
                     random_pose(random, 0.4, 0.3), 3};
        const Volume blade = random_volume(random, static_cast<std::size_t>(i / 6), 0.2);
        const Pose start = random_pose(random, 0.5, 0.3), end = random_pose(random, 0.5, 0.3);
        const Hitboxes body({&part, 1}, start, end);
        const Motion blow{.from = random.point(1.5), .to = random.point(0.7)};
        const HitboxQuery query{.turn_gap = 0.01};
        const auto hit = body.sweep(blade, blow, query);
        double first = 2;
        const int moments = 500;
        for (int k = 0; k <= moments && first > 1; ++k) {
            const double t = k / static_cast<double>(moments);
            const Pose pose = part_at(part, start, end, t);
            const Volume there(part.volume.shape, pose.orientation * glm::normalize(part.volume.orientation));
            const auto in = pair_overlap(blade, blow.from + (blow.to - blow.from) * t, there, pose.position);
            if (in && in->depth > 1e-6) first = t;
        }
        if (first <= 1) {
            ++hits;
            ASSERT_TRUE(hit.has_value()) << i;
            ASSERT_LE(hit->t, first + 1e-6) << i;
        }
        if (!hit || hit->status != HitStatus::ok) continue;
        // Moved by the gap along the normal, they overlap: the hit is no farther off than that.
        const Pose pose = part_at(part, start, end, hit->t);
        const Volume there(part.volume.shape, pose.orientation * glm::normalize(part.volume.orientation));
        const dvec3 place = blow.from + (blow.to - blow.from) * hit->t;
        ASSERT_TRUE(pair_overlap(blade, place - hit->normal * (2 * query.turn_gap), there, pose.position)) << i;
    }
    EXPECT_GT(hits, 60);
}

TEST(Hitboxes, WhatDoesNotTurnIsHitWithoutAnyGap) {
    const HitPart ball{Sphere{0.5}, {.position = {1, 0, 0}}, {.position = {1, 2, 0}}, 1};
    const Hitboxes body({&ball, 1}, {.position = {0, 0, 0}}, {.position = {0, 0, 4}});
    const auto hit = body.sweep(Sphere{0.25}, {.from = {1, 0, 10}, .to = {1, 2, 4}});
    ASSERT_TRUE(hit);
    // Seen from the ball it comes from 10 m ahead to 0: 9.25 m of 10.
    EXPECT_NEAR(hit->t, 0.925, 1e-8);
    EXPECT_NEAR(hit->normal.z, 1, 1e-7);
}

TEST(Hitboxes, WhatBeginsInsideHitsAtOnce) {
    const std::vector<HitPart> parts = person();
    const Hitboxes body(parts, {});
    const auto shot = body.ray({.from = {0, 0.3, 0}, .to = {0, 0.3, 5}});
    ASSERT_TRUE(shot);
    EXPECT_TRUE(shot->started_inside);
    EXPECT_EQ(shot->t, 0);
    EXPECT_EQ(shot->normal, dvec3(0, 0, -1));
    const auto blade = body.sweep(Sphere{0.02}, {.from = {0, 0.3, 0.1}, .to = {0, 0.3, 5}});
    ASSERT_TRUE(blade);
    EXPECT_TRUE(blade->started_inside);
    EXPECT_EQ(blade->t, 0);
}

TEST(Hitboxes, TiesGoToTheLowestNumber) {
    HitPart parts[] = {{Sphere{0.5}, {}, {}, 9}, {Sphere{0.5}, {}, {}, 4}, {Sphere{0.5}, {}, {}, 6}};
    EXPECT_EQ(Hitboxes(parts, {}).ray(towards_z(0, 0))->number, 4U);
}

TEST(Hitboxes, BadDataAreRefusedAndNeverAFreePass) {
    std::vector<HitPart> parts = person();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const Hitboxes body(parts, {});
    EXPECT_EQ(body.ray({.from = {nan, 0, 0}, .to = {0, 0, 0}})->status, HitStatus::invalid);
    EXPECT_EQ(body.ray(towards_z(9, 9), {.begin = 0.5, .end = 0.4})->status, HitStatus::invalid);
    EXPECT_EQ(body.ray(towards_z(9, 9), {.turn_gap = 0})->status, HitStatus::invalid);
    EXPECT_EQ(body.sweep(Sphere{-1}, towards_z(9, 9))->status, HitStatus::invalid);
    parts[2].volume = Sphere{nan};
    EXPECT_EQ(Hitboxes(parts, {}).ray(towards_z(9, 9))->status, HitStatus::invalid);
    parts = person();
    EXPECT_EQ(Hitboxes(parts, {.position = {nan, 0, 0}}).ray(towards_z(9, 9))->status, HitStatus::invalid);
    EXPECT_FALSE(Hitboxes({}, {}).ray(towards_z(0, 0)).has_value()) << "a body without parts is met by nothing";
}

TEST(Hitboxes, ATurnThatCannotBeFollowedSoCloselyBlocks) {
    const HitPart part{Box{{1, 1, 1}}, {}, {.orientation = {0, 0, 0, 1}}, 5};
    const auto hit = Hitboxes({&part, 1}, {}).ray(towards_z(0, 0), {.turn_gap = 1e-12});
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->status, HitStatus::overflow);
    EXPECT_EQ(hit->t, 0);
}

}  // namespace
}  // namespace surefoot::tests
