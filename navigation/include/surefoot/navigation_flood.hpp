/// Where the feet really get: a flood fill by `step`, and a navigation mesh cut down to what it reaches.
///
/// A character is stood on a place and walked from cell to cell of a grid, each move simulated by `step`, until no new
/// cell is found. It knows nothing of the mesh, so it can judge it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <surefoot/character_settings.hpp>
#include <surefoot/navigation_mesh.hpp>
#include <surefoot/world.hpp>

namespace [[gnu::visibility("default")]] surefoot {
inline namespace v0 {

struct NavigationFloodOptions {
    double cell = 0;                     ///< the side of a cell of the grid [m, > 0]; 0: the character's radius
    double speed = 5;                    ///< of a move from cell to cell [m/s, > 0]
    double longest_fall = 1;             ///< a character that is in the air for longer is lost [s, >= 0]
    std::size_t most_cells = 4'000'000;  ///< the flood ends there [> 0]
    /// Those of the mesh: feet turn back where the ground is forbidden.
    std::span<const NavigationRegion> regions{};
    std::span<const std::uint32_t> surface_areas{};

    int threads = 2;                ///< the result is the same [1 to 64]
    NavigationProgress progress{};  ///< told of cells: those done, and those known so far
};

/// A cell in which a character can stand.
struct NavigationFloodCell {
    dvec3 feet{0, 0, 0};   ///< where it stood [m]
    bool returns = false;  ///< from here the first of the seeds can be got to again
};

struct NavigationFlood {
    double cell = 0;    ///< the side of a cell [m]
    double radius = 0;  ///< that the mesh for this character has [m]
    std::vector<NavigationFloodCell> cells;
    std::size_t moves = 0;  ///< that were simulated
    bool whole = true;      ///< false if it ended at `most_cells`

    /// Of each of the mesh's links: both its ends are places that the feet get to and come back from.
    std::vector<bool> links_used;

    /// Of all cells from which one can return [m^2].
    [[nodiscard]] double area() const noexcept;
};

/// Floods from the ground under `seeds` (places of feet, as far as the agent is high above it). A link whose beginning
/// is reached leads to its end, since its simulation did. `mesh` lends its frame, `up` and the links; its
/// polygons are not looked at.
[[nodiscard]] NavigationFlood flood_by_feet(const World& world, const CharacterSettings& settings,
                                            const NavigationMesh& mesh, std::span<const dvec3> seeds,
                                            const NavigationFloodOptions& options = {});

/// What `keep_reached` did, and how well mesh and feet agree.
struct NavigationAgreement {
    double kept = 0;               ///< area of the mesh that is left [m^2]
    double unreached = 0;          ///< area taken out since no feet got there [m^2]
    double no_return = 0;          ///< area taken out since there is no way back to the first seed over the mesh [m^2]
    double flood = 0;              ///< area of the flood [m^2]
    double flood_covered = 0;      ///< that of its cells that the kept mesh comes into, or nearly [m^2]
    std::size_t rehearsed = 0;     ///< random walks that were rehearsed
    std::size_t failed_links = 0;  ///< dropped, since they failed in a rehearsal
    std::size_t failed_polygons = 0;  ///< taken out, since feet got stuck before them or on them
    double failed_area = 0;           ///< of these polygons [m^2]
    std::vector<dvec3> missing{};     ///< some of the flood's cells that it does not cover

    /// Share of what the feet reach that the mesh knows [0 to 1].
    [[nodiscard]] double covered() const noexcept { return flood > 0 ? flood_covered / flood : 0; }
};

/// Takes out all polygons where feet did not get, and all from which the mesh knows no way to the first seed or that it
/// cannot get to from there. Areas that are shut count as open.
NavigationAgreement keep_reached(NavigationMesh& mesh, const NavigationFlood& flood, const dvec3& seed);

}  // namespace v0
}  // namespace surefoot
