/// Everything that Assimp is asked to do, in the one program that links it.
#pragma once

#include <string>

#include <surefoot/import.hpp>

#include "placement.hpp"

namespace surefoot::importer {

/// The level at `path`, or an Error without a file name.
[[nodiscard]] Expected<ImportedLevel> read_with_assimp(const std::string& path, const internal::Placement& placement);

}  // namespace surefoot::importer
