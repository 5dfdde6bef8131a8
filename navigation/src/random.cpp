#include <algorithm>
#include <array>
#include <cmath>

#include <surefoot/random.hpp>

#include "pieces.hpp"
#include "query_state.hpp"

namespace surefoot {

namespace navigation {

void Pieces::add(dtPolyRef reference, const dtMeshTile& tile, const dtPoly& polygon) {
    const auto corner = [&](int i) { return &tile.verts[3 * static_cast<std::size_t>(polygon.verts[i])]; };
    for (int i = 2; i < polygon.vertCount; ++i) {
        const Piece piece{reference, {corner(0), corner(i - 1), corner(i)}, area_};
        const auto [a, b, c] = piece.corners;
        area_ +=
            std::abs((double{b[0]} - a[0]) * (double{c[2]} - a[2]) - (double{b[2]} - a[2]) * (double{c[0]} - a[0])) / 2;
        pieces_.push_back(piece);
    }
}

std::optional<NavigationPoint> Pieces::draw(const QueryState& state, std::uint64_t seed) const {
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
        place[axis] = static_cast<float>(a[axis] + u * (double{b[axis]} - a[axis]) + v * (double{c[axis]} - a[axis]));
    float height = 0;
    if (dtStatusSucceed(state.detour->getPolyHeight(piece.polygon, place.data(), &height))) place[1] = height;
    return state.point(piece.polygon, place.data());
}

}  // namespace navigation

inline namespace v0 {

std::optional<NavigationPoint> NavigationQuery::random(std::uint64_t seed) const {
    state_->refresh_filter();
    // Thousands of draws from one mesh look at its polygons once.
    if (const std::uint64_t changes = state_->ground().changes; changes != state_->pieces_of) {
        state_->pieces = {};
        navigation::each_polygon(*state_->ground().detour,
                                 [&](dtPolyRef reference, const dtMeshTile& tile, const dtPoly& polygon) {
                                     if (state_->is_open(polygon)) state_->pieces.add(reference, tile, polygon);
                                 });
        state_->pieces_of = changes;
    }
    return state_->pieces.draw(*state_, seed);
}

std::optional<NavigationPoint> NavigationQuery::random_reachable(const NavigationPoint& from,
                                                                 std::uint64_t seed) const {
    state_->refresh_filter();
    if (!state_->knows(from.polygon)) return std::nullopt;
    const dtNavMesh& detour = *state_->ground().detour;
    navigation::Pieces pieces;
    for (const dtPolyRef reference : navigation::reachable(detour, from.polygon.id, state_->shut)) {
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
    for (const dtPolyRef reference : navigation::reachable(*state_->ground().detour, from.polygon.id, state_->shut))
        if (state_->ground().detour->getOffMeshConnectionByRef(reference) == nullptr) found.push_back({reference});
    return found;
}

}  // namespace v0
}  // namespace surefoot
