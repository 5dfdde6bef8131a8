// What the world does with its bodies: names, layers, limits, and what comes with a hit.
#include <limits>
#include <utility>

#include "world_things.hpp"

namespace surefoot {
namespace {

using namespace tests;

template <typename Source>
concept CanBeAdded = requires(World& world, Source&& source) {
    world.add(std::forward<Source>(source));
};

// A world refers to a source; of a mesh it holds a copy, which shares the triangles.
static_assert(CanBeAdded<const VisitedSource&> && CanBeAdded<SourceView> && CanBeAdded<Mesh>);
static_assert(!CanBeAdded<VisitedSource> && !CanBeAdded<const HeightField>);

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(World, a_tie_goes_to_the_lowest_body_whatever_the_order_of_adding) {
    for (const bool backwards : {false, true}) {
        World world;
        for (const std::uint32_t i : {0u, 1u, 2u}) {
            const std::uint32_t body = backwards ? 9 - i : 7 + i;
            ASSERT_TRUE(world.add(floor(4), {.body = body}));
        }
        const auto hit = world.sweep(Sphere{}, {.from = {0, 2, 0}, .to = {0, 0, 0}});
        ASSERT_TRUE(hit);
        EXPECT_EQ(hit->body, 7u);
        const auto nearest = world.nearest({0, 2, 0}, 3);
        ASSERT_TRUE(nearest);
        EXPECT_EQ(nearest->body, 7u);
    }
}

TEST(World, layers_and_filters_decide_what_exists) {
    World world;
    ASSERT_TRUE(world.add(floor(4), {.pose = {{0, 2, 0}}, .body = 1, .layers = 2}));
    const auto low = world.add(floor(4), {.body = 2, .layers = 4});
    ASSERT_TRUE(low);
    const Motion fall{.from = {0.5, 5, 1}, .to = {0.5, -1, 1}};
    const auto met = [&](const WorldQuery& query) {
        const auto hit = world.sweep(Sphere{.radius = 0.1}, fall, query);
        EXPECT_EQ(world.sweep_any(Sphere{.radius = 0.1}, fall, query), hit.has_value());
        return hit ? hit->body : 0;
    };
    EXPECT_EQ(met({}), 1u);
    EXPECT_EQ(met({.layers = 4}), 2u);
    EXPECT_EQ(met({.layers = 1}), 0u);
    EXPECT_EQ(met({.bodies = [](std::uint32_t body) { return body != 1; }}), 2u);
    const auto not_the_upper = [](std::uint32_t body, std::uint32_t, std::uint32_t) { return body != 1; };
    EXPECT_EQ(met({.triangles = not_the_upper}), 2u);
    EXPECT_TRUE(world.set_layers(*low, 0));
    EXPECT_EQ(met({.triangles = not_the_upper}), 0u);
}

TEST(World, one_sided_floors_of_turned_bodies_let_through_from_behind) {
    World world;
    // Turned upside down: its front looks down.
    ASSERT_TRUE(world.add(floor(4), {.pose = {{0, 1, 0}, {0, 0, 0, 2}}}));
    const Sphere ball{.radius = 0.25};
    const Motion down{.from = {0.5, 3, 1}, .to = {0.5, 0, 1}};
    EXPECT_FALSE(world.sweep(ball, down, {.one_sided = true}));
    EXPECT_TRUE(world.sweep(ball, {down.to, down.from}, {.one_sided = true}));
    EXPECT_TRUE(world.sweep(ball, down));
}

TEST(World, refuses_what_cannot_be_placed_and_says_why) {
    World world;
    ASSERT_TRUE(world.add(floor(1), {.body = 3}));
    const auto twice = world.add(floor(1), {.body = 3});
    ASSERT_FALSE(twice);
    EXPECT_EQ(twice.error().code, ErrorCode::invalid);
    EXPECT_NE(twice.error().text.find("body 3"), std::string::npos);
    EXPECT_FALSE(world.add(floor(1), {.pose = {{nan, 0, 0}}}));
    EXPECT_FALSE(world.add(floor(1), {.pose = {{0, 2e9, 0}}}));
    EXPECT_FALSE(world.add(floor(1), {.pose = {{0, 0, 0}, {0, 0, 0, 0}}}));
    EXPECT_FALSE(world.add(floor(1), {.pose = {{0, 0, 0}, {1, nan, 0, 0}}}));
    EXPECT_EQ(world.body_count(), 1u);
}

TEST(World, without_a_number_a_body_takes_the_lowest_that_is_free) {
    World world;
    const auto zero = world.add(floor(1));
    ASSERT_TRUE(world.add(floor(1), {.body = 1}));
    ASSERT_TRUE(world.add(floor(1), {.body = 3}));
    const auto two = world.add(floor(1));
    ASSERT_TRUE(zero && two);
    EXPECT_EQ(world.poses(*zero).body, 0u);
    EXPECT_EQ(world.poses(*two).body, 2u);
    EXPECT_TRUE(world.remove(*zero));
    EXPECT_FALSE(world.find(0));
    const auto again = world.add(floor(1));
    ASSERT_TRUE(again);
    EXPECT_EQ(world.find(0), *again);
    EXPECT_FALSE(world.contains(*zero));
}

TEST(World, a_pose_that_is_not_finite_is_refused_and_the_body_stays) {
    World world;
    const auto body = world.add(floor(4));
    ASSERT_TRUE(body);
    EXPECT_FALSE(world.move(*body, {{0, nan, 0}}));
    EXPECT_FALSE(world.move(*body, {}, {{0, 1, 0}, {0, 0, 0, 0}}));
    EXPECT_TRUE(world.sweep(Sphere{}, {.from = {0, 2, 0}, .to = {0, 0, 0}}));
}

TEST(World, a_question_outside_the_limits_is_blocked) {
    World world;
    const Motion far{.from = {0, 0, 0}, .to = {2e9, 0, 0}};
    for (const auto& hit :
         {world.sweep(Sphere{}, far), world.sweep(Sphere{.radius = 0}, {}), world.ray(far),
          world.sweep(Sphere{}, {}, {.begin = -1}), world.sweep(Sphere{}, {}, {.begin = 0.5, .end = 0.25}),
          world.sweep(Sphere{}, {}, {.end = nan})}) {
        ASSERT_TRUE(hit);
        EXPECT_EQ(hit->status, HitStatus::invalid);
        EXPECT_EQ(hit->t, 0);
    }
    EXPECT_EQ(world.nearest({nan, 0, 0}, 1)->status, HitStatus::invalid);
}

// Seen from a body at -8e8 m, a motion that ends at 8e8 m goes beyond what can be asked. It is blocked if it meets the
// body's box before anything else, and not at all if it does not.
TEST(World, a_body_too_far_apart_blocks_only_where_it_is_met) {
    World world;
    ASSERT_TRUE(world.add(floor(100), {.pose = {{-8e8, 0, 0}, {1, 0, 0, 0}}, .body = 1}));
    const Motion away{.from = {-7e8, 1, 0}, .to = {8e8, 1, 0}};
    const Motion along{.from = {-9e8, 1, 0}, .to = {8e8, 1, 0}};
    for (const Search search : {Search::tree, Search::brute_force}) {
        EXPECT_FALSE(world.sweep(Sphere{}, away, {.search = search}));
        const auto blocked = world.sweep(Sphere{}, along, {.search = search});
        ASSERT_TRUE(blocked);
        EXPECT_EQ(blocked->status, HitStatus::invalid);
        EXPECT_EQ(blocked->t, 0);
        EXPECT_EQ(blocked->body, 1u);
    }
}

TEST(World, weights_of_a_hit_give_its_point_back) {
    World world;
    SplitMix random(61);
    ASSERT_TRUE(world.add(soup(62, 60, 3).mesh(), {.pose = any_pose(random, 3), .body = 4}));
    int hits = 0;
    for (int i = 0; i < 600; ++i) {
        const auto hit = world.ray({random.point(8), random.point(8)});
        if (!hit) continue;
        ++hits;
        const Triangle triangle = *world.triangle(hit->body, hit->triangle);
        const dvec3 weights = barycentrics(hit->point, triangle);
        EXPECT_NEAR(weights.x + weights.y + weights.z, 1, 1e-15);
        EXPECT_GE(std::min(weights.x, std::min(weights.y, weights.z)), 0);
        const dvec3 back = weights.x * triangle.a + weights.y * triangle.b + weights.z * triangle.c;
        EXPECT_LT(glm::length(back - hit->point), 1e-9);
    }
    EXPECT_GT(hits, 50);
}

TEST(World, weights_of_triangles_without_area_are_those_on_their_longest_edge) {
    const Triangle segment{{0, 0, 0}, {1, 0, 0}, {4, 0, 0}};
    EXPECT_EQ(barycentrics({1, 5, 0}, segment), dvec3(0.75, 0, 0.25));
    const Triangle point{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}};
    EXPECT_EQ(barycentrics({3, 0, 0}, point), dvec3(1, 0, 0));
    EXPECT_EQ(barycentrics({nan, 0, 0}, segment), dvec3(1, 0, 0));
}

TEST(World, the_trace_of_a_turned_body_is_in_the_world) {
    World world;
    ASSERT_TRUE(world.add(floor(4), {.pose = {{0, 0, 0}, {1, 1, 0, 0}}}));  // the floor stands upright: a wall
    std::array<TraceRecord, 64> room;
    Trace trace(room);
    const auto hit = world.sweep(Sphere{}, {.from = {0.5, 0, 3}, .to = {0.5, 0, 0}}, {.trace = &trace});
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->normal.z, 1, 1e-12);
    // The face's own plane, which in the body's frame would look along y.
    int faces = 0;
    for (const TraceRecord& record : trace.records()) {
        if (record.feature != Feature::face || record.verdict != Verdict::decided || record.normal == dvec3(0))
            continue;
        ++faces;
        EXPECT_NEAR(record.normal.z, 1, 1e-12);
    }
    EXPECT_GT(faces, 0);
}

// A source of the user's own: one ball-sized hill of a mesh, counted.
TEST(World, takes_any_source_by_reference) {
    const Mesh mesh = floor(4);
    World world;
    ASSERT_TRUE(world.add(SourceView(mesh), {.pose = {{0, 1, 0}}, .body = 2}));
    const auto hit = world.sweep(Sphere{}, {.from = {0, 3, 0}, .to = {0, 1, 0}});
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->t, 0.75, 1e-12);
    EXPECT_EQ(hit->body, 2u);
}

TEST(World, a_guarded_march_stops_where_a_sweep_would_and_an_unguarded_one_tunnels) {
    World world;
    ASSERT_TRUE(world.add(floor(6), {.pose = {{0, 0, 5}, {1, 1, 0, 0}}}));  // a wall at z = 5
    const Sphere ball{.radius = 0.25};
    const JumpArc shot{.from = {0, 1, 0}, .velocity = {0, 4, 60}, .duration = 0.5};
    const auto stopped = march(ball, shot, world, {.steps = 15});
    ASSERT_TRUE(stopped);
    EXPECT_NEAR(stopped->position.z, 4.75, 1e-9);
    EXPECT_FALSE(march(ball, shot, world, {.steps = 15, .guarded = false}));
}

TEST(World, a_march_takes_its_part_of_the_tick) {
    World world;
    const auto lift = world.add(floor(6));
    ASSERT_TRUE(lift);
    ASSERT_TRUE(world.move(*lift, {{0, 4, 0}}));
    const auto stand = [](double) { return dvec3(0, 2.5, 0); };
    // The floor is at 4 t, the ball's lowest point at 2.
    const auto met = march(Sphere{}, stand, world, {.steps = 8});
    ASSERT_TRUE(met);
    EXPECT_NEAR(met->hit.t, 0.5, 1e-12);
    EXPECT_FALSE(march(Sphere{}, stand, world, {.steps = 8}, {.end = 0.25}));
    const auto sampled = march(Sphere{}, stand, world, {.steps = 8, .guarded = false});
    ASSERT_TRUE(sampled);
    EXPECT_NEAR(sampled->hit.t, 0.5, 1e-12);
}

#ifndef NDEBUG
TEST(WorldDeathTest, a_dead_handle_asserts_in_words) {
    World world;
    const auto body = world.add(floor(1));
    ASSERT_TRUE(body);
    ASSERT_TRUE(world.remove(*body));
    EXPECT_DEATH((void)world.remove(*body), "dead");
    EXPECT_DEATH((void)world.move(*body, Pose{}), "dead");
    EXPECT_DEATH((void)world.carried(*body, {}), "dead");
}
#else
TEST(World, a_dead_handle_changes_nothing_where_asserts_are_off) {
    World world;
    const auto body = world.add(floor(1));
    ASSERT_TRUE(body);
    ASSERT_TRUE(world.remove(*body));
    EXPECT_FALSE(world.remove(*body));
    EXPECT_FALSE(world.move(*body, Pose{}));
    EXPECT_FALSE(world.set_layers(*body, 1));
    EXPECT_FALSE(world.refit(*body));
    EXPECT_EQ(world.carried(*body, {1, 2, 3}), dvec3(1, 2, 3));
}
#endif

}  // namespace
}  // namespace surefoot
