#include "debugger/squash.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "numeric_reference.hpp"

namespace surefoot::debugger {
namespace {

void expect_near(const dvec3& a, const dvec3& b, double tolerance = 1e-12) {
    EXPECT_LT(glm::length(a - b), tolerance)
        << a.x << ' ' << a.y << ' ' << a.z << " and " << b.x << ' ' << b.y << ' ' << b.z;
}

TEST(Squash, is_the_world_at_0_and_the_method_s_space_at_1) {
    tests::Random random(1);
    for (int i = 0; i < 200; ++i) {
        const Volume volume(tests::some_shape(random, i % 2), random.turn());
        const dvec3 v = random.point(5);
        expect_near(squash_at(volume, 0).vector(v), v);
        expect_near(squash_at(volume, 1).vector(v), squashed(volume, v), 1e-10);
        expect_near(unsquashed(volume, squashed(volume, v)), v);
    }
}

TEST(Squash, takes_the_surface_to_that_of_the_ellipsoid_that_it_says) {
    tests::Random random(2);
    for (int i = 0; i < 300; ++i) {
        const Volume volume(tests::some_shape(random, i % 2), random.turn());
        const Squash squash = squash_at(volume, random.in(0, 1));
        // A point of the surface, and where it goes.
        const dvec3 ball = glm::normalize(random.point(1));
        const dvec3 mapped = squash.vector(unsquashed(volume, ball));
        const Volume image(Ellipsoid{squash.radii}, squash.orientation);
        EXPECT_NEAR(glm::length(squashed(image, mapped)), 1, 1e-10);
    }
}

TEST(Squash, keeps_its_pivot_and_takes_planes_to_planes) {
    tests::Random random(3);
    for (int i = 0; i < 200; ++i) {
        const Volume volume(tests::some_shape(random, 1), random.turn());
        const dvec3 pivot = random.point(9);
        const Squash squash = squash_at(volume, random.in(0, 1), pivot);
        expect_near(squash.point(pivot), pivot);
        const Triangle triangle{random.point(4), random.point(4), random.point(4)};
        const dvec3 normal = glm::cross(triangle.b - triangle.a, triangle.c - triangle.a);
        const Triangle mapped = squash.triangle(triangle);
        const dvec3 of_mapped = glm::normalize(glm::cross(mapped.b - mapped.a, mapped.c - mapped.a));
        expect_near(squash.normal(normal), of_mapped, 1e-8);
        const Motion motion = squash.motion({triangle.a, triangle.b});
        expect_near(motion.from, mapped.a);
        expect_near(motion.to, mapped.b);
    }
}

TEST(Squash, leaves_the_other_shapes_as_they_are) {
    EXPECT_FALSE(is_squashable(Box{}));
    expect_near(squash_at(Volume(Box{{1, 2, 3}}), 1).vector({1, 2, 3}), {1, 2, 3});
}

}  // namespace
}  // namespace surefoot::debugger
