#include "playtest/report/frame_sky.hpp"

#include "playtest/vectors.hpp"

namespace surefoot::playtest {
namespace {

// The game's own hours, brighter at night: a frame is looked at by day.
const FrameSky day{.towards_sun = unit({0.42, 0.80, 0.43}),
                   .sun = {0.90, 0.82, 0.69},
                   .above = {0.31, 0.38, 0.48},
                   .below = {0.20, 0.185, 0.17},
                   .zenith = {0.08, 0.30, 0.66},
                   .horizon = {0.56, 0.75, 0.88},
                   .nadir = {0.40, 0.58, 0.72},
                   .fog_distance = 260};
const FrameSky dusk{.towards_sun = unit({0.78, 0.38, 0.5}),
                    .sun = {1.15, 0.72, 0.45},
                    .above = {0.36, 0.34, 0.48},
                    .below = {0.20, 0.185, 0.17},
                    .zenith = {0.13, 0.15, 0.34},
                    .horizon = {0.82, 0.48, 0.34},
                    .nadir = {0.34, 0.28, 0.34},
                    .fog_distance = 260};
const FrameSky night{.towards_sun = unit({-0.35, 0.86, 0.38}),
                     .sun = {0.55, 0.64, 0.90},
                     .above = {0.28, 0.33, 0.50},
                     .below = {0.14, 0.14, 0.21},
                     .zenith = {0.012, 0.02, 0.07},
                     .horizon = {0.07, 0.10, 0.22},
                     .nadir = {0.03, 0.04, 0.10},
                     .fog_distance = 160};
const FrameSky cave{.towards_sun = unit({0.2, 0.95, 0.25}),
                    .sun = {0.70, 0.64, 0.56},
                    .above = {0.34, 0.36, 0.42},
                    .below = {0.22, 0.19, 0.18},
                    .zenith = {0.035, 0.05, 0.07},
                    .horizon = {0.12, 0.16, 0.19},
                    .nadir = {0.06, 0.07, 0.09},
                    .fog_distance = 120};

}  // namespace

const FrameSky& frame_sky(std::string_view name) {
    if (name == "dusk") return dusk;
    if (name == "night") return night;
    return name == "cave" ? cave : day;
}

}  // namespace surefoot::playtest
