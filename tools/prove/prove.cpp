// surefoot prove: asks the library about families of hard queries and has every answer judged in exact numbers.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fmt/format.h>
#include <memory>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "bridge.hpp"
#include "command.hpp"
#include "failure.hpp"
#include "judge/runner.hpp"
#include "lines.hpp"
#include "moment.hpp"
#include "text.hpp"

namespace surefoot::tools {
namespace {

struct ProveOptions {
    std::uint64_t queries = 100000;
    std::uint64_t seed = 1;
    int threads = 2;
    std::vector<std::string> shapes;
    std::vector<std::string> families;
    std::string dump;
    std::string save_failures;
    bool json = false;
};

struct FileCloser {
    void operator()(std::FILE* file) const { std::fclose(file); }
};

/// What is neither a miss, nor late, nor a false hit, nor without proof.
std::uint64_t others(const judge::Tally& tally) {
    using judge::Verdict;
    return tally.failures() - tally.count(Verdict::miss) - tally.count(Verdict::late) -
           tally.count(Verdict::false_hit) - tally.count(Verdict::unproved);
}

std::vector<std::string> cells(const std::string& shape, const std::string& family, const judge::Tally& tally) {
    using judge::Verdict;
    return {shape,
            family,
            grouped(tally.queries),
            grouped(tally.hits),
            grouped(tally.count(Verdict::miss)),
            grouped(tally.count(Verdict::late)),
            grouped(tally.count(Verdict::false_hit)),
            grouped(others(tally)),
            grouped(tally.count(Verdict::unproved)),
            fmt::format("{:.1e}", tally.worst_gap * judge::allowed_gap),
            duration(tally.seconds)};
}

std::string table_of(const std::vector<judge::Row>& rows) {
    Table table({"shape", "family", "queries", "hits", "misses", "lates", "false hits", "others", "unproved",
                 "worst gap", "time"});
    judge::Tally all, of_shape;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const judge::Row& row = rows[i];
        table.add(cells(judge::name_of(row.kind), row.family->name, row.tally));
        of_shape.add(row.tally);
        all.add(row.tally);
        if (i + 1 < rows.size() && rows[i + 1].kind == row.kind) continue;
        table.add(cells(judge::name_of(row.kind), "all", of_shape));
        of_shape = {};
    }
    table.add(cells("all", "all", all));
    return table.text();
}

nlohmann::json json_of(const judge::Tally& tally) {
    using judge::Verdict;
    nlohmann::json verdicts;
    for (int i = 0; i < judge::verdict_count; ++i)
        verdicts[judge::name_of(static_cast<Verdict>(i))] = tally.count(static_cast<Verdict>(i));
    return {{"queries", tally.queries},     {"hits", tally.hits},
            {"failures", tally.failures()}, {"worst_gap", tally.worst_gap * judge::allowed_gap},
            {"seconds", tally.seconds},     {"verdicts", verdicts}};
}

std::string json_text(const std::vector<judge::Row>& rows, const ProveOptions& given) {
    nlohmann::json result{{"seed", given.seed}, {"rows", nlohmann::json::array()}};
    for (const judge::Row& row : rows) {
        nlohmann::json entry = json_of(row.tally);
        entry["shape"] = judge::name_of(row.kind);
        entry["family"] = row.family->name;
        result["rows"].push_back(entry);
    }
    return result.dump(2) + "\n";
}

void show_progress(double share) {
    constexpr int width = 40;
    const int done = static_cast<int>(share * width);
    std::string bar(static_cast<std::size_t>(done), '#');
    bar.append(static_cast<std::size_t>(width - done), '.');
    fmt::print(stderr, "\r[{}] {:3.0f}%{}", bar, 100 * share, share >= 1 ? "\r\033[K" : "");
    std::fflush(stderr);
}

/// Keeps the first failures as moments, a file each.
class FailureFolder {
public:
    explicit FailureFolder(const std::string& folder) : folder_(folder) {
        if (folder.empty()) return;
        std::error_code error;
        std::filesystem::create_directories(folder, error);
        if (error) throw Failure{ExitCode::file, fmt::format("cannot make the folder {}: {}", folder, error.message())};
    }

    void take(const judge::Record& record) {
        constexpr std::size_t most = 1000;
        if (folder_.empty() || saved_ == most) return;
        const std::string path =
            fmt::format("{}/{}-{}-{}.json", folder_, judge::name_of(record.query.kind), record.family.name, ++saved_);
        if (const auto written = write_capture(capture_from(record), path); !written && wrong_.empty())
            wrong_ = written.error().text;
    }

    /// What stands under the first failures.
    [[nodiscard]] std::string text() const {
        if (folder_.empty()) return "--save-failures DIR saves each in a file that `surefoot replay` explains.\n";
        return fmt::format("{} saved in {}; `surefoot replay` explains them.\n", grouped(saved_), folder_);
    }

    /// Fails if one could not be written.
    void check() const {
        if (!wrong_.empty()) throw Failure{ExitCode::file, wrong_};
    }

private:
    std::string folder_;
    std::size_t saved_ = 0;
    std::string wrong_;
};

judge::Plan plan_from(const ProveOptions& given) {
    judge::Plan plan;
    plan.queries_per_shape = given.queries;
    plan.seed = given.seed;
    plan.threads = given.threads;
    for (int i = 0; i < judge::kind_count; ++i) {
        const judge::Kind kind = static_cast<judge::Kind>(i);
        if (std::find(given.shapes.begin(), given.shapes.end(), judge::name_of(kind)) != given.shapes.end())
            plan.kinds.push_back(kind);
    }
    plan.families = given.families;
    return plan;
}

ExitCode run_prove(const ProveOptions& given) {
    judge::Plan plan = plan_from(given);
    std::unique_ptr<std::FILE, FileCloser> dump;
    bool written = true;
    if (!given.dump.empty()) {
        dump.reset(std::fopen(given.dump.c_str(), "wb"));
        if (!dump) throw Failure{ExitCode::file, fmt::format("cannot write {}: does its folder exist?", given.dump)};
        plan.record_all = true;
    }
    FailureFolder saved(given.save_failures);
    std::string failures;
    std::uint64_t shown = 0;
    plan.record = [&](const judge::Record& record) {
        std::string line;
        append_record(line, record);
        line += '\n';
        if (dump) written = written && std::fwrite(line.data(), 1, line.size(), dump.get()) == line.size();
        constexpr std::uint64_t most_shown = 5;
        if (record.judgement.verdict == judge::Verdict::right) return;
        if (shown++ < most_shown) failures += line;
        saved.take(record);
    };
    const bool bar = isatty(STDERR_FILENO) != 0;
    if (bar) plan.progress = show_progress;

    const auto begin = std::chrono::steady_clock::now();
    const std::vector<judge::Row> rows = judge::run(plan, [] { return judge::Sweep(ask); });
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    if (dump && (std::fflush(dump.get()) != 0 || !written))
        throw Failure{ExitCode::file, fmt::format("{} did not take everything: is the disk full?", given.dump)};

    saved.check();

    judge::Tally all;
    for (const judge::Row& row : rows) all.add(row.tally);
    const bool proved = all.failures() == 0;
    if (given.json) {
        write_out(json_text(rows, given));
    } else {
        std::string out = table_of(rows);
        out +=
            "\nThe worst gap is relative to the largest coordinate, length or radius of its query; 1e-10 is allowed.\n";
        out +=
            fmt::format("{} queries judged in {}, seed {}: {}\n", grouped(all.queries), duration(seconds), given.seed,
                        proved ? "every answer is proved right." : fmt::format("{} FAILED.", grouped(all.failures())));
        if (!proved) out += fmt::format("\nThe first failures:\n{}{}", failures, saved.text());
        write_out(out);
    }
    return proved ? ExitCode::ok : ExitCode::failed;
}

}  // namespace

void add_prove(CLI::App& program, Run& run) {
    auto* command =
        program.add_subcommand("prove", "Judge the sweeps of this build in exact numbers, on families of hard queries");
    const auto given = std::make_shared<ProveOptions>();
    std::vector<std::string> shapes, families;
    for (int i = 0; i < judge::kind_count; ++i) shapes.emplace_back(judge::name_of(static_cast<judge::Kind>(i)));
    std::string about;
    for (const judge::Family& family : judge::families()) {
        families.emplace_back(family.name);
        about += fmt::format("  {:<10} {}\n", family.name, family.about);
    }
    command->add_option("--queries", given->queries, "How many for each shape, spread over the families")
        ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{1000000000000}))
        ->capture_default_str();
    command->add_option("--shape", given->shapes, "Only this shape (may be given more than once)")
        ->check(CLI::IsMember(shapes));
    command->add_option("--family", given->families, "Only this family (may be given more than once)")
        ->check(CLI::IsMember(families));
    command->add_option("--seed", given->seed, "Other seeds ask other queries")->capture_default_str();
    command->add_option("--threads", given->threads, "How many at once")
        ->check(CLI::Range(1, 256))
        ->capture_default_str();
    command->add_option("--dump", given->dump, "Write every query, answer and verdict there, a JSON line each")
        ->type_name("FILE");
    command
        ->add_option("--save-failures", given->save_failures,
                     "Save failures as moments in this folder, for `surefoot replay`; the first 1000")
        ->type_name("DIR");
    command->add_flag("--json", given->json, "Print the counts as JSON");
    command->footer("\nFamilies:\n" + about +
                    help_footer("  surefoot prove\n"
                                "  surefoot prove --queries 10000000 --shape ellipsoid\n"
                                "  surefoot prove --family tangent --family touching --seed 7 --dump queries.jsonl\n"
                                "\nExit codes: 0 every answer is proved right, 1 at least one is not, 2 wrong usage,\n"
                                "3 the dump or a failure cannot be written."));
    command->callback([given, &run] { run = [given] { return run_prove(*given); }; });
}

}  // namespace surefoot::tools
