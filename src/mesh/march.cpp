#include "march.hpp"

#include <surefoot/mesh.hpp>

namespace surefoot {
inline namespace v0 {

std::optional<MarchHit> march(const Volume& volume, const Path& path, const Mesh& mesh, const MarchOptions& options) {
    const QueryOptions query{.one_sided = options.one_sided};
    const auto swept = [&](const Motion& motion) noexcept { return mesh.sweep(volume, motion, query); };
    const auto look = [&](const dvec3& position) noexcept -> std::optional<Overlap> {
        Overlap first;
        if (mesh.overlap(volume, position, std::span<Overlap>(&first, 1), query) == 0) return std::nullopt;
        return first;
    };
    return internal::walk(path, options, swept, look);
}

}  // namespace v0
}  // namespace surefoot
