// surefoot march: walk along a jump or along a path from a file, step by step.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fstream>
#include <glm/geometric.hpp>
#include <vector>

#include "command.hpp"
#include "level.hpp"
#include "number.hpp"
#include "options.hpp"
#include "polyline.hpp"
#include "query.hpp"
#include "text.hpp"

namespace surefoot::tools {
namespace {

struct MarchOptionsGiven {
    LevelOptions level;
    VolumeOptions volume;
    std::string from;
    std::string velocity;
    std::string gravity = "0,-9.81,0";
    double duration = 2;
    std::string path;
    std::uint32_t steps = 0;
    bool unguarded = false;
    bool json = false;
};

constexpr std::uint32_t most_steps = 1U << 24U;  // surefoot/march.hpp
constexpr std::uint32_t arc_steps = 60;

std::string json_of(const std::optional<MarchHit>& met) {
    if (!met) return "{\"hit\":false}\n";
    std::string out;
    append_answer(out, met->hit);
    out.pop_back();
    out += R"(,"position":)";
    append_array(out, met->position);
    return out + fmt::format(",\"step\":{}}}\n", met->step);
}

std::string text_of(const Level& level, const std::string& what, std::uint32_t steps, bool guarded,
                    const std::optional<MarchHit>& met) {
    std::string out = what + fmt::format(", in {} steps, {}.\n", steps,
                                         guarded ? "each swept (guarded)" : "only the samples looked at (unguarded)");
    if (!met) {
        out += "No hit: the whole path is free.\n";
        if (!guarded) out += "An unguarded march can tunnel through thin walls; leave out --unguarded to be sure.\n";
        return out;
    }
    out +=
        fmt::format("Hit in step {} (counted from 0), at t = {} of the path.\n", met->step, short_number(met->hit.t));
    out += fmt::format("  stops at  {} m\n", short_vector(met->position));
    out += fmt::format("  touches   {} m\n", short_vector(met->hit.point));
    out += fmt::format("  normal    {}\n", short_vector(met->hit.normal));
    out += fmt::format("  feature   {}\n", in_words(met->hit.feature));
    out += fmt::format("  triangle  {}\n", met->hit.triangle);
    out += fmt::format("  surface   {}\n", surface_text(level, met->hit.surface));
    if (met->hit.started_inside) out += "It touched or overlapped already at the start.\n";
    return out;
}

ExitCode run_march(const MarchOptionsGiven& given) {
    const bool arc = given.path.empty();
    if (arc && (given.from.empty() || given.velocity.empty()))
        throw Failure{ExitCode::usage,
                      "a march needs a path: --from and --velocity for a jump, or --path FILE with lines x,y,z"};
    if (!arc && !(given.from.empty() && given.velocity.empty()))
        throw Failure{ExitCode::usage, "--path already says where the way starts: leave out --from and --velocity"};
    if (given.steps > most_steps) throw Failure{ExitCode::usage, fmt::format("--steps: at most {}", most_steps)};
    if (!(given.duration > 0 && std::isfinite(given.duration)))
        throw Failure{ExitCode::usage, "--duration: must be more than 0 seconds"};
    const Volume volume = given.volume.volume();
    MarchOptions options{.steps = given.steps, .guarded = !given.unguarded, .one_sided = given.volume.one_sided};
    std::optional<MarchHit> met;
    std::string what;
    const auto walk = [&](const Level& level, const Path& path) { met = march(volume, path, level.mesh, options); };
    if (arc) {
        const JumpArc jump{.from = position_of("--from", given.from),
                           .velocity = vector_of("--velocity", given.velocity),
                           .gravity = vector_of("--gravity", given.gravity),
                           .duration = given.duration};
        if (options.steps == 0) options.steps = arc_steps;
        what = fmt::format("{} jumps from ({}) at ({}) m/s for {} s", describe(volume), short_vector(jump.from),
                           short_vector(jump.velocity), short_number(jump.duration));
        const Level level = load_level(given.level);
        walk(level, jump);
        write_out(given.json ? json_of(met) : text_of(level, what, options.steps, options.guarded, met));
    } else {
        const Polyline line = read_polyline(given.path);
        if (options.steps == 0) options.steps = line.segments();
        what = fmt::format("{} follows {} points of {}", describe(volume), line.points.size(), given.path);
        const Level level = load_level(given.level);
        walk(level, line);
        write_out(given.json ? json_of(met) : text_of(level, what, options.steps, options.guarded, met));
    }
    if (met && met->hit.status != HitStatus::ok)
        throw Failure{ExitCode::failed, "the path leaves +-1e9 m or is not a number there, so it counts as blocked"};
    return ExitCode::ok;
}

}  // namespace

void add_march(CLI::App& program, Run& run) {
    auto* command = program.add_subcommand("march", "Walk along a jump, or a path from a file, step by step");
    const auto given = std::make_shared<MarchOptionsGiven>();
    given->level.add_to(*command);
    given->volume.add_to(*command, true);
    command->add_option("--from", given->from, "Where a jump starts [m]")->type_name("X,Y,Z");
    command->add_option("--velocity", given->velocity, "How fast it starts [m/s]")->type_name("X,Y,Z");
    command->add_option("--gravity", given->gravity, "Pull during the jump [m/s2] (default: 0,-9.81,0)")
        ->type_name("X,Y,Z");
    command->add_option("--duration", given->duration, "How long the jump is followed [s] (default: 2)")
        ->type_name("SECONDS");
    command->add_option("--path", given->path, "Follow the lines x,y,z of this CSV file instead; # starts a comment")
        ->type_name("CSV");
    command
        ->add_option("--steps", given->steps,
                     "Into how many steps the path is cut (default: 60 for a jump, one a line for a file)")
        ->type_name("N");
    command->add_flag("--unguarded", given->unguarded,
                      "Look at the samples only, as most games begin: tunnels when a step is too large");
    command->add_flag("--json", given->json, "Print the answer as one line of JSON");
    command->footer(help_footer(
        "  surefoot march castle.obj --shape ellipsoid:0.4,0.9,0.4 --from 0,1,0 --velocity 3,5,0\n"
        "  surefoot march castle.obj --shape sphere:0.05 --from 0,1,0 --velocity 400,0,0 --steps 120 --unguarded\n"
        "  surefoot march castle.obj --shape capsule:0.4,0.5 --path route.csv --json\n"
        "\nThe points of a file are equally far apart in t, whatever their distance.\n"
        "Exit codes: 0 answered (a hit or none), 1 the path is not finite, 2 wrong usage, 3 a file cannot be read."));
    command->callback([given, &run] { run = [given] { return run_march(*given); }; });
}

}  // namespace surefoot::tools
