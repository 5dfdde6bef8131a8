// The page: its head, the summary of each level, people's sessions, and the files beside it. Its pictures are in
// report_pictures.cpp.
#include "playtest/report/report.hpp"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>

#include "game/whole_file.hpp"
#include "playtest/report/report_parts.hpp"
#include "playtest/report/report_script.hpp"

namespace surefoot::playtest {
namespace {

constexpr std::string_view head = R"(<!doctype html>
<html lang="en"><head><meta charset="utf-8"><title>Playtest</title>
<meta name="viewport" content="width=device-width, initial-scale=1"><style>
body{font:15px/1.45 system-ui,sans-serif;color:#222;background:#faf9f6;max-width:1000px;margin:2em auto;padding:0 1em}
h1,h2,h3{line-height:1.2}h2{margin-top:2.5em;border-top:2px solid #ccc;padding-top:.8em}
table{border-collapse:collapse;margin:.8em 0}td,th{padding:.25em .8em;text-align:left;border-bottom:1px solid #ddd}
td.n,th.n{text-align:right;font-variant-numeric:tabular-nums}
.good{color:#18723a}.bad{color:#b3261e;font-weight:600}.dim{color:#777}
.plan{position:relative;background:#dfe5ea;margin:.6em 0;max-width:100%}.plan svg{position:absolute;left:0;top:0}
.plans{display:flex;flex-wrap:wrap;gap:1em}figure{margin:0}figcaption{color:#555;font-size:13px}
.incidents{display:flex;flex-wrap:wrap;gap:.8em;align-items:flex-start}
.incident{width:480px;max-width:100%;box-sizing:content-box;font-size:13px;background:#fff;border:1px solid #ddd;padding:.5em}
.incident.small{width:214px}.incident p{margin:.4em 0 0}.incident code{font-size:12px}
.incident img,.clip canvas{display:block;max-width:100%;height:auto}
.aside{display:flex;margin-top:2px}.aside figure{width:50%}
.incident figure{position:relative}.incident figcaption{position:absolute;left:.4em;bottom:.3em;color:#fff;text-shadow:0 0 3px #000,0 0 3px #000}
.from-above{width:214px;height:150px;background-color:#dfe5ea;position:relative;overflow:hidden}
.from-above svg{position:absolute;left:0;top:0}
.clip{margin-top:2px}.bar{display:flex;gap:.5em;align-items:center}.bar input{flex:1}
</style></head><body>
)";

std::string minutes(double seconds) {
    return fmt::format("{}:{:04.1f}", int(seconds / 60), seconds - 60 * int(seconds / 60));
}

std::string verdict(bool good, const std::string& text) {
    return fmt::format("<span class=\"{}\">{}</span>", good ? "good" : "bad", text);
}

void add_summary(std::string& out, const Findings& of) {
    std::vector<double> times;
    for (const PlayedRun& run : of.runs)
        if (run.telemetry.won && run.telemetry.begun_in == 0) times.push_back(run.telemetry.seconds);
    std::ranges::sort(times);
    out += "<table>";
    const auto row = [&](const std::string& name, const std::string& value) {
        out += fmt::format("<tr><th>{}</th><td>{}</td></tr>", name, value);
    };
    if (!of.unreachable.empty()) row("Goal", verdict(false, escaped(of.unreachable)));
    row("Played", fmt::format("{} in {} runs, {:.0f} times as fast as by hand", minutes(of.played), of.runs.size(),
                              of.took > 0 ? of.played / of.took : 0));
    if (of.navigators() > 0)
        row("Bots that know the way",
            verdict(of.navigators_won() == of.navigators(),
                    fmt::format("{} of {} runs finished", of.navigators_won(), of.navigators())));
    if (!times.empty())
        row("Times", fmt::format("fastest {}, median {}, slowest {}; par {}", minutes(times.front()),
                                 minutes(times[times.size() / 2]), minutes(times.back()), minutes(of.level->par)));
    for (const auto kind :
         {Incident::Kind::stuck, Incident::Kind::escape, Incident::Kind::not_a_number, Incident::Kind::overflow})
        row(std::string(name_of(kind)), verdict(of.count(kind) == 0, std::to_string(of.count(kind))));
    row("Failed jumps", std::to_string(of.count(Incident::Kind::failed_jump)));
    std::string never;
    for (const std::uint32_t pickup : of.never_taken) {
        const game::PickupPlan& plan = of.level->pickups[pickup];
        never += fmt::format("{}{} ({:.1f}, {:.1f}, {:.1f})", never.empty() ? "" : "; ", game::name_of(plan.kind),
                             plan.place.x, plan.place.y, plan.place.z);
    }
    row("Never taken by anybody", never.empty() ? "nothing" : never);
    std::string reasons;
    for (const PlayedRun& run : of.runs)
        if (!run.telemetry.gave_up.empty() && reasons.find(run.telemetry.gave_up) == std::string::npos)
            reasons += fmt::format("<div>{}: {}</div>", escaped(run.telemetry.player), escaped(run.telemetry.gave_up));
    if (!reasons.empty()) row("Bots gave up", reasons);
    out += "</table>\n";
}

void add_sections(std::string& out, const Findings& of) {
    const std::vector<std::uint32_t> deaths = of.deaths_by_section();
    out +=
        "<h3>Sections</h3><p class=dim>Deaths of everybody; explorers play equally long in each "
        "section.</p><table><tr><th>section</th><th class=n>reached by</th><th class=n>deaths</th><th "
        "class=n>mean time</th><th>verdict</th></tr>";
    for (std::size_t i = 0; i < deaths.size(); ++i) {
        int reached = 0;
        double seconds = 0;
        for (const PlayedRun& run : of.runs)
            if (i < run.telemetry.section_reached.size() && run.telemetry.section_reached[i]) {
                ++reached;
                seconds += run.telemetry.section_seconds[i];
            }
        out += fmt::format("<tr><td>{}</td><td class=n>{}</td><td class=n>{}</td><td class=n>{}</td><td>{}</td></tr>",
                           escaped(of.level->checkpoints[i].section), reached, deaths[i],
                           reached > 0 ? minutes(seconds / reached) : "", death_verdict(deaths, i));
    }
    out += "</table>\n";
}

void add_sessions(std::string& out, std::span<const Session> sessions) {
    if (sessions.empty()) return;
    out +=
        "<h2>People</h2>\n<table><tr><th>who</th><th>plays</th><th>with</th><th class=n>fun</th><th "
        "class=n>difficulty</th><th class=n>control</th><th class=n>knew the way</th><th class=n>would go "
        "on</th></tr>";
    const auto mark = [](int answer) { return answer == 0 ? std::string("\u2013") : std::to_string(answer); };
    for (const Session& session : sessions) {
        const Questionnaire& answers = session.answers;
        out += fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td>", escaped(session.start.player),
                           escaped(session.start.plays_games), escaped(session.start.device));
        for (const int answer : {answers.fun, answers.difficulty, answers.control, answers.way, answers.again})
            out += fmt::format("<td class=n>{}</td>", mark(answer));
        out += "</tr>";
    }
    out += "</table>\n";
    for (const Session& session : sessions) {
        out += fmt::format("<h3>{}</h3><ul>", escaped(session.start.player));
        if (!session.answers.remark.empty()) out += fmt::format("<li>said: {}</li>", escaped(session.answers.remark));
        for (const SessionNote& note : session.notes)
            out += fmt::format("<li>{}: {}</li>",
                               note.run.empty() ? std::string("between runs")
                                                : fmt::format("{} at {}", escaped(note.run), minutes(note.seconds)),
                               note.text.empty() ? std::string("marked") : escaped(note.text));
        out += "</ul>\n";
    }
}

}  // namespace

Report make_report(std::span<const Findings> levels, std::span<const Session> sessions, const std::string& folder,
                   const ReportOptions& options) {
    Report report;
    std::string& out = report.html;
    out += head;
    out +=
        "<h1>Playtest</h1>\n<table><tr><th>level</th><th class=n>runs</th><th>finished</th><th "
        "class=n>deaths</th><th>look "
        "at</th></tr>";
    for (const Findings& of : levels) {
        const std::size_t looks = of.count(Incident::Kind::stuck) + of.count(Incident::Kind::escape) +
                                  of.count(Incident::Kind::not_a_number) + of.count(Incident::Kind::overflow);
        out += fmt::format(
            "<tr><td><a href=\"#{0}\">{1}</a></td><td class=n>{2}</td><td>{3}</td><td "
            "class=n>{4}</td><td>{5}</td></tr>",
            escaped(of.level->id), escaped(of.level->title), of.runs.size(),
            of.unreachable.empty() ? verdict(of.navigators_won() == of.navigators(),
                                             fmt::format("{} of {}", of.navigators_won(), of.navigators()))
                                   : verdict(false, "unreachable"),
            of.count(Incident::Kind::death),
            verdict(of.is_fine(),
                    of.is_fine() ? of.runs.empty() ? "not played" : "nothing" : fmt::format("{} incidents", looks)));
    }
    out += "</table>\n";
    for (std::size_t i = 0; i < levels.size(); ++i) {
        const Findings& of = levels[i];
        out += fmt::format("<h2 id=\"{}\">{}</h2>\n<p>{}</p>\n", escaped(of.level->id), escaped(of.level->title),
                           escaped(of.level->idea));
        if (of.runs.empty() && of.unreachable.empty()) {
            out += "<p>Nobody has played it.</p>\n";
            continue;
        }
        add_summary(out, of);
        add_sections(out, of);
        const PlanFrame frame = plan_frame(*of.level);
        add_plans(out, of, frame, i);
        // Levels that follow get as much of the room that is left.
        const std::size_t left = options.most_bytes > out.size() ? options.most_bytes - out.size() : 0;
        add_incidents(report, of, frame,
                      {.level = i,
                       .folder = folder,
                       .framed = options.framed,
                       .room = left / (levels.size() - i),
                       .progress = [&](double done) {
                           if (options.progress) options.progress((double(i) + done) / double(levels.size()));
                       }});
    }
    add_sessions(out, sessions);
    out += page_script;
    out += "</body></html>\n";
    return report;
}

Expected<void> write_report(const std::string& path, std::span<const Findings> levels,
                            std::span<const Session> sessions, const ReportOptions& options) {
    const std::filesystem::path page(path);
    const std::string folder = page.stem().string() + "_files";
    const Report report = make_report(levels, sessions, folder, options);
    for (const ReportFile& file : report.files)
        if (auto written = game::write_whole((page.parent_path() / folder / file.name).string(), file.bytes); !written)
            return written;
    return game::write_whole(path, report.html);
}

}  // namespace surefoot::playtest
