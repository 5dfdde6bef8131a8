// The benchmark, as far as it can be right or wrong: its scenes, its motions and its comparison with brute force. No
// test looks at a time.
#include <algorithm>
#include <gtest/gtest.h>
#include <span>

#include "check.hpp"
#include "motions.hpp"
#include "rollback.hpp"
#include "shelf.hpp"
#include "suite.hpp"

namespace surefoot::bench {
namespace {

Scene small_scene(const std::string& name) {
    return name == "terrain" ? make_terrain(32) : name == "city" ? make_city(1) : make_soup(4000);
}
const std::string scene_names[] = {"terrain", "city", "soup"};

/// FNV-1a over the bits, so that a scene that differs anywhere differs here.
std::uint64_t hash_of(const Scene& scene) {
    std::uint64_t hash = 0xcbf29ce484222325ULL;
    const auto take = [&](std::span<const std::byte> bytes) {
        for (const std::byte byte : bytes) hash = (hash ^ static_cast<std::uint64_t>(byte)) * 0x100000001b3ULL;
    };
    take(std::as_bytes(std::span(scene.vertices)));
    take(std::as_bytes(std::span(scene.indices)));
    return hash;
}

TEST(Scenes, are_as_large_as_their_page_says) {
    EXPECT_EQ(make_terrain().triangle_count(), 524'288U);
    EXPECT_NEAR(static_cast<double>(make_city().triangle_count()), 200'000, 20'000);
    EXPECT_EQ(make_soup().triangle_count(), 1'000'000U);
}

TEST(Scenes, are_the_same_bits_on_every_machine) {
    EXPECT_EQ(hash_of(make_terrain(64)), 14022267435950842393U);
    EXPECT_EQ(hash_of(make_city(2)), 2357371339895888905U);
    EXPECT_EQ(hash_of(make_soup(1000)), 16489952743817266884U);
}

TEST(Motions, of_a_frame_start_just_off_a_surface) {
    for (const std::string& name : scene_names) {
        const Stage stage(small_scene(name));
        for (const Motion& motion : make_motions(stage.scene, stage.mesh, Body::sphere, Path::brief, 200)) {
            const auto nearest = stage.mesh.nearest(motion.from, 1);
            ASSERT_TRUE(nearest) << name;
            EXPECT_GT(nearest->distance, 0.4) << name;
            EXPECT_LT(nearest->distance, 0.4501) << name;
        }
    }
}

TEST(Motions, of_every_body_start_free) {
    const Stage stage(small_scene("soup"));
    for (const Body body : bodies) {
        const Motions motions = make_motions(stage.scene, stage.mesh, body, Path::brief, 100);
        EXPECT_EQ(motions.size(), 100U) << name_of(body);
        for (const Motion& motion : motions)
            EXPECT_EQ(stage.mesh.overlap(volume_of(body), motion.from, {}), 0U) << name_of(body);
    }
}

TEST(Motions, sorted_in_space_are_the_same_motions_nearer_to_each_other) {
    const Stage stage(small_scene("soup"));
    Motions motions = make_motions(stage.scene, stage.mesh, Body::sphere, Path::brief, 2000);
    Motions sorted = sorted_in_space(motions);
    const auto way = [](const Motions& list) {
        double sum = 0;
        for (std::size_t i = 1; i < list.size(); ++i)
            for (glm::length_t axis = 0; axis < 3; ++axis) sum += std::abs(list[i].from[axis] - list[i - 1].from[axis]);
        return sum;
    };
    EXPECT_LT(way(sorted), 0.3 * way(motions));
    const auto before = [](const Motion& a, const Motion& b) { return a.from.x < b.from.x; };
    std::sort(motions.begin(), motions.end(), before);
    std::sort(sorted.begin(), sorted.end(), before);
    const auto same = [](const Motion& a, const Motion& b) { return a.from == b.from && a.to == b.to; };
    EXPECT_TRUE(std::equal(motions.begin(), motions.end(), sorted.begin(), sorted.end(), same));
}

TEST(Suite, meets_things_in_every_scene_and_answers_as_brute_force) {
    for (const std::string& name : scene_names) {
        const Stage stage(small_scene(name));
        for (const Row& row : run_suite(stage, {.motions = 64, .rounds = 2, .batch_seconds = 1e-5, .checked = 8})) {
            SCOPED_TRACE(name + ": " + name_of(row.workload) + " of " + std::string(name_of(row.workload.solver)));
            EXPECT_GT(row.median, 0);
            EXPECT_GT(row.hit_share, 0.02);
            EXPECT_EQ(row.checked.wrong, 0U);
            if (row.workload.solver == Solver::surefoot) {
                EXPECT_EQ(row.checked.answers, 8U);
                EXPECT_GT(row.tested, 0);
            }
        }
    }
}

TEST(Check, counts_answers_of_another_scene_as_wrong) {
    Stage stage(small_scene("terrain"));
    for (vec3& vertex : stage.scene.vertices) vertex.y += 0.03F;
    MotionShelf shelf(stage, 64);
    for (const Workload& workload : all_workloads()) {
        // The nearest point has the mesh's own brute force as its reference, which knows nothing of the change.
        if (workload.solver != Solver::surefoot || workload.question == Question::nearest) continue;
        if (workload.question == Question::gather) continue;  // a few centimetres seldom change what is near
        EXPECT_GT(check(stage, workload, shelf.of(workload)).wrong, 0U) << name_of(workload);
    }
}

TEST(Rollback, of_a_crowd_on_lifts_comes_to_the_same_hash_in_every_frame) {
    const RollbackReport report = run_rollback({.rounds = 40});
    EXPECT_FALSE(report.first_differs.has_value()) << *report.first_differs;
    EXPECT_EQ(report.compared, 320U);
    EXPECT_GT(report.touching, 0.9) << "they are to touch each other";
    EXPECT_GT(report.riding, 0.9) << "on the lifts";
    EXPECT_GT(report.frame, 0);
}

TEST(Rollback, that_forgets_where_the_lifts_were_is_found_in_its_first_frame) {
    const RollbackReport report = run_rollback({.rounds = 3, .settling = 60, .restores_poses = false});
    ASSERT_TRUE(report.first_differs.has_value());
    EXPECT_EQ(*report.first_differs, 52U);
}

}  // namespace
}  // namespace surefoot::bench
