// Overlap with triangles near the end of the doubles' range.
#include <gtest/gtest.h>

#include <surefoot/overlap.hpp>

namespace surefoot {
namespace {

TEST(OverlapTiny, whatever_is_around_a_triangle_of_next_to_nothing_is_given_a_way_out) {
    // Found by fuzzing: a capsule's way out had a normal of zero and a depth of 1e300 m.
    for (const double size : {7.605232914819536e-311, 5e-324, 1e-200, 1e-170}) {
        for (const dvec3& axis : {dvec3(1, 0, 0), dvec3(0, 1, 0), dvec3(0.25, 0.5, 1)}) {
            const Triangle tiny{axis * size, {0, 0, 0}, {0, 0, 0}};
            const Volume volumes[] = {Sphere{1.5},        Ellipsoid{{0.4, 0.9, 0.4}},
                                      Capsule{1.5, 1e-5}, Capsule{3.75, 2.5e-308},
                                      Box{{1, 2, 3}},     Cylinder{1, 2},
                                      Cone{1, 2}};
            for (const Volume& volume : volumes) {
                const auto found = overlap(volume, {0, 0, 0}, tiny);
                ASSERT_TRUE(found.has_value()) << volume.shape.index();
                EXPECT_NEAR(glm::length(found->normal), 1, 1e-12) << volume.shape.index() << " at " << size;
                EXPECT_LE(found->depth, 4) << volume.shape.index() << " at " << size;
            }
        }
    }
}

}  // namespace
}  // namespace surefoot
