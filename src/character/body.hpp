// The body of a character, turned to its `up` and measured.
#pragma once

#include <surefoot/character_settings.hpp>

#include "character/surroundings.hpp"
#include "vec.hpp"

namespace surefoot::internal {

/// `up` is of unit length. Requires: a valid volume.
[[nodiscard]] Body body_of(const Volume& volume, double skin, const Vec& up) noexcept;

/// A volume that is upright where up is +Y, turned to `up`, which is of unit length.
[[nodiscard]] Volume turned_to(const Volume& volume, const Vec& up) noexcept;

/// How far a volume reaches from its reference point along `direction`, which is of unit length [m].
[[nodiscard]] double reach_along(const Volume& volume, const Vec& direction) noexcept;

/// The smallest dimension of a shape; the straight part of a capsule does not count [m].
[[nodiscard]] double smallest_of(const Shape& shape) noexcept;

}  // namespace surefoot::internal
