// Every seed of fuzz/fuzz_navigation, and what fuzzing found once, is asked again by each build of the tests.
#include "fuzz_seeds.hpp"

namespace surefoot::tests {
namespace {

TEST(FuzzNavigation, every_seed_keeps_all_promises) {
    EXPECT_GE(ask_seeds(SUREFOOT_FUZZ_SEEDS), 6);
}

}  // namespace
}  // namespace surefoot::tests
