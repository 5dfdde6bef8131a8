/// Entities become markers: starts, items, jump pads, teleporters, movers.
#pragma once

#include <string_view>
#include <vector>

#include <surefoot/import.hpp>

#include "entities.hpp"
#include "map.hpp"
#include "placement.hpp"

namespace surefoot::internal::quake3 {

/// What a class of entities is to a game: "spawn", "item", ...; empty for the rest.
[[nodiscard]] std::string_view kind_of(std::string_view class_name);

/// A marker for every entity but the world, in the order of the file.
[[nodiscard]] std::vector<ImportedMarker> markers_of(const Map& map, const std::vector<Entity>& entities,
                                                     const Placement& placement);

}  // namespace surefoot::internal::quake3
