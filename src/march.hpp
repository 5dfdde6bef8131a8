// The walk along a path that march on a triangle and march on a mesh share.
#pragma once

#include <surefoot/march.hpp>
#include <surefoot/overlap.hpp>

#include "ieee_guard.hpp"
#include "limits.hpp"
#include "vec.hpp"

namespace surefoot::internal {

inline constexpr std::uint32_t most_march_steps = 1U << 24;

inline Hit hit_of(const Overlap& touch) noexcept {
    Hit hit;
    hit.point = touch.point;
    hit.normal = touch.normal;
    hit.triangle = touch.triangle;
    hit.surface = touch.surface;
    hit.body = touch.body;
    hit.feature = touch.feature;
    hit.status = touch.status;
    return hit;
}

inline MarchHit blocked_march(double t, const dvec3& position, std::uint32_t step) noexcept {
    MarchHit blocked;
    blocked.hit.status = HitStatus::invalid;
    blocked.hit.t = t;
    blocked.position = position;
    blocked.step = step;
    return blocked;
}

/// `sweep` answers `std::optional<Hit>(const Motion&)`, `look` answers `std::optional<Overlap>(const dvec3&)`.
template <typename Sweep, typename Look>
std::optional<MarchHit> walk(const Path& path, const MarchOptions& options, const Sweep& sweep, const Look& look) {
    if (options.steps < 1 || options.steps > most_march_steps) return blocked_march(0, dvec3(0, 0, 0), 0);
    const auto time_of = [&options](double sample) noexcept { return sample / options.steps; };
    dvec3 from(0, 0, 0);
    for (std::uint32_t sample = 0; sample <= options.steps; ++sample) {
        const std::uint32_t step = sample == 0 ? 0 : sample - 1;
        const dvec3 to = path(time_of(sample));
        // NaN has no position to report: the last good one is where the shape stays.
        if (!is_valid_point(to)) return blocked_march(time_of(step), from, step);
        if (!options.guarded) {
            if (const auto touch = look(to)) {
                MarchHit met{.hit = hit_of(*touch), .position = to, .step = step};
                met.hit.t = time_of(sample);
                met.hit.started_inside = sample == 0 && touch->status == HitStatus::ok;
                return met;
            }
        } else if (sample > 0) {
            if (const auto hit = sweep(Motion{.from = from, .to = to})) {
                const IeeeGuard guard;
                MarchHit met{.hit = *hit, .position = to, .step = step};
                if (hit->t < 1) {
                    const Vec start = to_vec(from);
                    met.position = to_dvec3(start + (to_vec(to) - start) * hit->t);
                }
                met.hit.t = smaller(1, time_of(step + hit->t));
                return met;
            }
        }
        from = to;
    }
    return std::nullopt;
}

}  // namespace surefoot::internal
