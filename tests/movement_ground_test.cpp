// The ground under a body is what the world has there, whatever else was gathered.
#include <gtest/gtest.h>

#include "character/body.hpp"
#include "character/ground.hpp"
#include "character/neighbours.hpp"
#include "movement_scene.hpp"
#include "splitmix.hpp"

namespace surefoot::tests {
namespace {

using internal::Ground;
using internal::Vec;

constexpr CharacterSettings settings;

Ground ground_at(const World& world, const Vec& position, double gathered_around) {
    const Vec up{0, 1, 0};
    const internal::Body body = internal::body_of(settings.volume, settings.skin, up);
    const internal::Neighbours nobody(body, settings.skin, {});
    const internal::Gait gait{.up = up, .least_ground_up = 0.64, .skin = settings.skin};
    internal::Surroundings surroundings(world, {.begin = 1, .end = 1}, settings.surfaces, settings.skin, nobody,
                                        nullptr);
    EXPECT_TRUE(surroundings.cover(body.around(position, up * -settings.snap_down, gathered_around)));
    const internal::GroundRule rule{settings.perch_distance, {1, 0, 0}, settings.snap_down};
    return ground_under(surroundings, body, gait, rule, position, settings.snap_down + settings.skin);
}

// The rough edge of a platform along z, and lower ground beside it that is near enough to be followed.
World rough_edge(SplitMix& random) {
    Scene scene;
    for (int i = 0; i < 12; ++i) {
        const double z0 = 0.1 * (i - 6);
        const double z1 = z0 + 0.1;
        const double height = 0.004 * random.in(-1, 1);
        scene.quad({-3, 0, z0}, {-3, 0, z1}, {0, height, z1}, {0, height, z0});
        scene.quad({0, height, z0}, {0, height, z1}, {0, -1, z1}, {0, -1, z0});
    }
    scene.floor(-1, 4, -3, 3, -0.35, 7);
    return scene.world();
}

TEST(MovementGround, DoesNotDependOnWhatElseWasGathered) {
    SplitMix random(7);
    int walked_off = 0;
    for (int i = 0; i < 400; ++i) {
        const World world = rough_edge(random);
        const Vec position{random.in(0.2, 0.39), random.in(0.7, 0.95), random.in(-0.3, 0.3)};
        const Ground alone = ground_at(world, position, 2.5 * settings.skin);
        const Ground among_others = ground_at(world, position, 1.5);
        EXPECT_EQ(alone.footing, among_others.footing) << i;
        EXPECT_EQ(alone.triangle, among_others.triangle) << i;
        EXPECT_EQ(alone.distance, among_others.distance) << i;
        EXPECT_TRUE(alone.normal == among_others.normal) << i;
        EXPECT_TRUE(alone.point == among_others.point) << i;
        walked_off += among_others.footing != Footing::air && among_others.contact_normal.y < 0.64 ? 1 : 0;
    }
    EXPECT_GT(walked_off, 100);
}

}  // namespace
}  // namespace surefoot::tests
