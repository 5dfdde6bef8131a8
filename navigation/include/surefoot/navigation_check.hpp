/// Do mesh and feet agree? Builds the mesh of a level, finds its links, floods the level by `step`, and walks the real
/// character over thousands of random paths. `surefoot navcheck` is this with a printer.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <surefoot/character.hpp>
#include <surefoot/character_settings.hpp>
#include <surefoot/error.hpp>
#include <surefoot/navigation_flood.hpp>
#include <surefoot/navigation_links.hpp>
#include <surefoot/navigation_mesh.hpp>
#include <surefoot/navigation_walk.hpp>
#include <surefoot/world.hpp>

namespace [[gnu::visibility("default")]] surefoot {
inline namespace v0 {

/// The parts of a check, in their order.
enum class NavigationCheckPart : std::uint8_t { build, links, flood, rehearsal, walks };

/// Any callable `void(NavigationCheckPart, std::size_t done, std::size_t all)`; as `NavigationProgress` otherwise.
class NavigationCheckProgress {
public:
    constexpr NavigationCheckProgress() noexcept = default;

    template <typename Callable>
    requires(
        std::is_invocable_v<const Callable&, NavigationCheckPart, std::size_t, std::size_t> &&
        !std::is_same_v<Callable, NavigationCheckProgress>) constexpr NavigationCheckProgress(const Callable&
                                                                                                  callable) noexcept
        : callable_(&callable),
          call_([](const void* target, NavigationCheckPart part, std::size_t done, std::size_t all) {
              (*static_cast<const Callable*>(target))(part, done, all);
          }) {}

    void operator()(NavigationCheckPart part, std::size_t done, std::size_t all) const {
        if (call_ != nullptr) call_(callable_, part, done, all);
    }

private:
    const void* callable_ = nullptr;
    void (*call_)(const void*, NavigationCheckPart, std::size_t, std::size_t) = nullptr;
};

struct NavigationCheckOptions {
    NavigationOptions mesh{};
    std::optional<dvec3> start{};  ///< where the feet begin [m]; else `best_start` chooses
    NavigationLinkOptions links{};
    NavigationFloodOptions flood{};
    WalkOptions walk{};
    std::size_t walks = 1000;      ///< random paths
    std::uint64_t seed = 1;        ///< of their ends: the same gives the same paths
    std::size_t rehearsals = 200;  ///< walks of a round of rehearsal; 0: there is none
    double least_covered = 0.98;   ///< the share of what feet reach that the mesh has to know [0 to 1]
    int threads = 2;               ///< for each of the parts [1 to 64]; the result is the same
    NavigationCheckProgress progress{};
};

/// A walk that did not end where it should.
struct NavigationFailedWalk {
    dvec3 from{0, 0, 0};  ///< feet
    dvec3 to{0, 0, 0};
    WalkReport report;
};

struct NavigationCheck {
    NavigationReport mesh;  ///< as built, before anything was taken out
    NavigationLinkReport links;
    std::size_t links_of_feet[4] = {};  ///< of each kind, between places that the feet get to and come back from
    std::size_t links_kept[4] = {};     ///< of those, between places that the mesh kept, too
    std::size_t flood_cells = 0;
    bool flood_whole = true;
    NavigationAgreement agreement;
    std::size_t walks = 0;
    std::size_t arrived = 0;
    std::size_t links_walked = 0;
    double length = 0;                         ///< of the paths of all walks that arrived [m]
    double seconds = 0;                        ///< that these walks took [s]
    double slowest = 0;                        ///< the largest time of a walk over that of its path at full speed
    std::vector<NavigationFailedWalk> failed;  ///< the first 32, in the order of their numbers
    double least_covered = 0;

    [[nodiscard]] bool all_arrived() const noexcept { return walks > 0 && arrived == walks; }
    [[nodiscard]] bool is_covered() const noexcept { return agreement.covered() >= least_covered; }
    /// There is a kind of link that the feet use here, but of which the mesh kept none.
    [[nodiscard]] bool lost_a_kind() const noexcept;
    [[nodiscard]] bool passes() const noexcept { return all_arrived() && is_covered() && !lost_a_kind(); }
};

/// A place to begin: of these places (spawn points, over the ground or on it) the one from which most of the mesh can
/// be got to; without any, a place of the largest piece of the mesh. None for a mesh without ground.
[[nodiscard]] std::optional<dvec3> best_start(const NavigationMesh& mesh, std::span<const dvec3> places) noexcept;

/// The ground under a place, or near it, to begin on. Fails with `invalid`, in words, where there is none.
[[nodiscard]] Expected<dvec3> start_at(const NavigationMesh& mesh, const dvec3& place);

/// Walks random ways and takes away what they fail at, until a round of them has no failure or there were twelve. Their
/// ends have seeds of their own, whatever `options.seed` is. Links that failed are dropped. Of the ground, what the
/// feet could not get on to is taken out, but no more than a hundredth: a mesh that is wrong by more does not fit the
/// feet, and nobody is helped by what would be left of it. `agreement`: that of `keep_reached`, which is kept up to
/// date.
void rehearse(NavigationMesh& mesh, const World& world, const CharacterSettings& settings, const NavigationFlood& flood,
              const dvec3& start, const NavigationCheckOptions& options, NavigationAgreement& agreement);

/// Links and flood for a mesh that was just built: sets its links and takes out what the feet do not reach from
/// `start` or cannot come back from; then it rehearses. This is the second half of `surefoot nav build`.
NavigationAgreement prove_by_feet(NavigationMesh& mesh, const World& world, const CharacterSettings& settings,
                                  const dvec3& start, const NavigationCheckOptions& options,
                                  NavigationCheck* check = nullptr);

/// The whole check. The mesh is built by `options.mesh`, the feet move by `settings`. Fails as `NavigationMesh::build`
/// does, and with `invalid` for a level without ground, or without any at `options.start`. Areas that are shut count as
/// open, in this and in its parts: doors stand open in `world`, or are not in it.
[[nodiscard]] Expected<NavigationCheck> check_navigation(const World& world, const CharacterSettings& settings,
                                                         std::span<const dvec3> starts,
                                                         const NavigationCheckOptions& options = {});

}  // namespace v0
}  // namespace surefoot
