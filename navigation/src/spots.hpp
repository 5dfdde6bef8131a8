// Numbered places in a grid: which of them are near another place?
#pragma once

#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include <surefoot/math.hpp>

namespace surefoot::navigation {

class Spots {
public:
    /// `reach`: what is farther away need not be found [m, > 0].
    explicit Spots(double reach) : reach_(reach) {}

    void add(const dvec3& place, std::uint32_t number) { cells_[key(cell(place, 0, 0, 0))].push_back(number); }

    /// Asks about all that are within reach, and others, until one is true.
    template <typename IsIt>
    bool any_near(const dvec3& place, const IsIt& is_it) const {
        for (int x = -1; x <= 1; ++x)
            for (int y = -1; y <= 1; ++y)
                for (int z = -1; z <= 1; ++z) {
                    const auto found = cells_.find(key(cell(place, x, y, z)));
                    if (found == cells_.end()) continue;
                    for (const std::uint32_t number : found->second)
                        if (is_it(number)) return true;
                }
        return false;
    }

private:
    struct Cell {
        std::int64_t x = 0, y = 0, z = 0;
    };
    [[nodiscard]] Cell cell(const dvec3& place, int x, int y, int z) const {
        return {static_cast<std::int64_t>(std::floor(place.x / reach_)) + x,
                static_cast<std::int64_t>(std::floor(place.y / reach_)) + y,
                static_cast<std::int64_t>(std::floor(place.z / reach_)) + z};
    }
    /// Cells that share a key only cost time.
    [[nodiscard]] static std::uint64_t key(const Cell& cell) {
        const auto bits = [](std::int64_t at) { return static_cast<std::uint64_t>(at) & 0x1fffff; };
        return bits(cell.x) | bits(cell.y) << 21 | bits(cell.z) << 42;
    }

    double reach_;
    std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> cells_;
};

}  // namespace surefoot::navigation
