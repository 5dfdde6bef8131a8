// surefoot ray: where does a line of sight first meet the level?
#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "command.hpp"
#include "level.hpp"
#include "options.hpp"
#include "query.hpp"
#include "text.hpp"

namespace surefoot::tools {
namespace {

struct RayOptionsGiven {
    LevelOptions level;
    std::string from;
    std::string to;
    bool one_sided = false;
    bool json = false;
};

ExitCode run_ray(const RayOptionsGiven& given) {
    const Motion motion{position_of("--from", given.from), position_of("--to", given.to)};
    const Level level = load_level(given.level);
    const std::optional<Hit> hit = level.mesh.ray(motion, {.one_sided = given.one_sided});
    if (hit && hit->status != HitStatus::ok)
        throw Failure{ExitCode::failed, "this ray is beyond what can be computed, so it counts as blocked"};
    std::string out;
    if (given.json) {
        append_answer(out, hit);
        out += '\n';
    } else {
        const double length = glm::length(motion.to - motion.from);
        out = fmt::format("ray of {} m from ({}) to ({}){}.\n", short_number(length), short_vector(motion.from),
                          short_vector(motion.to), given.one_sided ? ", one-sided" : "");
        if (!hit) {
            out += "No hit: the line of sight is free.\n";
        } else {
            out += fmt::format("Hit at t = {}, after {} m.\n", short_number(hit->t), short_number(hit->t * length));
            out += fmt::format("  point     {} m\n", short_vector(hit->point));
            out += fmt::format("  normal    {}\n", short_vector(hit->normal));
            out += fmt::format("  feature   {}\n", in_words(hit->feature));
            out += fmt::format("  triangle  {}\n", hit->triangle);
            out += fmt::format("  surface   {}\n", surface_text(level, hit->surface));
            if (hit->started_inside) out += "It starts on that triangle.\n";
        }
    }
    write_out(out);
    return ExitCode::ok;
}

}  // namespace

void add_ray(CLI::App& program, Run& run) {
    auto* command = program.add_subcommand("ray", "Where does a line of sight first meet the level?");
    const auto given = std::make_shared<RayOptionsGiven>();
    given->level.add_to(*command);
    command->add_option("--from", given->from, "Where it starts [m]")->type_name("X,Y,Z")->required();
    command->add_option("--to", given->to, "Where it ends [m]")->type_name("X,Y,Z")->required();
    command->add_flag("--one-sided", given->one_sided, "Triangles exist from their front only");
    command->add_flag("--json", given->json, "Print the answer as one line of JSON, in the format of sweep");
    command->footer(
        help_footer("  surefoot ray castle.obj --from 0,1.7,0 --to 0,1.7,50\n"
                    "  surefoot ray castle.obj --from -1,9,2 --to -1,-9,2 --one-sided --json\n"
                    "\nExit codes: 0 answered (a hit or none), 2 wrong usage, 3 the level cannot be read."));
    command->callback([given, &run] { run = [given] { return run_ray(*given); }; });
}

}  // namespace surefoot::tools
