/// A level seen from above, as a picture: shaded by height, north (-Z) up.
#pragma once

#include <string>

#include "game/level.hpp"
#include "playtest/telemetry.hpp"

namespace surefoot::playtest {

/// Where the level lies in the picture.
struct PlanFrame {
    double west = 0;   ///< the least x [m]
    double north = 0;  ///< the least z [m]
    double scale = 1;  ///< pixels a metre
    int width = 1;     ///< [pixels]
    int height = 1;

    [[nodiscard]] double x(const dvec3& place) const { return (place.x - west) * scale; }
    [[nodiscard]] double y(const dvec3& place) const { return (place.z - north) * scale; }
};

[[nodiscard]] PlanFrame plan_frame(const game::Level& level, int longest = 900);

/// "data:image/png;base64,...".
[[nodiscard]] std::string plan_picture(const game::Level& level, const PlanFrame& frame);

/// The same size, clear where nothing was counted; by the logarithm of the counts.
[[nodiscard]] std::string heat_picture(const HeatMap& heat, const PlanFrame& frame);

}  // namespace surefoot::playtest
