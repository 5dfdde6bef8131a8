/// The signs of games as shapes, not as pictures: how far a place is from the outline of each.
#pragma once

#include <cstdint>
#include <glm/ext/vector_double2.hpp>

namespace surefoot::view {

// clang-format off
enum class Sign : std::uint8_t {
    heart, coin, star, key, clock, skull, flag, gamepad, keyboard, mouse, lock, door, arrow, check, medal, ghost, play,
    enemy, beam,
    count,
};
// clang-format on

/// Signed distance to a sign's outline, below zero inside. The sign fills the square from -1 to 1, y downwards; an
/// arrow points upwards.
[[nodiscard]] double distance_to(Sign sign, const glm::dvec2& place);

}  // namespace surefoot::view
