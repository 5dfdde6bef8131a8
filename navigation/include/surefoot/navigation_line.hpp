/// A line on a navigation mesh, as it is followed.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <surefoot/math.hpp>

namespace [[gnu::visibility("default")]] surefoot {
inline namespace v0 {

/// A line on the mesh with the links on it, measured from its beginning.
struct NavigationLine {
    struct Point {
        dvec3 position{0, 0, 0};
        double along = 0;                     ///< from the beginning [m]
        std::optional<std::uint32_t> link{};  ///< begins here and ends at the next point
    };
    std::vector<Point> points;

    [[nodiscard]] double length() const noexcept { return points.empty() ? 0 : points.back().along; }
};

}  // namespace v0
}  // namespace surefoot
