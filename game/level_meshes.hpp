/// Cuts an imported level's triangles into meshes by the name of their node.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <surefoot/import.hpp>
#include <surefoot/mesh.hpp>

namespace surefoot::game {

/// Some of the triangles of a level.
struct MeshCut {
    std::vector<vec3> vertices;
    std::vector<std::uint32_t> indices;
    std::vector<std::uint32_t> surfaces;

    /// Relative to `origin`.
    [[nodiscard]] Expected<Mesh> build(const dvec3& origin) const;
};

class LevelCutter {
public:
    /// Requires: `from` outlives it.
    explicit LevelCutter(const ImportedLevel& from) : from_(from), taken_(from.parts.size(), false) {}

    /// Appends the parts of this name that nobody has taken. False if there were none.
    bool take(const std::string& name, MeshCut& into);

    /// Appends everything that nobody has taken.
    void take_rest(MeshCut& into);

private:
    void append(const ImportedPart& part, MeshCut& into) const;

    const ImportedLevel& from_;
    std::vector<bool> taken_;
};

}  // namespace surefoot::game
