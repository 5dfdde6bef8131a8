// Binned surface area heuristic: Wald, "On fast Construction of SAH-based Bounding Volume Hierarchies" (2007). The
// triangles themselves are carried along and split in place, so that each level reads memory in a row.
#include "tree/binary_tree.hpp"

#include <algorithm>
#include <atomic>
#include <limits>
#include <thread>

namespace surefoot::internal {

namespace {

constexpr int bin_count = 16;
constexpr std::uint32_t leaf_size = 2;          // the collapse makes larger leaves where they pay
constexpr std::uint32_t least_to_share = 4096;  // fewer are not worth a thread

struct Item {
    FloatBox box;
    std::uint32_t id;
    std::uint32_t tile;

    [[nodiscard]] float middle(int axis) const noexcept { return box.min[axis] + box.max[axis]; }  // doubled
};

constexpr FloatBox nothing() noexcept {
    constexpr float far = std::numeric_limits<float>::max();
    return {{far, far, far}, {-far, -far, -far}};
}

struct Range {
    std::uint32_t first;
    std::uint32_t count;
};

struct Split {
    int axis = -1;  ///< -1: there is none
    int bin = 0;    ///< the first bin of the right side
    float low = 0;
    float per_bin = 0;

    [[nodiscard]] int bin_of(const Item& item) const noexcept {
        const int found = static_cast<int>((item.middle(axis) - low) * per_bin);
        return found < bin_count - 1 ? found : bin_count - 1;
    }
};

struct Summary {
    FloatBox box = nothing();
    FloatBox middles = nothing();
};

Summary summarise(std::span<const Item> items) noexcept {
    Summary summary;
    for (const Item& item : items) {
        summary.box.include(item.box);
        const FloatBox middle{{item.middle(0), item.middle(1), item.middle(2)},
                              {item.middle(0), item.middle(1), item.middle(2)}};
        summary.middles.include(middle);
    }
    return summary;
}

Split best_split(std::span<const Item> items, const FloatBox& middles) noexcept {
    struct Bin {
        FloatBox box = nothing();
        std::uint32_t count = 0;
    };
    Split best;
    float least = std::numeric_limits<float>::max();
    Split trial[3];
    Bin bins[3][bin_count];
    for (int axis = 0; axis < 3; ++axis) {
        const float extent = middles.max[axis] - middles.min[axis];
        if (!(extent > 0)) continue;
        trial[axis] = {axis, 0, middles.min[axis], static_cast<float>(bin_count) * 0.9999F / extent};
        if (!(trial[axis].per_bin < std::numeric_limits<float>::max())) trial[axis].axis = -1;
    }
    for (const Item& item : items) {
        for (int axis = 0; axis < 3; ++axis) {
            if (trial[axis].axis < 0) continue;
            Bin& bin = bins[axis][trial[axis].bin_of(item)];
            bin.box.include(item.box);
            ++bin.count;
        }
    }
    for (int axis = 0; axis < 3; ++axis) {
        if (trial[axis].axis < 0) continue;
        float right_cost[bin_count];
        Bin right;
        for (int i = bin_count - 1; i > 0; --i) {
            right.box.include(bins[axis][i].box);
            right.count += bins[axis][i].count;
            right_cost[i] = right.count == 0 ? 0 : right.box.area() * static_cast<float>(right.count);
        }
        Bin left;
        for (int i = 1; i < bin_count; ++i) {
            left.box.include(bins[axis][i - 1].box);
            left.count += bins[axis][i - 1].count;
            if (left.count == 0 || left.count == items.size()) continue;
            const float cost = left.box.area() * static_cast<float>(left.count) + right_cost[i];
            if (cost < least) {
                least = cost;
                best = trial[axis];
                best.bin = i;
            }
        }
    }
    return best;
}

class Builder {
public:
    Builder(std::vector<Item>& items, std::vector<BinaryNode>& nodes) : items_(items), nodes_(nodes) {}

    // Fills `node` and everything below it; the nodes of a subtree are appended behind all that are there.
    void fill(std::uint32_t node, Range range, int depth) {
        const std::span<Item> items(items_.data() + range.first, range.count);
        const std::uint32_t left = divide(node, items, range.first, depth);
        if (left == 0) return;
        const auto children = static_cast<std::uint32_t>(nodes_.size());
        nodes_.resize(nodes_.size() + 2);
        nodes_[node].left = children;
        nodes_[node].right = children + 1;
        fill(children, {range.first, left}, depth + 1);
        fill(children + 1, {range.first + left, range.count - left}, depth + 1);
    }

    // Describes the node, puts its items on their sides and says how many are on the left; 0 for a leaf.
    std::uint32_t divide(std::uint32_t node, std::span<Item> items, std::uint32_t first, int depth) {
        const Summary summary = summarise(items);
        const auto count = static_cast<std::uint32_t>(items.size());
        nodes_[node] = {summary.box, first, count, 0, 0};
        if (const std::uint32_t of_first_tiles = divide_tiles(items); of_first_tiles != 0) return of_first_tiles;
        if (count <= leaf_size) return 0;
        const Split split = depth < deepest_split ? best_split(items, summary.middles) : Split{};
        if (split.axis < 0) return count / 2;
        const auto middle = std::partition(items.begin(), items.end(),
                                           [&](const Item& item) { return split.bin_of(item) < split.bin; });
        return static_cast<std::uint32_t>(middle - items.begin());
    }

private:
    // A leaf lies in one tile, so tiles are parted first. Returns 0 if there is but one.
    static std::uint32_t divide_tiles(std::span<Item> items) {
        std::uint32_t lowest = items[0].tile;
        std::uint32_t highest = lowest;
        for (const Item& item : items) {
            lowest = std::min(lowest, item.tile);
            highest = std::max(highest, item.tile);
        }
        if (lowest == highest) return 0;
        const std::uint32_t middle = lowest + (highest - lowest) / 2;
        const auto rest =
            std::partition(items.begin(), items.end(), [&](const Item& item) { return item.tile <= middle; });
        return static_cast<std::uint32_t>(rest - items.begin());
    }

    std::vector<Item>& items_;
    std::vector<BinaryNode>& nodes_;
};

// Subtrees that were built apart, put behind the top of the tree in a fixed order.
void append(std::vector<BinaryNode>& nodes, std::uint32_t place, const std::vector<BinaryNode>& subtree) {
    const auto base = static_cast<std::uint32_t>(nodes.size()) - 1;  // its root goes to `place`, the rest behind
    for (std::size_t i = 0; i < subtree.size(); ++i) {
        BinaryNode node = subtree[i];
        if (node.left != 0) {
            node.left += base;
            node.right += base;
        }
        if (i == 0) {
            nodes[place] = node;
        } else {
            nodes.push_back(node);
        }
    }
}

}  // namespace

BinaryTree build_binary_tree(std::span<const FloatBox> boxes, std::span<const std::uint16_t> tiles, int threads) {
    std::vector<Item> items(boxes.size());
    for (std::uint32_t i = 0; i < items.size(); ++i) items[i] = {boxes[i], i, tiles.empty() ? 0U : tiles[i]};
    BinaryTree tree;
    tree.nodes.reserve(boxes.size());
    tree.nodes.resize(1);
    Builder top(items, tree.nodes);

    struct Job {
        std::uint32_t node;
        Range range;
        int depth;
        std::vector<BinaryNode> nodes{};
    };
    std::vector<Job> jobs{{0, {0, static_cast<std::uint32_t>(items.size())}, 0}};
    // The largest is divided until there is enough to go round. How much that is does not depend on the threads.
    constexpr std::size_t enough = 16;
    while (jobs.size() < enough) {
        const auto largest = std::max_element(jobs.begin(), jobs.end(),
                                              [](const Job& a, const Job& b) { return a.range.count < b.range.count; });
        if (largest->range.count < least_to_share) break;
        const Job job = *largest;
        const std::uint32_t left =
            top.divide(job.node, {items.data() + job.range.first, job.range.count}, job.range.first, job.depth);
        const auto children = static_cast<std::uint32_t>(tree.nodes.size());
        tree.nodes.resize(tree.nodes.size() + 2);
        tree.nodes[job.node].left = children;
        tree.nodes[job.node].right = children + 1;
        *largest = {children, {job.range.first, left}, job.depth + 1};
        jobs.push_back({children + 1, {job.range.first + left, job.range.count - left}, job.depth + 1});
    }
    std::atomic<std::size_t> next{0};
    const auto work = [&] {
        for (std::size_t i = next++; i < jobs.size(); i = next++) {
            jobs[i].nodes.reserve(jobs[i].range.count);
            jobs[i].nodes.resize(1);
            Builder(items, jobs[i].nodes).fill(0, jobs[i].range, jobs[i].depth);
        }
    };
    std::vector<std::thread> helpers;
    for (int i = 1; i < threads && jobs.size() > 1; ++i) helpers.emplace_back(work);
    work();
    for (std::thread& helper : helpers) helper.join();
    for (const Job& job : jobs) append(tree.nodes, job.node, job.nodes);

    tree.order.resize(items.size());
    for (std::size_t i = 0; i < items.size(); ++i) tree.order[i] = items[i].id;
    return tree;
}

}  // namespace surefoot::internal
