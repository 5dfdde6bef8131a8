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

}  // namespace
