/// Wavefront OBJ, read exactly: every coordinate is the float nearest to the decimals in the file, and every face keeps
/// its place. Assimp is not used for it because it moves some coordinates by an ulp, sorts faces by material, and
/// merges groups; docs/import.md has the numbers.
#pragma once

#include <string_view>

#include <surefoot/import.hpp>

#include "level_builder.hpp"
#include "placement.hpp"

namespace surefoot::internal {

/// Any bytes are fine: the answer is a level or an Error without a file name, whose text begins with "line N".
[[nodiscard]] Expected<ImportedLevel> read_obj(std::string_view text, const Placement& placement,
                                               const ReadLimits& limits);

}  // namespace surefoot::internal
