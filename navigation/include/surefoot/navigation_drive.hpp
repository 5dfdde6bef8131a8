/// Over a link, tick by tick: where to run, when to jump and how to steer in the air. Links are proven by this driver
/// and gone over by it, so that what was simulated is what is done.
#pragma once

#include <cstdint>
#include <type_traits>

#include <surefoot/character.hpp>
#include <surefoot/navigation_link.hpp>

namespace [[gnu::visibility("default")]] surefoot {
inline namespace v0 {

enum class NavigationDriveStatus : std::uint8_t {
    approaching,  ///< on its way to where the link begins
    under_way,    ///< runs, jumps, falls or climbs
    arrived,      ///< has ground under its feet where the link ends
    failed,       ///< is somewhere else, or took far too long: find another path
};

/// What a driver remembers from tick to tick: plain, copied freely. Begin each link with a new one.
struct NavigationDrive {
    dvec3 up{0, 1, 0};  ///< `NavigationMesh::up`
    double feet = 0.9;  ///< `NavigationAgent::feet`
    /// Comes to rest where the link begins, as the simulated character did, before it sets out. Slower than to begin on
    /// the run; for those whom the link has failed.
    bool careful = false;

    NavigationDriveStatus status = NavigationDriveStatus::approaching;
    bool pressed = false;         ///< the jump of this link
    std::uint32_t air_jumps = 0;  ///< that were pressed since
    bool airborne = false;        ///< has left the ground since it is under way
    bool landed = false;          ///< and came to stand again
    double seconds = 0;           ///< since `status` last changed [s]
    double grounded = 0;          ///< since it landed [s]
    double stalled = 0;           ///< since it last moved by itself [s]
};

static_assert(std::is_trivially_copyable_v<NavigationDrive>);

/// What to tell the character in this tick of `dt` seconds [s, > 0]. Looks at the state alone: whoever is pushed is
/// steered back. Does nothing once it arrived or failed.
[[nodiscard]] CharacterInput drive(const NavigationLink& link, NavigationDrive& drive, const CharacterState& state,
                                   const CharacterSettings& settings, double dt) noexcept;

}  // namespace v0
}  // namespace surefoot
