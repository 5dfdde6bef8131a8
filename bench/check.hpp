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

/// Asks our solver each question, and asks `sweep`, `ray` or `overlap` of every single triangle that lies within reach
/// of the motion, found by no tree. The same triangle, time and normal, to the bit, or it counts as wrong.
[[nodiscard]] Checked check(const Stage& stage, const Workload& workload, std::span<const Motion> motions);

}  // namespace surefoot::bench
