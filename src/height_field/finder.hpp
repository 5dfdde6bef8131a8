// Which triangles of a height field a query may meet: down the pyramid, nearest first.
#pragma once

#include <algorithm>
#include <cstdint>

#include <surefoot/query.hpp>

#include "height_field/pyramid.hpp"
#include "height_field/samples.hpp"
#include "query/moving_reach.hpp"
#include "query/reach.hpp"

namespace surefoot::internal {

/// See query/ask.hpp.
class HeightFieldFinder {
public:
    static constexpr bool trusted = true;

    HeightFieldFinder(const HeightSamples& samples, const HeightPyramid& pyramid) noexcept
        : samples_(samples), pyramid_(pyramid) {}

    [[nodiscard]] Box3 box() const noexcept {
        const GridLine& x = samples_.x;
        const GridLine& z = samples_.z;
        const HeightRange& y = pyramid_.top();
        return {{x.at(0.0), y.low, z.at(0.0)}, {x.at(x.count()), y.high, z.at(z.count())}};
    }

    template <typename Ask>
    void find_all(const Ask& ask) const noexcept {
        for (std::int64_t row = 0; row < samples_.z.count(); ++row) {
            for (std::int64_t column = 0; column < samples_.x.count(); ++column) {
                if (samples_.is_hole(samples_.quad_at(column, row))) continue;
                hand_out(HeightQuad(samples_, column, row), column, row, ask);
            }
        }
    }

    template <typename Reach, typename Ask, typename Limit>
    void find(const Reach& reach, const Ask& ask, const Limit& limit, QueryWork* work) const noexcept {
        const Box3 whole = reach.whole();
        const CellRange quads{samples_.x.first_reaching(whole.min.x), samples_.x.last_reached(whole.max.x),
                              samples_.z.first_reaching(whole.min.z), samples_.z.last_reached(whole.max.z)};
        if (quads.is_empty()) return;

        // Begin where the quads below the motion are four nodes or fewer: a short motion has no business at the top.
        int level = 0;
        CellRange nodes = quads.shifted(HeightPyramid::leaf_shift);
        while (nodes.last_column - nodes.first_column > 1 || nodes.last_row - nodes.first_row > 1) {
            nodes = nodes.shifted(1);
            ++level;
        }
        Node stack[4 * HeightPyramid::most_levels];
        int size = 0;
        push_nodes(reach, level, nodes, stack, size);
        while (size > 0) {
            const Node node = stack[--size];
            if (node.key > limit()) continue;
            if (work != nullptr) ++work->nodes;
            if (node.level == 0) {
                look_at_quads(reach, below(node, quads, HeightPyramid::leaf_shift), ask, limit);
            } else {
                const int shift = HeightPyramid::leaf_shift + node.level - 1;
                push_nodes(reach, node.level - 1, below(node, quads.shifted(shift), 1), stack, size);
            }
        }
    }

private:
    struct Node {
        double key;
        std::int32_t level;
        std::int32_t column;
        std::int32_t row;
    };

    /// What lies in a node, each 2^shift of which make the node's width, and within `bounds`.
    static CellRange below(const Node& node, const CellRange& bounds, int shift) noexcept {
        const auto first = [&](std::int64_t at) { return at << shift; };
        const auto last = [&](std::int64_t at) { return ((at + 1) << shift) - 1; };
        return {std::max(bounds.first_column, first(node.column)), std::min(bounds.last_column, last(node.column)),
                std::max(bounds.first_row, first(node.row)), std::min(bounds.last_row, last(node.row))};
    }

    [[nodiscard]] Box3 box_of_node(int level, std::int64_t column, std::int64_t row) const noexcept {
        const int shift = HeightPyramid::leaf_shift + level;
        const HeightRange& range = pyramid_.at(level, column, row);
        const auto end = [shift](std::int64_t at, const GridLine& line) {
            return std::min((at + 1) << shift, line.count());
        };
        return {{samples_.x.at(column << shift), range.low, samples_.z.at(row << shift)},
                {samples_.x.at(end(column, samples_.x)), range.high, samples_.z.at(end(row, samples_.z))}};
    }

    /// Pushes the nodes of `range`, at most four of them, the nearest last.
    template <typename Reach>
    void push_nodes(const Reach& reach, int level, const CellRange& range, Node* stack, int& size) const noexcept {
        const int bottom = size;
        for (std::int64_t row = range.first_row; row <= range.last_row; ++row) {
            for (std::int64_t column = range.first_column; column <= range.last_column; ++column) {
                const double key = reach.key(box_of_node(level, column, row));
                if (key == never) continue;
                int place = size++;
                for (; place > bottom && stack[place - 1].key < key; --place) stack[place] = stack[place - 1];
                stack[place] = {key, level, static_cast<std::int32_t>(column), static_cast<std::int32_t>(row)};
            }
        }
    }

    /// Asks about the quads of one leaf, nearest first.
    template <typename Reach, typename Ask, typename Limit>
    void look_at_quads(const Reach& reach, const CellRange& range, const Ask& ask, const Limit& limit) const noexcept {
        struct Candidate {
            double key;
            std::int64_t column;
            std::int64_t row;
        };
        Candidate near[1 << (2 * HeightPyramid::leaf_shift)];
        int count = 0;
        const double farthest = limit();
        for (std::int64_t row = range.first_row; row <= range.last_row; ++row) {
            for (std::int64_t column = range.first_column; column <= range.last_column; ++column) {
                const double key = reach.key(HeightQuad(samples_, column, row).box());
                if (!(key <= farthest) || samples_.is_hole(samples_.quad_at(column, row))) continue;
                int place = count++;
                for (; place > 0 && near[place - 1].key > key; --place) near[place] = near[place - 1];
                near[place] = {key, column, row};
            }
        }
        for (int i = 0; i < count && near[i].key <= limit(); ++i) {
            hand_out(HeightQuad(samples_, near[i].column, near[i].row), near[i].column, near[i].row, ask);
        }
    }

    template <typename Ask>
    void hand_out(const HeightQuad& quad, std::int64_t column, std::int64_t row, const Ask& ask) const noexcept {
        const bool rising = samples_.is_rising(column, row);
        const std::size_t id = 2 * samples_.quad_at(column, row);
        const auto name = static_cast<std::uint32_t>(id);
        ask(SourceTriangle{.triangle = quad.first(rising), .id = name, .surface = samples_.surface(id)});
        ask(SourceTriangle{.triangle = quad.second(rising), .id = name + 1, .surface = samples_.surface(id + 1)});
    }

    const HeightSamples& samples_;
    const HeightPyramid& pyramid_;
};

}  // namespace surefoot::internal
