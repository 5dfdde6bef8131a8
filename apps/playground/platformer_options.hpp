/// The command line of the platformer.
#pragma once

#include "playground/options.hpp"

namespace surefoot::playground {

/// As `read_options`, for the program that has the platformer's room only.
[[nodiscard]] std::optional<ExitCode> read_platformer_options(int argc, const char* const* argv, Options& options);

}  // namespace surefoot::playground
