// Every seed of fuzz/fuzz_navigation, and what fuzzing found once, is asked again by each build of the tests.
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace surefoot {
namespace {

// A broken promise ends the program with its name.
TEST(FuzzNavigation, every_seed_keeps_all_promises) {
    int seeds = 0;
    for (const auto& entry : std::filesystem::directory_iterator(SUREFOOT_FUZZ_SEEDS)) {
        SCOPED_TRACE(entry.path().filename().string());
        std::ifstream file(entry.path(), std::ios::binary);
        const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
        EXPECT_EQ(LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()), 0);
        ++seeds;
    }
    EXPECT_GE(seeds, 6);
}

}  // namespace
}  // namespace surefoot
