// xxHash is used as headers alone: nothing to link, and the same code on every target that is cross-compiled.
#define XXH_INLINE_ALL
#include <xxhash.h>

#include <surefoot/file.hpp>

namespace surefoot {
inline namespace v0 {

std::uint64_t hash_bytes(std::span<const std::byte> bytes, std::uint64_t seed) noexcept {
    return XXH3_64bits_withSeed(bytes.data(), bytes.size(), seed);
}

}  // namespace v0
}  // namespace surefoot
