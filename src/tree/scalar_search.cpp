#include "tree/scalar_search.hpp"

namespace surefoot::internal {

namespace {

double component(const Vec& v, int axis) noexcept {
    return axis == 0 ? v.x : (axis == 1 ? v.y : v.z);
}

}  // namespace

BoxSweep::BoxSweep(const Motion& motion, const Box3& extent) noexcept
    : from_(to_vec(motion.from)), along_(to_vec(motion.to) - from_), extent_(extent) {}

double BoxSweep::operator()(const Box3& box) const noexcept {
    double enter = 0;
    double leave = 1;
    for (int axis = 0; axis < 3; ++axis) {
        const double from = component(from_, axis);
        const double along = component(along_, axis);
        const double low = component(box.min, axis) - component(extent_.max, axis) - from;
        const double high = component(box.max, axis) - component(extent_.min, axis) - from;
        if (along == 0) {
            if (low > 0 || high < 0) return 2;
            continue;
        }
        const double a = low / along;
        const double b = high / along;
        enter = larger(enter, smaller(a, b));
        leave = smaller(leave, larger(a, b));
    }
    return enter <= leave ? enter : 2;
}

Box3 box_of_node(const WideNode& node) noexcept {
    Box3 around = box_of_child(node, 0);
    for (std::uint32_t i = 1; i < node.count && i < tree_width; ++i) around.include(box_of_child(node, i));
    return around;
}

double BoxDistance::operator()(const Box3& box) const noexcept {
    double farthest = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const double at = component(point_, axis);
        farthest = larger(farthest, larger(component(box.min, axis) - at, at - component(box.max, axis)));
    }
    return farthest;
}

}  // namespace surefoot::internal
