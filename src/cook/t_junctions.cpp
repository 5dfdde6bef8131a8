// Which corners lie on an open edge? The corners that open edges have are sorted into the cells of a grid, and each
// open edge walks through the cells along its way (Amanatides and Woo: A fast voxel traversal algorithm for ray
// tracing, 1987). Only edges without a partner are asked: where two triangles share an edge, nothing can be in between.
#include <algorithm>
#include <cmath>

#include "cook/findings.hpp"

namespace surefoot::internal {
namespace {

// Rounding to floats moves a corner by up to 2^-24 of its coordinates, and so the ends of the edge.
constexpr double float_noise = 0x1p-22;

struct Cell {
    std::int64_t x;
    std::int64_t y;
    std::int64_t z;

    friend bool operator==(const Cell&, const Cell&) = default;
};

class CornerGrid {
public:
    CornerGrid(const Soup& soup, const std::vector<std::uint32_t>& corners, double cell, double reach)
        : cell_(cell), per_metre_(1 / cell) {
        std::size_t size = 64;
        while (2 * size < corners.size()) size *= 2;
        mask_ = size * slots_a_bucket - 1;
        begin_.assign(size + 1, 0);
        crowd_.assign(size * slots_a_bucket / 4, 0);
        const auto each_cell = [&](const auto& visit) {
            for (const std::uint32_t corner : corners) {
                const Vec& place = soup.vertices[corner];
                const Vec margin{reach, reach, reach};
                const Cell low = cell_at(place - margin);
                const Cell high = cell_at(place + margin);
                for (std::int64_t x = low.x; x <= high.x; ++x)
                    for (std::int64_t y = low.y; y <= high.y; ++y)
                        for (std::int64_t z = low.z; z <= high.z; ++z) visit(slot_of({x, y, z}), corner);
            }
        };
        each_cell([&](std::size_t slot, std::uint32_t) {
            ++begin_[bucket_of(slot)];
            if (crowd_in(slot) < most_counted)
                crowd_[slot / 4] = static_cast<std::uint8_t>(crowd_[slot / 4] + (1U << (2 * (slot % 4))));
        });
        for (std::size_t bucket = 0; bucket < size; ++bucket) begin_[bucket + 1] += begin_[bucket];
        corners_.resize(begin_[size]);
        // From where each bucket ends down to where it begins.
        each_cell([&](std::size_t slot, std::uint32_t corner) { corners_[--begin_[bucket_of(slot)]] = corner; });
    }

    [[nodiscard]] Cell cell_at(const Vec& v) const noexcept {
        const auto down = [&](double x) {
            const double scaled = x * per_metre_;
            auto whole = static_cast<std::int64_t>(scaled);
            return static_cast<double>(whole) > scaled ? whole - 1 : whole;
        };
        return {down(v.x), down(v.y), down(v.z)};
    }

    /// Those in this cell, and strangers whose cells have the same bucket; none if there are no more than `known`.
    [[nodiscard]] std::span<const std::uint32_t> corners_in(const Cell& cell, unsigned known) const noexcept {
        const std::size_t slot = slot_of(cell);
        if (crowd_in(slot) <= known && known < most_counted) return {};
        const std::size_t bucket = bucket_of(slot);
        return std::span(corners_).subspan(begin_[bucket], begin_[bucket + 1] - begin_[bucket]);
    }

    [[nodiscard]] double cell_size() const noexcept { return cell_; }

private:
    // Nearly all cells on the way hold nothing but what is known, and it takes one look into a small table to see that:
    // it counts in far more slots than there are buckets, so that few cells share one, and blocks of 4 x 4 x 4 cells
    // lie together in it, so that most looks are at what has just been fetched.
    static constexpr std::size_t slots_a_bucket = 32;
    static constexpr unsigned most_counted = 3;

    [[nodiscard]] unsigned crowd_in(std::size_t slot) const noexcept {
        return crowd_[slot / 4] >> (2 * (slot % 4)) & 3U;
    }
    [[nodiscard]] std::size_t slot_of(const Cell& cell) const noexcept {
        std::uint64_t hash = static_cast<std::uint64_t>(cell.x >> 2) * 0x9E3779B97F4A7C15;
        hash = (hash ^ (hash >> 32U) ^ static_cast<std::uint64_t>(cell.y >> 2)) * 0xBF58476D1CE4E5B9;
        hash = (hash ^ (hash >> 32U) ^ static_cast<std::uint64_t>(cell.z >> 2)) * 0x94D049BB133111EB;
        const auto within = static_cast<std::size_t>((cell.x & 3) << 4 | (cell.y & 3) << 2 | (cell.z & 3));
        return (static_cast<std::size_t>(hash >> 24U) << 6 | within) & mask_;
    }
    [[nodiscard]] std::size_t bucket_of(std::size_t slot) const noexcept {
        return static_cast<std::size_t>(std::uint64_t{slot} * 0x9E3779B97F4A7C15 >> 32U) & (begin_.size() - 2);
    }

    double cell_;
    double per_metre_;
    std::size_t mask_ = 0;
    std::vector<std::uint32_t> begin_;
    std::vector<std::uint32_t> corners_;
    std::vector<std::uint8_t> crowd_;  // two bits a slot: how many, up to 3
};

// Visits the cells from `a` to `b` in order; false when that is more than `most`.
template <typename Visit>
bool walk(const CornerGrid& grid, const Vec& a, const Vec& b, std::int64_t most, const Visit& visit) {
    const Cell first = grid.cell_at(a);
    const Cell last = grid.cell_at(b);
    std::int64_t at[3] = {first.x, first.y, first.z};
    const std::int64_t to[3] = {last.x, last.y, last.z};
    const double from[3] = {a.x, a.y, a.z};
    const double along[3] = {b.x - a.x, b.y - a.y, b.z - a.z};
    std::int64_t steps_left = 0;
    double next[3];   // when the way crosses into the next cell along each axis
    double every[3];  // and how long a cell takes
    for (int i = 0; i < 3; ++i) {
        const std::int64_t steps = to[i] > at[i] ? to[i] - at[i] : at[i] - to[i];
        if (steps > most || (steps_left += steps) > most) return false;
        const double cell = grid.cell_size();
        every[i] = steps == 0 ? 2 : cell / absolute(along[i]);
        const double border = static_cast<double>(to[i] > at[i] ? at[i] + 1 : at[i]) * cell;
        next[i] = steps == 0 ? 2 : (border - from[i]) / along[i];
    }
    for (;; --steps_left) {
        visit(Cell{at[0], at[1], at[2]});
        if (steps_left == 0) return true;
        // Only axes that have not arrived: rounding may say otherwise near the end.
        int axis = -1;
        for (int i = 0; i < 3; ++i)
            if (at[i] != to[i] && (axis < 0 || next[i] < next[axis])) axis = i;
        at[axis] += to[axis] > at[axis] ? 1 : -1;
        next[axis] += every[axis];
    }
}

struct OpenEdges {
    std::vector<std::uint32_t> sides;
    std::vector<std::uint32_t> corners;  // of those sides, sorted, each once
    double usual_length = 0;             // the median [m]
    double noise = 0;                    // what floats cannot express anywhere in the level [m]
};

OpenEdges open_edges(const Soup& soup, const EdgeMatches& matches) {
    OpenEdges open;
    std::vector<bool> taken(soup.vertices.size(), false);
    std::vector<double> lengths;
    for (std::uint32_t side = 0; side < matches.partner.size(); ++side) {
        if (matches.partner[side] != EdgeMatches::none) continue;
        open.sides.push_back(side);
        lengths.push_back(length(soup.corner(next_side(side)) - soup.corner(side)));
        for (const std::uint32_t corner : {soup.indices[side], soup.indices[next_side(side)]}) taken[corner] = true;
    }
    for (std::uint32_t corner = 0; corner < taken.size(); ++corner) {
        if (!taken[corner]) continue;
        open.corners.push_back(corner);
        open.noise = larger(open.noise, float_noise * largest(soup.vertices[corner]));
    }
    if (lengths.empty()) return open;
    const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
    std::nth_element(lengths.begin(), middle, lengths.end());
    open.usual_length = *middle;
    return open;
}

// Is p between a and b, and not at one of them?
bool lies_on(const Vec& p, const Vec& a, const Vec& b, double tolerance) noexcept {
    const Vec edge = b - a;
    const Vec offset = p - a;
    const double squared = dot(edge, edge);
    const double along = dot(offset, edge);
    if (along <= 0 || along >= squared) return false;
    const double near = tolerance + float_noise * larger(largest(p), larger(largest(a), largest(b)));
    const Vec apart = cross(edge, offset);
    const Vec to_end = p - b;
    return dot(apart, apart) <= near * near * squared && dot(offset, offset) > near * near &&
           dot(to_end, to_end) > near * near;
}

}  // namespace

void find_t_junctions(const Soup& soup, const EdgeMatches& matches, const CookOptions& options, CookReport& report) {
    const OpenEdges open = open_edges(soup, matches);
    if (open.sides.empty()) return;
    const double reach = options.tolerance + open.noise;
    const CornerGrid grid(soup, open.corners, larger(larger(open.usual_length, 4 * reach), 1e-6), reach);

    struct Part {
        Finding found;
        std::uint64_t unsearched = 0;
    };
    std::vector<Part> parts(static_cast<std::size_t>(options.threads));
    in_parts(open.sides.size(), options.threads, [&](std::size_t number, std::size_t begin, std::size_t end) {
        Part& part = parts[number];
        // Ordinary edges take about ten visits; what strange ones do without is counted.
        constexpr std::int64_t longest_walk = 1 << 12;
        constexpr std::size_t most_corners = 1 << 12;
        std::vector<std::uint32_t> seen;
        for (std::size_t i = begin; i < end; ++i) {
            const std::uint32_t side = open.sides[i];
            const Vec& a = soup.corner(side);
            const Vec& b = soup.corner(next_side(side));
            seen.clear();
            std::size_t asked = 0;
            const Cell first = grid.cell_at(a);
            const Cell last = grid.cell_at(b);
            // The grid has the third corner as well if another side of it is open.
            const std::uint32_t tip = next_side(next_side(side));
            const bool has_tip =
                matches.partner[tip] == EdgeMatches::none || matches.partner[next_side(side)] == EdgeMatches::none;
            const Cell with_tip = grid.cell_at(soup.corner(tip));
            const bool walked = walk(grid, a, b, longest_walk, [&](const Cell& cell) {
                const unsigned own =
                    (cell == first ? 1U : 0U) + (cell == last ? 1U : 0U) + (has_tip && cell == with_tip ? 1U : 0U);
                for (const std::uint32_t corner : grid.corners_in(cell, own)) {
                    if (++asked > most_corners) return;
                    if (corner == soup.indices[side] || corner == soup.indices[next_side(side)]) continue;
                    if (lies_on(soup.vertices[corner], a, b, options.tolerance)) seen.push_back(corner);
                }
            });
            if (!walked || asked > most_corners) ++part.unsearched;
            // A corner is in several cells if it is near their borders.
            std::sort(seen.begin(), seen.end());
            seen.erase(std::unique(seen.begin(), seen.end()), seen.end());
            for (const std::uint32_t corner : seen) {
                if (corner == soup.indices[tip]) continue;  // a sliver's own tip
                add_place(part.found, side / 3, soup.vertices[corner], options.most_places);
            }
        }
    });
    for (const Part& part : parts) {
        report.edges_unsearched += part.unsearched;
        report.t_junctions.count += part.found.count;
        for (const Finding::Place& place : part.found.places)
            if (report.t_junctions.places.size() < options.most_places) report.t_junctions.places.push_back(place);
    }
}

}  // namespace surefoot::internal
