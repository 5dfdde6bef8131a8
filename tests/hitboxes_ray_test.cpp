// A ray against each of the six shapes, beside a dense search with the shapes' definitions alone.
#include <cmath>
#include <gtest/gtest.h>

#include "hitboxes/ray_shape.hpp"
#include "overloaded.hpp"
#include "splitmix.hpp"

namespace surefoot::tests {
namespace {

using internal::ray_shape;
using internal::RayTouch;
using internal::Vec;

// How far outside a point is, in a measure of each shape's own: at most 0 inside, and growing outwards.
double outside(const Shape& shape, const Vec& p) {
    const double run = std::sqrt(p.x * p.x + p.z * p.z);
    return std::visit(internal::Overloaded{
                          [&](const Sphere& s) { return internal::length(p) - s.radius; },
                          [&](const Ellipsoid& s) {
                              return internal::length(internal::divide_each(p, internal::to_vec(s.radii))) - 1;
                          },
                          [&](const Capsule& s) {
                              const double y = std::max(std::abs(p.y) - s.half_height, 0.0);
                              return std::sqrt(run * run + y * y) - s.radius;
                          },
                          [&](const Box& s) {
                              return std::max({std::abs(p.x) - s.half_extents.x, std::abs(p.y) - s.half_extents.y,
                                               std::abs(p.z) - s.half_extents.z});
                          },
                          [&](const Cylinder& s) { return std::max(run - s.radius, std::abs(p.y) - s.half_height); },
                          [&](const Cone& s) {
                              return std::max({run - p.y * s.radius / s.height, p.y - s.height, -p.y});
                          },
                      },
                      shape);
}

std::vector<Shape> shapes() {
    return {Sphere{0.7},     Ellipsoid{{0.4, 0.9, 0.3}}, Ellipsoid{{2, 0.01, 1}}, Capsule{0.3, 0.6},
            Capsule{0.5, 0}, Box{{0.4, 0.9, 0.2}},       Cylinder{0.5, 0.8},      Cone{0.4, 1.8},
            Cone{2, 0.3}};
}

// The least value of `outside` along the segment, which is convex along a line, by thirds.
double least_outside(const Shape& shape, const Vec& from, const Vec& along, double& at) {
    double low = 0, high = 1;
    for (int i = 0; i < 200; ++i) {
        const double a = low + (high - low) / 3, b = high - (high - low) / 3;
        (outside(shape, from + along * a) < outside(shape, from + along * b) ? high : low) =
            outside(shape, from + along * a) < outside(shape, from + along * b) ? b : a;
    }
    at = 0.5 * (low + high);
    for (const double end : {0.0, 1.0}) {
        if (outside(shape, from + along * end) < outside(shape, from + along * at)) at = end;
    }
    return outside(shape, from + along * at);
}

// Where a segment that has a point inside comes in.
double first_inside(const Shape& shape, const Vec& from, const Vec& along, double inside) {
    double low = 0, high = inside;
    for (int i = 0; i < 200; ++i) {
        const double middle = 0.5 * (low + high);
        (outside(shape, from + along * middle) <= 0 ? high : low) = middle;
    }
    return high;
}

TEST(HitboxRay, EachShapeIsHitWhereItsDefinitionSays) {
    SplitMix random(11);
    int hits = 0, misses = 0;
    for (const Shape& shape : shapes()) {
        for (int i = 0; i < 20000; ++i) {
            const Vec from = internal::to_vec(random.point(2.5));
            const Vec to = internal::to_vec(random.point(2.5));
            const Vec along = to - from;
            const auto touch = ray_shape(shape, from, along);
            double at = 0;
            const double least = least_outside(shape, from, along, at);
            if (std::abs(least) < 1e-9) continue;  // it grazes
            ASSERT_EQ(touch.has_value(), least < 0) << shape.index() << " " << i << " " << least;
            if (!touch) {
                ++misses;
                continue;
            }
            ++hits;
            ASSERT_EQ(touch->inside, outside(shape, from) <= 0) << shape.index() << " " << i;
            if (touch->inside) {
                ASSERT_EQ(touch->t, 0);
                continue;
            }
            ASSERT_NEAR(touch->t, first_inside(shape, from, along, at), 1e-7) << shape.index() << " " << i;
            ASSERT_NEAR(outside(shape, from + along * touch->t), 0, 1e-9) << shape.index() << " " << i;
        }
    }
    EXPECT_GT(hits, 10000);
    EXPECT_GT(misses, 10000);
}

TEST(HitboxRay, TheNormalIsThatOfTheSurfaceAndFacesTheRay) {
    SplitMix random(12);
    for (const Shape& shape : shapes()) {
        for (int i = 0; i < 5000; ++i) {
            const Vec from = internal::to_vec(random.point(2.5));
            const Vec along = internal::to_vec(random.point(0.3)) - from;
            const auto touch = ray_shape(shape, from, along);
            if (!touch || touch->inside) continue;
            ASSERT_NEAR(internal::length(touch->normal), 1, 1e-12);
            ASSERT_LE(internal::dot(touch->normal, along), 1e-9) << shape.index() << " " << i;
            // No point of a convex shape lies before the plane of its normal: look at many of them.
            const Vec point = from + along * touch->t;
            for (int k = 0; k < 20; ++k) {
                const Vec other = internal::to_vec(random.point(2));
                if (outside(shape, other) > 0) continue;
                ASSERT_LE(internal::dot(touch->normal, other - point), 1e-7) << shape.index() << " " << i;
            }
        }
    }
}

TEST(HitboxRay, AlongAxesSidesAndThroughTipsItIsRight) {
    const auto t = [](const Shape& shape, const Vec& from, const Vec& along) {
        const auto touch = ray_shape(shape, from, along);
        return touch ? touch->t : -1;
    };
    const Cone cone{1, 2};
    EXPECT_NEAR(t(cone, {0, -2, 0}, {0, 4, 0}), 0.5, 1e-15) << "up through the apex";
    EXPECT_NEAR(t(cone, {0, 4, 0}, {0, -4, 0}), 0.5, 1e-15) << "down through the disc";
    EXPECT_NEAR(t(cone, {1, 4, 0}, {-3, -6, 0}), 2.0 / 6, 1e-15) << "along the side, within it";
    EXPECT_NEAR(t(cone, {1.5, 4, 0}, {-3, -6, 0}), 2.0 / 6, 1e-15) << "along the side, through the middle";
    EXPECT_EQ(t(cone, {2.5, 4, 0}, {-3, -6, 0}), -1) << "along the side, outside";
    EXPECT_NEAR(t(cone, {2, -4, 0}, {-3, 6, 0}), 4.0 / 6, 1e-15) << "along the side, through the apex";
    EXPECT_NEAR(t(cone, {3, -4, 0}, {-3, 6, 0}), 5.0 / 6, 1e-15) << "along the side, in from below";
    EXPECT_EQ(t(cone, {0.1, -3, 0}, {0, 2.9, 0}), -1) << "in the lower nappe, which is none of the cone";
    EXPECT_EQ(t(cone, {-2, 1, 0}, {4, 0, 0}), 1.5 / 4);
    EXPECT_EQ(t(Cylinder{1, 1}, {0.5, 3, 0}, {0, -4, 0}), 0.5);
    EXPECT_EQ(t(Cylinder{1, 1}, {1.5, 3, 0}, {0, -4, 0}), -1);
    EXPECT_EQ(t(Capsule{1, 1}, {0, 4, 0}, {0, -4, 0}), 0.5);
    EXPECT_EQ(t(Box{{1, 1, 1}}, {0.5, 3, 0.5}, {0, -4, 0}), 0.5);
    EXPECT_EQ(t(Box{{1, 1, 1}}, {1.5, 3, 0.5}, {0, -4, 0}), -1);
    EXPECT_EQ(t(Sphere{1}, {0, 0, 0}, {0, 0, 0}), 0) << "a point inside";
    EXPECT_EQ(t(Sphere{1}, {2, 0, 0}, {0, 0, 0}), -1) << "a point outside";
}

TEST(HitboxRay, ACapsuleEnteredByItsRoundEndAndLeftByItsSideIsInsideInBetween) {
    const Vec from{0.17248371439173082, 0.084203960877379025, -0.18832522995610068};
    const Vec along{0.23621266325812007, -1.0996015069171126, -0.065296277548410053};
    const auto touch = ray_shape(Capsule{0.3, 0.6}, from, along);
    ASSERT_TRUE(touch.has_value());
    EXPECT_TRUE(touch->inside);
}

TEST(HitboxRay, ASmallShapeIsHitFromVeryFarAway) {
    SplitMix random(13);
    for (int i = 0; i < 2000; ++i) {
        const double size = 0.05;
        const Vec middle = internal::to_vec(random.point(0.3 * size));
        const Vec direction = internal::to_vec(random.point(1));
        const Vec away = direction * (1e6 / internal::length(direction));
        for (const Shape& shape : {Shape(Sphere{size}), Shape(Box{{size, size, size}}), Shape(Capsule{size, size}),
                                   Shape(Cylinder{size, size}), Shape(Ellipsoid{{size, 2 * size, size}})}) {
            const auto touch = ray_shape(shape, middle + away, away * -2);
            ASSERT_TRUE(touch.has_value()) << shape.index();
            const Vec point = middle + away - away * (2 * touch->t);
            ASSERT_NEAR(outside(shape, point), 0, 1e-7);
        }
    }
}

}  // namespace
}  // namespace surefoot::tests
