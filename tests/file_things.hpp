// Small levels, their files, and a folder of its own for each test.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <optional>
#include <span>
#include <string>
#include <unistd.h>
#include <vector>

#include <surefoot/cook.hpp>
#include <surefoot/mesh.hpp>

#include "splitmix.hpp"

namespace surefoot::tests {

using Bytes = std::vector<std::byte>;

class FileTest : public testing::Test {
protected:
    void SetUp() override {
        const auto* const test = testing::UnitTest::GetInstance()->current_test_info();
        folder_ =
            std::filesystem::temp_directory_path() / ("surefoot-file-" + std::to_string(getpid()) + "-" + test->name());
        std::filesystem::create_directories(folder_);
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    [[nodiscard]] std::string path(const std::string& name) const { return (folder_ / name).string(); }

    [[nodiscard]] std::size_t file_count() const {
        const std::filesystem::directory_iterator files(folder_);
        return static_cast<std::size_t>(std::distance(begin(files), end(files)));
    }

    std::filesystem::path folder_;
};

inline Bytes read_bytes(const std::string& path) {
    std::ifstream input(path, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(input), {}};
    const auto bytes = std::as_bytes(std::span(text));
    return {bytes.begin(), bytes.end()};
}

inline void write_bytes(const std::string& path, std::span<const std::byte> bytes) {
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

struct Level {
    std::vector<dvec3> vertices;
    std::vector<std::uint32_t> indices;

    [[nodiscard]] CookInput input() const { return {.vertices = vertices, .indices = indices}; }
};

/// Hills of side x side squares of `step` metres, every triangle in its place, from `origin` on.
inline Level hills(std::uint32_t side, double step = 0.5, const dvec3& origin = {0, 0, 0}) {
    Level level;
    SplitMix random(7);
    for (std::uint32_t z = 0; z <= side; ++z)
        for (std::uint32_t x = 0; x <= side; ++x)
            level.vertices.push_back(
                origin + dvec3(x * step, static_cast<double>(static_cast<float>(random.in(0, 1))), z * step));
    for (std::uint32_t z = 0; z < side; ++z) {
        for (std::uint32_t x = 0; x < side; ++x) {
            const std::uint32_t a = z * (side + 1) + x;
            for (const std::uint32_t corner : {a, a + side + 1, a + 1, a + 1, a + side + 1, a + side + 2})
                level.indices.push_back(corner);
        }
    }
    return level;
}

inline Cooked cooked(const Level& level, const CookOptions& options = {}) {
    auto result = cook(level.input(), options);
    if (!result) throw std::runtime_error(result.error().text);
    return std::move(*result);
}

/// Asks a mesh of everything, in the middle of its bounds and around them. Returns how many hits there were.
inline std::uint64_t ask_everything(const Mesh& mesh, std::uint64_t seed, int queries) {
    SplitMix random(seed);
    const Bounds bounds = mesh.bounds();
    const auto place = [&] {
        return dvec3(random.in(bounds.min.x - 1, bounds.max.x + 1), random.in(bounds.min.y - 1, bounds.max.y + 1),
                     random.in(bounds.min.z - 1, bounds.max.z + 1));
    };
    std::uint64_t hits = 0;
    std::array<Overlap, 8> overlaps;
    std::array<SourceTriangle, 8> gathered;
    for (int i = 0; i < queries; ++i) {
        const Motion motion{place(), place()};
        hits += mesh.sweep(Ellipsoid{.radii = {0.4, 0.9, 0.4}}, motion).has_value() ? 1U : 0U;
        hits += mesh.ray(motion).has_value() ? 1U : 0U;
        hits += mesh.sweep_any(Sphere{.radius = 0.3}, motion) ? 1U : 0U;
        hits += mesh.overlap(Sphere{.radius = 0.5}, motion.from, overlaps) > 0 ? 1U : 0U;
        hits += mesh.nearest(motion.from, 2).has_value() ? 1U : 0U;
        hits += mesh.gather({motion.from - dvec3(1), motion.from + dvec3(1)}, gathered) > 0 ? 1U : 0U;
        if (mesh.triangle_count() > 0) {
            const auto id = static_cast<std::uint32_t>(random.next() % mesh.triangle_count());
            hits += mesh.triangle(id).a.x > 0 ? 1U : 0U;
            hits += mesh.surface(id) > 0 ? 1U : 0U;
        }
    }
    return hits;
}

}  // namespace surefoot::tests
