/// Queries and answers as JSON lines, in the format of `surefoot sweep --batch` with the triangle and the answer added,
/// so that anyone can judge them. Doubles read back to the same bits; what JSON cannot say (NaN, infinity) is a string.
#pragma once

#include <string>

#include "judge/runner.hpp"

namespace surefoot::tools {

/// Appends one line, without its end.
void append_record(std::string& out, const judge::Record& record);

}  // namespace surefoot::tools
