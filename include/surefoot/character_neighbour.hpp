/// Another character, as one that takes a step sees it: where it was when the tick began.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include <surefoot/math.hpp>
#include <surefoot/shapes.hpp>

namespace [[gnu::visibility("default")]] surefoot {
inline namespace v0 {

/// What meeting another character means.
enum class Firmness : std::uint8_t {
    hard,  ///< it is in the way like a wall, and an overlap is undone at once
    soft,  ///< it can be walked into, and an overlap is undone at `soft_parting_speed`
};

/// How fast a character gets out of a soft one, at most [m/s].
inline constexpr double soft_parting_speed = 2;

/// How many neighbours a step heeds. More than these are not looked at, and the step says `overflow`.
inline constexpr std::size_t most_neighbours = 64;

/// One of the others. All of them as they are before anybody has taken the step: then the order of stepping is nothing
/// that a result could depend on.
struct Neighbour {
    Volume volume;              ///< its body, as it is turned in the world
    dvec3 position{0, 0, 0};    ///< of its reference point [m]
    dvec3 velocity{0, 0, 0};    ///< relative to what carries it [m/s]
    std::uint32_t id = 0;       ///< your own number for it; comes back in `CharacterEvents::blocked_body`
    std::uint32_t carrier = 0;  ///< the body of the world that carries it, if `is_carried`: both are taken along alike
    bool is_carried = false;
    Firmness firmness = Firmness::hard;
    std::uint8_t reserved[6] = {};
};

static_assert(std::is_trivially_copyable_v<Neighbour>);

}  // namespace v0
}  // namespace surefoot
