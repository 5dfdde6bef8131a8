#include "limited_read.hpp"

#include <array>
#include <charconv>
#include <cmath>

#include "child_process.hpp"
#include "level_builder.hpp"
#include "programs.hpp"
#include "reply.hpp"

namespace surefoot::internal {
namespace {

std::string decimal(double value) {
    std::array<char, 40> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
    return {text.data(), end};
}

const char* axis_name(UpAxis up) {
    switch (up) {
        case UpAxis::x:
            return "x";
        case UpAxis::z:
            return "z";
        case UpAxis::y:
        case UpAxis::by_format:
            break;
    }
    return "y";
}

/// Why there is no level, told by how the reader ended.
Error explain(const ChildOutcome& outcome, const Error& reply) {
    using End = ChildOutcome::End;
    if (outcome.end == End::timed_out) return time_error();
    if (outcome.end == End::too_talkative) return memory_error();
    if (!reply.text.empty()) return reply;
    const std::string cure =
        "; the file is probably damaged, so open it in the program that made it and export it as .glb";
    std::string how = "its reader stopped without an answer (exit code " + std::to_string(outcome.exit_code) + ")";
    if (outcome.end == End::killed) how = "its reader crashed (" + signal_name(outcome.signal) + ")";
    return {.code = ErrorCode::unreadable, .text = how + cure, .file = {}};
}

}  // namespace

std::string seconds_until(Deadline deadline) {
    const std::chrono::duration<double> left = deadline - std::chrono::steady_clock::now();
    return std::to_string(static_cast<long long>(std::ceil(std::max(0.0, left.count()))) + 1);
}

Expected<ImportedLevel> read_in_child(const LimitedRead& request) {
    const auto importer = find_importer(request.options);
    if (!importer) return tl::unexpected(importer.error());
    const std::vector<std::string> arguments{"read",
                                             request.path,
                                             decimal(request.placement.scale),
                                             axis_name(request.placement.up),
                                             std::to_string(request.options.memory_limit),
                                             seconds_until(request.deadline)};
    const auto outcome = run_child(*importer, arguments, request.deadline, request.options.memory_limit);
    if (!outcome) return tl::unexpected(outcome.error());

    // A reader that answered in full and then crashed while cleaning up has answered.
    Expected<ImportedLevel> level = decode_reply(outcome->output);
    if (!level) return tl::unexpected(explain(*outcome, level.error()));
    return level;
}

}  // namespace surefoot::internal
