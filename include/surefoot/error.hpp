/// What went wrong with a file or with data handed in, in a form for a person and a form for a program.
#pragma once

#include <cstdint>
#include <string>
#include <tl/expected.hpp>

namespace [[gnu::visibility("default")]] surefoot {
inline namespace v0 {

enum class ErrorCode : std::uint32_t {
    not_found,      ///< there is no such file, or it may not be read
    unreadable,     ///< the file is there but is not what its name says, or is damaged
    unsupported,    ///< a known kind of file that this build cannot read; the text says what to install or convert
    limit,          ///< larger, slower or more than a stated limit allows
    invalid,        ///< data that cannot be used: an index out of range, a coordinate that is not finite
    write_failed,   ///< the result could not be written; what was there before is still there
    out_of_memory,  ///< memory ran out while building
};

/// A failure: what kind, one sentence that a person can act on, and where it is.
struct Error {
    ErrorCode code = ErrorCode::invalid;
    std::string text;        ///< one sentence that names the cure, ready to print
    std::string file;        ///< the file it is about, empty if none
    std::uint64_t byte = 0;  ///< where in the file, 0 when that means nothing
};

/// A value, or the reason why there is none.
template <typename T>
using Expected = tl::expected<T, Error>;

}  // namespace v0
}  // namespace surefoot
