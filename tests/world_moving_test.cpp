#include <algorithm>
#include <cmath>

#include "world_things.hpp"

namespace surefoot {
namespace {

using namespace tests;

constexpr double turn_gap = 0.001;

dquat about_y(double degrees) {
    const double half = degrees * 3.14159265358979323846 / 360;
    return dquat(std::cos(half), 0, std::sin(half), 0);
}

TEST(WorldMoving, a_lift_that_comes_up_hits_who_stands_on_its_way) {
    World world;
    const auto lift = world.add(floor(2), {.body = 8});
    ASSERT_TRUE(lift);
    ASSERT_TRUE(world.move(*lift, {{0, 1, 0}}));
    const dvec3 feet_at_half(0.3, 1.4, 0.2);  // the capsule's lowest point is at 0.5
    const auto hit = world.sweep(Capsule{}, {feet_at_half, feet_at_half});
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->t, 0.5, 1e-12);
    EXPECT_NEAR(hit->point.y, 0.5, 1e-12);
    EXPECT_EQ(hit->normal, dvec3(0, 1, 0));
    EXPECT_EQ(hit->body, 8u);
    EXPECT_FALSE(hit->started_inside);
    // Whoever rides along is not hit, and neither is anybody in the part of the tick before.
    EXPECT_FALSE(world.sweep(Sphere{}, {{0.3, 0.5, 0.2}, {0.3, 1.5, 0.2}}));
    EXPECT_FALSE(world.sweep(Capsule{}, {feet_at_half, feet_at_half}, {.end = 0.49}));
    EXPECT_TRUE(world.sweep(Capsule{}, {feet_at_half, feet_at_half}, {.begin = 0.25, .end = 0.75}));
    // A moment takes no time, so nothing moves in it.
    EXPECT_FALSE(world.sweep(Capsule{}, {feet_at_half, feet_at_half}, {.begin = 0.25, .end = 0.25}));
    EXPECT_TRUE(world.ray({{0, 2, 0}, {0, 0.8, 0}}, {.begin = 1}));
    EXPECT_FALSE(world.ray({{0, 2, 0}, {0, 0.8, 0}}, {.end = 0}));
}

TEST(WorldMoving, in_the_next_tick_what_arrived_stands_still) {
    World world;
    const auto lift = world.add(floor(2));
    ASSERT_TRUE(lift);
    ASSERT_TRUE(world.move(*lift, {{0, 1, 0}}));
    const dvec3 above(0, 1.6, 0);
    EXPECT_TRUE(world.sweep(Sphere{.radius = 0.7}, {above, above}));
    world.begin_tick();
    EXPECT_FALSE(world.sweep(Sphere{.radius = 0.7}, {above, above}));
    EXPECT_EQ(world.poses(*lift).start.position, dvec3(0, 1, 0));
    const auto fall = world.sweep(Sphere{}, {{0, 3, 0}, {0, 1, 0}});
    ASSERT_TRUE(fall);
    EXPECT_NEAR(fall->t, 0.75, 1e-12);
}

// The relative motion is exact: a body that moves and does not turn is the body standing, asked about it.
TEST(WorldMoving, a_body_that_moves_answers_like_the_relative_motion) {
    const Mesh mesh = soup(71, 150, 4).mesh();
    World world;
    const auto body = world.add(mesh, {.body = 3});
    ASSERT_TRUE(body);
    SplitMix random(72);
    int hits = 0;
    for (int i = 0; i < 600; ++i) {
        const auto grid = [&](double size) { return glm::floor(random.point(size)) * 0.125; };
        const Pose start{grid(80)};
        const Pose end{start.position + grid(30)};
        ASSERT_TRUE(world.move(*body, start, end));
        const Volume volume(every_shape[static_cast<std::size_t>(i) % 6], random.turn());
        const Motion local{grid(45), grid(45)};
        const Motion motion{local.from + start.position, local.to + end.position};
        const auto expected = mesh.sweep(volume, local);
        const auto hit = world.sweep(volume, motion);
        ASSERT_EQ(hit.has_value(), expected.has_value());
        EXPECT_EQ(world.sweep_any(volume, motion), hit.has_value());
        EXPECT_EQ(world.ray(motion).has_value(), mesh.ray(local).has_value());
        if (!hit) continue;
        ++hits;
        EXPECT_TRUE(same_bits(hit->t, expected->t));
        EXPECT_TRUE(same_bits(hit->normal, expected->normal));
        EXPECT_EQ(hit->triangle, expected->triangle);
        const dvec3 place = start.position + (end.position - start.position) * hit->t;
        EXPECT_LT(glm::length(hit->point - (expected->point + place)), 1e-12);
    }
    EXPECT_GT(hits, 150);
}

// The deepest that the volume is in any triangle of the body at a time of the tick; -1 if it touches none.
double depth_at(const World& world, std::uint32_t body, const Mesh& mesh, const Volume& volume, const dvec3& place,
                double at) {
    double deepest = -1;
    for (std::uint32_t id = 0; id < mesh.triangle_count(); ++id) {
        const auto found = overlap(volume, place, *world.triangle(body, id, at));
        if (found) deepest = std::max(deepest, found->depth);
    }
    return deepest;
}

// The volume, a little more than `by` larger in every direction.
Volume larger_by(const Volume& volume, double by) {
    Volume result = volume;
    if (auto* sphere = std::get_if<Sphere>(&result.shape)) sphere->radius += by;
    if (auto* capsule = std::get_if<Capsule>(&result.shape)) capsule->radius += by;
    if (auto* box = std::get_if<Box>(&result.shape)) box->half_extents += dvec3(by, by, by);
    if (auto* ellipsoid = std::get_if<Ellipsoid>(&result.shape)) ellipsoid->radii += 2.0 * dvec3(by, by, by);
    if (auto* cylinder = std::get_if<Cylinder>(&result.shape)) {
        cylinder->radius += by;
        cylinder->half_height += by;
    }
    return result;
}

struct Tick {
    Mesh mesh;
    World world;
    BodyHandle handle;

    explicit Tick(const Mesh& of) : mesh(of) {
        const auto added = world.add(mesh, {.body = 6});
        EXPECT_TRUE(added);
        handle = *added;
    }
    dvec3 place_at(const Motion& motion, double t) const { return motion.from + (motion.to - motion.from) * t; }

    // Compares a sweep with many moments of the tick, each a question of its own. Returns whether there was a hit.
    bool check(const Volume& volume, const Motion& motion, int samples) const {
        const auto hit = world.sweep(volume, motion, {.turn_gap = turn_gap});
        const auto brute = world.sweep(volume, motion, {.search = Search::brute_force, .turn_gap = turn_gap});
        EXPECT_TRUE(same_bits(hit, brute));
        EXPECT_EQ(world.sweep_any(volume, motion, {.turn_gap = turn_gap}), hit.has_value());
        const double last = hit ? hit->t : 1;
        for (int i = 0; i <= samples; ++i) {
            const double t = last * i / samples;
            const double depth = depth_at(world, 6, mesh, volume, place_at(motion, t), t);
            EXPECT_LE(depth, turn_gap) << "deeper than it says, at t = " << t << " of " << last;
            if (depth > turn_gap) return hit.has_value();
        }
        if (hit) {
            EXPECT_EQ(hit->status, HitStatus::ok);
            EXPECT_GE(depth_at(world, 6, mesh, larger_by(volume, 1.1 * turn_gap), place_at(motion, hit->t), hit->t), 0)
                << "hit at t = " << hit->t << " where there is nothing within the gap";
            const Triangle met = *world.triangle(6, hit->triangle, hit->t);
            const dvec3 weights = barycentrics(hit->point, met);
            const dvec3 back = weights.x * met.a + weights.y * met.b + weights.z * met.c;
            EXPECT_LT(glm::length(back - hit->point), 1e-9) << "the point is not on the triangle";
            EXPECT_NEAR(glm::length(hit->normal), 1, 1e-12);
        }
        return hit.has_value();
    }
};

Mesh door() {
    return quad({0, 0, 0}, {1.2f, 0, 0}, {1.2f, 2.2f, 0}, {0, 2.2f, 0});
}

TEST(WorldMoving, a_door_that_swings_hits_who_stands_in_its_way_however_fast) {
    Tick tick(door());
    int asked = 0;
    for (const double degrees : {1.0, 3.0, 20.0, 90.0, 170.0}) {
        for (const Shape& shape : every_shape) {
            if (std::holds_alternative<Cone>(shape)) continue;  // stands on its apex: another height
            // It turns from -z towards +x: whoever stands a little behind the edge is met.
            ASSERT_TRUE(tick.world.move(tick.handle, {{0, 0, 0}}, {{0, 0, 0}, about_y(degrees)}));
            const double angle = degrees * 3.14159265358979323846 / 360;
            const dvec3 stand(0.9 * std::cos(angle), 1, -0.9 * std::sin(angle) - (degrees < 10 ? 0.55 : 0.0));
            const bool starts_clear = depth_at(tick.world, 6, tick.mesh, shape, stand, 0) < 0;
            if (!starts_clear) continue;
            const bool hit = tick.check(shape, {stand, stand}, 60);
            ++asked;
            if (degrees >= 90) {
                EXPECT_TRUE(hit) << degrees << " degrees";
            }
        }
    }
    EXPECT_GT(asked, 12);
}

TEST(WorldMoving, a_door_does_not_hit_who_it_leaves) {
    Tick tick(door());
    ASSERT_TRUE(tick.world.move(tick.handle, {{0, 0, 0}}, {{0, 0, 0}, about_y(5)}));
    // In touch with the side that swings away.
    const dvec3 beside(0.6, 1, 0.5);
    EXPECT_FALSE(tick.world.sweep(Sphere{}, {beside, beside}));
    EXPECT_FALSE(tick.world.sweep(Capsule{.radius = 0.5}, {beside, beside}));
    EXPECT_FALSE(tick.world.sweep(Box{.half_extents = {0.3, 0.5, 0.5}}, {beside, beside}));
    // And who walks with it on the other side is in its way only if it is faster.
    const dvec3 before(0.6, 1, -0.5);
    const auto pushed = tick.world.sweep(Sphere{}, {before, before});
    ASSERT_TRUE(pushed);
    EXPECT_EQ(pushed->t, 0);
    EXPECT_FALSE(tick.world.sweep(Sphere{}, {before, before - dvec3(0, 0, 0.2)}));
}

// A turntable carries a player round; a box does not turn with it, but its sole stays in the floor's plane.
TEST(WorldMoving, a_rider_of_a_turntable_is_free) {
    World world;
    const auto table = world.add(floor(5));
    ASSERT_TRUE(table);
    ASSERT_TRUE(world.move(*table, {}, {{0, 0, 0}, about_y(8)}));
    for (const double height : {0.0, 0.002}) {
        for (const Shape& shape :
             {Shape{Capsule{.radius = 0.4, .half_height = 0.5}}, Shape{Ellipsoid{}}, Shape{Cylinder{}}, Shape{Box{}}}) {
            const dvec3 stand(2, 0.9 + height, 1);
            const dvec3 goes = world.carried(*table, stand);
            EXPECT_EQ(goes.y, stand.y);
            const auto hit = world.sweep(shape, {stand, goes});
            EXPECT_FALSE(hit) << "shape " << shape.index() << " at " << height << ", t = " << hit->t;
        }
    }
}

// The player stands right over the hinge, where the door's relative motion is nothing but a turn.
TEST(WorldMoving, a_volume_at_the_hinge_is_hit_by_what_turns_into_it) {
    Tick tick(quad({0.5f, 0, -0.2f}, {1.5f, 0, -0.2f}, {1.5f, 2, -0.2f}, {0.5f, 2, -0.2f}));
    ASSERT_TRUE(tick.world.move(tick.handle, {}, {{0, 0, 0}, about_y(-60)}));
    const dvec3 hinge(0, 1, 0);
    // The wall's near edge goes round at 0.54 m, from beside the volume to before its end.
    EXPECT_TRUE(tick.check(Box{.half_extents = {0.535, 0.5, 0.1}}, {hinge, hinge}, 200));
    EXPECT_TRUE(tick.check(Ellipsoid{.radii = {0.62, 0.6, 0.2}}, {hinge, hinge}, 200));
    EXPECT_FALSE(tick.check(Capsule{.radius = 0.4, .half_height = 0.1}, {hinge, hinge}, 200));
}

TEST(WorldMoving, turning_bodies_are_never_met_late_nor_too_early) {
    SplitMix random(81);
    int hits = 0;
    for (int i = 0; i < 200; ++i) {
        Tick tick(soup(200 + static_cast<std::uint64_t>(i), 6, 2).mesh());
        const Pose start = any_pose(random, 2);
        Pose end{start.position + random.point(0.5), start.orientation};
        const double strength = i % 3 == 0 ? 0.7 : 0.1;
        end.orientation = end.orientation * glm::length(end.orientation);
        const dquat other = random.turn();
        end.orientation = dquat(end.orientation.w + strength * other.w, end.orientation.x + strength * other.x,
                                end.orientation.y + strength * other.y, end.orientation.z + strength * other.z);
        ASSERT_TRUE(tick.world.move(tick.handle, start, end));
        const Shape& shape = every_shape[static_cast<std::size_t>(i) % 5];
        const Volume volume(shape, random.turn());
        Motion motion{random.point(4), random.point(4)};
        // Starts in touch are a matter of approach, and have their own tests.
        while (depth_at(tick.world, 6, tick.mesh, larger_by(volume, 0.01), motion.from, 0) >= 0) {
            motion.from = random.point(4);
        }
        hits += tick.check(volume, motion, 100);
        if (testing::Test::HasFailure()) FAIL() << "in round " << i << ", shape " << shape.index();
    }
    EXPECT_GT(hits, 40);
}

TEST(WorldMoving, a_ray_bends_with_the_body_that_turns) {
    Tick tick(door());
    ASSERT_TRUE(tick.world.move(tick.handle, {}, {{0, 0, 0}, about_y(90)}));
    // It stands still where the door comes by half way, at 45 degrees.
    const dvec3 place(0.5, 1, -0.5);
    const auto hit = tick.world.ray({place, place});
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->t, 0.5, 1e-3);
    EXPECT_TRUE(tick.world.ray_any({place, place}));
    EXPECT_LT(glm::length(hit->point - place), 2e-3);
    const dvec3 beyond(0.9, 1, -0.9);
    EXPECT_FALSE(tick.world.ray({beyond, beyond}));
}

TEST(WorldMoving, what_turns_too_far_for_its_gap_overflows_where_it_is_met_and_only_there) {
    World world;
    const auto body = world.add(floor(1000), {.body = 2});
    ASSERT_TRUE(body);
    ASSERT_TRUE(world.move(*body, {}, {{0, 0, 0}, {1, 1, 0, 0}}));
    const Motion near{.from = {100, 40, -900}, .to = {100, 41, -900}};  // the floor comes up here
    const Motion far{.from = {5000, 40, 900}, .to = {5000, 41, 900}};
    for (const Search search : {Search::tree, Search::brute_force}) {
        const auto hit = world.sweep(Box{}, near, {.search = search, .turn_gap = 1e-6});
        ASSERT_TRUE(hit);
        EXPECT_EQ(hit->status, HitStatus::overflow);
        EXPECT_EQ(hit->t, 0);
        EXPECT_EQ(hit->body, 2u);
        EXPECT_FALSE(world.sweep(Box{}, far, {.search = search, .turn_gap = 1e-6}));
        const auto roughly = world.sweep(Box{}, near, {.search = search, .turn_gap = 10});
        ASSERT_TRUE(roughly);
        EXPECT_EQ(roughly->status, HitStatus::ok);
        EXPECT_GT(roughly->t, 0);
    }
}

TEST(WorldMoving, a_point_is_carried_along_and_says_how_fast) {
    World world;
    const auto body = world.add(floor(1), {.pose = {{1, 2, 3}}});
    ASSERT_TRUE(body);
    EXPECT_EQ(world.carried(*body, {5, 5, 5}), dvec3(5, 5, 5));
    ASSERT_TRUE(world.move(*body, {{2, 2, 3}}));
    EXPECT_EQ(world.carried(*body, {5, 5, 5}), dvec3(6, 5, 5));
    EXPECT_EQ(world.carried(*body, {5, 5, 5}, 0.5, 1), dvec3(5.5, 5, 5));
    EXPECT_EQ(world.velocity_at(*body, {5, 5, 5}, 0.5), dvec3(2, 0, 0));
    ASSERT_TRUE(world.move(*body, {{0, 0, 0}}, {{0, 0, 0}, about_y(90)}));
    const dvec3 turned = world.carried(*body, {1, 7, 0});
    EXPECT_LT(glm::length(turned - dvec3(0, 7, -1)), 1e-15);
}

TEST(WorldMoving, poses_between_are_those_at_the_ends_and_turn_the_shorter_way) {
    const Pose start{{1, 2, 3}, {0, 3, 0, 0}};
    const Pose end{{2, 2, 3}, {0, -5, 0, 0.001}};
    EXPECT_EQ(pose_between(start, end, 0).orientation, start.orientation);
    EXPECT_EQ(pose_between(start, end, 1).orientation, end.orientation);
    const Pose half = pose_between(start, end, 0.5);
    EXPECT_EQ(half.position, dvec3(1.5, 2, 3));
    // A quarter turn about x would carry y far away; the shorter way hardly moves it.
    EXPECT_LT(glm::length(to_world({{0, 0, 0}, half.orientation}, {0, 1, 0}) - dvec3(0, -1, 0)), 1e-3);
    EXPECT_LT(glm::length(to_body(half, to_world(half, {4, 5, 6})) - dvec3(4, 5, 6)), 1e-14);
}

}  // namespace
}  // namespace surefoot
