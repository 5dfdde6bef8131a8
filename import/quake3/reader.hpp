/// A Quake III map (IBSP 46) as a level: its surfaces, patches and clip brushes as triangles, its entities as markers.
#pragma once

#include <cstddef>
#include <span>

#include <surefoot/import.hpp>

#include "level_builder.hpp"
#include "placement.hpp"

namespace surefoot::internal::quake3 {

struct MapOptions {
    double tolerance = 0.01;  ///< of patches [m]
    Quake3Solids solids = Quake3Solids::drawn;
};

/// Any bytes are fine: the answer is a level or an Error without a file name, whose text begins with the lump and byte.
/// Takes time and memory within the limits, whatever the bytes.
[[nodiscard]] Expected<ImportedLevel> read_bsp(std::span<const std::byte> file, const Placement& placement,
                                               const ReadLimits& limits, const MapOptions& options);

}  // namespace surefoot::internal::quake3
