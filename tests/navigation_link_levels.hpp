// Small levels with a character, and the links that they have.
#pragma once

#include <algorithm>
#include <gtest/gtest.h>

#include <surefoot/navigation_links.hpp>

#include "movement_scene.hpp"

namespace surefoot::tests {

/// A level, the character in it, and the links that it has.
struct Level {
    World world;
    CharacterSettings settings{};
    NavigationOptions mesh_options{};
    NavigationLinkOptions options{};
    NavigationLinkReport report{};

    [[nodiscard]] NavigationMesh mesh() const {
        auto mesh = NavigationMesh::build(world, settings, mesh_options);
        EXPECT_TRUE(mesh.has_value()) << mesh.error().text;
        return *std::move(mesh);
    }
    [[nodiscard]] std::vector<NavigationLink> links() { return find_links(world, settings, mesh(), options, &report); }
};

inline Level level_of(const Scene& scene) {
    return {.world = scene.world()};
}

inline Scene terrace(double height) {
    Scene scene;
    return scene.floor(-10, 10, -10, 10).block({-4, 0, -4}, {4, height, 4});
}

/// Two blocks, and a gap along x between them, so deep that nobody comes out of it.
inline Scene gap(double width, double rise = 0) {
    Scene scene;
    return scene.block({-6, 0, -3}, {-width / 2, 20, 3}).block({width / 2, 0, -3}, {6, 20 + rise, 3});
}

}  // namespace surefoot::tests
