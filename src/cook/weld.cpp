#include "cook/weld.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/weld.hpp"

namespace surefoot::internal {
namespace {

constexpr std::uint32_t nobody = 0xFFFFFFFF;

// Welding within a tolerance, in the order of the vertices: each goes to the first representative that is near enough,
// and becomes one itself if there is none. So nothing moves farther than the tolerance, however dense the vertices are.
class NearWelder {
public:
    NearWelder(std::span<const dvec3> vertices, double tolerance) : vertices_(vertices), tolerance_(tolerance) {
        std::size_t size = 16;
        while (size < 2 * vertices.size()) size *= 2;
        first_in_cell_.assign(size, nobody);
        next_in_cell_.assign(vertices.size(), nobody);
    }

    std::uint32_t representative_of(std::uint32_t vertex) {
        const Vec place = to_vec(vertices_[vertex]);
        std::uint32_t best = nobody;
        // Cells are as wide as the tolerance, so whatever is near enough is in the cell or in one beside it.
        for (int corner = 0; corner < 27; ++corner) {
            const int along[3] = {corner % 3 - 1, corner / 3 % 3 - 1, corner / 9 - 1};
            const Vec offset{double(along[0]), double(along[1]), double(along[2])};
            for (std::uint32_t other = first_in_cell_[cell_of(place, offset)]; other != nobody;
                 other = next_in_cell_[other]) {
                const Vec apart = to_vec(vertices_[other]) - place;
                if (dot(apart, apart) <= tolerance_ * tolerance_) best = std::min(best, other);
            }
        }
        if (best != nobody) return best;
        std::uint32_t& first = first_in_cell_[cell_of(place, {0, 0, 0})];
        next_in_cell_[vertex] = first;
        first = vertex;
        return vertex;
    }

private:
    [[nodiscard]] std::size_t cell_of(const Vec& place, const Vec& offset) const {
        std::uint64_t hash = 0;
        for (const double x :
             {place.x / tolerance_ + offset.x, place.y / tolerance_ + offset.y, place.z / tolerance_ + offset.z}) {
            // Down to a whole number; a coordinate over a tolerance that small is whole already.
            const double most = 0x1p62;
            const double within = x > most ? most : x < -most ? -most : x;
            auto cell = static_cast<std::int64_t>(within);
            if (static_cast<double>(cell) > within) --cell;
            hash = (hash ^ static_cast<std::uint64_t>(cell)) * 0x9E3779B97F4A7C15;
            hash ^= hash >> 29U;
        }
        return static_cast<std::size_t>(hash) & (first_in_cell_.size() - 1);
    }

    std::span<const dvec3> vertices_;
    double tolerance_;
    std::vector<std::uint32_t> first_in_cell_;
    std::vector<std::uint32_t> next_in_cell_;
};

}  // namespace

Soup weld(std::span<const dvec3> vertices, std::span<const std::uint32_t> indices, double tolerance,
          CookReport& report) {
    report.vertices_given = vertices.size();
    std::vector<std::uint32_t> place = same_places(vertices);
    std::vector<bool> used(vertices.size(), false);
    for (const std::uint32_t index : indices) used[index] = true;
    std::vector<bool> wanted(vertices.size(), false);
    for (std::uint32_t i = 0; i < used.size(); ++i) {
        if (!used[i]) ++report.vertices_unused;
        if (used[i]) wanted[place[i]] = true;
    }
    if (tolerance > 0) {
        NearWelder near(vertices, tolerance);
        std::vector<std::uint32_t> target(vertices.size(), nobody);
        for (std::uint32_t i = 0; i < target.size(); ++i)
            if (place[i] == i && wanted[i]) target[i] = near.representative_of(i);
        for (std::uint32_t i = 0; i < target.size(); ++i) {
            if (!used[i]) continue;
            place[i] = target[place[i]];
            const Vec apart = to_vec(vertices[place[i]]) - to_vec(vertices[i]);
            const double moved = std::sqrt(dot(apart, apart));
            if (moved > 0) ++report.vertices_moved;
            report.largest_move = larger(report.largest_move, moved);
        }
    }
    Soup soup;
    std::vector<std::uint32_t> number(vertices.size(), nobody);
    soup.indices.resize(indices.size());
    // Vertices keep their order: programs write neighbours near each other, and everything after this profits from it.
    for (std::uint32_t i = 0; i < place.size(); ++i) {
        if (!used[i] || number[place[i]] != nobody) continue;
        number[place[i]] = static_cast<std::uint32_t>(soup.vertices.size());
        soup.vertices.push_back(to_vec(vertices[place[i]]));
    }
    for (std::size_t i = 0; i < indices.size(); ++i) soup.indices[i] = number[place[indices[i]]];
    report.vertices_kept = soup.vertices.size();
    return soup;
}

void weld_again(Soup& soup) {
    std::vector<dvec3> vertices(soup.vertices.size());
    std::transform(soup.vertices.begin(), soup.vertices.end(), vertices.begin(),
                   [](const Vec& v) { return to_dvec3(v); });
    const std::vector<std::uint32_t> place = same_places(std::span<const dvec3>(vertices));
    for (std::uint32_t& index : soup.indices) index = place[index];
}

}  // namespace surefoot::internal
