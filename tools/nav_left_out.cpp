// `surefoot nav` of a program that was built without surefoot::navigation: says so.
#include <CLI/CLI.hpp>

#include "command.hpp"

namespace surefoot::tools {

void add_nav(CLI::App& program, Run& run) {
    auto* command =
        program.add_subcommand("nav", "Left out of this program: it was built without surefoot::navigation");
    command->allow_extras();
    command->callback([&run] {
        run = []() -> ExitCode {
            throw Failure{ExitCode::usage,
                          "nav: this program was built without surefoot::navigation; configure with "
                          "-DSUREFOOT_BUILD_NAVIGATION=ON"};
        };
    });
}

}  // namespace surefoot::tools
