// Every seed of fuzz/fuzz_step, and what fuzzing found once, is asked again by each build of the tests.
#include "fuzz_seeds.hpp"

namespace surefoot::tests {
namespace {

TEST(FuzzStep, every_seed_keeps_all_promises) {
    EXPECT_GE(ask_seeds(SUREFOOT_FUZZ_SEEDS), 8);
}

TEST(FuzzStep, no_bytes_at_all_are_a_step_too) {
    const std::uint8_t none = 0;
    EXPECT_EQ(LLVMFuzzerTestOneInput(&none, 0), 0);
}

}  // namespace
}  // namespace surefoot::tests
