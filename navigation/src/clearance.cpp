#include "clearance.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace surefoot::navigation {
namespace {

// Distances are in halves of a cell, as whole numbers: 2 along a side, 3 across a corner.
constexpr int side = 2;
constexpr int corner = 3;
constexpr std::uint16_t far_away = 0xffff;

bool is_solid_between(const rcHeightfield& solid, int x, int z, int low, int high) {
    if (x < 0 || z < 0 || x >= solid.width || z >= solid.height) return false;
    for (const rcSpan* span = solid.spans[x + z * solid.width]; span != nullptr; span = span->next)
        if (static_cast<int>(span->smax) > low && static_cast<int>(span->smin) < high) return true;
    return false;
}

/// The span beside `span` in a direction, or -1.
int beside(const rcCompactHeightfield& ground, const rcCompactSpan& span, int x, int z, int direction) {
    const int connection = rcGetCon(span, direction);
    if (connection == RC_NOT_CONNECTED) return -1;
    const int at = (x + rcGetDirOffsetX(direction)) + (z + rcGetDirOffsetY(direction)) * ground.width;
    return static_cast<int>(ground.cells[at].index) + connection;
}

struct Edge {
    bool wall = false;
    bool drop = false;
};

Edge edge_of(const rcHeightfield& solid, const rcCompactHeightfield& ground, int x, int z, int index, int climb,
             int height) {
    Edge edge;
    const rcCompactSpan& span = ground.spans[index];
    for (int direction = 0; direction < 4; ++direction) {
        const int next = beside(ground, span, x, z, direction);
        if (next >= 0) {
            if (ground.areas[next] != RC_NULL_AREA) continue;
            // Steep ground stands in the way uphill, and is a way to fall downhill.
            (ground.spans[next].y > span.y ? edge.wall : edge.drop) = true;
            continue;
        }
        const int floor = span.y;
        const bool stops = is_solid_between(solid, x + rcGetDirOffsetX(direction), z + rcGetDirOffsetY(direction),
                                            floor + climb, floor + height);
        (stops ? edge.wall : edge.drop) = true;
    }
    return edge;
}

/// Finds ground that rises by more than a step within the depth that a step needs: a step of narrow treads, or a bank
/// so short that its cells hold some of the ground below and above it and count as such. Cell by cell it can be
/// climbed; feet find no hold there.
class Banks {
public:
    Banks(const rcCompactHeightfield& ground, int climb, double depth)
        : ground_(ground),
          climb_(climb),
          straight_(static_cast<int>(depth / static_cast<double>(ground.cs) + 1e-3)),
          across_(static_cast<int>(depth / (static_cast<double>(ground.cs) * 1.4143) + 1e-3)) {}

    /// Calls `visit(index)` for every span in the middle of such a rise.
    template <typename Visit>
    void each(const Visit& visit) const {
        for (int z = 0; z < ground_.height; ++z) {
            for (int x = 0; x < ground_.width; ++x) {
                const rcCompactCell& cell = ground_.cells[x + z * ground_.width];
                for (unsigned i = cell.index, end = i + cell.count; i < end; ++i)
                    for (int direction = 0; direction < 4; ++direction) {
                        if (straight_ >= 2) rise(static_cast<int>(i), x, z, direction, direction, straight_, visit);
                        for (const int turn : {(direction + 1) % 4, (direction + 3) % 4})
                            if (across_ >= 1) rise(static_cast<int>(i), x, z, direction, turn, 2 * across_, visit);
                    }
            }
        }
    }

private:
    /// So many cells on, by turns in the one direction and in the other.
    template <typename Visit>
    void rise(int from, int x, int z, int direction, int turn, int cells, const Visit& visit) const {
        int middle = from;
        int here = from;
        for (int step = 0; step < cells; ++step) {
            const int way = step % 2 == 0 ? direction : turn;
            here = beside(ground_, ground_.spans[here], x, z, way);
            if (here < 0) return;
            x += rcGetDirOffsetX(way);
            z += rcGetDirOffsetY(way);
            if (step == (cells - 1) / 2) middle = here;
        }
        if (static_cast<int>(ground_.spans[here].y) - static_cast<int>(ground_.spans[from].y) > climb_) visit(middle);
    }

    const rcCompactHeightfield& ground_;
    int climb_;
    int straight_;  ///< cells along a side that are no deeper
    int across_;    ///< the same over corners
};

/// For every span how far the nearest wall is, over connected ground.
class WallDistance {
public:
    WallDistance(const rcCompactHeightfield& ground, std::vector<std::uint16_t>& distance)
        : ground_(ground), distance_(distance) {}

    void spread() {
        for (int z = 0; z < ground_.height; ++z)
            for (int x = 0; x < ground_.width; ++x) at(x, z, 0, 3);
        for (int z = ground_.height - 1; z >= 0; --z)
            for (int x = ground_.width - 1; x >= 0; --x) at(x, z, 2, 1);
    }

private:
    /// Takes what comes from `first` and, beyond it, from the corner towards `turn`; and the same from `turn`.
    void at(int x, int z, int first, int turn) {
        const rcCompactCell& cell = ground_.cells[x + z * ground_.width];
        for (unsigned i = cell.index, end = i + cell.count; i < end; ++i) {
            take(static_cast<int>(i), x, z, first, turn);
            take(static_cast<int>(i), x, z, turn, (first + 2) % 4);
        }
    }
    void take(int index, int x, int z, int direction, int turn) {
        const int next = beside(ground_, ground_.spans[index], x, z, direction);
        if (next < 0) return;
        improve(index, next, side);
        const int diagonal =
            beside(ground_, ground_.spans[next], x + rcGetDirOffsetX(direction), z + rcGetDirOffsetY(direction), turn);
        if (diagonal >= 0) improve(index, diagonal, corner);
    }
    void improve(int index, int from, int cost) {
        std::uint16_t& mine = distance_[static_cast<std::size_t>(index)];
        mine = static_cast<std::uint16_t>(std::min<int>(mine, distance_[static_cast<std::size_t>(from)] + cost));
    }

    const rcCompactHeightfield& ground_;
    std::vector<std::uint16_t>& distance_;
};

}  // namespace

void bar_banks(rcCompactHeightfield& ground, int climb, double depth) {
    std::vector<int> barred;
    Banks(ground, climb, depth).each([&](int span) { barred.push_back(span); });
    for (const int span : barred) ground.areas[span] = RC_NULL_AREA;
}

void keep_clear(rcHeightfield& solid, rcCompactHeightfield& ground, int radius, int climb, int height) {
    std::vector<std::uint16_t> distance(static_cast<std::size_t>(ground.spanCount), far_away);
    std::vector<bool> edge(static_cast<std::size_t>(ground.spanCount), false);
    for (int z = 0; z < ground.height; ++z) {
        for (int x = 0; x < ground.width; ++x) {
            const rcCompactCell& cell = ground.cells[x + z * ground.width];
            for (unsigned i = cell.index, end = i + cell.count; i < end; ++i) {
                if (ground.areas[i] == RC_NULL_AREA) continue;
                // Beyond the border of what was looked at is nothing that is known.
                if (x == 0 || z == 0 || x == ground.width - 1 || z == ground.height - 1) continue;
                const Edge found = edge_of(solid, ground, x, z, static_cast<int>(i), climb, height);
                if (found.wall) distance[i] = 0;
                edge[i] = found.drop;
            }
        }
    }
    WallDistance(ground, distance).spread();
    for (std::size_t i = 0; i < distance.size(); ++i)
        if (distance[i] < side * radius - 1 || edge[i]) ground.areas[i] = RC_NULL_AREA;
}

}  // namespace surefoot::navigation
