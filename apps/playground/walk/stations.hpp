/// Places of a level to begin at, each with a line that says what to try there.
#pragma once

#include <string>
#include <vector>

#include <surefoot/math.hpp>

#include "level.hpp"

namespace surefoot::playground {

struct Station {
    std::string name;
    dvec3 place{0, 0, 0};  ///< for the feet [m]
    dvec3 look{0, 0, -1};  ///< a level direction
    std::string try_this;
};

/// Those of our training ground, written down here; of any other level its spawns, goals and named places. At least
/// one: a level that names none begins on the ground below its middle, if there is any.
[[nodiscard]] std::vector<Station> stations_of(const tools::Level& level);

}  // namespace surefoot::playground
