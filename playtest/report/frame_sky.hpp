/// The light of a frame, by the hour that a level names.
#pragma once

#include <string_view>

#include <surefoot/math.hpp>

namespace surefoot::playtest {

/// Colours as they add up, not as they are shown.
struct FrameSky {
    dvec3 towards_sun;  ///< unit
    dvec3 sun;
    dvec3 above;  ///< on what faces up
    dvec3 below;  ///< on what faces down
    dvec3 zenith;
    dvec3 horizon;
    dvec3 nadir;
    double fog_distance;  ///< where half of a colour is the horizon's [m]
};

/// "day", "dusk", "night", "cave"; the day for any other word.
[[nodiscard]] const FrameSky& frame_sky(std::string_view name);

}  // namespace surefoot::playtest
