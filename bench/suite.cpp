#include "suite.hpp"

#include <algorithm>
#include <utility>

#include "clock.hpp"
#include "shelf.hpp"

namespace surefoot::bench {
namespace {

/// A workload while it is timed.
struct Lane {
    Workload workload;
    std::span<const Motion> motions;
    std::size_t batch = 1;
    std::size_t next = 0;
    std::vector<double> times{};  ///< [ns a question], one a round
    Tally tally{};
};

bool is_wanted(const Workload& workload, const SuiteOptions& options) {
    if (options.only.empty() || workload.solver == Solver::embree) return true;
    const std::string name = name_of(workload);
    return std::any_of(options.only.begin(), options.only.end(),
                       [&](const std::string& part) { return name.find(part) != std::string::npos; });
}

/// The next `size` motions, from the beginning again where they run out.
std::span<const Motion> take(Lane& lane, std::size_t size) {
    if (lane.next + size > lane.motions.size()) lane.next = 0;
    const std::span<const Motion> motions = lane.motions.subspan(lane.next, size);
    lane.next += size;
    return motions;
}

/// [s a question], for the next batch of this size. A quarter as many are asked before the clock starts, or else each
/// would first pay for what the one before it threw out of the caches.
double time_batch(const Stage& stage, Lane& lane, std::size_t size) {
    static_cast<void>(ask(stage, lane.workload, take(lane, (size + 3) / 4)));
    const std::span<const Motion> motions = take(lane, size);
    const double begin = thread_seconds();
    const Tally tally = ask(stage, lane.workload, motions);
    const double end = thread_seconds();
    lane.tally.add(tally);
    return (end - begin) / static_cast<double>(size);
}

/// How many questions take about as long as a batch should.
void choose_batch(const Stage& stage, Lane& lane, const SuiteOptions& options) {
    const std::size_t most = lane.motions.size();
    std::size_t size = std::min<std::size_t>(16, most);
    static_cast<void>(time_batch(stage, lane, size));  // wakes up caches and predictors
    const double each = std::max(time_batch(stage, lane, size), 1e-9);
    size = static_cast<std::size_t>(std::min(options.batch_seconds / each, static_cast<double>(most)));
    lane.batch = std::clamp<std::size_t>(size, std::min<std::size_t>(8, most), most);
    lane.tally = {};
    lane.next = 0;
}

/// The value below which a share of the sorted times lies.
double quantile(const std::vector<double>& sorted, double share) {
    return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1) + 0.5)];
}

/// `count` motions, from all over the list.
Motions sample(std::span<const Motion> motions, std::size_t count) {
    Motions chosen;
    count = std::min(count, motions.size());
    for (std::size_t i = 0; i < count; ++i) chosen.push_back(motions[i * motions.size() / count]);
    return chosen;
}

Row row_of(const Stage& stage, Lane& lane, const SuiteOptions& options) {
    std::sort(lane.times.begin(), lane.times.end());
    const auto share_of = [](double part, std::uint64_t whole) {
        return whole == 0 ? 0 : part / static_cast<double>(whole);
    };
    const Tally& tally = lane.tally;
    Row row{.workload = lane.workload, .motions = lane.motions.size(), .batch = lane.batch};
    row.median = quantile(lane.times, 0.5);
    row.p10 = quantile(lane.times, 0.1);
    row.p90 = quantile(lane.times, 0.9);
    row.hit_share = share_of(static_cast<double>(tally.hits), tally.asked);
    row.mean_t = share_of(tally.t_sum, tally.hits);
    row.mean_found = share_of(static_cast<double>(tally.found), tally.asked);
    if (lane.workload.solver == Solver::surefoot) {
        const Motions counted = sample(lane.motions, options.counted);
        const QueryWork work = count_work(stage, lane.workload, counted);
        row.nodes = share_of(static_cast<double>(work.nodes), counted.size());
        row.tested = share_of(static_cast<double>(work.triangles), counted.size());
    }
    row.checked = check(stage, lane.workload, sample(lane.motions, options.checked));
    return row;
}

void set_multiples(std::vector<Row>& rows) {
    for (const Row& unit : rows) {
        if (unit.workload.solver != Solver::embree) continue;
        for (Row& row : rows)
            if (row.workload.order == unit.workload.order) row.multiple = row.median / unit.median;
    }
}

}  // namespace

std::vector<Row> run_suite(const Stage& stage, const SuiteOptions& options) {
    MotionShelf shelf(stage, options.motions);
    std::vector<Lane> lanes;
    for (const Workload& workload : all_workloads()) {
        if (!is_built_in(workload.solver) || !is_wanted(workload, options)) continue;
        const std::span<const Motion> motions = shelf.of(workload);
        if (!motions.empty()) lanes.push_back({.workload = workload, .motions = motions});
    }
    for (Lane& lane : lanes) choose_batch(stage, lane, options);
    for (std::size_t round = 0; round < options.rounds; ++round)
        for (Lane& lane : lanes) lane.times.push_back(1e9 * time_batch(stage, lane, lane.batch));
    std::vector<Row> rows;
    for (Lane& lane : lanes) rows.push_back(row_of(stage, lane, options));
    set_multiples(rows);
    return rows;
}

}  // namespace surefoot::bench
