#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <surefoot/navigation_field.hpp>

#include "field_state.hpp"
#include "follow_line.hpp"

namespace surefoot {
namespace navigation {

NavigationMinimum lowest_of(const FieldState& field, const QueryState& query, dtPolyRef polygon) {
    const vec3 goal(field.goal_inside);
    std::array<float, 3> nearest{goal.x, goal.y, goal.z};
    bool over = false;
    if (dtStatusFailed(query.detour->closestPointOnPoly(polygon, &goal.x, nearest.data(), &over)))
        return {.place = {}, .value = std::numeric_limits<double>::infinity()};
    NavigationMinimum lowest{.place = query.point(polygon, nearest.data()), .value = 0};
    lowest.value = length(lowest.place.position - field.goal.position);
    return lowest;
}

namespace {

/// From one way out to the next.
NavigationDescent follow_ways(const FieldState& field, const NavigationPoint& from) {
    NavigationDescent descent;
    const dvec3 place = field.frame.turned_in(from.position - field.frame.origin);
    const Descend first = best_way(field.ways, from.polygon.id, place, field.goal.polygon.id, field.goal_inside);
    append(descent.line, from.position);
    if (!std::isfinite(first.left)) return descent;
    for (std::uint32_t way = first.first; way != no_way; way = field.ways.all[way].next)
        append(descent.line, field.frame.out(field.ways.all[way].position), field.ways.all[way].link);
    append(descent.line, field.goal.position);
    descent.arrived = true;
    return descent;
}

}  // namespace
}  // namespace navigation

inline namespace v0 {

using navigation::FieldState;

NavigationField::NavigationField(std::unique_ptr<FieldState> state) noexcept : state_(std::move(state)) {}
NavigationField::NavigationField(NavigationField&& other) noexcept = default;
NavigationField& NavigationField::operator=(NavigationField&& other) noexcept = default;
NavigationField::~NavigationField() = default;

std::optional<NavigationField> NavigationField::make(const NavigationQuery& query, const NavigationPoint& goal,
                                                     const NavigationFieldOptions& options) {
    const navigation::QueryState& state = query.state();
    if (!state.knows(goal.polygon)) return std::nullopt;
    auto field = std::make_unique<FieldState>();
    field->options = options;
    field->goal = goal;
    field->frame = state.frame();
    field->goal_inside = field->frame.turned_in(goal.position - field->frame.origin);
    if (options.potential == NavigationPotential::walked)
        field->ways = navigation::find_ways(state, goal, options.spacing);
    return NavigationField(std::move(field));
}

NavigationPotential NavigationField::potential() const noexcept {
    return state_->options.potential;
}

const NavigationPoint& NavigationField::goal() const noexcept {
    return state_->goal;
}

double NavigationField::at(const NavigationPoint& place) const {
    if (potential() == NavigationPotential::straight) return navigation::length(place.position - state_->goal.position);
    const dvec3 inside = state_->frame.turned_in(place.position - state_->frame.origin);
    return navigation::best_way(state_->ways, place.polygon.id, inside, state_->goal.polygon.id, state_->goal_inside)
        .left;
}

std::vector<NavigationMinimum> NavigationField::minima(const NavigationQuery& query) const {
    std::vector<NavigationMinimum> found;
    // Every place from which the goal can be walked to has a way down.
    if (potential() == NavigationPotential::walked) return found;
    const dtNavMesh& detour = *query.state().ground().detour;
    navigation::each_polygon(detour, [&](dtPolyRef polygon, const dtMeshTile& tile, const dtPoly& sides) {
        if (!query.state().is_open(sides)) return;
        const NavigationMinimum lowest = navigation::lowest_of(*state_, query.state(), polygon);
        const double slack = 1e-3 + 1e-6 * lowest.value;
        bool is_lowest = lowest.value > slack;
        for (unsigned int i = sides.firstLink; i != DT_NULL_LINK && is_lowest; i = tile.links[i].next) {
            const dtMeshTile* next_tile = nullptr;
            const dtPoly* next = nullptr;
            if (dtStatusFailed(detour.getTileAndPolyByRef(tile.links[i].ref, &next_tile, &next)) ||
                next->getType() != DT_POLYTYPE_GROUND || !query.state().is_open(*next))
                continue;
            is_lowest = navigation::lowest_of(*state_, query.state(), tile.links[i].ref).value >= lowest.value - slack;
        }
        if (is_lowest) found.push_back(lowest);
    });
    return found;
}

NavigationDescent NavigationField::descend(const NavigationQuery& query, const NavigationPoint& from,
                                           const NavigationDescendOptions& options) const {
    if (potential() == NavigationPotential::straight) return navigation::climb_down(*state_, query, from, options);
    return navigation::follow_ways(*state_, from);
}

}  // namespace v0
}  // namespace surefoot
