/// What the subcommands share: how they join the program, and what their exit codes mean.
#pragma once

#include <functional>
#include <string>
#include <string_view>

// NOLINTNEXTLINE(readability-identifier-naming): CLI11's own
namespace CLI {
class App;  // its header takes seconds to compile
}

namespace surefoot::tools {

/// What the program says to a script when it ends.
enum class ExitCode : int {
    ok = 0,      ///< answered; a hit and no hit are both answers
    failed = 1,  ///< done, but not all was well: `prove` found a failure, a replay differs, a batch had bad lines
    usage = 2,   ///< the command line makes no sense
    file = 3,    ///< a file cannot be read or written
};

/// Ends a command: thrown by helpers, caught in main, printed as "surefoot: text".
struct Failure {
    ExitCode code;
    std::string text;
};

/// Each adds its subcommand to the program; `run` is set to what the chosen one does.
using Run = std::function<ExitCode()>;
void add_sweep(CLI::App& program, Run& run);
void add_overlap(CLI::App& program, Run& run);
void add_ray(CLI::App& program, Run& run);
void add_march(CLI::App& program, Run& run);
void add_info(CLI::App& program, Run& run);
void add_cook(CLI::App& program, Run& run);
void add_export(CLI::App& program, Run& run);
void add_tour(CLI::App& program, Run& run);
void add_prove(CLI::App& program, Run& run);
void add_bench(CLI::App& program, Run& run);
void add_replay(CLI::App& program, Run& run);
void add_course(CLI::App& program, Run& run);
void add_nav(CLI::App& program, Run& run);
void add_navcheck(CLI::App& program, Run& run);
void add_playtest(CLI::App& program, Run& run);

/// The part of the help that is the same for every subcommand.
[[nodiscard]] std::string help_footer(std::string_view examples);

/// Writes all of `text` to standard output; fails as a file does (a full disk must not look like success).
void write_out(std::string_view text);

}  // namespace surefoot::tools
