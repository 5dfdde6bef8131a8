#include <algorithm>
#include <cassert>
#include <chrono>
#include <cmath>

#include <surefoot/navigation_mesh.hpp>

#include "mesh_state.hpp"
#include "tiles.hpp"

namespace surefoot {
inline namespace v0 {

using navigation::MeshState;
using navigation::Plan;
using navigation::TileMesh;

namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::vector<NavigationArea> areas_of(const NavigationOptions& options) {
    if (options.areas.empty()) return {NavigationArea{.name = "ground"}};
    return {options.areas.begin(), options.areas.end()};
}

std::size_t most_polygons(std::span<const TileMesh> tiles) {
    // Twice as many as there are, and some more: links and what is built later need names, too.
    std::size_t most = 128;
    for (const TileMesh& tile : tiles) most = std::max(most, 2 * tile.areas.size());
    return most;
}

}  // namespace

NavigationMesh::NavigationMesh(std::unique_ptr<MeshState> state) noexcept : state_(std::move(state)) {}
NavigationMesh::NavigationMesh(NavigationMesh&& other) noexcept = default;
NavigationMesh& NavigationMesh::operator=(NavigationMesh&& other) noexcept = default;
NavigationMesh::~NavigationMesh() = default;

Expected<NavigationMesh> NavigationMesh::build(const World& world, const CharacterSettings& settings,
                                               const NavigationOptions& options) {
    const auto start = std::chrono::steady_clock::now();
    Expected<Plan> plan = navigation::make_plan(world, settings, options);
    if (!plan) return tl::unexpected(plan.error());
    auto state = std::make_unique<MeshState>();
    state->plan = *plan;
    state->areas = areas_of(options);
    std::vector<std::pair<int, int>> places;
    for (int z = 0; z < plan->tiles_z; ++z)
        for (int x = 0; x < plan->tiles_x; ++x) places.emplace_back(x, z);
    Expected<std::vector<TileMesh>> tiles = navigation::build_tiles(world, settings, options, *plan, places);
    if (!tiles) return tl::unexpected(tiles.error());
    state->tile_meshes = *std::move(tiles);
    auto detour = navigation::make_detour(*plan, most_polygons(state->tile_meshes));
    if (!detour) return tl::unexpected(detour.error());
    state->detour = *std::move(detour);
    for (const TileMesh& tile : state->tile_meshes)
        if (const auto put = navigation::put_tile(*state, tile); !put) return tl::unexpected(put.error());
    for (const NavigationRegion& region : options.regions)
        if (auto missing = navigation::missing_ground(*state, region)) return tl::unexpected(*std::move(missing));
    state->seconds = seconds_since(start);
    return NavigationMesh(std::move(state));
}

Expected<std::size_t> NavigationMesh::rebuild(const World& world, const CharacterSettings& settings,
                                              const NavigationOptions& options, const Bounds& changed) {
    const Plan& plan = state_->plan;
    const double border = (plan.border_cells() + 1) * plan.cell_size;
    dvec3 low(1e300);
    dvec3 high(-1e300);
    for (int corner = 0; corner < 8; ++corner) {
        const dvec3 place{corner & 1 ? changed.max.x : changed.min.x, corner & 2 ? changed.max.y : changed.min.y,
                          corner & 4 ? changed.max.z : changed.min.z};
        const dvec3 inside = plan.frame.turned_in(place - plan.frame.origin);
        for (int axis = 0; axis < 3; ++axis) {
            low[axis] = std::min(low[axis], inside[axis] - border);
            high[axis] = std::max(high[axis], inside[axis] + border);
        }
    }
    const auto tile = [&](double at, std::int32_t count) {
        return static_cast<int>(std::clamp(std::floor(at / plan.tile_size), -1.0, static_cast<double>(count)));
    };
    std::vector<std::pair<int, int>> places;
    for (int z = std::max(tile(low.z, plan.tiles_z), 0); z <= std::min(tile(high.z, plan.tiles_z), plan.tiles_z - 1);
         ++z)
        for (int x = std::max(tile(low.x, plan.tiles_x), 0);
             x <= std::min(tile(high.x, plan.tiles_x), plan.tiles_x - 1); ++x)
            places.emplace_back(x, z);
    Expected<std::vector<TileMesh>> tiles = navigation::build_tiles(world, settings, options, plan, places);
    if (!tiles) return tl::unexpected(tiles.error());
    if (auto fault = navigation::replace_tiles(*state_, *std::move(tiles))) return tl::unexpected(*std::move(fault));
    return places.size();
}

const NavigationAgent& NavigationMesh::agent() const noexcept {
    return state_->plan.agent;
}
const dvec3& NavigationMesh::up() const noexcept {
    return state_->plan.frame.y;
}
std::span<const NavigationArea> NavigationMesh::areas() const noexcept {
    return state_->areas;
}
std::span<const NavigationLink> NavigationMesh::links() const noexcept {
    return state_->links;
}

bool NavigationMesh::set_area(std::uint32_t area, bool closed, double cost) noexcept {
    const bool known = area < state_->areas.size() && cost >= 1 && cost <= navigation::most_cost;
    assert(known && "NavigationMesh::set_area: an area that is there, and a cost from 1 to 1e6");
    if (!known) return false;
    ++state_->changes;
    state_->areas[area].closed = closed;
    state_->areas[area].cost = cost;
    navigation::change_flags(*state_->detour, [&](const dtPoly& polygon) {
        // A link is no ground: it is open as long as both its ends are.
        if (polygon.getType() != DT_POLYTYPE_GROUND || polygon.getArea() != navigation::detour_area(area))
            return polygon.flags;
        return static_cast<std::uint16_t>(closed ? polygon.flags | navigation::closed
                                                 : polygon.flags & ~navigation::closed);
    });
    return true;
}

void NavigationMesh::take_out(std::span<const NavigationPolygon> polygons, bool out) noexcept {
    ++state_->changes;
    for (const NavigationPolygon& polygon : polygons) {
        unsigned short flags = 0;
        if (dtStatusFailed(state_->detour->getPolyFlags(polygon.id, &flags))) continue;
        state_->detour->setPolyFlags(polygon.id, static_cast<unsigned short>(out ? flags | navigation::taken_out
                                                                                 : flags & ~navigation::taken_out));
    }
}

}  // namespace v0
}  // namespace surefoot
