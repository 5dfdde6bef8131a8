// Edges to hang on: a ball finds the wall, a small column that is let down behind it finds the edge.
#pragma once

#include <optional>

#include "character/tick.hpp"

namespace surefoot::internal {

struct Ledge {
    Vec edge;               ///< a point of the ground behind the edge, above the wall [m]
    Vec wall;               ///< out of the wall, across `up`, unit
    Vec hang;               ///< where the body hangs [m]
    Vec stands;             ///< where it stands once it has climbed [m]
    bool has_room = false;  ///< to stand there
    std::uint32_t body = 0;
    std::uint32_t triangle = 0;
};

/// The edge ahead that is `low` to `high` above the lowest point of the body [m], or nothing. Every probe goes to the
/// trace. `ahead` is of unit length and across `up`.
[[nodiscard]] std::optional<Ledge> find_ledge(Tick& tick, const Vec& ahead, double low, double high) noexcept;

}  // namespace surefoot::internal
