/// Many sweeps, one JSON line each, in a constant amount of memory.
#pragma once

#include <cstdint>
#include <cstdio>
#include <istream>

#include <surefoot/mesh.hpp>

#include "query.hpp"

namespace surefoot::tools {

/// Longer lines are answered with an error, so that memory is bounded whatever the input.
inline constexpr std::size_t longest_line = 1U << 20U;

struct BatchCount {
    std::uint64_t lines = 0;
    std::uint64_t bad = 0;
    bool written = true;  ///< false: the output did not take everything
};

/// Answers every line of `input` with one line on `output`, in order. Answers are flushed whenever the input has
/// nothing more at hand, so that a program at the other end of a pipe can ask, wait for the answer, and ask again.
BatchCount run_batch(const Mesh& mesh, const QueryDefaults& defaults, std::istream& input, std::FILE* output);

}  // namespace surefoot::tools
