/// The part of a command line that every program with a picture has.
#pragma once

#include <string>

#include "playground/options.hpp"

// NOLINTNEXTLINE(readability-identifier-naming): CLI11's own
namespace CLI {
class App;  // its header takes seconds to compile
}

namespace surefoot::playground {

/// `size` is taken as text, for `take_size` to read.
void add_picture_options(CLI::App& program, Options& options, std::string& size);

/// False, and said so, if it is no size.
[[nodiscard]] bool take_size(const std::string& size, const char* program, Options& options);

}  // namespace surefoot::playground
