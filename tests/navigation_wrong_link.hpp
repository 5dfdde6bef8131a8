// A chasm, and a link over it that nobody gets over.
#pragma once

#include <surefoot/navigation_link.hpp>

#include "movement_scene.hpp"

namespace surefoot::tests {

/// Two floors with a chasm of 6 m between them, joined by a bridge far to the side.
inline Scene chasm() {
    Scene scene;
    return scene.block({-8, -9, -8}, {-3, 0, 8}).block({3, -9, -8}, {8, 0, 8}).block({-3, -9, 6}, {3, 0, 8});
}

/// A low wall before it lets nobody fall.
inline Scene& walled(Scene& scene, double until = 5) {
    return scene.block({-3.2, 0, -8}, {-3, 3, until});
}

/// A way through the wall and over the chasm, as somebody claims.
inline NavigationLink through_the_wall() {
    return {.from = {-4, 0, 0},
            .to = {4, 0, 0},
            .takeoff = {-3.5, 0, 0},
            .kind = NavigationLinkKind::step_up,
            .seconds = 1};
}

}  // namespace surefoot::tests
