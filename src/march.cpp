#include "march.hpp"

#include <surefoot/sweep.hpp>

namespace surefoot {
inline namespace v0 {

dvec3 JumpArc::operator()(double t) const noexcept {
    const internal::IeeeGuard guard;
    using internal::to_vec;
    const double s = t * duration;
    return internal::to_dvec3(to_vec(from) + to_vec(velocity) * s + to_vec(gravity) * (s * s / 2));
}

std::optional<MarchHit> march(const Volume& volume, const Path& path, const Triangle& triangle,
                              const MarchOptions& options) {
    const auto swept = [&](const Motion& motion) noexcept {
        return sweep(volume, motion, triangle, {.one_sided = options.one_sided});
    };
    const auto look = [&](const dvec3& position) noexcept {
        return overlap(volume, position, triangle, {.one_sided = options.one_sided});
    };
    return internal::walk(path, options, swept, look);
}

}  // namespace v0
}  // namespace surefoot
