// surefoot bench: how fast, next to what, and was there anything to hit?
#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <functional>
#include <map>

#include "command.hpp"
#include "level.hpp"
#include "number.hpp"
#include "query.hpp"
#include "rollback.hpp"
#include "suite.hpp"
#include "text.hpp"

namespace surefoot::tools {
namespace {

struct BenchOptionsGiven {
    std::vector<std::string> levels;
    std::vector<std::string> scenes;
    bench::SuiteOptions suite;
    bool only_rollback = false;
    bool is_small = false;
    bool json = false;
};

const std::vector<std::string> scene_names{"terrain", "city", "soup"};

bench::Scene make_scene(const std::string& name, bool is_small) {
    if (name == "terrain") return is_small ? bench::make_terrain(64) : bench::make_terrain();
    if (name == "city") return is_small ? bench::make_city(2) : bench::make_city();
    return is_small ? bench::make_soup(10'000) : bench::make_soup();
}

/// The triangles of a level as a scene, equal corners made one again.
bench::Scene scene_of_level(const std::string& file) {
    LevelOptions options;
    options.file = file;
    const Level level = load_level(options);
    bench::Scene scene{.name = std::filesystem::path(file).stem().string()};
    std::map<std::array<float, 3>, std::uint32_t> known;
    for (std::uint32_t id = 0; id < level.mesh.triangle_count(); ++id) {
        const Triangle triangle = level.mesh.triangle(id);
        for (const dvec3& corner : {triangle.a, triangle.b, triangle.c}) {
            const vec3 vertex(corner);
            const auto next = static_cast<std::uint32_t>(scene.vertices.size());
            const auto [place, is_new] = known.try_emplace({vertex.x, vertex.y, vertex.z}, next);
            if (is_new) scene.vertices.push_back(vertex);
            scene.indices.push_back(place->second);
        }
    }
    return scene;
}

/// What machine and compiler the numbers belong to.
std::string processor() {
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);)
        if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
    return "an unknown processor";
}

std::string compiler() {
#if defined(__clang__)
    return fmt::format("clang {}.{}", __clang_major__, __clang_minor__);
#elif defined(__GNUC__)
    return fmt::format("g++ {}.{}", __GNUC__, __GNUC_MINOR__);
#else
    return "an unknown compiler";
#endif
}

std::string short_time(double ns) {
    return ns < 1000 ? fmt::format("{:.0f} ns", ns) : fmt::format("{:.3g} us", ns / 1000);
}

/// Blank where there is nothing to say.
std::string unless(bool nothing, std::string text) {
    return nothing ? std::string("-") : std::move(text);
}

std::string seconds_per_million(double seconds, std::size_t triangles) {
    return fmt::format("{} ({:.2f} s a million)", duration(seconds), 1e6 * seconds / static_cast<double>(triangles));
}

double bytes_a_triangle(const bench::Stage& stage, std::size_t bytes) {
    return static_cast<double>(bytes) / static_cast<double>(std::max<std::size_t>(stage.scene.triangle_count(), 1));
}

std::string text_of(const bench::Stage& stage, const std::vector<bench::Row>& rows) {
    const std::size_t triangles = stage.scene.triangle_count();
    std::string out = fmt::format("\n{}: {} triangles, built in {}", stage.scene.name, grouped(triangles),
                                  seconds_per_million(stage.build_seconds, triangles));
    if (stage.embree) out += fmt::format("; Embree {}", duration(stage.embree_build_seconds));
    if (stage.bullet) out += fmt::format("; Bullet {}", duration(stage.bullet_build_seconds));
    const MeshMemory memory = stage.mesh.memory();
    out += fmt::format("\n{:.1f} bytes a triangle that queries read ({:.1f} tree, {:.1f} leaves), {:.1f} in all\n",
                       bytes_a_triangle(stage, memory.nodes + memory.leaves), bytes_a_triangle(stage, memory.nodes),
                       bytes_a_triangle(stage, memory.leaves), bytes_a_triangle(stage, memory.total()));
    Table table({"question", "of", "order", "median", "x E", "p10", "p90", "hits", "mean t", "found", "nodes", "tested",
                 "checked"});
    std::size_t wrong = 0;
    for (const bench::Row& row : rows) {
        const bench::Workload& workload = row.workload;
        const bool is_ours = workload.solver == bench::Solver::surefoot;
        const bool has_time = workload.question == bench::Question::sweep ||
                              workload.question == bench::Question::sweeps || workload.question == bench::Question::ray;
        wrong += row.checked.wrong;
        table.add(
            {bench::name_of(workload), std::string(bench::name_of(workload.solver)),
             std::string(bench::name_of(workload.order)), short_time(row.median),
             unless(row.multiple == 0, fmt::format("{:.2f}", row.multiple)), short_time(row.p10), short_time(row.p90),
             fmt::format("{:.0f}%", 100 * row.hit_share),
             unless(!has_time || row.hit_share == 0, fmt::format("{:.3f}", row.mean_t)),
             unless(has_time, fmt::format("{:.1f}", row.mean_found)),
             unless(!is_ours, fmt::format("{:.1f}", row.nodes)), unless(!is_ours, fmt::format("{:.1f}", row.tested)),
             unless(row.checked.answers == 0, row.checked.wrong == 0 ? fmt::format("{} right", row.checked.answers)
                                                                     : fmt::format("{} WRONG", row.checked.wrong))});
    }
    out += table.text();
    if (wrong > 0) out += fmt::format("{} answers differ from brute force: this is a bug, please report it\n", wrong);
    return out;
}

std::string json_of(const bench::Stage& stage, const std::vector<bench::Row>& rows) {
    std::string out = fmt::format(R"({{"scene":{},"triangles":{},"vertices":{})", json_string(stage.scene.name),
                                  stage.scene.triangle_count(), stage.scene.vertices.size());
    const auto add = [&out](std::string_view name, double value) {
        out += fmt::format(R"(,"{}":)", name);
        append_number(out, value);
    };
    add("build_seconds", stage.build_seconds);
    if (stage.embree) add("embree_build_seconds", stage.embree_build_seconds);
    if (stage.bullet) add("bullet_build_seconds", stage.bullet_build_seconds);
    const MeshMemory memory = stage.mesh.memory();
    add("bytes_per_triangle", bytes_a_triangle(stage, memory.nodes + memory.leaves));
    add("all_bytes_per_triangle", bytes_a_triangle(stage, memory.total()));
    out += R"(,"rows":[)";
    for (const bench::Row& row : rows) {
        if (out.back() != '[') out += ',';
        out += fmt::format(R"({{"question":{},"solver":"{}","order":"{}","motions":{},"batch":{})",
                           json_string(bench::name_of(row.workload)), bench::name_of(row.workload.solver),
                           bench::name_of(row.workload.order), row.motions, row.batch);
        add("median_ns", row.median);
        add("p10_ns", row.p10);
        add("p90_ns", row.p90);
        if (row.multiple > 0) add("multiple_of_e", row.multiple);
        add("hit_share", row.hit_share);
        add("mean_t", row.mean_t);
        add("mean_found", row.mean_found);
        if (row.workload.solver == bench::Solver::surefoot) {
            add("nodes_opened", row.nodes);
            add("triangles_tested", row.tested);
        }
        out += fmt::format(R"(,"checked":{},"wrong":{}}})", row.checked.answers, row.checked.wrong);
    }
    return out + "]}";
}

std::string text_of(const bench::RollbackOptions& given, const bench::RollbackReport& report) {
    std::string out = fmt::format(
        "\nrollback: {} characters on {} moving lifts, {:.0f}% of them riding, {:.0f}% touching another; {} frames "
        "played "
        "again from a snapshot\n{} a frame (one in ten over {}), {} a character; {} to restore states and poses\n",
        given.characters, given.lifts, 100 * report.riding, 100 * report.touching, given.frames,
        short_time(report.frame), short_time(report.slow_frame), short_time(report.character),
        short_time(report.restoring));
    if (!report.first_differs) return out + fmt::format("{} hashes compared, all equal\n", grouped(report.compared));
    return out + fmt::format("frame {} came out DIFFERENT when it was played again: this is a bug, please report it\n",
                             *report.first_differs);
}

std::string json_of(const bench::RollbackOptions& given, const bench::RollbackReport& report) {
    std::string out = fmt::format(R"({{"characters":{},"lifts":{},"frames":{},"compared":{},"first_differs":{})",
                                  given.characters, given.lifts, given.frames, report.compared,
                                  report.first_differs ? std::to_string(*report.first_differs) : "null");
    const auto add = [&out](std::string_view name, double value) {
        out += fmt::format(R"(,"{}":)", name);
        append_number(out, value);
    };
    add("frame_ns", report.frame);
    add("frame_p90_ns", report.slow_frame);
    add("character_ns", report.character);
    add("restoring_ns", report.restoring);
    add("touching", report.touching);
    add("riding", report.riding);
    return out + "}";
}

ExitCode run_bench(BenchOptionsGiven given) {
    if (given.is_small) {
        given.suite.motions = std::min<std::size_t>(given.suite.motions, 256);
        given.suite.rounds = std::min<std::size_t>(given.suite.rounds, 3);
    }
    const bool all = given.scenes.empty() && given.levels.empty();
    const bool with_rollback = given.only_rollback || (all && given.suite.only.empty());
    if (all && !given.only_rollback) given.scenes = scene_names;
    std::vector<std::function<bench::Scene()>> makers;
    for (const std::string& name : given.scenes) makers.push_back([&] { return make_scene(name, given.is_small); });
    for (const std::string& file : given.levels) makers.push_back([&] { return scene_of_level(file); });

    const std::string machine = fmt::format("{}, {}", processor(), compiler());
    if (given.json) {
        write_out(fmt::format(R"({{"machine":{},"rounds":{},"scenes":[)", json_string(machine), given.suite.rounds));
    } else {
        std::string head =
            fmt::format("{}; thread CPU time, median of {} rounds in turns\n", machine, given.suite.rounds);
        for (const std::string_view missing : {bench::embree_missing(), bench::bullet_missing()})
            if (!missing.empty()) head += fmt::format("{}\n", missing);
        write_out(head);
    }
    bool all_right = true;
    bool is_first = true;
    for (const auto& make : makers) {
        const bench::Stage stage(make());
        const std::vector<bench::Row> rows = bench::run_suite(stage, given.suite);
        for (const bench::Row& row : rows) all_right = all_right && row.checked.wrong == 0;
        write_out(given.json ? (is_first ? "" : ",") + json_of(stage, rows) : text_of(stage, rows));
        is_first = false;
    }
    if (given.json) write_out("]");
    if (with_rollback) {
        bench::RollbackOptions options{.rounds = given.suite.rounds};
        if (given.is_small) options.settling = 30;
        const bench::RollbackReport report = bench::run_rollback(options);
        all_right = all_right && !report.first_differs;
        write_out(given.json ? R"(,"rollback":)" + json_of(options, report) : text_of(options, report));
    }
    if (given.json) write_out("}\n");
    return all_right ? ExitCode::ok : ExitCode::failed;
}

}  // namespace

void add_bench(CLI::App& program, Run& run) {
    auto* command = program.add_subcommand("bench", "How fast is it here, next to Embree and Bullet?");
    const auto given = std::make_shared<BenchOptionsGiven>();
    command->add_option("LEVEL", given->levels, "Levels of yours, instead of the scenes")->type_name("");
    command->add_option("--scene", given->scenes, "terrain, city or soup; may be given again (default: all three)")
        ->type_name("NAME")
        ->allow_extra_args(false)
        ->check(CLI::IsMember(scene_names));
    command->add_option("--only", given->suite.only, "Only questions with this in their names; may be given again")
        ->type_name("TEXT")
        ->allow_extra_args(false);
    command->add_option("--rounds", given->suite.rounds, "Batches of each question (default: 101)")
        ->type_name("N")
        ->check(CLI::Range(1, 1'000'000));
    command
        ->add_option_function<double>(
            "--batch", [given](double ms) { given->suite.batch_seconds = 1e-3 * ms; },
            "How long a batch takes (default: 4)")
        ->type_name("MS")
        ->check(CLI::Range(0.01, 1000.0));
    command->add_option("--motions", given->suite.motions, "Different motions of each kind (default: 16384)")
        ->type_name("N")
        ->check(CLI::Range(1, 10'000'000));
    command->add_option("--check", given->suite.checked, "Answers of each kind compared with brute force (default: 16)")
        ->type_name("N");
    command->add_flag("--rollback", given->only_rollback,
                      "Only the rollback: 8 frames of 64 characters on moving lifts, played again and compared");
    command->add_flag("--small", given->is_small, "Small scenes and few questions: does it run?");
    command->add_flag("--json", given->json, "Print JSON");
    command->footer(
        help_footer("  surefoot bench\n"
                    "  surefoot bench --scene terrain --only \"sphere sweep\"\n"
                    "  surefoot bench castle.glb --json\n"
                    "  surefoot bench --rollback\n"
                    "\nE is Embree's closest ray on the long motions, in the same order, in the same run.\n"
                    "Exit codes: 0 done, 1 an answer was not that of brute force or a frame played again came out "
                    "different,\n2 wrong usage, 3 a level cannot be read."));
    command->callback([given, &run] { run = [given] { return run_bench(*given); }; });
}

}  // namespace surefoot::tools
