// What building has decided before the first tile: the frame, the grid of tiles, and the agent in cells.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <surefoot/error.hpp>
#include <surefoot/navigation_build.hpp>

#include "frame.hpp"

namespace surefoot::navigation {

/// Plain, as it is kept in files.
struct Plan {
    Frame frame;
    NavigationAgent agent;
    double cell_size = 0;    ///< [m]
    double cell_height = 0;  ///< [m]
    double tile_size = 0;    ///< [m]
    std::int32_t tile_cells = 0;
    std::int32_t tiles_x = 0;  ///< tiles cover [0, tiles_x * tile_size] of the frame's x, and z likewise
    std::int32_t tiles_z = 0;
    float low = 0;  ///< all ground lies above it, in the frame [m]
    float high = 0;
    std::uint64_t layers = all_layers;

    /// How many cells around a tile are looked at: walls beyond its border count within the agent's radius.
    [[nodiscard]] int border_cells() const;
};

/// A triangle of the ground in the frame, and which area it is of; 0: nobody stands on it.
struct GroundTriangle {
    vec3 corners[3];
    std::uint8_t area = 0;
};

/// Detour's number of an area: it keeps 6 bits, and 0 means that there is no ground.
[[nodiscard]] inline std::uint8_t detour_area(std::uint32_t area) {
    return static_cast<std::uint8_t>(area + 1);
}
inline constexpr std::size_t most_areas = 60;
inline constexpr double most_cost = 1e6;             ///< of an area; floats still add up what paths cost
inline constexpr double largest_coordinate = 1e9;    ///< as everywhere in the library [m]
inline constexpr std::size_t most_tiles = 1U << 14;  ///< leaves 8 bits of a reference to polygons

/// Why a plan cannot be, in words, if it cannot: for options as for files.
[[nodiscard]] std::optional<std::string> fault_of(const Plan& plan);

/// Looks at the world and the options. Fails with `invalid` and `limit`, in words.
[[nodiscard]] Expected<Plan> make_plan(const World& world, const CharacterSettings& settings,
                                       const NavigationOptions& options);

/// All triangles that reach into a tile or its border.
[[nodiscard]] std::vector<GroundTriangle> ground_of_tile(const World& world, const CharacterSettings& settings,
                                                         const NavigationOptions& options, const Plan& plan, int tile_x,
                                                         int tile_z);

}  // namespace surefoot::navigation
