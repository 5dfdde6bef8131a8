// Two processes on one level: its pages are in memory once.
#include <array>
#include <cstdio>
#include <fstream>
#include <gtest/gtest.h>
#include <sstream>
#include <sys/wait.h>
#include <unistd.h>

#include "file_things.hpp"

namespace surefoot::tests {
namespace {

using Sharing = FileTest;

/// What of a file is in this process's memory [KiB]: its own share of the pages, and all pages that it has touched.
struct Share {
    std::uint64_t pss = 0;
    std::uint64_t rss = 0;
};

Share share_of(const std::string& file) {
    std::ifstream maps("/proc/self/smaps");
    Share share;
    bool ours = false;
    for (std::string line; std::getline(maps, line);) {
        std::istringstream words(line);
        std::string name;
        std::uint64_t size = 0;
        words >> name;
        if (name.back() != ':') {
            ours = line.find(file) != std::string::npos;
        } else if (ours && words >> size) {
            if (name == "Pss:") share.pss += size;
            if (name == "Rss:") share.rss += size;
        }
    }
    return share;
}

TEST_F(Sharing, two_processes_on_one_level_take_half_of_it_each) {
    if (!std::ifstream("/proc/self/smaps")) GTEST_SKIP() << "no /proc/self/smaps here";
    const std::string file = path("level.surefoot");
    ASSERT_TRUE(cooked(hills(256)).mesh.write(file).has_value());
    constexpr int queries = 100000;

    // Each side asks, tells the other that it has, and holds the mesh until both have looked.
    std::array<int, 2> up{};
    std::array<int, 2> down{};
    ASSERT_EQ(pipe(up.data()), 0);
    ASSERT_EQ(pipe(down.data()), 0);
    const auto ask = [&](std::uint64_t seed) {
        auto mesh = Mesh::open(file);
        if (!mesh) throw std::runtime_error(mesh.error().text);
        SplitMix random(seed);
        std::uint64_t hits = 0;
        for (int i = 0; i < queries; ++i) {
            const dvec3 from(random.in(2, 126), 2, random.in(2, 126));
            hits += mesh->sweep(Sphere{.radius = 0.4}, {from, from + dvec3(random.in(-1, 1), -3, random.in(-1, 1))})
                            .has_value()
                        ? 1U
                        : 0U;
        }
        EXPECT_EQ(hits, static_cast<std::uint64_t>(queries));
        return std::move(*mesh);
    };
    const pid_t child = fork();
    if (child == 0) {
        char byte = 0;
        Share share;
        {
            const Mesh mesh = ask(1);
            if (write(up[1], &byte, 1) != 1 || read(down[0], &byte, 1) != 1) _exit(1);
            share = share_of(file);
            if (write(up[1], &share, sizeof share) != sizeof share || read(down[0], &byte, 1) != 1) _exit(1);
        }
        _exit(0);
    }
    const Mesh mesh = ask(2);
    char byte = 0;
    ASSERT_EQ(read(up[0], &byte, 1), 1);
    ASSERT_EQ(write(down[1], &byte, 1), 1);
    Share theirs;
    ASSERT_EQ(read(up[0], &theirs, sizeof theirs), static_cast<ssize_t>(sizeof theirs));
    const Share ours = share_of(file);
    ASSERT_EQ(write(down[1], &byte, 1), 1);
    int status = 0;
    waitpid(child, &status, 0);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
    for (const int end : {up[0], up[1], down[0], down[1]}) close(end);

    for (const Share& share : {ours, theirs}) {
        std::printf("after %d sweeps: %llu KiB of the level in memory, this process's share (Pss) %llu KiB\n", queries,
                    static_cast<unsigned long long>(share.rss), static_cast<unsigned long long>(share.pss));
        EXPECT_GT(share.rss, 1000U);
        EXPECT_NEAR(static_cast<double>(share.pss), static_cast<double>(share.rss) / 2,
                    0.05 * static_cast<double>(share.rss) / 2);
    }
}

}  // namespace
}  // namespace surefoot::tests
