// One program, `surefoot`: each subcommand is in a file of its own.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <fmt/format.h>
#include <string>
#include <vector>

#include <surefoot/version.hpp>

#include "command.hpp"
#include "parse.hpp"

namespace surefoot::tools {
namespace {

std::string version_text() {
    const Version v = library_version();
    return fmt::format("surefoot {}.{}.{}", v.major, v.minor, v.patch);
}

/// What is wrong with the command line, the nearest option for one that is not known, and where to read on.
std::string usage_message(const CLI::App* program, const CLI::Error& error) {
    const auto chosen = program->get_subcommands();
    const CLI::App* const command = chosen.empty() ? program : chosen.front();
    std::string text = fmt::format("surefoot: {}\n", error.what());
    std::vector<std::string> known;
    for (const CLI::Option* option : command->get_options())
        for (const std::string& name : option->get_lnames()) known.push_back("--" + name);
    for (const CLI::App* subcommand : command->get_subcommands([](const CLI::App*) { return true; }))
        known.push_back(subcommand->get_name());
    for (const std::string& word : command->remaining(true))
        if (const std::string near = nearest_word(word, known); !near.empty() && near != word)
            text += fmt::format("Did you mean {} for {}?\n", near, word);
    return text + fmt::format("Try: surefoot {}--help\n", command == program ? "" : command->get_name() + " ");
}

int run_program(int argc, char** argv) {
    CLI::App program{"Do I hit something moving from A to B, and where? Exact sweeps on real levels.", "surefoot"};
    program.set_version_flag("--version", version_text());
    program.get_formatter()->column_width(28);
    program.require_subcommand(1);
    program.failure_message(usage_message);
    program.footer(
        "`surefoot SUBCOMMAND --help` shows examples.\n"
        "A LEVEL is a .surefoot, or any file that surefoot::import reads: .obj .gltf .glb .ply .stl .ac .blend\n"
        "Exit codes: 0 answered (a hit or none), 1 failures found, 2 wrong usage, 3 a file cannot be read or written.");
    Run run;
    for (const auto add : {add_sweep, add_overlap, add_ray, add_march, add_info, add_cook, add_export, add_tour,
                           add_prove, add_bench, add_replay, add_course, add_nav, add_navcheck, add_playtest})
        add(program, run);
    try {
        program.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return program.exit(error) == 0 ? 0 : static_cast<int>(ExitCode::usage);
    }
    return static_cast<int>(run());
}

}  // namespace

std::string help_footer(std::string_view examples) {
    return fmt::format("\nExamples:\n{}", examples);
}

void write_out(std::string_view text) {
    if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0)
        throw Failure{ExitCode::file, "standard output did not take the answer: is the disk full?"};
}

}  // namespace surefoot::tools

int main(int argc, char** argv) {
    using surefoot::tools::ExitCode;
    try {
        return surefoot::tools::run_program(argc, argv);
    } catch (const surefoot::tools::Failure& failure) {
        fmt::print(stderr, "surefoot: {}\n", failure.text);
        return static_cast<int>(failure.code);
    } catch (const std::bad_alloc&) {
        fmt::print(stderr, "surefoot: out of memory: the level is too large for this machine\n");
        return static_cast<int>(ExitCode::file);
    }
}
