/// Links found by the feet: ways over which no mesh goes, proposed from its borders and kept only where a simulated
/// character gets over them, and gets over them too when it is a little early, late, aside, slower or faster.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <surefoot/character.hpp>
#include <surefoot/navigation_build.hpp>
#include <surefoot/navigation_link.hpp>
#include <surefoot/navigation_mesh.hpp>
#include <surefoot/world.hpp>

namespace [[gnu::visibility("default")]] surefoot {
inline namespace v0 {

/// How far off a character may be and still has to get over. With zeros a link may be one that works once in a blue
/// moon.
struct NavigationLinkMargins {
    double along = 0.2;   ///< jumps, or begins, so much early and so much late [m, >= 0]
    double aside = 0.25;  ///< runs so much farther left and right [times the agent's radius, >= 0]
    double speed = 0.1;   ///< runs so much slower and faster [share of the speed, 0 to 0.9]
    /// Sets out so far to each side of where it begins, and on the move [m, 0 to 0.15: from farther away a driver comes
    /// nearer first].
    double begin = 0.14;
};

/// How to look for links. Every default is meant to be kept.
struct NavigationLinkOptions {
    double run_speed = 6;     ///< that the character wishes for [m/s, > 0]
    double tick = 1.0 / 60;   ///< of the simulation [s, 0.001 to 0.1]
    double deepest_drop = 8;  ///< that is taken [m, >= 0]

    /// Along a border about one link in so many metres [m, > 0].
    double spacing = 1.5;

    /// Places that are joined by walking get a link only if the walk is longer than so many times the link and
    /// `least_saving` more.
    double shortcut = 3;
    double least_saving = 5;  ///< [m, >= 0]

    NavigationLinkMargins margins{};

    /// Those of the mesh: feet do not touch the ground where it is forbidden.
    std::span<const NavigationRegion> regions{};
    std::span<const std::uint32_t> surface_areas{};

    /// How many threads may work [1 to 64]. The result is the same.
    int threads = 2;

    NavigationProgress progress{};

    /// Once this is true, looking ends soon and nothing is found. Whoever sets it keeps it until then.
    const std::atomic<bool>* stop = nullptr;
};

/// What looking for links found, each by `NavigationLinkKind`.
struct NavigationLinkReport {
    std::size_t tried[4] = {};  ///< were simulated
    std::size_t done[4] = {};   ///< the character got over, with all margins
    std::size_t kept[4] = {};   ///< after thinning out
    std::size_t too_long = 0;   ///< were not simulated: they end beyond the next tile, where no link leads
    std::uint64_t ticks = 0;    ///< that were simulated on the way
    double seconds = 0;
};

/// Looks for links along all borders of the mesh. The world and the settings must be those of the mesh. Put them in
/// with `NavigationMesh::set_links`. Areas that are shut count as open: a door is where somebody may go, and its body
/// is not in the world, or stands open there. The mesh may have links; a way over them counts as walking. The same
/// arguments give the same links, to the last bit. None for settings or options out of range.
[[nodiscard]] std::vector<NavigationLink> find_links(const World& world, const CharacterSettings& settings,
                                                     const NavigationMesh& mesh,
                                                     const NavigationLinkOptions& options = {},
                                                     NavigationLinkReport* report = nullptr);

/// At rest where it comes to stand when it is put down at a place of the mesh: from here a link's inputs count. In the
/// air if there is no ground.
[[nodiscard]] CharacterState stand_at(const World& world, const CharacterSettings& settings, const dvec3& feet,
                                      const dvec3& up = {0, 1, 0}, double tick = 1.0 / 60) noexcept;

}  // namespace v0
}  // namespace surefoot
