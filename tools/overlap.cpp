// surefoot overlap: what does a shape, standing still, touch, and which way is out?
#include <CLI/CLI.hpp>
#include <algorithm>
#include <fmt/format.h>
#include <vector>

#include "command.hpp"
#include "level.hpp"
#include "number.hpp"
#include "options.hpp"
#include "query.hpp"
#include "text.hpp"

namespace surefoot::tools {
namespace {

struct OverlapOptionsGiven {
    LevelOptions level;
    VolumeOptions volume;
    std::string at;
    bool json = false;
};

std::string json_of(std::span<const Overlap> found) {
    std::string out = fmt::format(R"({{"touching":{},"overlaps":[)", found.empty() ? "false" : "true");
    for (const Overlap& overlap : found) {
        if (out.back() != '[') out += ',';
        out += fmt::format(R"({{"triangle":{},"feature":"{}","point":)", overlap.triangle, word(overlap.feature));
        append_array(out, overlap.point);
        out += R"(,"normal":)";
        append_array(out, overlap.normal);
        out += R"(,"depth":)";
        append_number(out, overlap.depth);
        out += '}';
    }
    return out + "]}\n";
}

std::string text_of(const Level& level, const Volume& volume, const dvec3& at, std::span<const Overlap> found) {
    std::string out = fmt::format("{} at ({}).\n", describe(volume), short_vector(at));
    if (found.empty()) return out + "Touches nothing.\n";
    out += fmt::format("Touches {} {}; moving by normal x depth leads out of that one.\n", found.size(),
                       found.size() == 1 ? "triangle" : "triangles");
    Table table({"triangle", "feature", "depth [m]", "normal", "deepest point [m]", "surface"});
    for (const Overlap& overlap : found)
        table.add({std::to_string(overlap.triangle), std::string(word(overlap.feature)), short_number(overlap.depth),
                   short_vector(overlap.normal), short_vector(overlap.point), surface_text(level, overlap.surface)});
    const auto deepest = std::max_element(found.begin(), found.end(),
                                          [](const Overlap& a, const Overlap& b) { return a.depth < b.depth; });
    return out + table.text() +
           fmt::format("Deepest: {} m, in triangle {}.\n", short_number(deepest->depth), deepest->triangle);
}

ExitCode run_overlap(const OverlapOptionsGiven& given) {
    const Volume volume = given.volume.volume();
    const dvec3 at = position_of("--at", given.at);
    const Level level = load_level(given.level);
    const QueryOptions options{.one_sided = given.volume.one_sided};
    std::vector<Overlap> found(level.mesh.overlap(volume, at, {}, options));
    level.mesh.overlap(volume, at, found, options);
    for (const Overlap& overlap : found)
        if (overlap.status != HitStatus::ok)
            throw Failure{ExitCode::failed, "this query is beyond what can be computed"};
    write_out(given.json ? json_of(found) : text_of(level, volume, at, found));
    return ExitCode::ok;
}

}  // namespace

void add_overlap(CLI::App& program, Run& run) {
    auto* command = program.add_subcommand("overlap", "What does a shape touch where it stands, and which way is out?");
    const auto given = std::make_shared<OverlapOptionsGiven>();
    given->level.add_to(*command);
    given->volume.add_to(*command, true);
    command->add_option("--at", given->at, "Where its reference point is [m]")->type_name("X,Y,Z")->required();
    command->add_flag("--json", given->json, "Print the answer as one line of JSON");
    command->footer(
        help_footer("  surefoot overlap castle.obj --shape ellipsoid:0.4,0.9,0.4 --at 0,0.8,0\n"
                    "  surefoot overlap castle.obj --shape capsule:0.4,0.5 --at -3,0.8,2 --json\n"
                    "\nExit codes: 0 answered (touching or not), 2 wrong usage, 3 the level cannot be read."));
    command->callback([given, &run] { run = [given] { return run_overlap(*given); }; });
}

}  // namespace surefoot::tools
