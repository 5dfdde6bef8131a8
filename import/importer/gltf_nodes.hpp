/// What a glTF file says beside its triangles. Assimp hands on only part of it (arrays in extras are lost, poses are
/// floats), so the JSON is read here.
#pragma once

#include <map>
#include <string>
#include <vector>

#include <surefoot/import.hpp>

#include "placement.hpp"

namespace surefoot::importer {

struct GltfExtras {
    std::vector<ImportedMarker> markers;           ///< in the order of the scene's tree, placed
    std::map<std::string, std::string> materials;  ///< extras by the name of the material, JSON text
};

/// Reads a .gltf or .glb. Fails with `unreadable` for anything that is no glTF 2, and with `unsupported` when the file
/// requires an extension that changes geometry and that is not read here.
[[nodiscard]] Expected<GltfExtras> read_gltf_extras(const std::string& path, const internal::Placement& placement);

}  // namespace surefoot::importer
