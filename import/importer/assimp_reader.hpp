/// Everything that Assimp is asked to do, in the one program that links it.
#pragma once

#include <string>

#include <surefoot/import.hpp>

#include "placement.hpp"

namespace surefoot::importer {

/// The level at `path`, or an Error without a file name. The level alone takes at most `bytes`; what Assimp takes is
/// for the limits of the process.
[[nodiscard]] Expected<ImportedLevel> read_with_assimp(const std::string& path, const internal::Placement& placement,
                                                       std::uint64_t bytes);

}  // namespace surefoot::importer
