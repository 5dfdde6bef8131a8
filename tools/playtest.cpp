// surefoot playtest: bots play a level, or all of a folder, and a page says what came of it.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <memory>
#include <numeric>
#include <optional>

#include "command.hpp"
#include "game/whole_file.hpp"
#include "playtest/campaign.hpp"
#include "playtest/report/report.hpp"
#include "progress.hpp"
#include "text.hpp"

namespace surefoot::tools {
namespace {

struct PlaytestGiven {
    std::string level;
    int bots = 4;
    double hours = 0.25;
    std::uint64_t seed = 1;
    int threads = 2;
    int frames = playtest::ReportOptions{}.framed;
    std::string report = "playtest.html";
    std::string sessions;
};

template <typename T>
T must(Expected<T> expected) {
    if (!expected) throw Failure{ExitCode::file, expected.error().text};
    return std::move(*expected);
}

std::vector<std::shared_ptr<const game::Level>> levels_of(const std::string& path) {
    const std::vector<std::string> files =
        std::filesystem::is_directory(path) ? game::levels_in(path) : std::vector<std::string>{path};
    if (files.empty()) throw Failure{ExitCode::usage, path + ": there is no .glb in this folder"};
    std::vector<std::shared_ptr<const game::Level>> levels;
    for (const std::string& file : files)
        levels.push_back(std::make_shared<const game::Level>(must(game::read_level(file))));
    std::ranges::stable_sort(levels, {}, [](const auto& level) { return level->order; });
    return levels;
}

/// What people did, noted down from their recordings as if it had been watched; where the level has changed since,
/// as it was noted down then.
void add_people(std::vector<playtest::Findings>& levels, const std::vector<playtest::Session>& sessions) {
    for (const playtest::Session& session : sessions)
        for (const std::string& name : session.runs) {
            const std::string stem = session.folder + "/" + name;
            auto recording = game::read_recording(stem + ".run");
            playtest::PlayedRun run{.telemetry = {}, .recording = {}, .by_human = true};
            const auto level_called = [&](const std::string& id) {
                return std::ranges::find_if(levels, [&](const playtest::Findings& of) { return of.level->id == id; });
            };
            auto of = recording ? level_called(recording->level) : levels.end();
            if (of != levels.end() && recording->level_hash == of->level->hash) {
                run.telemetry = must(playtest::replay(of->level, *recording));
                run.recording = std::move(*recording);
            } else {
                const auto text = game::read_whole(stem + ".json");
                if (!text) continue;  // of a level that is not among these
                run.telemetry = must(playtest::telemetry_of(*text, stem + ".json"));
                of = level_called(run.telemetry.level);
            }
            if (of == levels.end()) continue;
            run.telemetry.player = session.start.player;
            of->runs.push_back(std::move(run));
        }
    for (playtest::Findings& of : levels) playtest::look_over(of);
}

std::string where_most_die(const playtest::Findings& of) {
    const std::vector<std::uint32_t> deaths = of.deaths_by_section();
    const auto most = std::ranges::max_element(deaths);
    const double all = std::accumulate(deaths.begin(), deaths.end(), 0.0);
    if (all == 0) return "";
    return fmt::format("{} ({:.0f} %)", of.level->checkpoints[std::size_t(most - deaths.begin())].section,
                       100 * *most / all);
}

ExitCode run_playtest(const PlaytestGiven& given) {
    std::vector<playtest::Findings> all;
    Table table({"level", "finished", "deaths", "most of them", "stuck", "escapes", "NaN", "never taken", "played",
                 "times real time"});
    std::string reasons;
    for (const auto& level : levels_of(given.level)) {
        ProgressBar bar(level->id);
        all.push_back(must(playtest::run_campaign(level, {.bots = given.bots,
                                                          .hours = given.hours,
                                                          .seed = given.seed,
                                                          .threads = given.threads,
                                                          .progress = [&](double done) { bar.show(done); }})));
        const playtest::Findings& of = all.back();
        using Kind = playtest::Incident::Kind;
        table.add({level->id, fmt::format("{} of {}", of.navigators_won(), of.navigators()),
                   std::to_string(of.count(Kind::death)), where_most_die(of), std::to_string(of.count(Kind::stuck)),
                   std::to_string(of.count(Kind::escape)), std::to_string(of.count(Kind::not_a_number)),
                   std::to_string(of.never_taken.size()), fmt::format("{:.1f} min", of.played / 60),
                   fmt::format("{:.0f}", of.took > 0 ? of.played / of.took : 0)});
        if (!of.unreachable.empty()) reasons += fmt::format("{}: {}\n", level->id, of.unreachable);
        if (const std::string fault = of.death_fault(); !fault.empty())
            reasons += fmt::format("{}: {}\n", level->id, fault);
    }
    std::vector<playtest::Session> sessions;
    if (!given.sessions.empty()) {
        sessions = must(playtest::read_sessions(given.sessions));
        add_people(all, sessions);
    }
    std::optional<ProgressBar> bar(std::in_place, "drawing incidents");
    const auto written = playtest::write_report(
        given.report, all, sessions, {.framed = given.frames, .progress = [&](double done) { bar->show(done); }});
    bar.reset();
    if (!written) throw Failure{ExitCode::file, written.error().text};
    write_out(table.text() + reasons + fmt::format("report: {}\n", given.report));
    return std::ranges::all_of(all, &playtest::Findings::is_fine) ? ExitCode::ok : ExitCode::failed;
}

}  // namespace

void add_playtest(CLI::App& program, Run& run) {
    auto* command = program.add_subcommand("playtest", "Bots play a level of the platformer; a page says how it went");
    const auto given = std::make_shared<PlaytestGiven>();
    command->add_option("level", given->level, "A level of the platformer (.glb), or a folder of them")->required();
    command
        ->add_option("--bots", given->bots,
                     "How many, by turns one that knows its way and one that explores (default: 4)")
        ->check(CLI::Range(0, 1000))
        ->type_name("COUNT");
    command
        ->add_option("--hours", given->hours,
                     "Of play in each level, all bots together; each plays once at least (default: 0.25)")
        ->check(CLI::Range(0.0, 10000.0))
        ->type_name("HOURS");
    command->add_option("--seed", given->seed, "The same number gives the same runs (default: 1)")->type_name("NUMBER");
    command->add_option("--threads", given->threads, "How many bots play at a time (default: 2)")
        ->check(CLI::Range(1, 64))
        ->type_name("COUNT");
    command
        ->add_option("--frames", given->frames,
                     "Of how many places of a level where something happened frames are drawn (default: 10)")
        ->check(CLI::Range(0, 1000))
        ->type_name("COUNT");
    command->add_option("--report", given->report, "Where the page goes (default: playtest.html)")->type_name("FILE");
    command->add_option("--sessions", given->sessions, "A folder of sessions with people, to be told of, too")
        ->type_name("FOLDER");
    command->footer(help_footer(
        "  surefoot playtest levels/platformer/first-steps.glb\n"
        "  surefoot playtest levels/platformer --bots 8 --hours 2 --report out/playtest.html\n"
        "  surefoot playtest levels/platformer --bots 0 --sessions ~/sessions\n"
        "\nThe page needs nothing but itself. It holds frames, the last seconds and replays of what happened, up to "
        "some\n"
        "10 MB; replays that find no room lie in the folder FILE_files.\n"
        "Exit codes: 0 all is well, 1 there is something to look at (a goal out of reach, a bot that knows its way "
        "and\n"
        "did not finish, somebody stuck, out of the level, or nowhere, nobody who dies or most of them in one "
        "section),\n"
        "2 wrong usage, 3 a file cannot be read or written."));
    command->callback([given, &run] { run = [given] { return run_playtest(*given); }; });
}

}  // namespace surefoot::tools
