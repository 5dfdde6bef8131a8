/// A program run to its end, within limits, its standard output collected.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <surefoot/error.hpp>

#include "polygon.hpp"

namespace surefoot::internal {

struct ChildOutcome {
    enum class End : std::uint8_t {
        exited,        ///< by itself, or nobody can say how: a host that ignores SIGCHLD loses the status
        killed,        ///< by a signal: it crashed, or ran into a limit of its own
        timed_out,     ///< by us, at the deadline
        too_talkative  ///< by us, for more output than allowed
    };
    End end = End::exited;
    int exit_code = 0;
    int signal = 0;
    std::vector<std::byte> output;
};

/// Runs `program` (a path, not looked up) with `arguments`. It sees an empty standard input, no standard error, and
/// default signals, and is the head of a process group, so that what it started is ended with it.
/// Fails with `unsupported` when it cannot be started.
[[nodiscard]] Expected<ChildOutcome> run_child(const std::string& program, const std::vector<std::string>& arguments,
                                               Deadline deadline, std::uint64_t most_output);

/// "segmentation fault" and the like.
[[nodiscard]] std::string signal_name(int signal);

}  // namespace surefoot::internal
