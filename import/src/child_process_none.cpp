// For systems without posix_spawn: formats that need the helper program are refused in words, OBJ works.
#include "child_process.hpp"

namespace surefoot::internal {

Expected<ChildOutcome> run_child(const std::string& program, const std::vector<std::string>&, Deadline, std::uint64_t) {
    return tl::unexpected(
        Error{.code = ErrorCode::unsupported,
              .text = "the program " + program + " cannot be run within limits on this system; export the level as OBJ",
              .file = {}});
}

std::string signal_name(int signal) {
    return "signal " + std::to_string(signal);
}

}  // namespace surefoot::internal
