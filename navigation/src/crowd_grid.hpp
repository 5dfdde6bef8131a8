// Who is near whom: a grid over places seen from above.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <surefoot/math.hpp>

namespace surefoot::navigation {

class CrowdGrid {
public:
    /// Cells are of side `range`, so that whoever is within it is in the nine cells around.
    void fill(std::span<const vec3> places, float range);

    /// Calls `visit(index)` for everybody in the nine cells around a place, and perhaps for some from elsewhere.
    template <typename Visit>
    void around(const vec3& place, const Visit& visit) const {
        const std::int32_t x = cell(place.x), z = cell(place.z);
        // Two cells may share a bucket; it is looked into once.
        std::uint32_t seen[9];
        std::size_t count = 0;
        for (std::int32_t i = x - 1; i <= x + 1; ++i) {
            for (std::int32_t k = z - 1; k <= z + 1; ++k) {
                const std::uint32_t at = bucket(i, k);
                bool known = false;
                for (std::size_t n = 0; n < count; ++n) known = known || seen[n] == at;
                if (known) continue;
                seen[count++] = at;
                for (std::uint32_t n = first_[at]; n < first_[at + 1]; ++n) visit(sorted_[n]);
            }
        }
    }

private:
    [[nodiscard]] std::int32_t cell(float along) const;
    [[nodiscard]] std::uint32_t bucket(std::int32_t x, std::int32_t z) const {
        const std::uint32_t mixed =
            static_cast<std::uint32_t>(x) * 73856093U ^ static_cast<std::uint32_t>(z) * 19349663U;
        return mixed & mask_;
    }

    float range_ = 1;
    std::uint32_t mask_ = 0;
    std::vector<std::uint32_t> first_{0, 0};  ///< of each bucket in `sorted_`, and the end
    std::vector<std::uint32_t> sorted_;
};

}  // namespace surefoot::navigation
