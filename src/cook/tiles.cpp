#include "cook/tiles.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "cook/weld.hpp"

namespace surefoot::internal {
namespace {

// A float holds whole numbers up to 2^24, so relative to an origin no more than a tile away it holds every multiple of
// the grid. Origins are multiples of a tile and so of every grid that is in use: a vertex on the grid is the same real
// point whatever tile looks at it.
constexpr double tile_size = 1024;       // [m]
constexpr double finest_grid = 0x1p-14;  // [m] tile_size * 2^-24
constexpr double steps_in_tile = 0x1p24;
constexpr std::size_t most_tiles = 65535;

// To the nearest multiple of a power of two. Requires: |x| / grid < 2^51.
double rounded(double x, double grid) noexcept {
    constexpr double no_fraction_left = 0x1.8p52;
    return (x / grid + no_fraction_left - no_fraction_left) * grid;
}

Vec rounded(const Vec& v, double grid) noexcept {
    return {rounded(v.x, grid), rounded(v.y, grid), rounded(v.z, grid)};
}

using TileCell = std::array<double, 3>;

struct Assignment {
    std::vector<TileCell> origin;   // of each triangle
    std::vector<TileCell> origins;  // sorted, each once
    std::vector<double> grid;       // of each vertex
};

Assignment assign(const Soup& soup, double size) {
    Assignment result;
    result.origin.resize(soup.triangle_count());
    result.grid.assign(soup.vertices.size(), finest_grid);
    for (std::uint32_t id = 0; id < result.origin.size(); ++id) {
        Vec low = soup.corner(3 * id);
        Vec high = low;
        for (const std::uint32_t side : {3 * id + 1, 3 * id + 2}) {
            const Vec& v = soup.corner(side);
            low = {smaller(low.x, v.x), smaller(low.y, v.y), smaller(low.z, v.z)};
            high = {larger(high.x, v.x), larger(high.y, v.y), larger(high.z, v.z)};
        }
        const Vec origin = rounded((low + high) * 0.5, size);
        // Rounding to the grid may carry a vertex outwards by one step.
        const double reach = larger(largest(low - origin), largest(high - origin));
        double grid = finest_grid;
        while (reach > (steps_in_tile - 1) * grid) grid *= 2;
        for (std::uint32_t side = 3 * id; side < 3 * id + 3; ++side) {
            double& finest_for_all = result.grid[soup.indices[side]];
            finest_for_all = larger(finest_for_all, grid);
        }
        result.origin[id] = {origin.x, origin.y, origin.z};
    }
    result.origins = result.origin;
    std::sort(result.origins.begin(), result.origins.end());
    result.origins.erase(std::unique(result.origins.begin(), result.origins.end()), result.origins.end());
    return result;
}

void note_move(const Vec& from, const Vec& to, CookReport& report) {
    const Vec apart = to - from;
    const double moved = std::sqrt(dot(apart, apart));
    if (moved > 0) ++report.vertices_moved;
    report.largest_move = larger(report.largest_move, moved);
}

vec3 to_floats(const Vec& v) noexcept {
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

Tiles one_tile(Soup& soup, CookReport& report) {
    Tiles tiles;
    tiles.vertices.reserve(soup.vertices.size());
    bool moved = false;
    for (Vec& v : soup.vertices) {
        const vec3 stored = to_floats(v);
        const Vec now = to_vec(dvec3(stored));
        moved = moved || now.x != v.x || now.y != v.y || now.z != v.z;
        note_move(v, now, report);
        v = now;
        tiles.vertices.push_back(stored);
    }
    if (moved) weld_again(soup);
    tiles.indices = soup.indices;
    report.tiles = 1;
    return tiles;
}

}  // namespace

Tiles cut_into_tiles(Soup& soup, CookReport& report) {
    double reach = 0;
    bool floats = true;  // then tiles could only make them coarser
    for (const Vec& v : soup.vertices) {
        reach = larger(reach, largest(v));
        floats = floats && to_vec(dvec3(to_floats(v))) == v;
    }
    if (floats || reach <= tile_size) return one_tile(soup, report);

    double size = tile_size;
    Assignment assignment = assign(soup, size);
    while (assignment.origins.size() > most_tiles) assignment = assign(soup, size *= 2);
    for (std::size_t i = 0; i < soup.vertices.size(); ++i) {
        const Vec now = rounded(soup.vertices[i], assignment.grid[i]);
        note_move(soup.vertices[i], now, report);
        soup.vertices[i] = now;
    }
    weld_again(soup);

    Tiles tiles;
    for (const TileCell& origin : assignment.origins) tiles.origins.emplace_back(origin[0], origin[1], origin[2]);
    report.tiles = tiles.origins.size();
    tiles.of.resize(soup.triangle_count());
    tiles.indices.resize(soup.indices.size());
    // A vertex is written once for each tile that uses it: corners by tile, then by vertex, number them.
    struct Use {
        std::uint64_t tile_and_vertex;
        std::uint32_t side;
    };
    std::vector<Use> uses(soup.indices.size());
    for (std::uint32_t side = 0; side < uses.size(); ++side) {
        const auto tile = static_cast<std::uint16_t>(
            std::lower_bound(assignment.origins.begin(), assignment.origins.end(), assignment.origin[side / 3]) -
            assignment.origins.begin());
        tiles.of[side / 3] = tile;
        uses[side] = {std::uint64_t{tile} << 32U | soup.indices[side], side};
    }
    std::sort(uses.begin(), uses.end(), [](const Use& a, const Use& b) {
        return a.tile_and_vertex != b.tile_and_vertex ? a.tile_and_vertex < b.tile_and_vertex : a.side < b.side;
    });
    for (std::size_t i = 0; i < uses.size(); ++i) {
        if (i == 0 || uses[i].tile_and_vertex != uses[i - 1].tile_and_vertex) {
            const Vec origin = to_vec(tiles.origins[tiles.of[uses[i].side / 3]]);
            tiles.vertices.push_back(to_floats(soup.corner(uses[i].side) - origin));
        }
        tiles.indices[uses[i].side] = static_cast<std::uint32_t>(tiles.vertices.size() - 1);
    }
    return tiles;
}

}  // namespace surefoot::internal
