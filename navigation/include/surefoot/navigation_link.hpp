/// A link: a way between two places of a navigation mesh that is no ground, such as a drop or a jump, and the inputs
/// with which a simulated character got over.
#pragma once

#include <cstdint>
#include <type_traits>
#include <vector>

#include <surefoot/math.hpp>

namespace [[gnu::visibility("default")]] surefoot {
inline namespace v0 {

enum class NavigationLinkKind : std::uint8_t {
    drop,     ///< off an edge, down
    jump,     ///< over a gap, or up, by the jump button
    step_up,  ///< walked, where the mesh has a seam that feet have not
    ladder,   ///< up or down
};

/// What a character was told for some ticks in a row.
struct NavigationInput {
    dvec3 wish{0, 0, 0};      ///< as in `CharacterInput` [m/s]
    std::uint32_t ticks = 0;  ///< of `NavigationLink::tick`
    std::uint8_t jump = 0;    ///< 1: held
    std::uint8_t crouch = 0;  ///< 1: held; on a ladder it leads down
    std::uint8_t reserved[2] = {};
};

static_assert(std::is_trivially_copyable_v<NavigationInput> && sizeof(NavigationInput) == 32);

/// One way only: a drop is not a way up.
struct NavigationLink {
    dvec3 from{0, 0, 0};  ///< where it begins, on the mesh, at the feet [m]
    dvec3 to{0, 0, 0};    ///< where it ends [m]
    /// Where the feet leave the ground: at an edge, for a jump; `from` where there is no such place [m].
    dvec3 takeoff{0, 0, 0};
    NavigationLinkKind kind = NavigationLinkKind::drop;
    double speed = 6;                       ///< that is wished for on the way [m/s]
    std::uint32_t air_jumps = 0;            ///< of a jump: so many more in the air, each at the top of the one before
    double seconds = 0;                     ///< how long the simulated character took [s]
    double tick = 1.0 / 60;                 ///< the tick of the simulation [s]
    std::vector<NavigationInput> inputs{};  ///< from rest at `from` they lead to `end`
    dvec3 end{0, 0, 0};                     ///< where the feet are then: at `to`, but for what a tick makes [m]
};

}  // namespace v0
}  // namespace surefoot
