#include "runner.hpp"

#include <algorithm>
#include <atomic>
#include <ctime>
#include <mutex>
#include <thread>

namespace judge {
namespace {

constexpr std::uint64_t queries_per_chunk = 2048;

struct Chunk {
    std::size_t row = 0;
    std::uint64_t seed = 0;
    std::uint64_t queries = 0;
};

bool is_wanted(const Plan& plan, const Family& family) {
    return plan.families.empty() ||
           std::find(plan.families.begin(), plan.families.end(), family.name) != plan.families.end();
}

std::uint64_t mixed(std::uint64_t a, std::uint64_t b) {
    return Draw(a * 0x9e3779b97f4a7c15 + b).next();
}

/// Time that this thread has computed: other programs on the machine do not count.
double thread_seconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

class Worker {
public:
    Worker(const Plan& plan, Sweep sweep, std::mutex& mutex) : plan_(plan), sweep_(std::move(sweep)), mutex_(mutex) {}

    Tally run(const Chunk& chunk, Kind kind, const Family& family) {
        const double begin = thread_seconds();
        Tally tally;
        Draw draw(chunk.seed);
        while (tally.queries < chunk.queries) {
            queries_.clear();
            family.make({draw, kind, sweep_}, queries_);
            for (Query query : queries_) {
                if (draw.coin()) std::swap(query.b, query.c);  // both windings
                judge_one(query, family, tally);
            }
        }
        tally.seconds = thread_seconds() - begin;
        return tally;
    }

private:
    void judge_one(const Query& query, const Family& family, Tally& tally) {
        const Answer answer = sweep_(query);
        const Judgement judgement = judge(query, answer);
        ++tally.queries;
        tally.hits += answer.hit ? 1 : 0;
        ++tally.verdicts[static_cast<std::size_t>(judgement.verdict)];
        if (judgement.verdict == Verdict::right) tally.worst_gap = std::max(tally.worst_gap, judgement.gap);
        if (plan_.record && (plan_.record_all || judgement.verdict != Verdict::right)) {
            const std::lock_guard lock(mutex_);
            plan_.record({query, answer, judgement, family});
        }
    }

    const Plan& plan_;
    Sweep sweep_;
    std::mutex& mutex_;
    std::vector<Query> queries_;
};

}  // namespace

void Tally::add(const Tally& other) {
    queries += other.queries;
    hits += other.hits;
    for (std::size_t i = 0; i < verdicts.size(); ++i) verdicts[i] += other.verdicts[i];
    worst_gap = std::max(worst_gap, other.worst_gap);
    seconds += other.seconds;
}

std::vector<Row> run(const Plan& plan, const std::function<Sweep()>& make_sweep) {
    std::vector<Row> rows;
    for (int kind = 0; kind < kind_count; ++kind) {
        const Kind k = static_cast<Kind>(kind);
        if (!plan.kinds.empty() && std::find(plan.kinds.begin(), plan.kinds.end(), k) == plan.kinds.end()) continue;
        for (const Family& family : families())
            if (is_wanted(plan, family)) rows.push_back({k, &family, {}});
    }
    std::uint64_t wanted = 0;
    for (const Family& family : families()) wanted += is_wanted(plan, family) ? 1 : 0;
    if (rows.empty()) return rows;

    std::vector<Chunk> chunks;
    const std::uint64_t per_row = std::max<std::uint64_t>(1, (plan.queries_per_shape + wanted - 1) / wanted);
    for (std::size_t row = 0; row < rows.size(); ++row) {
        const auto index = static_cast<std::uint64_t>(rows[row].family - families().data());
        const std::uint64_t row_seed = mixed(mixed(plan.seed, static_cast<std::uint64_t>(rows[row].kind)), index);
        for (std::uint64_t first = 0, i = 0; first < per_row; first += queries_per_chunk, ++i)
            chunks.push_back({row, mixed(row_seed, i), std::min(queries_per_chunk, per_row - first)});
    }

    std::mutex mutex, record_mutex;
    std::atomic<std::size_t> next{0};
    std::size_t done = 0;
    const auto work = [&] {
        Worker worker(plan, make_sweep(), record_mutex);
        for (std::size_t i = next++; i < chunks.size(); i = next++) {
            Row& row = rows[chunks[i].row];
            const Tally tally = worker.run(chunks[i], row.kind, *row.family);
            const std::lock_guard lock(mutex);
            row.tally.add(tally);
            ++done;
            if (plan.progress) plan.progress(static_cast<double>(done) / static_cast<double>(chunks.size()));
        }
    };
    std::vector<std::jthread> threads;
    for (int i = 1; i < plan.threads; ++i) threads.emplace_back(work);
    work();
    threads.clear();
    return rows;
}

}  // namespace judge
