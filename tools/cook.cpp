// surefoot cook: levels become one file that is mapped and not parsed.
#include <CLI/CLI.hpp>
#include <chrono>
#include <filesystem>
#include <fmt/format.h>
#include <memory>

#include "command.hpp"
#include "findings.hpp"
#include "kitchen.hpp"
#include "level.hpp"
#include "number.hpp"
#include "query.hpp"
#include "text.hpp"

namespace surefoot::tools {
namespace {

struct CookOptionsGiven {
    LevelOptions level;
    std::vector<std::string> files;
    std::string output;
    bool json = false;
};

std::string joined(const std::vector<std::string>& files) {
    std::string out;
    for (const std::string& file : files) out += (out.empty() ? "" : ", ") + file;
    return out;
}

ExitCode run_cook(const CookOptionsGiven& given) {
    using Clock = std::chrono::steady_clock;
    const auto seconds_since = [](Clock::time_point start) {
        return std::chrono::duration<double>(Clock::now() - start).count();
    };
    for (const std::string& file : given.files) {
        if (is_cooked_name(file))
            throw Failure{ExitCode::usage, fmt::format("{}: is cooked already: cook what it was made from", file)};
    }
    const ImportOptions import = given.level.import_options();
    const double tolerance = given.level.welding_tolerance();
    const Clock::time_point start = Clock::now();
    ImportedLevel level = import_all(given.files, import);
    const double import_seconds = seconds_since(start);

    const Clock::time_point cook_start = Clock::now();
    const std::uint64_t made_from = hash_of_sources(given.files, import, tolerance).value_or(0);
    const Cooked cooked = cook_imported(level, tolerance, made_from);
    const std::vector<std::byte> notes = to_bytes(level.notes);
    Section section = import_notes_section;
    section.bytes = notes;
    const auto written = cooked.mesh.write(given.output, std::span(&section, 1));
    if (!written) throw Failure{ExitCode::file, written.error().text};
    const double cook_seconds = seconds_since(cook_start);

    std::error_code ignored;
    const auto bytes = std::filesystem::file_size(given.output, ignored);
    const auto triangles = static_cast<double>(cooked.report.triangles);
    if (given.json) {
        std::string out = fmt::format(R"({{"file":{},"bytes":{},"import_seconds":)", json_string(given.output), bytes);
        append_number(out, import_seconds);
        out += R"(,"cook_seconds":)";
        append_number(out, cook_seconds);
        write_out(out + R"(,"report":)" + findings_json(cooked.report) + "}\n");
        return ExitCode::ok;
    }
    constexpr std::size_t most_places = 3;
    write_out(fmt::format("{}: {} triangles of {}, {:.1f} bytes a triangle\n  time        read in {}, cooked in {}\n{}",
                          given.output, grouped(cooked.report.triangles), joined(given.files),
                          static_cast<double>(bytes) / triangles, duration(import_seconds), duration(cook_seconds),
                          findings_text(cooked.report, most_places)));
    return ExitCode::ok;
}

}  // namespace

void add_cook(CLI::App& program, Run& run) {
    auto* command = program.add_subcommand("cook", "Make a file that is opened at once, and say what is odd about it");
    const auto given = std::make_shared<CookOptionsGiven>();
    command
        ->add_option("IN", given->files,
                     "The levels: .obj .gltf .glb .ply .stl .ac .blend .bsp .pk3; several become one")
        ->type_name("...")
        ->required();
    command->add_option("-o,--output", given->output, "The file to write")->type_name("OUT.surefoot")->required();
    given->level.add_cooking_to(*command);
    command->add_flag("--json", given->json, "Print one line of JSON, with the places of everything that was found");
    command->footer(help_footer(
        "  surefoot cook castle.glb -o castle.surefoot\n"
        "  surefoot cook ground.obj houses.obj -o town.surefoot --scale 0.01 --json\n"
        "\nTriangles keep their ids: their order in the files. The old OUT.surefoot stays whole until the new\n"
        "one is.\n"
        "Exit codes: 0 written, 2 wrong usage, 3 a file cannot be read or written."));
    command->callback([given, &run] { run = [given] { return run_cook(*given); }; });
}

}  // namespace surefoot::tools
