#include "pair/boxes.hpp"

#include "exact/products.hpp"

namespace surefoot::internal {

std::optional<BoxPair> BoxPair::of(const PlacedPair& pair) noexcept {
    if (!std::holds_alternative<Box>(pair.a.shape()) || !std::holds_alternative<Box>(pair.b.shape())) {
        return std::nullopt;
    }
    BoxPair boxes;
    const auto add = [&](const Vec& direction) noexcept {
        const Vec n = unit(direction);
        if (n == Vec{}) return;
        boxes.axis_[boxes.count_] = n;
        boxes.reach_[boxes.count_++] = pair.a.reach(n) + pair.b.reach(n);
    };
    const Vec axes[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (const Vec& axis : axes) {
        add(pair.a.frame().to_world(axis));
        add(pair.b.frame().to_world(axis));
    }
    for (const Vec& of_a : axes) {
        for (const Vec& of_b : axes) add(accurate_cross(pair.a.frame().to_world(of_a), pair.b.frame().to_world(of_b)));
    }
    return boxes;
}

Gap BoxPair::gap_at(const Vec& x) const noexcept {
    Gap gap;
    gap.least = -1e300;
    for (int i = 0; i < count_; ++i) {
        const double along = dot(axis_[i], x);
        const double least = absolute(along) - reach_[i];
        if (least <= gap.least) continue;
        gap.least = least;
        gap.normal = along < 0 ? -axis_[i] : axis_[i];
    }
    gap.most = gap.least;
    return gap;
}

double BoxPair::guess_entry(const Vec& x, const Vec& motion) const noexcept {
    double last = 0;
    for (int i = 0; i < count_; ++i) {
        const double at = dot(axis_[i], x);
        const double speed = at < 0 ? dot(axis_[i], motion) : -dot(axis_[i], motion);
        const double gap = absolute(at) - reach_[i];
        if (gap > 0 && speed > 0) last = larger(last, gap / speed);
    }
    return last;
}

}  // namespace surefoot::internal
