// Edges and corners that are not there: between two triangles of one floor there is an edge in the data, but nothing
// for a foot to catch on.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "character/surroundings.hpp"

namespace surefoot::internal {

/// The surfaces that a touch really is against.
struct Faces {
    static constexpr std::size_t most = 6;

    std::array<Vec, most> normals{};
    std::size_t count = 0;
    bool replaced = false;  ///< the touch's own normal was none of the surface's
    Vec surface;            ///< as `surface_under` tells it

    [[nodiscard]] std::span<const Vec> get() const noexcept { return {normals.data(), count}; }
    void add(const Vec& normal) noexcept;
};

/// A touch on an edge or a corner is against what its normal says if no surface that holds the point of touch reaches
/// out in front of the plane of that normal. Where one does, the shape would have met that surface before: the edge is
/// an inner one, and the touch is against the faces that reach out and have all of the touched triangle behind them,
/// and against that triangle's own face, as far as the body is in front of them. A surface holds
/// a point that is half the `skin` away or less; `centre` is where the body is, to tell which side of a face it is on.
/// A body with edges may touch a face flat at its border: what lies behind another face there, which goes on in front
/// of it, is hidden by that one, as the sides of the blocks of a wall are.
[[nodiscard]] Faces faces_of(const Touch& touch, const Surroundings& surroundings, const Body& body, double skin,
                             const Vec& centre, const Vec& up) noexcept;

/// The normal of the surface that holds the point of touch and looks most along `up`, turned towards the body; the
/// touch's own if there is none.
[[nodiscard]] Vec surface_under(const Touch& touch, const Surroundings& surroundings, double skin, const Vec& centre,
                                const Vec& up) noexcept;

}  // namespace surefoot::internal
