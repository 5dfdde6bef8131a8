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
    std::vector<std::string> shapes;
    bool track = false;
    bool all_bars = false;
    bool json = false;
    bool list = false;
    bool catches = false;
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

course::ShapeName shape_of(const std::string& name) {
    std::string names;
    for (const course::ShapeName& known : course::shapes()) {
        if (known.name == name) return known;
        names += (names.empty() ? "" : ", ") + std::string(known.name);
    }
    throw Failure{ExitCode::usage, fmt::format("there is no shape {}: {}, or all", name, names)};
}

/// All that walk with one shape.
struct Field {
    std::string_view shape;
    course::Scenes scenes;
    std::vector<Contender> contenders;
};

/// Of each scene only the runs with this in their names; bars that compare runs are left with what there is.
void keep_runs(course::Scenes& scenes, const std::string& part) {
    for (course::Scene& scene : scenes)
        std::erase_if(scene.runs, [&](const course::Run& run) { return run.name.find(part) == std::string::npos; });
    std::erase_if(scenes, [](const course::Scene& scene) { return scene.runs.empty(); });
    if (scenes.empty()) throw Failure{ExitCode::usage, fmt::format("no run has {} in its name", part)};
}

std::vector<Field> fields_of(const CourseOptions& given) {
    std::vector<Field> fields;
    const auto add = [&](const course::ShapeName& shape) {
        fields.push_back({shape.name, chosen(given.scenes, shape.shape), {}});
        if (!given.run.empty()) keep_runs(fields.back().scenes, given.run);
    };
    for (const std::string& name : given.shapes) {
        if (name != "all") {
            add(shape_of(name));
            continue;
        }
        for (const course::ShapeName& known : course::shapes()) add(known);
    }
    if (fields.empty()) add(course::shapes().front());
    return fields;
}

std::string list_text(const course::Scenes& scenes) {
    std::string out;
    for (const course::Scene& scene : scenes) {
        out += fmt::format("{}: {}; {} runs\n", scene.name, scene.title, scene.runs.size());
        for (const course::Bar& bar : scene.bars)
            out += fmt::format("    {}: at most {}{}{}: {}\n", bar.what, short_number(bar.most),
                               bar.unit.empty() ? "" : " ", bar.unit, bar.reason);
        if (!scene.applies()) out += fmt::format("    does not apply to this shape: {}\n", scene.not_for_shape);
        if (!scene.catches.empty()) out += fmt::format("    fails {}\n", fmt::join(scene.catches, ", "));
    }
    return out;
}

std::string list_text(const std::vector<Field>& fields) {
    std::string out;
    for (const Field& field : fields) {
        if (fields.size() > 1) out += fmt::format("with a body of the shape {}:\n\n", field.shape);
        out += list_text(field.scenes) + "\n";
    }
    out += "movers:\n";
    for (const course::MoverName& mover : course::movers()) out += fmt::format("    {}: {}\n", mover.name, mover.about);
    return out;
}

/// The bars of one mover: those that it misses, or all of them.
std::string bars_text(const Contender& contender, bool all_bars) {
    Table table({"scene", "", "bar", "measured", "at most", "worst in"});
    for (const course::Score& score : contender.scores) {
        std::string name = score.scene->name;
        if (!score.scene->applies()) {
            table.add({name, "-", "does not apply to this shape: " + score.scene->not_for_shape, "", "", ""});
            continue;
        }
        const std::string verdict = score.passes() ? "passes" : "FAILS";
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

/// The scenes down, whoever or whatever walked them across.
std::string matrix_text(const std::vector<std::string>& names, const std::vector<const Contender*>& all,
                        const course::Scenes& scenes) {
    std::vector<std::string> heading{"scene"};
    heading.insert(heading.end(), names.begin(), names.end());
    Table table(heading);
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        std::vector<std::string> row{scenes[i].name};
        for (const Contender* contender : all) {
            const course::Score& score = contender->scores[i];
            row.emplace_back(!score.scene->applies() ? "does not apply" : score.passes() ? "pass" : "-");
        }
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
                       [](const course::Score& score) { return score.passes() || !score.scene->applies(); });
}

void append_measure(std::string& out, double value) {
    // JSON knows no infinity and no NaN.
    if (std::isfinite(value)) {
        append_number(out, value);
    } else {
        out += "null";
    }
}

std::size_t applying(const Contender& contender) {
    return static_cast<std::size_t>(std::count_if(contender.scores.begin(), contender.scores.end(),
                                                  [](const course::Score& score) { return score.scene->applies(); }));
}

std::string count_text(const Contender& contender, std::string_view with) {
    const std::size_t apply = applying(contender), beside = contender.scores.size() - apply;
    std::string out = fmt::format("{} passes {} of {} scenes{}", contender.name, passed(contender), apply, with);
    if (beside > 0) out += fmt::format("; {} {} not apply to this shape", beside, beside == 1 ? "does" : "do");
    return out + "\n";
}

std::string json_of(const Contender& contender, std::string_view shape) {
    std::string out =
        fmt::format(R"({{"mover":{},"shape":{},"passed":{},"apply":{},"scenes":[)", json_string(contender.name),
                    json_string(shape), passed(contender), applying(contender));
    for (const course::Score& score : contender.scores) {
        if (out.back() != '[') out += ',';
        out +=
            fmt::format(R"({{"scene":{},"applies":{},"why_not":{},"fails":{},"passes":{},"failure":{},"bars":[)",
                        json_string(score.scene->name), score.scene->applies(), json_string(score.scene->not_for_shape),
                        json_string(score.scene->catches.empty() ? "" : score.scene->catches.front()), score.passes(),
                        json_string(score.failure));
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

/// A scene that does not apply to the shape is not walked.
void walk(const course::Scenes& scenes, Contender& contender) {
    ProgressBar bar(contender.name);
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        if (!scenes[i].applies()) {
            contender.scores.push_back({&scenes[i], {}, {}});
            continue;
        }
        contender.scores.push_back(course::run_scene(scenes[i], *contender.mover, [&](double share) {
            bar.show((static_cast<double>(i) + share) / static_cast<double>(scenes.size()));
        }));
    }
}

/// Does each scene fail the broken mover that it is told to fail?
ExitCode run_catches(const std::vector<Field>& fields) {
    Table table({"shape", "scene", "broken mover", ""});
    bool is_well = true;
    for (const Field& field : fields) {
        for (const course::Scene& scene : field.scenes) {
            if (!scene.applies()) continue;
            const std::string name = scene.catches.empty() ? "" : scene.catches.front();
            const auto mover = course::make_mover(name);
            const bool fails = mover && course::fails_scene(scene, *mover);
            table.add({std::string(field.shape), scene.name, name, fails ? "fails" : "CLEARS IT"});
            is_well = is_well && fails;
        }
    }
    write_out(table.text());
    return is_well ? ExitCode::ok : ExitCode::failed;
}

std::string scores_text(const std::vector<Field>& fields, bool all_bars) {
    const Field& first = fields.front();
    if (fields.size() == 1 && first.contenders.size() == 1) return bars_text(first.contenders.front(), all_bars);
    std::vector<std::string> names;
    std::vector<const Contender*> all;
    for (const Field& field : fields) {
        for (const Contender& contender : field.contenders) {
            names.push_back(fields.size() == 1 ? contender.name : std::string(field.shape));
            all.push_back(&contender);
        }
    }
    return matrix_text(names, all, first.scenes);
}

ExitCode run_course(const CourseOptions& given) {
    std::vector<Field> fields = fields_of(given);
    if (given.list) {
        write_out(list_text(fields));
        return ExitCode::ok;
    }
    if (given.catches) return run_catches(fields);
    for (Field& field : fields) field.contenders = contenders(given);
    const bool is_one = fields.front().contenders.size() == 1;
    if (fields.size() > 1 && (!is_one || given.track))
        throw Failure{ExitCode::usage, "several shapes go with one mover, and without --track"};
    if (given.track) {
        write_tracks(fields.front().scenes, fields.front().contenders);
        return ExitCode::ok;
    }
    bool is_well = true;
    for (Field& field : fields) {
        for (Contender& contender : field.contenders) {
            walk(field.scenes, contender);
            if (contender.name == "ours" || is_one) is_well = is_well && clears_what_it_can(contender);
            if (given.json) write_out(json_of(contender, field.shape));
        }
    }
    if (!given.json) {
        write_out(scores_text(fields, given.all_bars));
        for (const Field& field : fields) {
            const std::string with = fields.size() > 1 ? fmt::format(" with the shape {}", field.shape) : "";
            for (const Contender& contender : field.contenders) write_out(count_text(contender, with));
        }
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
        ->add_option(
            "--shape", given->shapes,
            "The body: capsule, ellipsoid, sphere, box, cylinder or cone, as wide and as high as the capsule, or "
            "all; may be given again (default: capsule)")
        ->type_name("SHAPE")
        ->allow_extra_args(false);
    command->add_option("--run", given->run, "Of each scene only the runs with this in their names")->type_name("TEXT");
    command->add_flag("--track", given->track, "Print where it was after each tick instead of scores, as CSV");
    command->add_flag("--bars", given->all_bars, "Tell every bar with its measure, not only those that are missed");
    command->add_flag("--json", given->json, "Print JSON, a line for each mover");
    command->add_flag("--catches", given->catches,
                      "Walk the broken mover that each scene is about instead: does each scene fail it?");
    command->add_flag("--list", given->list, "Tell the scenes, their bars with the reasons, and the movers");
    command->footer(
        help_footer("  surefoot course\n"
                    "  surefoot course --scene stairs --mover bullet\n"
                    "  surefoot course --mover all\n"
                    "  surefoot course --shape ellipsoid\n"
                    "  surefoot course --shape all\n"
                    "  surefoot course --scene wedge-along --run '80 degrees' --track\n"
                    "  surefoot course --exec 'node my-mover.mjs'\n"
                    "\nHow a program joins: docs/course-protocol.md.\n"
                    "Exit codes: 0 ours, or the only one that walked, clears every bar; 1 it does not; 2 wrong usage; "
                    "3 a program cannot be started."));
    command->callback([given, &run] { run = [given] { return run_course(*given); }; });
}

}  // namespace surefoot::tools
