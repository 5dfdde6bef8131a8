#include "mesh/tree.hpp"

#include <algorithm>

namespace surefoot::internal {

namespace {

double component(const Vec& v, int axis) noexcept {
    return axis == 0 ? v.x : (axis == 1 ? v.y : v.z);
}

class Builder {
public:
    Builder(std::span<const Box3> boxes, Tree& tree) : boxes_(boxes), tree_(tree) {}

    void fill(std::uint32_t node, std::uint32_t first, std::uint32_t count) {
        Box3 box = boxes_[tree_.order[first]];
        Box3 middles{middle(tree_.order[first]), middle(tree_.order[first])};
        for (std::uint32_t i = first; i < first + count; ++i) {
            box.include(boxes_[tree_.order[i]]);
            middles.include(middle(tree_.order[i]));
        }
        tree_.nodes[node].box = box;
        if (count <= Tree::leaf_size) {
            tree_.nodes[node].first = first;
            tree_.nodes[node].count = count;
            return;
        }
        const Vec spread = middles.max - middles.min;
        const int axis = spread.x >= spread.y && spread.x >= spread.z ? 0 : (spread.y >= spread.z ? 1 : 2);
        const auto begin = tree_.order.begin() + first;
        const std::uint32_t half = count / 2;
        std::nth_element(begin, begin + half, begin + count, [&](std::uint32_t a, std::uint32_t b) {
            const double at_a = component(middle(a), axis);
            const double at_b = component(middle(b), axis);
            return at_a != at_b ? at_a < at_b : a < b;
        });
        const auto children = static_cast<std::uint32_t>(tree_.nodes.size());
        tree_.nodes[node].first = children;
        tree_.nodes.resize(tree_.nodes.size() + 2);
        fill(children, first, half);
        fill(children + 1, first + half, count - half);
    }

private:
    [[nodiscard]] Vec middle(std::uint32_t triangle) const {
        return boxes_[triangle].min + boxes_[triangle].max;  // doubled, which changes no order
    }

    std::span<const Box3> boxes_;
    Tree& tree_;
};

}  // namespace

Tree build_tree(std::span<const Box3> boxes) {
    Tree tree;
    if (boxes.empty()) return tree;
    tree.order.resize(boxes.size());
    for (std::uint32_t i = 0; i < tree.order.size(); ++i) tree.order[i] = i;
    tree.nodes.reserve(boxes.size());
    tree.nodes.resize(1);
    Builder(boxes, tree).fill(0, 0, static_cast<std::uint32_t>(boxes.size()));
    return tree;
}

BoxSweep::BoxSweep(const Motion& motion, const Box3& extent) noexcept
    : from_(to_vec(motion.from)), along_(to_vec(motion.to) - from_), extent_(extent) {}

double BoxSweep::entry(const Box3& box) const noexcept {
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

}  // namespace surefoot::internal
