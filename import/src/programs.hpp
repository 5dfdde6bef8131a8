/// Where the programs are that help with importing.
#pragma once

#include <surefoot/import.hpp>

namespace surefoot::internal {

/// surefoot-importer: see <surefoot/import.hpp> for the order. Fails with `unsupported` and a text that says where it
/// was looked for.
[[nodiscard]] Expected<std::string> find_importer(const ImportOptions& options);

/// Blender: SUREFOOT_BLENDER, else `blender` on the PATH. Fails with `unsupported`.
[[nodiscard]] Expected<std::string> find_blender();

}  // namespace surefoot::internal
