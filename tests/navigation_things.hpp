// A small level, its navigation mesh and a character that is sent somewhere.
#pragma once

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include <surefoot/navigation_follow.hpp>
#include <surefoot/navigation_query.hpp>
#include <surefoot/surefoot.hpp>

namespace surefoot::tests {

inline NavigationMesh built(const World& world, const CharacterSettings& settings = {},
                            const NavigationOptions& options = {}) {
    auto mesh = NavigationMesh::build(world, settings, options);
    EXPECT_TRUE(mesh.has_value()) << (mesh ? "" : mesh.error().text);
    return std::move(*mesh);
}

/// One character with a follower, and what is worth knowing of its way.
struct Walker {
    const World& world;
    const NavigationQuery& query;
    CharacterSettings settings{};
    NavigationFollower follower{};
    CharacterState state{};
    double dt = 1.0 / 60;
    double seconds = 0;
    double farthest_off_mesh = 0;  ///< of the feet, seen from above [m]
    double lowest = 1e30;          ///< of the feet, along y [m]
    double slowest = 1e30;         ///< after the first half second [m/s]

    Walker& at(const dvec3& feet) {
        state = {};
        state.position = feet + query.mesh().up() * (query.mesh().agent().feet + settings.skin);
        for (int i = 0; i < 20; ++i) state = step(world, settings, {.up = query.mesh().up()}, dt, state).state;
        return *this;
    }
    Walker& to(const dvec3& goal) {
        follower.go(query, goal);
        return *this;
    }
    [[nodiscard]] dvec3 feet() const { return state.position - query.mesh().up() * query.mesh().agent().feet; }

    void tick(const dvec3& impulse = {0, 0, 0}) {
        CharacterInput input = follower.input(query, state, settings, dt);
        input.impulse = impulse;
        state = step(world, settings, input, dt, state).state;
        seconds += dt;
        lowest = std::min(lowest, feet().y);
        if (seconds > 0.5 && follower.status() == NavigationFollowStatus::following)
            slowest = std::min(slowest, glm::length(state.velocity));
        if (const auto nearest = query.nearest(feet(), 3, 1)) {
            const dvec3 off = nearest->position - feet();
            const dvec3& up = query.mesh().up();
            farthest_off_mesh = std::max(farthest_off_mesh, glm::length(off - up * glm::dot(off, up)));
        }
    }
    /// Until it has arrived or given up, or the time is over.
    NavigationFollowStatus run(double most_seconds = 60) {
        for (double time = 0; time < most_seconds && follower.status() == NavigationFollowStatus::following; time += dt)
            tick();
        return follower.status();
    }
    [[nodiscard]] double from_goal(const dvec3& goal) const { return std::hypot(feet().x - goal.x, feet().z - goal.z); }
};

}  // namespace surefoot::tests
