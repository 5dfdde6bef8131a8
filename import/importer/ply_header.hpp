/// Assimp 5.2 looks for ever for the end of a .ply header that has none.
#pragma once

#include <optional>
#include <string>

#include <surefoot/import.hpp>

namespace surefoot::importer {

/// An error unless the header ends, within the first MiB, and something follows it.
[[nodiscard]] std::optional<Error> check_ply_header(const std::string& path);

}  // namespace surefoot::importer
