// How far the loading of a level has come.
#include "playground/level_loader.hpp"

#include <chrono>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <set>
#include <thread>
#include <unistd.h>
#include <utility>
#include <vector>

namespace surefoot::playground {
namespace {

/// A floor of n x n squares that nobody has cooked before.
std::string fresh_floor(int n) {
    // Tests run beside each other: each process has a file of its own.
    const std::string name = "surefoot-fresh-floor-" + std::to_string(::getpid()) + ".obj";
    const std::string path = (std::filesystem::path(testing::TempDir()) / name).string();
    std::ofstream file(path);
    file << "# " << std::chrono::system_clock::now().time_since_epoch().count() << "\n";
    for (int z = 0; z <= n; ++z)
        for (int x = 0; x <= n; ++x) file << "v " << x << " 0 " << z << "\n";
    for (int z = 0; z < n; ++z) {
        for (int x = 0; x < n; ++x) {
            const int corner = z * (n + 1) + x + 1;
            file << "f " << corner << " " << corner + n + 1 << " " << corner + n + 2 << " " << corner + 1 << "\n";
        }
    }
    return path;
}

TEST(LoadProgress, is_told_step_by_step_and_a_level_that_was_cooked_before_is_only_opened) {
    tools::LevelOptions options;
    options.file = fresh_floor(8);
    std::vector<std::pair<tools::LoadStep, double>> told;
    const auto tell = [&](tools::LoadStep step, double done) { told.emplace_back(step, done); };
    static_cast<void>(tools::load_level(options, tell));
    ASSERT_GT(told.size(), 4U);
    EXPECT_EQ(told[0].first, tools::LoadStep::opening);
    EXPECT_EQ(told[1].first, tools::LoadStep::reading);
    for (std::size_t i = 2; i < told.size(); ++i) {
        EXPECT_EQ(told[i].first, tools::LoadStep::cooking);
        EXPECT_GE(told[i].second, told[i - 1].second);
    }
    EXPECT_EQ(told.back().second, 1);
    told.clear();
    static_cast<void>(tools::load_level(options, tell));
    EXPECT_EQ(told, (std::vector<std::pair<tools::LoadStep, double>>{{tools::LoadStep::opening, 0}}));
}

TEST(LevelLoader, tells_how_much_is_cooked_while_it_cooks) {
    const std::string path = fresh_floor(500);
    LevelLoader loader(false);
    EXPECT_FALSE(loader.percent());
    bool came = false;
    loader.load(
        path, [&](const auto&) { came = true; }, [](const std::string& why) { ADD_FAILURE() << why; });
    std::set<std::string> steps;
    int last = 0;
    bool known = false;
    while (loader.update()) {
        steps.insert(std::string(loader.step()));
        if (const auto percent = loader.percent()) {
            known = true;
            EXPECT_GE(*percent, last);
            EXPECT_LE(*percent, 100);
            last = *percent;
        }
        std::this_thread::yield();
    }
    EXPECT_TRUE(came);
    EXPECT_TRUE(known) << "half a million triangles take a while to cook";
    EXPECT_TRUE(steps.contains("cooking"));
    EXPECT_FALSE(loader.percent());
}

}  // namespace
}  // namespace surefoot::playground
