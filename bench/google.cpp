// The same scenes and workloads under Google Benchmark, for its filters, its statistics and its tools that compare
// runs:
//
//     surefoot_benchmarks --benchmark_filter='terrain/short sphere' --benchmark_repetitions=9
//         --benchmark_enable_random_interleaving=true --benchmark_report_aggregates_only=true
//
// `surefoot bench` is the one whose multiples of E are told: it takes turns in small batches.
#include <benchmark/benchmark.h>
#include <memory>
#include <string>

#include "shelf.hpp"
#include "workload.hpp"

namespace surefoot::bench {
namespace {

constexpr std::size_t batch = 64;
constexpr std::size_t motions_made = 16384;

/// A scene that is made when a benchmark of it first runs, so that a filter saves the time for the others.
class LazyStage {
public:
    explicit LazyStage(Scene (*make)()) : make_(make) {}

    const Stage& stage() {
        if (!stage_) stage_ = std::make_unique<Stage>(make_());
        return *stage_;
    }
    const Motions& motions(const Workload& workload) {
        if (!shelf_) shelf_ = std::make_unique<MotionShelf>(stage(), motions_made);
        return shelf_->of(workload);
    }

private:
    Scene (*make_)();
    std::unique_ptr<Stage> stage_;
    std::unique_ptr<MotionShelf> shelf_;
};

void run(benchmark::State& state, LazyStage& lazy, const Workload& workload) {
    const Stage& stage = lazy.stage();
    const std::span<const Motion> motions = lazy.motions(workload);
    if (motions.size() < batch) return state.SkipWithError("the scene has no room for these motions");
    Tally tally;
    std::size_t next = 0;
    for ([[maybe_unused]] const auto _ : state) {
        if (next + batch > motions.size()) next = 0;
        tally.add(ask(stage, workload, motions.subspan(next, batch)));
        next += batch;
    }
    const auto asked = static_cast<double>(tally.asked);
    const auto hits = static_cast<double>(tally.hits);
    state.counters["each"] = benchmark::Counter(asked, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
    state.counters["hits"] = hits / asked;
    state.counters["mean_t"] = tally.hits == 0 ? 0 : tally.t_sum / hits;
    if (workload.solver != Solver::surefoot) return;
    const std::span<const Motion> some = motions.first(batch);
    state.counters["tested"] = static_cast<double>(count_work(stage, workload, some).triangles) / batch;
}

int run_benchmarks(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    LazyStage terrain([] { return make_terrain(); });
    LazyStage city([] { return make_city(); });
    LazyStage soup([] { return make_soup(); });
    const std::pair<std::string, LazyStage*> scenes[] = {{"terrain", &terrain}, {"city", &city}, {"soup", &soup}};
    for (const auto& [scene, stage] : scenes) {
        for (const Workload& workload : all_workloads()) {
            if (!is_built_in(workload.solver)) continue;
            const std::string name = scene + "/" + name_of(workload) + "/" + std::string(name_of(workload.solver)) +
                                     "/" + std::string(name_of(workload.order));
            benchmark::RegisterBenchmark(
                name.c_str(), [stage = stage, workload](benchmark::State& state) { run(state, *stage, workload); });
        }
    }
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    return 0;
}

}  // namespace
}  // namespace surefoot::bench

int main(int argc, char** argv) {
    return surefoot::bench::run_benchmarks(argc, argv);
}
