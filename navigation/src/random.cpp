#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "query_state.hpp"

namespace surefoot {

namespace navigation {
namespace {

/// The next of a row of numbers that look random (SplitMix64), in [0, 1).
double next_share(std::uint64_t& state) {
    state += 0x9e3779b97f4a7c15U;
    std::uint64_t bits = state;
    bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9U;
    bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebU;
    bits ^= bits >> 31;
    return static_cast<double>(bits >> 11) * 0x1p-53;
}

/// A triangle of the fan that a polygon is, with the area of all before it.
struct Piece {
    dtPolyRef polygon = 0;
    std::array<const float*, 3> corners{};
    double area_before = 0;
};

/// Triangles that places are drawn from.
class Pieces {
public:
    void add(dtPolyRef reference, const dtMeshTile& tile, const dtPoly& polygon) {
        const auto corner = [&](int i) { return &tile.verts[3 * static_cast<std::size_t>(polygon.verts[i])]; };
        for (int i = 2; i < polygon.vertCount; ++i) {
            const Piece piece{reference, {corner(0), corner(i - 1), corner(i)}, area_};
            const auto [a, b, c] = piece.corners;
            area_ += std::abs((double{b[0]} - a[0]) * (double{c[2]} - a[2]) -
                              (double{b[2]} - a[2]) * (double{c[0]} - a[0])) /
                     2;
            pieces_.push_back(piece);
        }
    }

    [[nodiscard]] std::optional<NavigationPoint> draw(const QueryState& state, std::uint64_t seed) const {
        if (pieces_.empty()) return std::nullopt;
        const double area = next_share(seed) * area_;
        const auto after = std::upper_bound(pieces_.begin(), pieces_.end(), area,
                                            [](double value, const Piece& piece) { return value < piece.area_before; });
        const Piece& piece = *std::prev(after);
        const auto [a, b, c] = piece.corners;
        double u = next_share(seed);
        double v = next_share(seed);
        if (u + v > 1) {
            u = 1 - u;
            v = 1 - v;
        }
        std::array<float, 3> place{};
        for (std::size_t axis = 0; axis < 3; ++axis)
            place[axis] =
                static_cast<float>(a[axis] + u * (double{b[axis]} - a[axis]) + v * (double{c[axis]} - a[axis]));
        float height = 0;
        if (dtStatusSucceed(state.detour->getPolyHeight(piece.polygon, place.data(), &height))) place[1] = height;
        return state.point(piece.polygon, place.data());
    }

private:
    std::vector<Piece> pieces_;
    double area_ = 0;
};

}  // namespace
}  // namespace navigation

inline namespace v0 {

std::optional<NavigationPoint> NavigationQuery::random(std::uint64_t seed) const {
    state_->refresh_filter();
    navigation::Pieces pieces;
    navigation::each_polygon(*state_->ground().detour,
                             [&](dtPolyRef reference, const dtMeshTile& tile, const dtPoly& polygon) {
                                 if (navigation::is_open(polygon)) pieces.add(reference, tile, polygon);
                             });
    return pieces.draw(*state_, seed);
}

std::optional<NavigationPoint> NavigationQuery::random_reachable(const NavigationPoint& from,
                                                                 std::uint64_t seed) const {
    state_->refresh_filter();
    if (!state_->knows(from.polygon)) return std::nullopt;
    const dtNavMesh& detour = *state_->ground().detour;
    navigation::Pieces pieces;
    for (const dtPolyRef reference : navigation::reachable(detour, from.polygon.id)) {
        const dtMeshTile* tile = nullptr;
        const dtPoly* polygon = nullptr;
        detour.getTileAndPolyByRefUnsafe(reference, &tile, &polygon);
        if (polygon->getType() == DT_POLYTYPE_GROUND) pieces.add(reference, *tile, *polygon);
    }
    return pieces.draw(*state_, seed);
}

std::vector<NavigationPolygon> NavigationQuery::reachable(const NavigationPoint& from) const {
    state_->refresh_filter();
    std::vector<NavigationPolygon> found;
    if (!state_->knows(from.polygon)) return found;
    for (const dtPolyRef reference : navigation::reachable(*state_->ground().detour, from.polygon.id))
        if (state_->ground().detour->getOffMeshConnectionByRef(reference) == nullptr) found.push_back({reference});
    return found;
}

}  // namespace v0
}  // namespace surefoot
