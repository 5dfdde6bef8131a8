#include <surefoot/version.hpp>

namespace surefoot {
inline namespace v0 {

// Defined here, not in the header: a caller compiled with old headers must learn what it really runs with.
Version library_version() noexcept {
    return header_version;
}

}  // namespace v0
}  // namespace surefoot
