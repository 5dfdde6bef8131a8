#include <cmath>
#include <limits>

#include "world_things.hpp"

namespace surefoot {
namespace {

using namespace tests;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// The triangles of one mesh, split over a hundred bodies; triangle k of body b is triangle b * share + k.
struct Split {
    static constexpr std::uint32_t bodies = 100;
    static constexpr std::uint32_t share = 4;
    Mesh mesh;
    World world;

    explicit Split(std::uint64_t seed) : mesh(soup(seed, bodies * share, 10).mesh()) {
        const Soup all = soup(seed, bodies * share, 10);
        // Not in the order of their numbers, so that nothing depends on it.
        for (std::uint32_t i = 0; i < bodies; ++i) {
            const std::uint32_t body = i * 37 % bodies;
            EXPECT_TRUE(world.add(all.mesh(std::size_t{body} * share, share), {.body = body}));
        }
    }
    template <typename Answer>
    static Answer in_one(Answer answer) {
        answer.triangle += answer.body * share;
        answer.body = 0;
        return answer;
    }
    static SourceTriangle in_one(SourceTriangle found) {
        found.id += found.body * share;
        found.body = 0;
        return found;
    }
    template <typename Answer>
    static std::optional<Answer> in_one(const std::optional<Answer>& answer) {
        return answer ? std::optional(in_one(*answer)) : answer;
    }
};

TEST(World, the_same_triangles_in_one_mesh_or_over_a_hundred_bodies_answer_with_the_same_bits) {
    const Split split(11);
    SplitMix random(12);
    int hits = 0;
    int touching = 0;
    for (int i = 0; i < 480; ++i) {
        const Volume volume(every_shape[static_cast<std::size_t>(i) % 6],
                            i % 2 == 0 ? dquat(1, 0, 0, 0) : random.turn());
        const dvec3 from = random.point(10);
        const Motion motion{from, i % 3 == 0 ? random.point(10) : from + random.point(0.3)};
        const bool one_sided = i % 5 == 0;
        for (const Search search : {Search::tree, Search::brute_force}) {
            const QueryOptions plain{.one_sided = one_sided};
            const WorldQuery query{.one_sided = one_sided, .search = search};
            const auto swept = split.world.sweep(volume, motion, query);
            EXPECT_TRUE(same_bits(split.mesh.sweep(volume, motion, plain), Split::in_one(swept)));
            EXPECT_EQ(split.world.sweep_any(volume, motion, query), swept.has_value());
            const auto seen = split.world.ray(motion, query);
            EXPECT_TRUE(same_bits(split.mesh.ray(motion, plain), Split::in_one(seen)));
            EXPECT_EQ(split.world.ray_any(motion, query), seen.has_value());
            const auto nearest = split.world.nearest(from, 3, query);
            EXPECT_TRUE(same_bits(split.mesh.nearest(from, 3, plain), Split::in_one(nearest)));

            std::array<Overlap, 7> expected;
            std::array<Overlap, 7> found;
            const std::size_t count = split.world.overlap(volume, from, found, query);
            EXPECT_EQ(split.mesh.overlap(volume, from, expected, plain), count);
            for (std::size_t k = 0; k < std::min(count, found.size()); ++k) {
                EXPECT_TRUE(same_bits(expected[k], Split::in_one(found[k])));
            }
            std::array<SourceTriangle, 200> gathered_before;
            std::array<SourceTriangle, 200> gathered;
            const Bounds near{from - dvec3(1, 1, 1), from + dvec3(1, 1, 1)};
            const std::size_t gathered_count = split.world.gather(near, gathered, query);
            EXPECT_EQ(split.mesh.gather(near, gathered_before, plain), gathered_count);
            for (std::size_t k = 0; k < std::min(gathered_count, gathered.size()); ++k) {
                EXPECT_TRUE(same_bits(gathered_before[k], Split::in_one(gathered[k])));
            }
            hits += swept.has_value();
            touching += count > 0;
        }
    }
    EXPECT_GT(hits, 150);
    EXPECT_GT(touching, 150);
}

// A pose that turns nothing and whose differences are doubles changes no bit either: the sweep is that in the body.
TEST(World, a_body_that_only_stands_elsewhere_answers_for_the_relative_motion) {
    const Mesh mesh = soup(21, 200, 4).mesh();
    World world;
    const dvec3 place(1024, -64, 0.5);
    const auto body = world.add(mesh, {.pose = {place, dquat(-3, 0, 0, 0)}, .body = 5});
    ASSERT_TRUE(body);
    SplitMix random(22);
    int hits = 0;
    for (int i = 0; i < 600; ++i) {
        const Volume volume(every_shape[static_cast<std::size_t>(i) % 6], random.turn());
        // Eighths of a metre, so that every difference is a double.
        const auto grid = [&] { return glm::floor(random.point(40)) * 0.125; };
        const Motion local{grid(), grid()};
        const auto expected = mesh.sweep(volume, local);
        const auto hit = world.sweep(volume, {local.from + place, local.to + place});
        ASSERT_EQ(hit.has_value(), expected.has_value());
        if (!hit) continue;
        ++hits;
        EXPECT_TRUE(same_bits(hit->t, expected->t));
        EXPECT_TRUE(same_bits(hit->normal, expected->normal));
        EXPECT_TRUE(same_bits(hit->point, place + expected->point));
        EXPECT_EQ(hit->body, 5u);
        EXPECT_EQ(hit->surface, mesh.surface(hit->triangle));
    }
    EXPECT_GT(hits, 100);
}

// The first touch of triangles that were placed in the world one by one.
std::optional<Hit> sweep_placed(const World& world, const std::vector<std::size_t>& counts, const Volume& volume,
                                const Motion& motion) {
    std::optional<Hit> first;
    for (std::uint32_t body = 0; body < counts.size(); ++body) {
        for (std::uint32_t id = 0; id < counts[body]; ++id) {
            const auto hit = sweep(volume, motion, *world.triangle(body, id));
            if (hit && (!first || hit->t < first->t)) first = hit;
        }
    }
    return first;
}

TEST(World, turned_bodies_answer_within_the_hair_like_the_triangles_turned) {
    World world;
    SplitMix random(31);
    std::vector<std::size_t> counts;
    for (std::uint32_t i = 0; i < 6; ++i) {
        const Soup part = soup(32 + i, 25, 3);
        ASSERT_TRUE(world.add(part.mesh(), {.pose = any_pose(random, 6), .body = i}));
        counts.push_back(part.count());
    }
    int hits = 0;
    int disagreements = 0;
    for (int i = 0; i < 1500; ++i) {
        const Volume volume(every_shape[static_cast<std::size_t>(i) % 6], random.turn());
        const Motion motion{random.point(9), random.point(9)};
        const auto expected = sweep_placed(world, counts, volume, motion);
        const auto hit = world.sweep(volume, motion);
        EXPECT_TRUE(same_bits(hit, world.sweep(volume, motion, {.search = Search::brute_force})));
        if (hit.has_value() != expected.has_value()) {
            ++disagreements;  // one grazes by less than the hair
            continue;
        }
        if (!hit) continue;
        ++hits;
        const dvec3 way = motion.to - motion.from;
        const double between = (expected->t - hit->t) * std::abs(glm::dot(expected->normal, way));
        EXPECT_LT(std::abs(between), 1e-10) << "by " << between << " m";
        if (hit->t > 0 && hit->feature == expected->feature) {
            EXPECT_LT(glm::length(hit->point - expected->point), 1e-5);
        }
    }
    EXPECT_GT(hits, 400);
    EXPECT_LE(disagreements, 1);
}

TEST(World, turned_bodies_are_touched_listed_and_near_where_their_triangles_are) {
    World world;
    SplitMix random(41);
    std::vector<std::size_t> counts;
    for (std::uint32_t i = 0; i < 5; ++i) {
        const Soup part = soup(42 + i, 20, 3);
        ASSERT_TRUE(world.add(part.mesh(), {.pose = any_pose(random, 5), .body = 2 * i}));
        counts.push_back(part.count());
    }
    std::size_t touched = 0;
    for (int i = 0; i < 400; ++i) {
        const Volume volume(every_shape[static_cast<std::size_t>(i) % 6], random.turn());
        const dvec3 place = random.point(4);
        std::vector<Overlap> expected;
        std::vector<SourceTriangle> in_box;
        double least = 4;
        const Bounds near{place - dvec3(0.8, 0.8, 0.8), place + dvec3(0.8, 0.8, 0.8)};
        for (std::uint32_t body = 0; body < counts.size(); ++body) {
            for (std::uint32_t id = 0; id < counts[body]; ++id) {
                const Triangle triangle = *world.triangle(2 * body, id);
                if (auto found = overlap(volume, place, triangle)) {
                    found->body = 2 * body;
                    found->triangle = id;
                    expected.push_back(*found);
                }
                // No function of the world: the smallest ball around the point that reaches the triangle.
                const dvec3 weights = barycentrics(place, triangle);
                const dvec3 foot = weights.x * triangle.a + weights.y * triangle.b + weights.z * triangle.c;
                least = std::min(least, glm::length(foot - place));
                if (overlap(Box{.half_extents = {0.8, 0.8, 0.8}}, place, triangle)) {
                    in_box.push_back({.triangle = triangle, .id = id, .body = 2 * body});
                }
            }
        }
        std::array<Overlap, 100> found;
        ASSERT_EQ(world.overlap(volume, place, found), expected.size());
        for (std::size_t k = 0; k < expected.size(); ++k) {
            EXPECT_EQ(found[k].body, expected[k].body);
            EXPECT_EQ(found[k].triangle, expected[k].triangle);
            EXPECT_NEAR(found[k].depth, expected[k].depth, 1e-9);
        }
        touched += expected.size();
        // With less room, the lowest, and the same count.
        std::array<Overlap, 2> few;
        EXPECT_EQ(world.overlap(volume, place, few), expected.size());
        for (std::size_t k = 0; k < std::min<std::size_t>(2, expected.size()); ++k) {
            EXPECT_TRUE(same_bits(few[k], found[k]));
        }

        const auto nearest = world.nearest(place, 4);
        ASSERT_EQ(nearest.has_value(), least < 4);
        if (nearest) {
            EXPECT_NEAR(nearest->distance, least, 1e-12);
            EXPECT_NEAR(glm::length(nearest->point - place), least, 1e-12);
        }

        std::array<SourceTriangle, 100> gathered;
        // At least what reaches into the box, each once and in order.
        const std::size_t count = world.gather(near, gathered);
        ASSERT_LE(count, gathered.size());
        std::size_t k = 0;
        for (const SourceTriangle& wanted : in_box) {
            while (k < count && (gathered[k].body != wanted.body || gathered[k].id != wanted.id)) ++k;
            ASSERT_LT(k, count);
            EXPECT_EQ(gathered[k].triangle.b, wanted.triangle.b);
        }
    }
    EXPECT_GT(touched, 100u);
}

TEST(World, more_overlaps_than_one_batch_are_all_listed_in_order) {
    World world;
    const Soup dense = soup(51, 150, 0.5);
    ASSERT_TRUE(world.add(dense.mesh(), {.pose = {{3, 2, 1}, {1, 2, 3, 4}}, .body = 9}));
    const Mesh mesh = dense.mesh();
    ASSERT_TRUE(world.add(mesh, {.pose = {{3, 2, 1}, {4, 1, 1, 0}}, .body = 4}));
    std::array<Overlap, 400> found;
    const std::size_t count = world.overlap(Sphere{.radius = 2}, {3, 2, 1}, found);
    ASSERT_EQ(count, 300u);
    for (std::uint32_t k = 0; k < count; ++k) {
        EXPECT_EQ(found[k].body, k < 150 ? 4u : 9u);
        EXPECT_EQ(found[k].triangle, k % 150);
    }
}

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
