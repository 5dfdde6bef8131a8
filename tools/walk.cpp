#include "walk.hpp"

#include <algorithm>
#include <vector>

#include "query.hpp"

namespace surefoot::tools {
namespace {

MarchHit blocked(const dvec3& position, double t, std::uint32_t step) {
    return {.hit = {.t = t, .status = HitStatus::invalid}, .position = position, .step = step};
}

std::optional<MarchHit> look(const Mesh& mesh, const Volume& volume, const Path& path, const MarchOptions& options) {
    const MeshQueryOptions query{.one_sided = options.one_sided};
    std::vector<Overlap> found(64);
    for (std::uint32_t sample = 0; sample <= options.steps; ++sample) {
        const double t = static_cast<double>(sample) / options.steps;
        const dvec3 position = path(t);
        if (complaint("path", position)) return blocked(position, t, sample);
        const std::size_t count = mesh.overlap(volume, position, found, query);
        if (count == 0) continue;
        if (count > found.size()) {
            found.resize(count);
            mesh.overlap(volume, position, found, query);
        }
        const auto deepest = std::max_element(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(count),
                                              [](const Overlap& a, const Overlap& b) { return a.depth < b.depth; });
        return MarchHit{.hit = {.t = t,
                                .point = deepest->point,
                                .normal = deepest->normal,
                                .triangle = deepest->triangle,
                                .surface = deepest->surface,
                                .feature = deepest->feature,
                                .status = deepest->status,
                                .started_inside = sample == 0},
                        .position = position,
                        .step = sample == 0 ? 0 : sample - 1};
    }
    return std::nullopt;
}

}  // namespace

std::optional<MarchHit> march(const Mesh& mesh, const Volume& volume, const Path& path, const MarchOptions& options) {
    if (!options.guarded) return look(mesh, volume, path, options);
    dvec3 from = path(0);
    if (complaint("path", from)) return blocked(from, 0, 0);
    for (std::uint32_t step = 0; step < options.steps; ++step) {
        const double end = static_cast<double>(step + 1) / options.steps;
        const dvec3 to = path(end);
        if (complaint("path", to)) return blocked(from, static_cast<double>(step) / options.steps, step);
        if (const std::optional<Hit> hit = mesh.sweep(volume, {from, to}, {.one_sided = options.one_sided})) {
            MarchHit met{.hit = *hit, .position = from + hit->t * (to - from), .step = step};
            met.hit.t = (step + hit->t) / options.steps;
            return met;
        }
        from = to;
    }
    return std::nullopt;
}

}  // namespace surefoot::tools
