// What the world answers: the same as one mesh of all its triangles, turned as they are.
#include <cmath>

#include "world_things.hpp"

namespace surefoot {
namespace {

using namespace tests;

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

}  // namespace
}  // namespace surefoot
