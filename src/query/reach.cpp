#include "query/reach.hpp"

#include "frame.hpp"
#include "sweep/query.hpp"

namespace surefoot::internal {

namespace {

constexpr double margin_share = 0x1p-36;

}  // namespace

double margin_of(const Volume& volume, double magnitude) noexcept {
    return margin_share * (size_of(volume.shape) + 4 * magnitude);
}

Box3 extent_of(const Volume& volume, double magnitude) noexcept {
    const double m = margin_of(volume, magnitude);
    const Vec margin{m, m, m};
    if (const auto* sphere = std::get_if<Sphere>(&volume.shape)) {
        const Vec radius{sphere->radius, sphere->radius, sphere->radius};
        return {-radius - margin, radius + margin};
    }
    const Frame frame(volume.orientation);
    const auto along = [&](const Vec& axis) {
        const Vec local = frame.to_local(-axis);
        return reach_against(volume.shape, frame.is_upright() ? local : unit(local));
    };
    const Vec low{along({-1, 0, 0}), along({0, -1, 0}), along({0, 0, -1})};
    const Vec high{along({1, 0, 0}), along({0, 1, 0}), along({0, 0, 1})};
    return {-low - margin, high + margin};
}

Box3 extent_of_point(double magnitude) noexcept {
    const double m = margin_share * 4 * magnitude;
    return {{-m, -m, -m}, {m, m, m}};
}

Box3 swept_box(const Box3& extent, const Motion& motion) noexcept {
    const Vec from = to_vec(motion.from);
    const Vec to = to_vec(motion.to);
    Box3 box{from + extent.min, from + extent.max};
    box.include(to + extent.min);
    box.include(to + extent.max);
    return box;
}

}  // namespace surefoot::internal
