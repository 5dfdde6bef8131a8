/// The whole benchmark of a scene: everything is timed in one run, in turns, so that a slow minute of the machine is
/// slow for all.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "check.hpp"
#include "workload.hpp"

namespace surefoot::bench {

struct SuiteOptions {
    std::size_t motions = 16384;      ///< for each workload
    std::size_t rounds = 101;         ///< each round times a batch of every workload
    double batch_seconds = 4e-3;      ///< how long a batch should take; sets how many questions it has [s]
    std::size_t checked = 16;         ///< answers of each workload that are compared with brute force
    std::size_t counted = 256;        ///< questions of each workload whose work is counted
    std::vector<std::string> only{};  ///< workloads whose names contain one of these; all if empty. E is always in
};

/// One workload, timed. Times are those of a whole batch divided by its questions.
struct Row {
    Workload workload;
    std::size_t motions = 0;  ///< different questions
    std::size_t batch = 0;    ///< questions in a batch
    double median = 0;        ///< of all rounds [ns a question]
    double p10 = 0;           ///< one round in ten was faster [ns a question]
    double p90 = 0;           ///< one round in ten was slower [ns a question]
    double multiple = 0;      ///< median over Embree's ray in the same order; 0 without Embree
    double hit_share = 0;     ///< [0, 1]
    double mean_t = 0;        ///< of the hits [0, 1]
    double mean_found = 0;    ///< triangles handed back by a question that asks for all
    double nodes = 0;         ///< nodes of our tree that a question opens
    double tested = 0;        ///< triangles that a question of ours tests
    Checked checked{};
};

/// Requires: `options.rounds` > 0. Rows of workloads that have a solver and motions in this scene.
[[nodiscard]] std::vector<Row> run_suite(const Stage& stage, const SuiteOptions& options);

}  // namespace surefoot::bench
