/// Is what was timed also right? A sample of the answers, against every triangle on its own.
#pragma once

#include <cstddef>
#include <span>

#include "workload.hpp"

namespace surefoot::bench {

struct Checked {
    std::size_t answers = 0;
    std::size_t wrong = 0;  ///< not the same bits
};

/// Asks our solver each question, and asks every single triangle within reach of the motion the same, found by no tree
/// (the nearest point is asked of the mesh's own brute force instead). The same triangle, time, normal and point, to
/// the bit, and as many where all are asked for, or it counts as wrong.
[[nodiscard]] Checked check(const Stage& stage, const Workload& workload, std::span<const Motion> motions);

}  // namespace surefoot::bench
