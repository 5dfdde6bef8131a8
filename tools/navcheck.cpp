// surefoot navcheck: do the navigation mesh and the feet agree?
#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <memory>

#include <surefoot/capture_step.hpp>
#include <surefoot/navigation_check.hpp>

#include "command.hpp"
#include "navigator.hpp"
#include "navigator_bars.hpp"
#include "number.hpp"
#include "query.hpp"
#include "text.hpp"

namespace surefoot::tools {
namespace {

struct CheckGiven {
    LevelOptions level;
    WalkerOptions walker;
    StartOption start;
    std::size_t walks = 1000;
    std::uint64_t seed = 1;
    std::optional<std::size_t> rehearsals;
    std::optional<double> mesh_radius;
    std::optional<double> mesh_slope;
    std::optional<double> mesh_climb;
    std::string save;
    bool json = false;
};

constexpr const char* kinds[] = {"drops", "jumps", "steps up", "ladders"};
constexpr const char* kind_keys[] = {"drops", "jumps", "step_ups", "ladders"};

std::string reason_of(const WalkReport& report) {
    if (report.out_of_time) return "it took too long";
    return std::string(sentence(report.reason));
}

std::string verdict(bool good) {
    return good ? "good" : "FAILS";
}

std::string check_text(const std::string& file, const StillLevel& still, const NavigationCheck& check,
                       const std::vector<std::string>& saved) {
    const NavigationAgreement& agreement = check.agreement;
    std::string out = fmt::format("{}: {} m2 of ground in {} polygons\n", file, short_number(check.mesh.area),
                                  grouped(check.mesh.polygons));
    out += still.text();
    out += fmt::format(
        "  taken out  {:.1f} m2 to which no feet get, {:.1f} m2 from which they do not get back; {:.1f} m2 are left\n",
        agreement.unreached, agreement.no_return, agreement.kept);
    out += fmt::format(
        "  rehearsed  {} walks: {} links that failed dropped, {:.1f} m2 in {} polygons where feet got stuck taken "
        "out\n",
        grouped(agreement.rehearsed), grouped(agreement.failed_links), agreement.failed_area,
        grouped(agreement.failed_polygons));
    Table links({"links", "tried", "done by the feet", "useful", "in reach", "kept"});
    for (std::size_t kind = 0; kind < std::size(kinds); ++kind)
        links.add({kinds[kind], grouped(check.links.tried[kind]), grouped(check.links.done[kind]),
                   grouped(check.links.kept[kind]), grouped(check.links_of_feet[kind]),
                   grouped(check.links_kept[kind])});
    out += links.text();
    if (check.links.too_long > 0)
        out += fmt::format("  {} ways were left aside: they end beyond the next tile, where no link leads\n",
                           grouped(check.links.too_long));
    out += fmt::format(
        "  {}  the mesh knows {:.2f}% of the {:.1f} m2 that feet reach and come back from (at least {:.0f}%)\n",
        verdict(check.is_covered()), 100 * agreement.covered(), agreement.flood, 100 * check.least_covered);
    if (!check.is_covered() && !agreement.missing.empty())
        out += fmt::format("         it does not know, among others, the ground at ({})\n",
                           short_vector(agreement.missing.front()));
    out += fmt::format("  {}  no kind of link fell to zero\n", verdict(!check.lost_a_kind()));
    out += fmt::format("  {}  {} of {} random walks arrived, over {} links", verdict(check.all_arrived()),
                       grouped(check.arrived), grouped(check.walks), grouped(check.links_walked));
    if (check.arrived > 0)
        out += fmt::format("; {:.2f} m/s along their paths, the slowest took {:.2f} times what full speed would",
                           check.length / check.seconds, check.slowest);
    out += '\n';
    for (std::size_t i = 0; i < check.failed.size(); ++i) {
        const NavigationFailedWalk& walk = check.failed[i];
        out += fmt::format("         from ({}) to ({}): ended at ({}): {}{}\n", short_vector(walk.from),
                           short_vector(walk.to), short_vector(walk.report.end), reason_of(walk.report),
                           saved[i].empty() ? "" : "; saved as " + saved[i]);
    }
    return out;
}

void append_point(std::string& out, const char* name, const dvec3& value) {
    out += fmt::format(R"("{}":)", name);
    append_array(out, value);
}

std::string check_json(const std::string& file, const StillLevel& still, const NavigationCheck& check,
                       const std::vector<std::string>& saved) {
    std::string out = fmt::format(
        R"({{"file":{},"passes":{},"polygons":{},"area":{:.3f},"kept":{:.3f},"unreached":{:.3f},"no_return":{:.3f},"flood":{:.3f},"covered":{:.6f},"rehearsed":{},"failed_links":{},"failed_polygons":{},"failed_area":{:.3f},"walks":{},"arrived":{},"links_walked":{},"length":{:.3f},"seconds":{:.3f},"slowest":{:.3f},"links":{{)",
        json_string(file), check.passes(), check.mesh.polygons, check.mesh.area, check.agreement.kept,
        check.agreement.unreached, check.agreement.no_return, check.agreement.flood, check.agreement.covered(),
        check.agreement.rehearsed, check.agreement.failed_links, check.agreement.failed_polygons,
        check.agreement.failed_area, check.walks, check.arrived, check.links_walked, check.length, check.seconds,
        check.slowest);
    for (std::size_t kind = 0; kind < std::size(kind_keys); ++kind)
        out += fmt::format(R"({}"{}":{{"tried":{},"done":{},"useful":{},"in_reach":{},"kept":{}}})",
                           kind == 0 ? "" : ",", kind_keys[kind], check.links.tried[kind], check.links.done[kind],
                           check.links.kept[kind], check.links_of_feet[kind], check.links_kept[kind]);
    out += "}" + still.json() + R"(,"failed":[)";
    for (std::size_t i = 0; i < check.failed.size(); ++i) {
        const NavigationFailedWalk& walk = check.failed[i];
        out += i == 0 ? "{" : ",{";
        append_point(out, "from", walk.from);
        out += ',';
        append_point(out, "to", walk.to);
        out += ',';
        append_point(out, "end", walk.report.end);
        out +=
            fmt::format(R"(,"reason":{},"capture":{}}})", json_string(reason_of(walk.report)), json_string(saved[i]));
    }
    return out + "]}\n";
}

/// The steps in which walks got stuck, each in a file of its own.
std::vector<std::string> save_stuck(const World& world, const CharacterSettings& settings, const NavigationCheck& check,
                                    const std::string& stem) {
    std::vector<std::string> saved(check.failed.size());
    for (std::size_t i = 0; i < check.failed.size() && !stem.empty(); ++i) {
        const auto& stuck = check.failed[i].report.stuck;
        if (!stuck) continue;
        StepCapture capture = capture_step(world, settings, stuck->input, WalkOptions{}.tick, stuck->before);
        capture.note = fmt::format("surefoot navcheck: stuck on the way to ({})", short_vector(check.failed[i].to));
        saved[i] = fmt::format("{}-{}.json", stem, i + 1);
        if (const auto written = write_capture(capture, saved[i]); !written)
            throw Failure{ExitCode::file, written.error().text};
    }
    return saved;
}

ExitCode run_check(const CheckGiven& given) {
    const std::optional<dvec3> start = given.start.value();
    static_cast<void>(given.walker.settings());  // what is wrong with them is said before the level is read
    const Level level = load_level(given.level);
    World world;
    const StillLevel still(level);
    if (const auto added = world.add(still.mesh); !added) throw Failure{ExitCode::file, added.error().text};
    CheckBars bars;
    const auto show = [&](NavigationCheckPart part, std::size_t done, std::size_t all) { bars.show(part, done, all); };
    const Ground ground(level, given.walker);
    const CharacterSettings& settings = ground.settings;
    NavigationCheckOptions options;
    options.mesh = ground.options;
    options.start = start;
    options.walks = given.walks;
    options.seed = given.seed;
    options.threads = given.walker.threads.value_or(options.threads);
    options.progress = NavigationCheckProgress(show);
    if (given.mesh_radius || given.mesh_slope || given.mesh_climb) {
        NavigationAgent agent = navigation_agent(settings);
        agent.radius = given.mesh_radius.value_or(agent.radius);
        agent.slope_limit_deg = given.mesh_slope.value_or(agent.slope_limit_deg);
        agent.climb = given.mesh_climb.value_or(agent.climb);
        options.mesh.agent = agent;
        options.rehearsals = 0;  // a trial shows what is wrong and does not mend it
    }
    options.rehearsals = given.rehearsals.value_or(options.rehearsals);
    const std::vector<dvec3> starts = starts_of(level);
    const auto check = check_navigation(world, settings, starts, options);
    bars.end();
    if (!check) throw Failure{ExitCode::usage, level.file + ": " + check.error().text};
    const std::vector<std::string> saved = save_stuck(world, settings, *check, given.save);
    write_out(given.json ? check_json(level.file, still, *check, saved) : check_text(level.file, still, *check, saved));
    return check->passes() ? ExitCode::ok : ExitCode::failed;
}

}  // namespace

void add_navcheck(CLI::App& program, Run& run) {
    auto* command = program.add_subcommand("navcheck", "Do the navigation mesh and the feet agree? Walks random paths");
    const auto given = std::make_shared<CheckGiven>();
    given->level.add_to(*command);
    given->walker.add_to(*command);
    given->start.add_to(*command);
    command->add_option("--walks", given->walks, "How many random paths are walked (default: 1000)")
        ->check(CLI::Range(std::size_t{1}, std::size_t{1000000}))
        ->type_name("COUNT");
    command->add_option("--seed", given->seed, "Of the paths' ends: the same number gives the same paths (default: 1)")
        ->type_name("NUMBER");
    command
        ->add_option("--rehearsals", given->rehearsals,
                     "Walks of a round of rehearsal, which mends what fails (default: 200, with --mesh-... 0: none)")
        ->check(CLI::Range(std::size_t{0}, std::size_t{1000000}))
        ->type_name("COUNT");
    command
        ->add_option("--mesh-radius", given->mesh_radius,
                     "Build the mesh for another radius than the feet have: a trial")
        ->type_name("METRES");
    command->add_option("--mesh-slope", given->mesh_slope, "The same for the steepest ground")->type_name("DEGREES");
    command->add_option("--mesh-climb", given->mesh_climb, "The same for the highest step")->type_name("METRES");
    command->add_option("--save", given->save, "Save the step in which a walk got stuck, as STEM-1.json and so on")
        ->type_name("STEM");
    command->add_flag("--json", given->json, "Print one line of JSON");
    command->footer(help_footer(
        "  surefoot navcheck castle.surefoot\n"
        "  surefoot navcheck castle.glb --walks 5000 --save stuck\n"
        "  surefoot navcheck castle.glb --mesh-climb 0.8        has to fail where there are steps of that height\n"
        "\nBuilds the mesh, finds its links, walks a character into every corner that its feet reach from where the\n"
        "level's markers of the kind `spawn` are (or from the largest piece of ground, or --start), takes out what "
        "they "
        "do\nnot reach, rehearses and drops what fails, and then walks other random paths. It passes if all arrive, if "
        "the "
        "mesh\n"
        "knows at least 98% of what the feet reach, and if no kind of link is lost. `surefoot replay STEM-1.json` "
        "says\n"
        "why a walk got stuck.\n"
        "Of a level of the platformer the still ground is checked, without what moves and what is drawn only.\n"
        "Exit codes: 0 it passes, 1 it does not, 2 wrong usage or a level for which this cannot be done, 3 a file\n"
        "cannot be read or written."));
    command->callback([given, &run] { run = [given] { return run_check(*given); }; });
}

}  // namespace surefoot::tools
