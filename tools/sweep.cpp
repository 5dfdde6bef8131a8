// surefoot sweep: when does a moving shape first touch the level? One question, or a batch of them.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <fmt/format.h>
#include <fstream>
#include <glm/geometric.hpp>
#include <iostream>
#include <vector>

#include "batch.hpp"
#include "command.hpp"
#include "level.hpp"
#include "moment.hpp"
#include "options.hpp"
#include "query.hpp"
#include "text.hpp"

namespace surefoot::tools {
namespace {

struct SweepOptionsGiven {
    LevelOptions level;
    VolumeOptions volume;
    std::string from;
    std::string to;
    std::string batch;
    std::string save;
    std::string note;
    bool json = false;
    bool trace = false;
};

std::string_view word(Verdict verdict) {
    switch (verdict) {
        case Verdict::separates:
            return "separates";
        case Verdict::enters:
            return "enters";
        case Verdict::leaves:
            return "leaves";
        case Verdict::inside:
            return "inside";
        case Verdict::contact:
            return "contact";
        case Verdict::decided:
            break;
    }
    return "decided";
}

std::string feature_name(const TraceRecord& record) {
    constexpr const char* edges[] = {"ab", "bc", "ca"};
    constexpr const char* corners[] = {"a", "b", "c"};
    const std::size_t index = std::min<std::size_t>(record.feature_index, 2);
    switch (record.feature) {
        case Feature::face:
            return "face";
        case Feature::edge:
            return fmt::format("edge {}", edges[index]);
        case Feature::vertex:
            break;
    }
    return fmt::format("vertex {}", corners[index]);
}

/// What was tried, as a table; the triangle that was hit alone when there is one, for that is the question.
std::string trace_text(const Trace& trace, const std::optional<Hit>& hit) {
    std::vector<std::uint32_t> triangles;
    for (const TraceRecord& record : trace.records()) triangles.push_back(record.triangle);
    std::sort(triangles.begin(), triangles.end());
    triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
    std::string text = fmt::format("\nWhy: {} triangles were tested near the way, with {} candidate planes{}.\n",
                                   triangles.size(), trace.records().size(),
                                   trace.dropped() == 0 ? "" : fmt::format(" ({} more not recorded)", trace.dropped()));
    text += hit ? fmt::format("Planes between the shape and triangle {}, which stopped it:\n", hit->triangle)
                : std::string("Planes that kept the shape and each triangle apart:\n");
    constexpr std::size_t most_rows = 60;
    std::size_t left_out = 0;
    std::size_t rows = 0;
    Table table({"triangle", "proposed by", "verdict", "t", "gap at from [m]", "gap at to [m]", "normal"});
    for (const TraceRecord& r : trace.records()) {
        const bool shown = hit ? r.triangle == hit->triangle : r.verdict == Verdict::separates;
        if (!shown) continue;
        if (rows++ >= most_rows) {
            ++left_out;
            continue;
        }
        const bool timed =
            r.verdict == Verdict::enters || r.verdict == Verdict::leaves || r.verdict == Verdict::decided;
        const bool plane = r.verdict != Verdict::decided;
        table.add({std::to_string(r.triangle), feature_name(r), std::string(word(r.verdict)),
                   timed ? short_number(r.t) : "-", plane ? short_number(r.gap_from) : "-",
                   plane ? short_number(r.gap_to) : "-", short_vector(r.normal)});
    }
    text += table.text();
    if (left_out > 0) text += fmt::format("  ... and {} more\n", left_out);
    text += hit ? "The latest plane that the motion enters, before it leaves another, is where it stops.\n"
                : "Each of these planes keeps the shape and its triangle apart on the whole way.\n";
    return text;
}

std::string answer_text(const Level& level, const SweepQuery& query, const std::optional<Hit>& hit) {
    const double length = glm::length(query.motion.to - query.motion.from);
    std::string text = fmt::format("{} moves {} m from ({}) to ({}){}.\n", describe(query.volume), short_number(length),
                                   short_vector(query.motion.from), short_vector(query.motion.to),
                                   query.one_sided ? ", one-sided" : "");
    if (!hit) return text + "No hit: the whole way is free.\n";
    const dvec3 stopped = query.motion.from + hit->t * (query.motion.to - query.motion.from);
    text += fmt::format("Hit at t = {}, after {} m.\n", short_number(hit->t), short_number(hit->t * length));
    text += fmt::format("  stops at  {} m\n", short_vector(stopped));
    text += fmt::format("  touches   {} m\n", short_vector(hit->point));
    text += fmt::format("  normal    {}\n", short_vector(hit->normal));
    text += fmt::format("  feature   {}\n", in_words(hit->feature));
    text += fmt::format("  triangle  {}\n", hit->triangle);
    text += fmt::format("  surface   {}\n", surface_text(level, hit->surface));
    if (hit->started_inside)
        text +=
            "It touched or overlapped already at the start and would go deeper, so it is stopped at t = 0.\n"
            "Ask `surefoot overlap` at that place for the way out.\n";
    return text;
}

ExitCode sweep_batch(const SweepOptionsGiven& given) {
    if (!given.from.empty() || !given.to.empty() || given.trace || !given.save.empty())
        throw Failure{ExitCode::usage,
                      "--from, --to, --trace and --save ask one question and --batch asks many: give one or the other"};
    QueryDefaults defaults{.shape = {}, .rotate = given.volume.rotate_value(), .one_sided = given.volume.one_sided};
    if (given.volume.has_shape()) defaults.shape = given.volume.shape_value();
    std::ios::sync_with_stdio(false);
    std::ifstream file;
    if (given.batch != "-") {
        file.open(given.batch, std::ios::binary);
        if (!file)
            throw Failure{ExitCode::file,
                          fmt::format("{}: cannot be read; --batch takes a file of JSON lines, or - for "
                                      "standard input",
                                      given.batch)};
    }
    const Level level = load_level(given.level);
    const BatchCount count = run_batch(level.mesh, defaults, given.batch == "-" ? std::cin : file, stdout);
    if (!count.written) throw Failure{ExitCode::file, "standard output did not take the answers: is the disk full?"};
    if (count.bad == 0) return ExitCode::ok;
    fmt::print(stderr, "surefoot: {} of {} lines could not be answered; their answers say why\n", count.bad,
               count.lines);
    return ExitCode::failed;
}

ExitCode sweep_once(const SweepOptionsGiven& given) {
    for (const auto& [name, text] :
         {std::pair{"--shape", &given.volume.shape}, {"--from", &given.from}, {"--to", &given.to}})
        if (text->empty())
            throw Failure{ExitCode::usage,
                          fmt::format("{} is missing: a sweep needs --shape, --from and --to (or --batch FILE)", name)};
    const SweepQuery query{.volume = given.volume.volume(),
                           .motion = {position_of("--from", given.from), position_of("--to", given.to)},
                           .one_sided = given.volume.one_sided};
    const Level level = load_level(given.level);
    std::vector<TraceRecord> room(given.trace ? std::size_t{1} << 16U : 0);
    Trace trace(room);
    const std::optional<Hit> hit = level.mesh.sweep(
        query.volume, query.motion, {.one_sided = query.one_sided, .trace = given.trace ? &trace : nullptr});
    if (!given.save.empty()) {
        Capture moment = capture_sweep(level.mesh, query.volume, query.motion, {.one_sided = query.one_sided});
        moment.note = given.note.empty() ? "surefoot sweep " + given.level.file : given.note;
        save_moment(moment, given.save);
    }
    if (hit && hit->status != HitStatus::ok)
        throw Failure{ExitCode::failed, "this query is beyond what can be computed, so it counts as blocked"};
    std::string out;
    if (given.json) {
        append_answer(out, hit);
        out += '\n';
    } else {
        out = answer_text(level, query, hit);
        if (given.trace) out += trace_text(trace, hit);
    }
    write_out(out);
    return ExitCode::ok;
}

}  // namespace

void add_sweep(CLI::App& program, Run& run) {
    auto* command = program.add_subcommand("sweep", "When does a moving shape first touch the level, and where?");
    const auto given = std::make_shared<SweepOptionsGiven>();
    given->level.add_to(*command);
    given->volume.add_to(*command, false);
    command->add_option("--from", given->from, "Where its reference point starts [m]")->type_name("X,Y,Z");
    command->add_option("--to", given->to, "Where it would like to be [m]")->type_name("X,Y,Z");
    command
        ->add_option("--batch", given->batch,
                     "Answer every JSON line of this file (- for standard input); --shape, --rotate and "
                     "--one-sided then hold for lines that say nothing themselves")
        ->type_name("FILE");
    command->add_flag("--json", given->json, "Print the answer as one line of JSON, as --batch does");
    command->add_flag("--trace", given->trace, "Show which planes were tried and what became of them");
    auto* save = command
                     ->add_option("--save", given->save,
                                  "Also save the question, the triangles near its way and the answer, for `surefoot "
                                  "replay`")
                     ->type_name("FILE");
    command->add_option("--note", given->note, "What the saved moment says about itself (default: the level)")
        ->type_name("TEXT")
        ->needs(save);
    command->footer(help_footer(
        "  surefoot sweep castle.obj --shape ellipsoid:0.4,0.9,0.4 --from 0,2,0 --to 0,2,12\n"
        "  surefoot sweep castle.obj --shape box:0.5,1,0.5 --rotate 0.9,0,0.4,0 --from -1,2,3 --to 4,0,3 --trace\n"
        "  echo '{\"shape\":{\"sphere\":[0.5]},\"from\":[0,9,0],\"to\":[0,-9,0]}' | surefoot sweep castle.obj --batch "
        "-\n"
        "\nIn a batch, answer N belongs to line N; a bad line is answered with {\"error\":\"line N: ...\"}.\n"
        "Exit codes: 0 answered, 1 a batch had bad lines, 2 wrong usage, 3 a file cannot be read or "
        "written."));
    command->callback(
        [given, &run] { run = [given] { return given->batch.empty() ? sweep_once(*given) : sweep_batch(*given); }; });
}

}  // namespace surefoot::tools
