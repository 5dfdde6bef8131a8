// surefoot course: how does a character controller do in the scenes of the movement course?
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <memory>

#include "command.hpp"
#include "course/catalogue.hpp"
#include "course/mover.hpp"
#include "course/runner.hpp"
#include "number.hpp"
#include "parse.hpp"
#include "progress.hpp"
#include "query.hpp"
#include "text.hpp"

namespace surefoot::tools {
namespace {

struct CourseOptions {
    std::vector<std::string> scenes;
    std::vector<std::string> movers;
    std::vector<std::string> programs;
    std::string run;
    std::string shape = "capsule";
    bool track = false;
    bool all_bars = false;
    bool json = false;
    bool list = false;
};

struct Contender {
    std::string name;
    std::unique_ptr<course::Mover> mover;
    std::vector<course::Score> scores;
};

std::string names_of_movers() {
    std::string names;
    for (const course::MoverName& known : course::movers())
        names += (names.empty() ? "" : ", ") + std::string(known.name);
    return names;
}

Contender contender(const std::string& name) {
    auto mover = course::make_mover(name);
    if (mover) return {name, std::move(mover), {}};
    if (name == "bullet") throw Failure{ExitCode::usage, std::string(course::bullet_missing())};
    throw Failure{ExitCode::usage, fmt::format("there is no mover {}: {}, or --exec PROGRAM", name, names_of_movers())};
}

std::vector<Contender> contenders(const CourseOptions& given) {
    std::vector<Contender> all;
    for (const std::string& name : given.movers) {
        if (name != "all") {
            all.push_back(contender(name));
            continue;
        }
        for (const course::MoverName& known : course::movers()) {
            if (auto mover = course::make_mover(known.name))
                all.push_back({std::string(known.name), std::move(mover), {}});
        }
    }
    for (const std::string& program : given.programs) {
        try {
            all.push_back({program, course::make_external_mover(program), {}});
        } catch (const course::MoverFailure& failure) {
            throw Failure{ExitCode::file, fmt::format("{}: {}", program, failure.text)};
        }
    }
    if (all.empty()) all.push_back(contender("ours"));
    return all;
}

/// The scenes that were asked for: whole names, or the beginnings of names.
course::Scenes chosen(const std::vector<std::string>& wanted, course::BodyShape shape) {
    course::Scenes scenes = course::all_scenes(shape);
    if (wanted.empty()) return scenes;
    for (const std::string& name : wanted) {
        if (std::none_of(scenes.begin(), scenes.end(), [&](const auto& scene) { return scene.name.starts_with(name); }))
            throw Failure{ExitCode::usage,
                          fmt::format("there is no scene {}; `surefoot course --list` tells them", name)};
    }
    std::erase_if(scenes, [&](const course::Scene& scene) {
        return std::none_of(wanted.begin(), wanted.end(),
                            [&](const std::string& name) { return scene.name.starts_with(name); });
    });
    return scenes;
}

course::BodyShape shape_of(const std::string& name) {
    std::string names;
    for (const course::ShapeName& known : course::shapes()) {
        if (known.name == name) return known.shape;
        names += (names.empty() ? "" : ", ") + std::string(known.name);
    }
    throw Failure{ExitCode::usage, fmt::format("there is no shape {}: {}", name, names)};
}

std::string list_text(const course::Scenes& scenes) {
    std::string out;
    for (const course::Scene& scene : scenes) {
        out += fmt::format("{}: {}; {} runs\n", scene.name, scene.title, scene.runs.size());
        for (const course::Bar& bar : scene.bars)
            out += fmt::format("    {}: at most {}{}{}: {}\n", bar.what, short_number(bar.most),
                               bar.unit.empty() ? "" : " ", bar.unit, bar.reason);
        if (!scene.cannot.empty()) out += fmt::format("    cannot be cleared: {}\n", scene.cannot);
        if (!scene.catches.empty()) out += fmt::format("    fails {}\n", fmt::join(scene.catches, ", "));
    }
    out += "\nmovers:\n";
    for (const course::MoverName& mover : course::movers()) out += fmt::format("    {}: {}\n", mover.name, mover.about);
    return out;
}

/// The bars of one mover: those that it misses, or all of them.
std::string bars_text(const Contender& contender, bool all_bars) {
    Table table({"scene", "", "bar", "measured", "at most", "worst in"});
    for (const course::Score& score : contender.scores) {
        std::string name = score.scene->name;
        std::string verdict = score.passes() ? "passes" : score.scene->cannot.empty() ? "FAILS" : "cannot";
        if (!score.failure.empty()) table.add({name, verdict, score.failure, "", "", ""});
        for (const course::Mark& mark : score.marks) {
            if (mark.passes() && !all_bars) continue;
            const std::string unit = mark.bar->unit.empty() ? "" : " " + mark.bar->unit;
            table.add({name, all_bars ? (mark.passes() ? "passes" : "FAILS") : verdict, mark.bar->what,
                       fmt::format("{:.3g}{}", mark.worst.value, unit), fmt::format("{:.3g}{}", mark.bar->most, unit),
                       mark.worst.where});
        }
        if (score.passes() && !all_bars) table.add({name, verdict, "", "", "", ""});
    }
    return table.text();
}

std::string matrix_text(const std::vector<Contender>& all, const course::Scenes& scenes) {
    std::vector<std::string> heading{"scene"};
    for (const Contender& contender : all) heading.push_back(contender.name);
    Table table(heading);
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        std::vector<std::string> row{scenes[i].name};
        for (const Contender& contender : all) row.emplace_back(contender.scores[i].passes() ? "pass" : "-");
        table.add(row);
    }
    return table.text();
}

std::size_t passed(const Contender& contender) {
    return static_cast<std::size_t>(std::count_if(contender.scores.begin(), contender.scores.end(),
                                                  [](const course::Score& score) { return score.passes(); }));
}

bool clears_what_it_can(const Contender& contender) {
    return std::all_of(contender.scores.begin(), contender.scores.end(),
                       [](const course::Score& score) { return score.passes() || !score.scene->cannot.empty(); });
}

void append_measure(std::string& out, double value) {
    // JSON knows no infinity and no NaN.
    if (std::isfinite(value)) {
        append_number(out, value);
    } else {
        out += "null";
    }
}

std::string json_of(const Contender& contender) {
    std::string out =
        fmt::format(R"({{"mover":{},"passed":{},"scenes":[)", json_string(contender.name), passed(contender));
    for (const course::Score& score : contender.scores) {
        if (out.back() != '[') out += ',';
        out += fmt::format(R"({{"scene":{},"passes":{},"failure":{},"bars":[)", json_string(score.scene->name),
                           score.passes(), json_string(score.failure));
        for (const course::Mark& mark : score.marks) {
            if (out.back() != '[') out += ',';
            out +=
                fmt::format(R"({{"what":{},"unit":{},"passes":{},"where":{},"measured":)", json_string(mark.bar->what),
                            json_string(mark.bar->unit), mark.passes(), json_string(mark.worst.where));
            append_measure(out, mark.worst.value);
            out += R"(,"most":)";
            append_measure(out, mark.bar->most);
            out += '}';
        }
        out += "]}";
    }
    return out + "]}\n";
}

/// Of each scene only the runs with this in their names; bars that compare runs are left with what there is.
void keep_runs(course::Scenes& scenes, const std::string& part) {
    for (course::Scene& scene : scenes)
        std::erase_if(scene.runs, [&](const course::Run& run) { return run.name.find(part) == std::string::npos; });
    std::erase_if(scenes, [](const course::Scene& scene) { return scene.runs.empty(); });
    if (scenes.empty()) throw Failure{ExitCode::usage, fmt::format("no run has {} in its name", part)};
}

/// Every tick of every run, a line each, for a spreadsheet or a plot.
void write_tracks(const course::Scenes& scenes, std::vector<Contender>& all) {
    write_out("mover,scene,run,time,x,y,z,grounded,wish_x,wish_z,jump\n");
    for (Contender& contender : all) {
        for (const course::Scene& scene : scenes) {
            for (const course::Run& run : scene.runs) {
                const course::Outing outing = course::walk_run(run, *contender.mover);
                for (const course::Spot& spot : outing.spots)
                    write_out(fmt::format("{},{},\"{}\",{:.9g},{:.17g},{:.17g},{:.17g},{:d},{:.9g},{:.9g},{:d}\n",
                                          contender.name, scene.name, run.name, spot.time, spot.position.x,
                                          spot.position.y, spot.position.z, spot.grounded, spot.input.wish.x,
                                          spot.input.wish.z, spot.input.jump));
            }
        }
    }
}

ExitCode run_course(const CourseOptions& given) {
    course::Scenes scenes = chosen(given.scenes, shape_of(given.shape));
    if (!given.run.empty()) keep_runs(scenes, given.run);
    if (given.list) {
        write_out(list_text(scenes));
        return ExitCode::ok;
    }
    std::vector<Contender> all = contenders(given);
    if (given.track) {
        write_tracks(scenes, all);
        return ExitCode::ok;
    }
    for (Contender& contender : all) {
        ProgressBar bar(contender.name);
        for (std::size_t i = 0; i < scenes.size(); ++i) {
            contender.scores.push_back(course::run_scene(scenes[i], *contender.mover, [&](double share) {
                bar.show((static_cast<double>(i) + share) / static_cast<double>(scenes.size()));
            }));
        }
    }
    bool is_well = true;
    for (const Contender& contender : all) {
        if (contender.name == "ours" || all.size() == 1) is_well = is_well && clears_what_it_can(contender);
        if (given.json) write_out(json_of(contender));
    }
    if (!given.json) {
        if (all.size() == 1) {
            write_out(bars_text(all.front(), given.all_bars));
        } else {
            write_out(matrix_text(all, scenes));
        }
        for (const Contender& contender : all)
            write_out(fmt::format("{} passes {} of {} scenes\n", contender.name, passed(contender), scenes.size()));
    }
    return is_well ? ExitCode::ok : ExitCode::failed;
}

}  // namespace

void add_course(CLI::App& program, Run& run) {
    auto* command = program.add_subcommand("course", "How does a character controller do on the movement course?");
    const auto given = std::make_shared<CourseOptions>();
    command->add_option("--scene", given->scenes, "Only scenes whose names begin so; may be given again")
        ->type_name("NAME")
        ->allow_extra_args(false);
    command->add_option("--mover", given->movers, "Who walks, or `all`; may be given again (default: ours)")
        ->type_name("NAME")
        ->allow_extra_args(false);
    command
        ->add_option("--exec", given->programs,
                     "A program of yours that speaks the line protocol, as a shell starts it")
        ->type_name("PROGRAM")
        ->allow_extra_args(false);
    command
        ->add_option("--shape", given->shape,
                     "The body: capsule, ellipsoid, sphere, box, cylinder or cone, as wide and as high as the capsule")
        ->type_name("SHAPE")
        ->capture_default_str();
    command->add_option("--run", given->run, "Of each scene only the runs with this in their names")->type_name("TEXT");
    command->add_flag("--track", given->track, "Print where it was after each tick instead of scores, as CSV");
    command->add_flag("--bars", given->all_bars, "Tell every bar with its measure, not only those that are missed");
    command->add_flag("--json", given->json, "Print JSON, a line for each mover");
    command->add_flag("--list", given->list, "Tell the scenes, their bars with the reasons, and the movers");
    command->footer(
        help_footer("  surefoot course\n"
                    "  surefoot course --scene stairs --mover bullet\n"
                    "  surefoot course --mover all\n"
                    "  surefoot course --shape ellipsoid\n"
                    "  surefoot course --scene wedge-along --run '80 degrees' --track\n"
                    "  surefoot course --exec 'node my-mover.mjs'\n"
                    "\nHow a program joins: docs/course-protocol.md.\n"
                    "Exit codes: 0 ours, or the only one that walked, clears every bar; 1 it does not; 2 wrong usage; "
                    "3 a program cannot be started."));
    command->callback([given, &run] { run = [given] { return run_course(*given); }; });
}

}  // namespace surefoot::tools
