/// Where somebody stands: on the still ground, or on one of the level's bodies.
#pragma once

#include <cstdint>

#include <surefoot/math.hpp>

namespace surefoot::playtest {

inline constexpr std::uint32_t on_ground = ~std::uint32_t{0};

struct Stand {
    std::uint32_t body = on_ground;
    dvec3 place{0, 0, 0};      ///< of the feet; of no meaning on a body
    std::uint32_t island = 0;  ///< of the mesh, on the ground
};

}  // namespace surefoot::playtest
