// Ice, belts, platforms that are jumped through: what surfaces do to characters.
#include <array>

#include "movement_scene.hpp"

namespace surefoot::tests {
namespace {

constexpr std::array<SurfaceRule, 5> rules{SurfaceRule{}, SurfaceRule{.grip = 0.05},
                                           SurfaceRule{.conveyor = {1.5, 0, 0}}, SurfaceRule{.one_way = true},
                                           SurfaceRule{.slippery = true}};

Actor on(const World& world, const dvec3& place) {
    Actor actor;
    actor.settings.surfaces = SurfaceRules(rules);
    actor.state.position = place;
    actor.run(world, 1);
    return actor;
}

TEST(MovementSurface, IceTakesTwentyTimesAsLongToGetGoingAndToStopAsFirmGround) {
    const World ice = Scene().made_of(1).floor(-50, 50, -50, 50).world();
    const World firm = Scene().floor(-50, 50, -50, 50).world();
    Actor slow = on(ice, {0, 1, 0});
    Actor quick = on(firm, {0, 1, 0});
    slow.run(ice, 1, {.wish = {4, 0, 0}});
    quick.run(firm, 0.05, {.wish = {4, 0, 0}});
    EXPECT_NEAR(slow.state.velocity.x, 3, 1e-9);
    EXPECT_NEAR(quick.state.velocity.x, 3, 1e-9);
    const double from = slow.state.position.x;
    slow.run(ice, 2);
    EXPECT_NEAR(slow.state.position.x - from, 1.5, 0.01) << "3 m/s, braked at 3 m/s^2";
    EXPECT_NEAR(slow.state.velocity.x, 0, 1e-9);
}

TEST(MovementSurface, ABeltCarriesWhatStandsOnItAndTurnsWithItsBody) {
    const Mesh belt = Scene().made_of(2).floor(-50, 50, -50, 50).mesh();
    World world;
    ASSERT_TRUE(world.add(belt));
    Actor actor = on(world, {0, 1, 0});
    double from = actor.state.position.x;
    actor.run(world, 2);
    EXPECT_NEAR(actor.state.position.x - from, 3, 1e-6);
    EXPECT_NEAR(actor.state.position.z, 0, 1e-9);

    World turned;
    const double half = 0.7071067811865476;
    ASSERT_TRUE(turned.add(belt, {.pose = {.orientation = {half, 0, -half, 0}}}));  // +x of the belt is +z
    Actor other = on(turned, {0, 1, 0});
    from = other.state.position.z;
    other.run(turned, 2);
    EXPECT_NEAR(other.state.position.z - from, 3, 1e-6);
}

TEST(MovementSurface, AOneWayPlatformIsJumpedThroughFromBelowAndStoodOnFromAbove) {
    const World world = Scene().floor(-5, 5, -5, 5).made_of(3).floor(-2, 2, -2, 2, 1.0).world();
    Actor actor = on(world, {0, 1, 0});
    ASSERT_LT(actor.state.position.y, 1);
    actor.settings.jump_height = 1.6;
    actor.run(world, 0.02, {.jump = true});
    actor.run(world, 2, {.jump = true});
    EXPECT_TRUE(actor.on_ground());
    EXPECT_NEAR(actor.state.position.y, 1.91, 0.005);
    EXPECT_FALSE(actor.did(CharacterEvent::hit_ceiling));
    EXPECT_FALSE(actor.did(CharacterEvent::recovered));
    // Walking about inside of it, below, meets nothing.
    Actor below = on(world, {-4, 1, 0});
    below.run(world, 2, {.wish = {3, 0, 0}});
    EXPECT_GT(below.state.position.x, 1.9);
    EXPECT_FALSE(below.did(CharacterEvent::blocked));
}

TEST(MovementSurface, NobodyStandsOnASlipperyFloor) {
    const World world = Scene().made_of(4).floor(-5, 5, -5, 5).world();
    const Actor actor = on(world, {0, 1, 0});
    EXPECT_EQ(actor.state.footing, Footing::steep);
}

}  // namespace
}  // namespace surefoot::tests
