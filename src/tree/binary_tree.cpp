// The triangles' boxes are carried along and divided in place, so that each level reads memory in a row.
//
// Where nodes lie does not depend on who builds them: the subtree over the items [f, f + n) has the 2n - 2 places
// behind 2f for what is below its root. A large range puts its children at the end of where its left one's places are,
// and a range that is built at one go fills its places from the front, which leaves what it does not need untouched.
#include "tree/binary_tree.hpp"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <mutex>
#include <span>

#include "parallel.hpp"
#include "tree/split.hpp"

namespace surefoot::internal {

namespace {

constexpr std::uint32_t leaf_size = 2;        // the collapse makes larger leaves where they pay
constexpr std::uint32_t least_part = 4096;    // fewer are not worth a thread
constexpr std::uint32_t parts_to_share = 32;  // at least

struct Range {
    std::uint32_t node;
    std::uint32_t first;
    std::uint32_t count;
    int depth;
    ItemSummary summary;
};

Range left_of(const Range& range, const Division& division, std::uint32_t children) noexcept {
    return {children, range.first, division.left, range.depth + 1, division.sides[0]};
}
Range right_of(const Range& range, const Division& division, std::uint32_t children) noexcept {
    return {children + 1, range.first + division.left, range.count - division.left, range.depth + 1, division.sides[1]};
}

class Builder {
public:
    Builder(std::vector<TreeItem>& items, BinaryTree& tree) : items_(items), tree_(tree) {}

    // Describes the node and puts its items on their sides.
    Division divide(const Range& range) {
        const std::span<TreeItem> items(items_.data() + range.first, range.count);
        const ItemSummary& summary = range.summary;
        tree_.nodes[range.node] = {summary.box, range.first, range.count, 0};
        // A leaf lies in one tile, so tiles are parted first.
        if (summary.lowest_tile != summary.highest_tile) {
            const auto lowest = static_cast<std::uint32_t>(summary.lowest_tile);
            const auto highest = static_cast<std::uint32_t>(summary.highest_tile);
            return divide_by_tile(items, static_cast<float>(lowest + (highest - lowest) / 2), scratch(range.count));
        }
        if (range.count <= leaf_size) return {};
        Division division;
        if (range.depth < deepest_split) {
            division = range.count <= most_to_sort ? divide_few_by_area(items)
                                                   : divide_by_area(items, summary.middles, scratch(range.count));
        }
        if (division.left != 0) return division;
        const std::uint32_t half = range.count / 2;
        return {half, {summarise(items.first(half)), summarise(items.subspan(half))}};
    }

    // Builds everything below a range.
    void fill_part(const Range& part) {
        next_ = 2 * part.first + 1;
        fill(part);
        for (std::uint32_t i = part.first; i < part.first + part.count; ++i) tree_.order[i] = items_[i].id();
    }

private:
    void fill(const Range& range) {
        const Division division = divide(range);
        if (division.left == 0) return;
        const std::uint32_t children = next_;
        next_ += 2;
        tree_.nodes[range.node].left = children;
        fill(left_of(range, division, children));
        fill(right_of(range, division, children));
    }

    TreeItem* scratch(std::uint32_t count) {
        if (count > scratch_size_) {
            scratch_ = std::make_unique_for_overwrite<TreeItem[]>(count);
            scratch_size_ = count;
        }
        return scratch_.get();
    }

    std::vector<TreeItem>& items_;
    BinaryTree& tree_;
    std::uint32_t next_ = 0;
    std::unique_ptr<TreeItem[]> scratch_;
    std::uint32_t scratch_size_ = 0;
};

// Ranges that wait for a thread, the largest first.
class Queue {
public:
    explicit Queue(const Range& all) : waiting_{all}, unfinished_(1) {}

    // Waits for a range; false when everything is built.
    bool take(Range& range) {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [&] { return !waiting_.empty() || unfinished_ == 0; });
        if (waiting_.empty()) return false;
        std::pop_heap(waiting_.begin(), waiting_.end(), smaller);
        range = waiting_.back();
        waiting_.pop_back();
        return true;
    }

    void replace_by(const Range& left, const Range& right) {
        {
            const std::scoped_lock lock(mutex_);
            for (const Range& range : {left, right}) {
                waiting_.push_back(range);
                std::push_heap(waiting_.begin(), waiting_.end(), smaller);
            }
            ++unfinished_;
        }
        changed_.notify_all();
    }

    void finish(std::uint32_t part, std::vector<std::uint32_t>& parts) {
        const std::scoped_lock lock(mutex_);
        parts.push_back(part);
        if (--unfinished_ == 0) changed_.notify_all();
    }

private:
    static bool smaller(const Range& a, const Range& b) noexcept { return a.count < b.count; }

    std::mutex mutex_;
    std::condition_variable changed_;
    std::vector<Range> waiting_;
    std::size_t unfinished_;
};

}  // namespace

BinaryTree build_binary_tree(std::vector<TreeItem>&& items, int threads) {
    const auto count = static_cast<std::uint32_t>(items.size());
    BinaryTree tree;
    tree.order.resize(count);
    tree.nodes = std::make_unique_for_overwrite<BinaryNode[]>(tree.room());
    tree.part_size = std::max(least_part, count / parts_to_share);

    Queue queue({0, 0, count, 0, summarise(items)});
    on_threads(count <= tree.part_size ? 1 : threads, [&] {
        Builder builder(items, tree);
        Range range{};
        while (queue.take(range)) {
            if (range.count <= tree.part_size) {
                builder.fill_part(range);
                queue.finish(range.node, tree.parts);
                continue;
            }
            const Division division = builder.divide(range);
            const std::uint32_t children = 2 * (range.first + division.left) - 1;
            tree.nodes[range.node].left = children;
            queue.replace_by(left_of(range, division, children), right_of(range, division, children));
        }
    });
    std::sort(tree.parts.begin(), tree.parts.end(),
              [&](std::uint32_t a, std::uint32_t b) { return tree.nodes[a].first < tree.nodes[b].first; });
    return tree;
}

}  // namespace surefoot::internal
