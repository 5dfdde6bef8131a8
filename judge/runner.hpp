/// Runs families of queries through a sweep and judges every answer. Kernel and judge meet only here, through a
/// function.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "families/families.hpp"
#include "judge.hpp"

namespace judge {

struct Tally {
    std::uint64_t queries = 0;
    std::uint64_t hits = 0;
    std::array<std::uint64_t, verdict_count> verdicts{};
    double worst_gap = 0;  ///< of the hits that are right, relative to the bound
    double seconds = 0;    ///< of computing, sweep and judge together

    [[nodiscard]] std::uint64_t count(Verdict verdict) const { return verdicts[static_cast<std::size_t>(verdict)]; }
    [[nodiscard]] std::uint64_t failures() const { return queries - count(Verdict::right); }
    void add(const Tally& other);
};

struct Row {
    Kind kind;
    const Family* family;
    Tally tally;
};

/// One query with its answer and judgement.
struct Record {
    const Query& query;
    const Answer& answer;
    const Judgement& judgement;
    const Family& family;
};

struct Plan {
    std::uint64_t queries_per_shape = 100000;  ///< spread evenly over the families
    std::uint64_t seed = 1;
    int threads = 2;
    std::vector<Kind> kinds;            ///< empty: all
    std::vector<std::string> families;  ///< empty: all
    /// Called from one thread at a time, for every query or only for failures.
    std::function<void(const Record&)> record;
    bool record_all = false;
    /// Called now and then, with the share that is done [0, 1].
    std::function<void(double)> progress;
};

/// `make_sweep` is called once a thread. The same plan gives the same queries whatever the number of threads.
[[nodiscard]] std::vector<Row> run(const Plan& plan, const std::function<Sweep()>& make_sweep);

}  // namespace judge
