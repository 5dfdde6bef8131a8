// What moving bodies do to a character before it moves by itself: they carry it, they push it, they crush it.
#pragma once

#include <cstdint>

#include <surefoot/world.hpp>

#include "character/slide.hpp"

namespace surefoot::internal {

struct Carried {
    Vec position;
    bool crushed = false;  ///< no way is left between things that move
    bool pushed = false;   ///< by something that came against it
    bool moved = false;
};

/// A part of the world's tick.
struct TickPart {
    double begin = 0;  ///< [0, 1]
    double end = 1;    ///< [begin, 1]
};

/// Takes a body through a part of the tick of the world's moving bodies.
/// `support` is the body that carries it, or nothing. Nothing that moves passes through it, however fast.
[[nodiscard]] Carried carry(Surroundings& surroundings, const Body& body, const Gait& gait, const Vec& from,
                            BodyHandle support, const TickPart& part) noexcept;

/// Does the body go anywhere during the tick?
[[nodiscard]] bool moves(const World& world, BodyHandle handle) noexcept;

}  // namespace surefoot::internal
