/// March through a whole mesh: as surefoot/march.hpp does it against one triangle.
#pragma once

#include <optional>

#include <surefoot/march.hpp>
#include <surefoot/mesh.hpp>

namespace surefoot::tools {

/// Walks `volume` along `path` through `mesh`. A guarded march sweeps each chord between two samples; an unguarded one
/// looks at the samples and reports the deepest overlap of the first that touches.
[[nodiscard]] std::optional<MarchHit> march(const Mesh& mesh, const Volume& volume, const Path& path,
                                            const MarchOptions& options);

}  // namespace surefoot::tools
