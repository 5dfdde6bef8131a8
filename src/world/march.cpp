#include "march.hpp"

#include <surefoot/world.hpp>

namespace surefoot {
inline namespace v0 {

std::optional<MarchHit> march(const Volume& volume, const Path& path, const World& world, const MarchOptions& options,
                              const WorldQuery& query) {
    WorldQuery now = query;
    now.one_sided = query.one_sided || options.one_sided;
    // The walk asks step by step, from the first on; each step has its own part of the tick.
    std::uint32_t asked = 0;
    const auto time_of = [&](std::uint32_t sample) noexcept {
        const internal::IeeeGuard guard;
        if (sample == 0) return query.begin;
        if (sample >= options.steps) return query.end;
        return query.begin + (query.end - query.begin) * (sample / static_cast<double>(options.steps));
    };
    const auto swept = [&](const Motion& motion) noexcept {
        now.begin = time_of(asked);
        now.end = time_of(++asked);
        return world.sweep(volume, motion, now);
    };
    const auto look = [&](const dvec3& position) noexcept -> std::optional<Overlap> {
        now.begin = now.end = time_of(asked++);
        Overlap first;
        if (world.overlap(volume, position, std::span<Overlap>(&first, 1), now) == 0) return std::nullopt;
        return first;
    };
    return internal::walk(path, options, swept, look);
}

}  // namespace v0
}  // namespace surefoot
