/// Which Surefoot this is. The library follows semantic versioning; while the major number is 0, a new minor number
/// may change the API. Every name lives in the inline namespace of its ABI, so that two versions can be linked into
/// one program without meeting.
#pragma once

namespace [[gnu::visibility("default")]] surefoot {
inline namespace v0 {

struct Version {
    int major = 0;
    int minor = 0;
    int patch = 0;

    friend constexpr bool operator==(const Version&, const Version&) = default;
};

/// The version of the headers that the caller was compiled with.
inline constexpr Version header_version{.major = 0, .minor = 1, .patch = 0};

/// The inline namespace that every name is in: two libraries with the same one take each other's data.
inline constexpr const char* abi_name = "v0";

/// The version of the library that the caller is linked with.
[[nodiscard]] Version library_version() noexcept;

}  // namespace v0
}  // namespace surefoot
