// Bodies come, go and move; whatever the tree has become, it answers like brute force, and it stays low.
#include <algorithm>

#include "world/body.hpp"
#include "world/top_tree.hpp"
#include "world_things.hpp"

namespace surefoot {
namespace {

using namespace tests;
using internal::Box3;
using internal::TopTree;

TEST(WorldTree, bodies_that_come_go_and_move_are_found_as_by_brute_force) {
    SplitMix random(101);
    std::vector<Mesh> meshes;
    for (std::uint64_t i = 0; i < 5; ++i) meshes.push_back(soup(400 + i, 8, 2).mesh());
    World world;
    std::vector<BodyHandle> alive;
    int hits = 0;
    for (int round = 0; round < 1500; ++round) {
        const double choice = random.in(0, 1);
        if (alive.size() < 5 || choice < 0.25) {
            const auto added = world.add(meshes[random.next() % 5], {.pose = any_pose(random, 15)});
            ASSERT_TRUE(added);
            alive.push_back(*added);
        } else if (choice < 0.42) {
            const std::size_t which = random.next() % alive.size();
            EXPECT_TRUE(world.remove(alive[which]));
            alive[which] = alive.back();
            alive.pop_back();
        } else if (choice < 0.9) {
            const BodyHandle which = alive[random.next() % alive.size()];
            Pose end = world.poses(which).end;
            end.position += random.point(random.in(0, 1) < 0.8 ? 0.3 : 10);
            if (random.in(0, 1) < 0.3) end.orientation = random.turn();
            EXPECT_TRUE(world.move(which, end));
        } else {
            world.begin_tick();
        }
        ASSERT_EQ(world.body_count(), alive.size());

        const Volume volume(every_shape[static_cast<std::size_t>(round) % 6], random.turn());
        const dvec3 from = random.point(15);
        const Motion motion{from, round % 2 == 0 ? random.point(15) : from + random.point(1)};
        const WorldQuery by_tree{.turn_gap = 0.05};
        const WorldQuery by_force{.search = Search::brute_force, .turn_gap = 0.05};
        const auto hit = world.sweep(volume, motion, by_tree);
        hits += hit.has_value();
        EXPECT_TRUE(same_bits(hit, world.sweep(volume, motion, by_force)));
        EXPECT_EQ(hit.has_value(), world.sweep_any(volume, motion, by_tree));
        EXPECT_TRUE(same_bits(world.ray(motion, by_tree), world.ray(motion, by_force)));
        EXPECT_TRUE(same_bits(world.nearest(from, 9, by_tree), world.nearest(from, 9, by_force)));
        std::array<Overlap, 6> found;
        std::array<Overlap, 6> expected;
        const std::size_t count = world.overlap(volume, from, found, by_tree);
        ASSERT_EQ(count, world.overlap(volume, from, expected, by_force));
        for (std::size_t i = 0; i < std::min(count, found.size()); ++i) EXPECT_TRUE(same_bits(found[i], expected[i]));
        std::array<SourceTriangle, 64> near;
        const Bounds box{from - dvec3(1, 1, 1), from + dvec3(1, 1, 1)};
        EXPECT_EQ(world.gather(box, near, by_tree), world.gather(box, {}, by_force));
        if (HasFailure()) FAIL() << "in round " << round;
    }
    EXPECT_GT(hits, 300);
}

TEST(WorldTree, a_query_opens_few_boxes_among_many_bodies) {
    World world;
    const Mesh tile = floor(0.5f);
    for (int x = 0; x < 40; ++x) {
        for (int z = 0; z < 40; ++z) ASSERT_TRUE(world.add(tile, {.pose = {dvec3(x, 0, z)}}));
    }
    QueryWork work;
    EXPECT_TRUE(world.sweep(Sphere{.radius = 0.2}, {{20.1, 1, 20.2}, {20.1, 0, 20.2}}, {.work = &work}));
    EXPECT_LT(work.nodes, 60u);
}

// Sorted input, which makes a list of an unbalanced tree.
TEST(WorldTree, is_never_higher_than_its_stack_allows) {
    TopTree tree;
    std::vector<std::uint32_t> leaves;
    const auto box_at = [](double x) { return Box3{{x, 0, 0}, {x + 0.5, 1, 1}}; };
    internal::WorldBody* const some_body = reinterpret_cast<internal::WorldBody*>(&leaves);  // never looked into
    const auto deepest = [&] {
        // A walk that opens everything: it is the stack that would overflow.
        std::size_t found = 0;
        tree.visit([](const Box3&) { return 0.0; }, [] { return 1.0; }, [&](const internal::WorldBody&) { ++found; },
                   [] {});
        return found;
    };
    for (int i = 0; i < 5000; ++i) leaves.push_back(tree.insert(box_at(i), some_body));
    EXPECT_EQ(deepest(), 5000u);
    EXPECT_LE(tree.height(), 18);  // 1.44 log2 of 5000
    for (int i = 0; i < 5000; ++i) tree.move(leaves[static_cast<std::size_t>(i)], box_at(-3 * i));
    EXPECT_LE(tree.height(), 18);
    for (int i = 0; i < 4900; ++i) tree.remove(leaves[static_cast<std::size_t>(i)]);
    EXPECT_EQ(deepest(), 100u);
    EXPECT_LE(tree.height(), 10);
    for (int i = 4900; i < 5000; ++i) tree.remove(leaves[static_cast<std::size_t>(i)]);
    EXPECT_EQ(deepest(), 0u);
}

}  // namespace
}  // namespace surefoot
