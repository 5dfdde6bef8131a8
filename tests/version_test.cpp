#include <gtest/gtest.h>
#include <string>
#include <type_traits>

#include <surefoot/surefoot.hpp>

namespace {

TEST(Version, the_headers_say_what_cmake_says) {
    const surefoot::Version version = surefoot::header_version;
    EXPECT_EQ(std::to_string(version.major) + "." + std::to_string(version.minor) + "." + std::to_string(version.patch),
              SUREFOOT_CMAKE_VERSION);
}

TEST(Version, the_library_says_what_the_headers_say) {
    EXPECT_EQ(surefoot::library_version(), surefoot::header_version);
}

TEST(Version, the_abi_namespace_carries_the_major_version) {
    static_assert(surefoot::header_version.major == 0, "a new major version needs a new inline namespace, see below");
    EXPECT_TRUE((std::is_same_v<surefoot::Hit, surefoot::v0::Hit>));
}

}  // namespace
