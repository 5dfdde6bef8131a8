// surefoot nav: the ground on which a character can stand, and the way from here to there.
#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <memory>

#include <surefoot/navigation_query.hpp>

#include "command.hpp"
#include "kitchen.hpp"
#include "navigator.hpp"
#include "number.hpp"
#include "options.hpp"
#include "query.hpp"
#include "text.hpp"

namespace surefoot::tools {
namespace {

struct BuildGiven {
    LevelOptions level;
    WalkerOptions walker;
    StartOption start;
    std::string output;
    bool unproved = false;
    bool json = false;
};

struct PathGiven {
    LevelOptions level;
    WalkerOptions walker;
    std::string from;
    std::string to;
    bool json = false;
};

void append_field(std::string& out, const char* name, double value) {
    out += fmt::format(R"(,"{}":)", name);
    append_number(out, value);
}

std::string built_json(const std::string& file, const StillLevel& still, const NavigationMesh& mesh, std::size_t bytes,
                       const NavigationAgreement& agreement) {
    const NavigationReport report = mesh.report();
    const NavigationAgent& agent = mesh.agent();
    std::string out = fmt::format(R"({{"file":{},"bytes":{},"tiles":{},"polygons":{},"links":{})", json_string(file),
                                  bytes, report.tiles, report.polygons, mesh.links().size());
    append_field(out, "area", report.area);
    append_field(out, "unreached", agreement.unreached);
    append_field(out, "no_return", agreement.no_return);
    append_field(out, "covered", agreement.covered());
    out += fmt::format(R"(,"rehearsed":{},"failed_links":{},"failed_polygons":{})", agreement.rehearsed,
                       agreement.failed_links, agreement.failed_polygons);
    append_field(out, "failed_area", agreement.failed_area);
    out += still.json();
    append_field(out, "seconds", report.seconds);
    out += R"(,"agent":{"radius":)";
    append_number(out, agent.radius);
    append_field(out, "height", agent.height);
    append_field(out, "climb", agent.climb);
    append_field(out, "slope_limit_deg", agent.slope_limit_deg);
    append_field(out, "feet", agent.feet);
    return out + "}}\n";
}

std::string built_text(const std::string& file, const StillLevel& still, const NavigationMesh& mesh, std::size_t bytes,
                       const NavigationAgreement& agreement) {
    const NavigationReport report = mesh.report();
    const NavigationAgent& agent = mesh.agent();
    std::string out = fmt::format("{}: {} m2 of ground in {} polygons and {} tiles, {} links, {} bytes, built in {}\n",
                                  file, short_number(report.area), grouped(report.polygons), grouped(report.tiles),
                                  grouped(mesh.links().size()), grouped(bytes), duration(report.seconds));
    out += still.text();
    out += fmt::format("  for       a cylinder of radius {} m and {} m high, with its skin, around the body\n",
                       short_number(agent.radius), short_number(agent.height));
    out += fmt::format("  that      walks up steps of {} m and stands on slopes of {} degrees\n",
                       short_number(agent.climb), short_number(agent.slope_limit_deg));
    if (agreement.flood > 0)
        out += fmt::format(
            "  taken out {:.1f} m2 to which no feet get, {:.1f} m2 from which they do not get back\n"
            "  rehearsed {} walks: {} links that failed dropped, {:.1f} m2 in {} polygons where feet got stuck taken "
            "out\n"
            "  knows     {:.2f}% of the {:.1f} m2 that feet reach and come back from\n",
            agreement.unreached, agreement.no_return, grouped(agreement.rehearsed), grouped(agreement.failed_links),
            agreement.failed_area, grouped(agreement.failed_polygons), 100 * agreement.covered(), agreement.flood);
    return out;
}

ExitCode run_build(const BuildGiven& given) {
    if (given.output.empty() && !is_cooked_name(given.level.file))
        throw Failure{ExitCode::usage,
                      fmt::format("{}: is not cooked, so name the file to write: -o LEVEL.surefoot", given.level.file)};
    const std::string output = given.output.empty() ? given.level.file : given.output;
    const Level level = load_level(given.level);
    const StillLevel still(level);
    NavigationAgreement agreement;
    const NavigationMesh mesh = build_ground(level, still, given.walker, given.unproved ? Proof::none : Proof::by_feet,
                                             given.start.value(), &agreement);
    const std::vector<std::byte> bytes = mesh.to_bytes();
    // What is refused when it is opened is better not written.
    if (const auto sound = NavigationMesh::read(bytes, output); !sound)
        throw Failure{ExitCode::failed, sound.error().text};
    const Section section = navigation_section(bytes, level.mesh.made_from());
    const auto written = level.mesh.write(output, std::span(&section, 1));
    if (!written) throw Failure{ExitCode::file, written.error().text};
    write_out(given.json ? built_json(output, still, mesh, bytes.size(), agreement)
                         : built_text(output, still, mesh, bytes.size(), agreement));
    return ExitCode::ok;
}

/// The ground under or near a place; nothing if there is none.
std::optional<NavigationPoint> ground_at(const NavigationQuery& query, const dvec3& place) {
    const NavigationAgent& agent = query.mesh().agent();
    if (const auto under = query.under(place, 2 * agent.height, agent.climb)) return under;
    return query.nearest(place, 2 * agent.radius, agent.height);
}

std::string_view word(NavigationLinkKind kind) {
    switch (kind) {
        case NavigationLinkKind::drop:
            return "drop";
        case NavigationLinkKind::jump:
            return "jump";
        case NavigationLinkKind::step_up:
            return "step_up";
        case NavigationLinkKind::ladder:
            return "ladder";
    }
    return "";
}

std::string path_json(const NavigationMesh& mesh, const NavigationPath& path) {
    std::string out = fmt::format(R"({{"found":true,"partial":{},"length":)", path.partial);
    append_number(out, path.length);
    out += fmt::format(R"(,"polygons":{},"corners":[)", path.polygons.size());
    for (std::size_t i = 0; i < path.corners.size(); ++i) {
        out += i == 0 ? "" : ",";
        append_array(out, path.corners[i].position);
    }
    out += R"(],"links":[)";
    bool first = true;
    for (std::size_t i = 0; i < path.corners.size(); ++i) {
        if (!path.corners[i].link) continue;
        const NavigationLink& link = mesh.links()[*path.corners[i].link];
        out += fmt::format(R"({}{{"corner":{},"link":{},"kind":"{}"}})", first ? "" : ",", i, *path.corners[i].link,
                           word(link.kind));
        first = false;
    }
    return out + "]}\n";
}

std::string path_text(const NavigationMesh& mesh, const NavigationPath& path, const dvec3& to) {
    std::string out =
        fmt::format("Path of {} m over {} polygons.\n", short_number(path.length), grouped(path.polygons.size()));
    if (path.partial)
        out += fmt::format("It does not get there: it ends as near to ({}) as it can.\n", short_vector(to));
    for (const NavigationCorner& corner : path.corners) {
        out += fmt::format("  {}", short_vector(corner.position));
        if (corner.link) out += fmt::format("   {} to", word(mesh.links()[*corner.link].kind));
        out += '\n';
    }
    return out;
}

ExitCode run_path(const PathGiven& given) {
    const dvec3 from = position_of("--from", given.from);
    const dvec3 to = position_of("--to", given.to);
    const Level level = load_level(given.level);
    std::optional<NavigationMesh> kept;
    if (!given.walker.any()) kept = ground_in(level);
    const NavigationMesh mesh =
        kept ? *std::move(kept) : build_ground(level, StillLevel(level), given.walker, Proof::none);
    const NavigationQuery query(mesh, 65535);
    const auto start = ground_at(query, from);
    const auto end = ground_at(query, to);
    const auto path = start && end ? query.path(*start, *end) : std::nullopt;
    if (path) {
        write_out(given.json ? path_json(mesh, *path) : path_text(mesh, *path, to));
        return ExitCode::ok;
    }
    const char* const where = start ? "--to" : "--from";
    write_out(given.json ? fmt::format(R"({{"found":false,"no_ground_at":"{}"}})"
                                       "\n",
                                       where + 2)
                         : fmt::format("No path: there is no ground to stand on at {} ({}).\n", where,
                                       short_vector(start ? to : from)));
    return ExitCode::ok;
}

void add_build(CLI::App& nav, Run& run) {
    auto* command = nav.add_subcommand("build", "Find the ground of a level, and keep it in the level's file");
    const auto given = std::make_shared<BuildGiven>();
    given->level.add_to(*command);
    given->walker.add_to(*command);
    given->start.add_to(*command);
    command
        ->add_option("-o,--output", given->output,
                     "The file to write: triangles, ground, and whatever else was there (default: a cooked LEVEL)")
        ->type_name("OUT.surefoot");
    command->add_flag("--unproved", given->unproved, "Ground alone: no links, and without trying where feet get");
    command->add_flag("--json", given->json, "Print one line of JSON");
    command->footer(help_footer(
        "  surefoot nav build castle.surefoot\n"
        "  surefoot nav build castle.glb -o castle.surefoot --radius 0.3 --height 1.5\n"
        "\nGround is what this character can stand on: not too steep, as wide and as high as its body needs, joined "
        "by\n"
        "steps that it walks up. Then a character is walked everywhere from the level's spawn points, drops and jumps\n"
        "that it gets over become links, and ground that it does not reach is taken out; that takes a minute or so.\n"
        "The old file stays whole until the new one is. Markers of the level of the kind\n"
        "navigation_forbid keep everybody out of their box; of the kind navigation_require they make building fail "
        "when\n"
        "there is no ground in it. Of a level of the platformer it is the still ground: what moves and what is drawn "
        "only\n"
        "is left out.\n"
        "Exit codes: 0 written, 2 wrong usage or a level for which this cannot be done, 3 a file cannot be read or\n"
        "written."));
    command->callback([given, &run] { run = [given] { return run_build(*given); }; });
}

void add_path(CLI::App& nav, Run& run) {
    auto* command = nav.add_subcommand("path", "How does a character get from one place to another?");
    const auto given = std::make_shared<PathGiven>();
    given->level.add_to(*command);
    command->add_option("--from", given->from, "Where its feet start: on the ground or a little above it [m]")
        ->type_name("X,Y,Z")
        ->required();
    command->add_option("--to", given->to, "Where they are to go [m]")->type_name("X,Y,Z")->required();
    given->walker.add_to(*command);
    command->add_flag("--json", given->json, "Print one line of JSON");
    command->footer(help_footer(
        "  surefoot nav path castle.surefoot --from 0,0,0 --to 12,3,-4\n"
        "  surefoot nav path castle.glb --from 0,0,0 --to 12,3,-4 --radius 0.3 --json\n"
        "\nThe ground is that of LEVEL where `surefoot nav build` has put it; it is found anew, and not kept, where "
        "there\n"
        "is none or where a body, a step, a slope or a cell is given. No way and half a way are answers.\n"
        "Exit codes: 0 answered, 2 wrong usage or a level for which this cannot be done, 3 a file cannot be read."));
    command->callback([given, &run] { run = [given] { return run_path(*given); }; });
}

}  // namespace

void add_nav(CLI::App& program, Run& run) {
    auto* command = program.add_subcommand("nav", "Where can a character stand, and how does it get there?");
    command->require_subcommand(1);
    add_build(*command, run);
    add_path(*command, run);
}

}  // namespace surefoot::tools
