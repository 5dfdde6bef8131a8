// Any number of threads may ask a const mesh at once. The thread sanitizer watches this test in ./test --all.
#include <array>
#include <gtest/gtest.h>
#include <optional>
#include <thread>
#include <vector>

#include <surefoot/surefoot.hpp>

#include "golden/queries.hpp"

namespace {

constexpr int query_count = 300;

std::vector<double> times_of_touch(const surefoot::Mesh& mesh) {
    golden::Queries queries(7);
    std::vector<double> times;
    for (int i = 0; i < query_count; ++i) {
        const surefoot::Volume volume = queries.volume(static_cast<std::size_t>(i) % 6);
        const surefoot::Motion motion = queries.motion();
        const auto swept = mesh.sweep(volume, motion);
        const auto seen = mesh.ray(motion);
        times.push_back(swept ? swept->t : -1);
        times.push_back(seen ? seen->t : -1);
        std::array<surefoot::Overlap, 4> found;
        times.push_back(static_cast<double>(mesh.overlap(volume, motion.from, found)));
    }
    return times;
}

TEST(Threads, all_get_the_same_answers_from_one_mesh) {
    golden::Queries queries(3);
    std::vector<surefoot::vec3> vertices;
    std::vector<std::uint32_t> indices;
    for (std::uint32_t i = 0; i < 300; ++i) {
        vertices.emplace_back(queries.position());
        indices.push_back(i);
    }
    const auto mesh = surefoot::Mesh::build({.vertices = vertices, .indices = indices});
    ASSERT_TRUE(mesh);

    std::array<std::vector<double>, 4> answers;
    std::vector<std::thread> threads;
    for (std::vector<double>& mine : answers) {
        // Copies of a mesh share its data, and making and dropping them is part of what must be safe.
        threads.emplace_back([copy = *mesh, &mine] { mine = times_of_touch(copy); });
    }
    for (std::thread& thread : threads) thread.join();
    const std::vector<double> alone = times_of_touch(*mesh);
    for (const std::vector<double>& theirs : answers) EXPECT_EQ(theirs, alone);
}

// Standing and turning bodies; between the ticks one thread changes them alone, and all ask again.
TEST(Threads, all_get_the_same_answers_from_one_world) {
    golden::Queries queries(5);
    std::vector<surefoot::vec3> vertices;
    std::vector<std::uint32_t> indices;
    for (std::uint32_t i = 0; i < 60; ++i) {
        vertices.emplace_back(queries.position());
        indices.push_back(i);
    }
    const auto mesh = surefoot::Mesh::build({.vertices = vertices, .indices = indices});
    ASSERT_TRUE(mesh);
    surefoot::World world;
    std::vector<surefoot::BodyHandle> bodies;
    for (int i = 0; i < 8; ++i) {
        const auto added = world.add(*mesh, {.pose = {queries.position(), queries.orientation()}});
        ASSERT_TRUE(added);
        bodies.push_back(*added);
    }
    const auto times = [&world] {
        golden::Queries questions(6);
        std::vector<double> answers;
        for (int i = 0; i < 60; ++i) {
            const surefoot::Volume volume = questions.volume(static_cast<std::size_t>(i) % 6);
            const surefoot::Motion motion = questions.motion();
            const auto swept = world.sweep(volume, motion, {.turn_gap = 0.2});
            const auto nearest = world.nearest(motion.from, 9);
            answers.push_back(swept ? swept->t : -1);
            answers.push_back(nearest ? nearest->distance : -1);
            std::array<surefoot::Overlap, 4> found;
            answers.push_back(static_cast<double>(world.overlap(volume, motion.from, found)));
        }
        return answers;
    };
    for (int tick = 0; tick < 3; ++tick) {
        world.begin_tick();
        ASSERT_TRUE(world.move(bodies[static_cast<std::size_t>(tick)], {queries.position(), queries.orientation()}));
        std::array<std::vector<double>, 4> answers;
        std::vector<std::thread> threads;
        for (std::vector<double>& mine : answers) threads.emplace_back([&] { mine = times(); });
        for (std::thread& thread : threads) thread.join();
        const std::vector<double> alone = times();
        for (const std::vector<double>& theirs : answers) EXPECT_EQ(theirs, alone);
    }
}

}  // namespace
