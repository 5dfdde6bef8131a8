// Small levels with a character, and the links that they have.
#pragma once

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include <surefoot/character.hpp>
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

inline double rise(const NavigationLink& link, const dvec3& up = {0, 1, 0}) {
    const dvec3 way = link.to - link.from;
    return way.x * up.x + way.y * up.y + way.z * up.z;
}

inline std::size_t count(const std::vector<NavigationLink>& links, NavigationLinkKind kind) {
    return static_cast<std::size_t>(
        std::count_if(links.begin(), links.end(), [&](const NavigationLink& link) { return link.kind == kind; }));
}

/// The inputs of a link, from rest where it begins.
inline dvec3 replayed(const Level& level, const NavigationLink& link, const dvec3& up = {0, 1, 0}) {
    CharacterState state = stand_at(level.world, level.settings, link.from, up, link.tick);
    EXPECT_EQ(state.footing, Footing::ground);
    for (const NavigationInput& input : link.inputs)
        for (std::uint32_t i = 0; i < input.ticks; ++i)
            state = step(level.world, level.settings,
                         {.wish = input.wish, .up = up, .jump = input.jump != 0, .crouch = input.crouch != 0},
                         link.tick, state)
                        .state;
    return state.position - up * navigation_agent(level.settings).feet;
}

inline void expect_replays(const Level& level, const std::vector<NavigationLink>& links) {
    for (const NavigationLink& link : links) {
        EXPECT_EQ(replayed(level, link), link.end);
        const dvec3 off = link.end - link.to;
        EXPECT_LT(std::hypot(off.x, off.z), 0.2);
        EXPECT_LT(std::abs(off.y), 0.4);
    }
}

}  // namespace surefoot::tests
