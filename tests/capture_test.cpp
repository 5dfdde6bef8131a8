// A captured moment answers as the source that it was taken from, to the last bit, and a changed bit is noticed.
#include <algorithm>
#include <array>

#include "capture_moments.hpp"

namespace surefoot {
namespace {

using namespace tests;

Motion any_motion(SplitMix& random, double size) {
    const dvec3 from = random.point(size);
    return {from, from + random.point(random.next() % 3 == 0 ? size : size / 8)};
}

TEST(Capture, of_a_mesh_replays_to_the_same_bits) {
    const Mesh mesh = soup(1, 400, 10).mesh();
    SplitMix random(2);
    int hits = 0;
    for (int i = 0; i < 2000; ++i) {
        const Volume volume = any_volume(random);
        const Motion motion = any_motion(random, 10);
        const QueryOptions options{.one_sided = i % 3 == 0};
        const Capture capture = capture_sweep(mesh, volume, motion, options);
        ASSERT_TRUE(same_bits(capture.answer, mesh.sweep(volume, motion, options)));
        ASSERT_TRUE(replay(capture).is_same()) << i;
        hits += capture.answer ? 1 : 0;
        const Capture line = capture_ray(mesh, motion, options);
        ASSERT_TRUE(same_bits(line.answer, mesh.ray(motion, options)));
        ASSERT_TRUE(replay(line).is_same()) << i;
    }
    EXPECT_GT(hits, 500);
    EXPECT_LT(hits, 1900);
}

TEST(Capture, holds_what_the_way_comes_by_and_no_more) {
    const Mesh mesh = soup(3, 400, 10).mesh();
    const Motion motion{{-9, 0, 0}, {9, 1, 2}};
    const Capture capture = capture_sweep(mesh, Sphere{0.5}, motion);
    EXPECT_LT(capture.triangles.size(), mesh.triangle_count() / 4);
    // What could be met after the first hit is there as well: it is part of the scene.
    std::size_t touched = 0;
    for (std::uint32_t id = 0; id < mesh.triangle_count(); ++id) {
        if (!sweep(Sphere{0.5}, motion, mesh.triangle(id))) continue;
        ++touched;
        const auto is_it = [&](const CapturedTriangle& one) { return one.id == id; };
        EXPECT_EQ(std::count_if(capture.triangles.begin(), capture.triangles.end(), is_it), 1);
    }
    EXPECT_GT(touched, 3U);
}

TEST(Capture, leaves_out_what_the_filter_refuses) {
    const Mesh mesh = soup(3, 400, 10).mesh();
    const auto odd = [](std::uint32_t id, std::uint32_t) { return id % 2 == 1; };
    const Capture capture = capture_sweep(mesh, Sphere{0.5}, {{-9, 0, 0}, {9, 1, 2}}, {.filter = odd});
    ASSERT_FALSE(capture.triangles.empty());
    for (const CapturedTriangle& one : capture.triangles) EXPECT_EQ(one.id % 2, 1U);
    EXPECT_TRUE(replay(capture).is_same());
}

TEST(Capture, of_one_triangle_is_the_sweep_against_it) {
    const Triangle triangle{{0, 0, 0}, {0, 0, 10}, {10, 0, 10}};
    const Motion motion{{2, 3, 7}, {2, -3, 7}};
    const Capture capture = capture_sweep(triangle, Ellipsoid{}, motion);
    ASSERT_TRUE(capture.answer);
    EXPECT_TRUE(same_bits(capture.answer, sweep(Ellipsoid{}, motion, triangle)));
    EXPECT_TRUE(replay(capture).is_same());
    EXPECT_FALSE(capture_sweep(triangle, Ellipsoid{}, motion, {.one_sided = true}).question.one_sided == false);
}

TEST(Capture, of_a_world_replays_bodies_that_stand_move_and_turn) {
    const World world = moving_world(soup(5, 300, 6));
    SplitMix random(6);
    int hits_of_each[50] = {};
    for (int i = 0; i < 1500; ++i) {
        const Volume volume = any_volume(random);
        const Motion motion = any_motion(random, 8);
        WorldQuery query{.one_sided = i % 5 == 0, .turn_gap = 0.01};
        if (i % 4 == 0) query.begin = random.in(0, 0.9);
        if (i % 4 == 0) query.end = random.in(query.begin, 1);
        const Capture capture = capture_sweep(world, volume, motion, query);
        ASSERT_TRUE(same_bits(capture.answer, world.sweep(volume, motion, query)));
        ASSERT_TRUE(replay(capture).is_same()) << i;
        if (capture.answer) ++hits_of_each[capture.answer->body];
        const Capture line = capture_ray(world, motion, query);
        ASSERT_TRUE(same_bits(line.answer, world.ray(motion, query)));
        ASSERT_TRUE(replay(line).is_same()) << i;
    }
    EXPECT_GT(hits_of_each[2], 50);
    EXPECT_GT(hits_of_each[9], 50);
    EXPECT_GT(hits_of_each[40], 50);
}

TEST(Capture, of_a_world_holds_only_the_bodies_of_the_query) {
    const World world = moving_world(soup(5, 300, 6));
    const auto not_the_first = [](std::uint32_t body) { return body != 2; };
    const auto even = [](std::uint32_t, std::uint32_t id, std::uint32_t) { return id % 2 == 0; };
    const WorldQuery query{.bodies = not_the_first, .triangles = even};
    const Capture capture = capture_sweep(world, Sphere{1}, {{-5, 0, 0}, {5, 0, 0}}, query);
    ASSERT_EQ(capture.bodies.size(), 2U);
    EXPECT_EQ(capture.bodies[0].body, 9U);
    EXPECT_EQ(capture.bodies[1].body, 40U);
    ASSERT_FALSE(capture.triangles.empty());
    for (const CapturedTriangle& one : capture.triangles) EXPECT_TRUE(one.body != 2 && one.id % 2 == 0);
    EXPECT_TRUE(replay(capture).is_same());
}

TEST(Capture, of_what_was_blocked_replays_as_blocked) {
    const Mesh mesh = soup(1, 40, 10).mesh();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const Motion motion{{0, 5, 0}, {0, -5, 0}};
    EXPECT_TRUE(replay(capture_sweep(mesh, Sphere{nan}, motion)).is_same());
    EXPECT_TRUE(replay(capture_sweep(mesh, Sphere{1}, {{nan, 0, 0}, {0, 0, 0}})).is_same());
    EXPECT_TRUE(replay(capture_sweep(Triangle{{nan, 0, 0}, {}, {}}, Sphere{1}, motion)).is_same());
    const World world = moving_world(soup(5, 300, 6));
    const Capture backwards = capture_sweep(world, Sphere{1}, motion, {.begin = 0.5, .end = 0.25});
    ASSERT_TRUE(backwards.answer);
    EXPECT_EQ(backwards.answer->status, HitStatus::invalid);
    EXPECT_TRUE(replay(backwards).is_same());
    const Capture too_fine = capture_sweep(world, Box{}, motion, {.turn_gap = 1e-15});
    ASSERT_TRUE(too_fine.answer);
    EXPECT_TRUE(replay(too_fine).is_same());
    EXPECT_TRUE(replay(capture_sweep(World(), Sphere{1}, motion)).is_same());
}

TEST(Replay, notices_every_changed_bit_and_says_where) {
    const Mesh mesh = soup(1, 400, 10).mesh();
    Capture capture = capture_sweep(mesh, Sphere{0.5}, {{-9, 0, 0}, {9, 1, 2}});
    ASSERT_TRUE(capture.answer);
    const Hit right = *capture.answer;
    const auto flipped = [](double value, int bit) {
        return std::bit_cast<double>(std::bit_cast<std::uint64_t>(value) ^ (std::uint64_t{1} << bit));
    };
    for (int bit = 0; bit < 64; ++bit) {
        capture.answer = right;
        capture.answer->t = flipped(right.t, bit);
        EXPECT_TRUE(replay(capture).differs.t);
        EXPECT_FALSE(replay(capture).differs.point);
        capture.answer = right;
        capture.answer->point.y = flipped(right.point.y, bit);
        EXPECT_TRUE(replay(capture).differs.point);
        capture.answer = right;
        capture.answer->normal.z = flipped(right.normal.z, bit);
        EXPECT_TRUE(replay(capture).differs.normal);
    }
    const auto changed = [&](auto change) {
        capture.answer = right;
        change(*capture.answer);
        return replay(capture).differs;
    };
    EXPECT_TRUE(changed([](Hit& hit) { ++hit.triangle; }).triangle);
    EXPECT_TRUE(changed([](Hit& hit) { ++hit.surface; }).surface);
    EXPECT_TRUE(changed([](Hit& hit) { ++hit.body; }).body);
    EXPECT_TRUE(changed([](Hit& hit) { hit.started_inside = !hit.started_inside; }).started_inside);
    EXPECT_TRUE(changed([](Hit& hit) { hit.status = HitStatus::overflow; }).status);
    EXPECT_TRUE(
        changed([](Hit& hit) { hit.feature = hit.feature == Feature::face ? Feature::edge : Feature::face; }).feature);
    capture.answer.reset();
    EXPECT_TRUE(replay(capture).differs.hit);
    capture.answer = right;
    EXPECT_TRUE(replay(capture).is_same());
}

TEST(Replay, tells_which_planes_were_tried) {
    const Triangle triangle{{0, 0, 0}, {0, 0, 10}, {10, 0, 10}};
    const Capture capture = capture_sweep(triangle, Ellipsoid{}, {{2, 3, 7}, {2, -3, 7}});
    std::array<TraceRecord, 64> room;
    Trace trace(room);
    EXPECT_TRUE(replay(capture, &trace).is_same());
    ASSERT_FALSE(trace.records().empty());
    EXPECT_EQ(trace.records().back().verdict, Verdict::decided);
}

TEST(Replay, of_bodies_that_make_no_world_is_invalid) {
    Capture capture = capture_sweep(moving_world(soup(5, 300, 6)), Sphere{1}, {{-5, 0, 0}, {5, 0, 0}});
    const std::vector<CapturedBody> right = capture.bodies;
    const auto status = [&] { return replay(capture).answer.value_or(Hit{}).status; };
    EXPECT_EQ(status(), HitStatus::ok);
    capture.bodies[1].body = capture.bodies[0].body;
    EXPECT_EQ(status(), HitStatus::invalid);
    capture.bodies = right;
    capture.bodies[0].end.position.x = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(status(), HitStatus::invalid);
    capture.bodies = right;
    capture.bodies[0].bounds.max.x = std::numeric_limits<double>::infinity();
    EXPECT_EQ(status(), HitStatus::invalid);
}

}  // namespace
}  // namespace surefoot
