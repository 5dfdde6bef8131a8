// `surefoot nav`, `navcheck` and `playtest` of a program that was built without surefoot::navigation: they say so.
#include <CLI/CLI.hpp>
#include <string>

#include "command.hpp"

namespace surefoot::tools {
namespace {

void add_left_out(CLI::App& program, Run& run, const std::string& name) {
    auto* command = program.add_subcommand(name, "Left out of this program: it was built without surefoot::navigation");
    command->allow_extras();
    command->callback([&run, name] {
        run = [name]() -> ExitCode {
            throw Failure{ExitCode::usage, name +
                                               ": this program was built without surefoot::navigation; configure with "
                                               "-DSUREFOOT_BUILD_NAVIGATION=ON"};
        };
    });
}

}  // namespace

void add_nav(CLI::App& program, Run& run) {
    add_left_out(program, run, "nav");
}
void add_navcheck(CLI::App& program, Run& run) {
    add_left_out(program, run, "navcheck");
}
void add_playtest(CLI::App& program, Run& run) {
    add_left_out(program, run, "playtest");
}

}  // namespace surefoot::tools
