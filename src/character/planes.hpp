// What a moving body may not do: a set of half-spaces through where it is, and the motion nearest to a wish that
// violates none of them.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "vec.hpp"

namespace surefoot::internal {

/// How far a motion may go against a plane and still count as along it, as a share of the motion. A tenth of a metre
/// goes 1e-8 m deep: the noise in the normals of edges, many orders below any skin.
inline constexpr double along_tolerance = 1e-7;

/// Planes that are met at one place, each by the unit normal that points to where there is room.
class Planes3 {
public:
    static constexpr std::size_t most = 24;

    /// False, and nothing is added, if there is no room for one more. A normal that is there already, to rounding, is
    /// not added again.
    bool add(const Vec& normal) noexcept;

    [[nodiscard]] std::span<const Vec> normals() const noexcept { return {normals_.data(), count_}; }

    /// Is this normal there already, to rounding?
    [[nodiscard]] bool has(const Vec& normal) const noexcept;

    /// The motion that is nearest to `wish` and violates none: the wish itself, its projection on one plane, on the
    /// crease of two, or no motion at all. Exact but for rounding: the conditions of Karush, Kuhn and Tucker are
    /// checked one set of planes after the other, and there is one solution only.
    [[nodiscard]] Vec nearest_to(const Vec& wish) const noexcept;

    /// The same where rising and sinking cost next to nothing, so that going up a slope takes nothing away from the
    /// motion as seen from above. `up` is of unit length.
    [[nodiscard]] Vec nearest_on_foot(const Vec& wish, const Vec& up) const noexcept;

private:
    std::array<Vec, most> normals_{};
    std::size_t count_ = 0;
};

}  // namespace surefoot::internal
