// Small levels for characters: floors, walls, ramps, stairs, made of triangles here and now.
#pragma once

#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>
#include <vector>

#include <surefoot/surefoot.hpp>

namespace surefoot::tests {

class Scene {
public:
    /// A flat four-sided face, its corners counter-clockwise from the front.
    Scene& quad(const dvec3& a, const dvec3& b, const dvec3& c, const dvec3& d) {
        triangle(a, b, c);
        return triangle(a, c, d);
    }
    Scene& triangle(const dvec3& a, const dvec3& b, const dvec3& c) {
        for (const dvec3& corner : {a, b, c}) {
            indices_.push_back(static_cast<std::uint32_t>(vertices_.size()));
            vertices_.emplace_back(corner);
        }
        surfaces_.push_back(surface_);
        return *this;
    }
    /// What comes from now on is made of this.
    Scene& made_of(std::uint32_t surface) {
        surface_ = surface;
        return *this;
    }
    /// Level ground at a height, cut into `pieces` squares along x and along z.
    Scene& floor(double from_x, double to_x, double from_z, double to_z, double height = 0, int pieces = 1) {
        const auto at = [&](double from, double to, int i) { return from + (to - from) * i / pieces; };
        for (int i = 0; i < pieces; ++i) {
            for (int k = 0; k < pieces; ++k) {
                const double x0 = at(from_x, to_x, i), x1 = at(from_x, to_x, i + 1);
                const double z0 = at(from_z, to_z, k), z1 = at(from_z, to_z, k + 1);
                quad({x0, height, z0}, {x0, height, z1}, {x1, height, z1}, {x1, height, z0});
            }
        }
        return *this;
    }
    /// A block with all its six sides.
    Scene& block(const dvec3& low, const dvec3& high) {
        const auto corner = [&](bool x, bool y, bool z) {
            return dvec3{x ? high.x : low.x, y ? high.y : low.y, z ? high.z : low.z};
        };
        const auto c000 = corner(false, false, false), c100 = corner(true, false, false);
        const auto c010 = corner(false, true, false), c110 = corner(true, true, false);
        const auto c001 = corner(false, false, true), c101 = corner(true, false, true);
        const auto c011 = corner(false, true, true), c111 = corner(true, true, true);
        quad(c010, c011, c111, c110).quad(c000, c100, c101, c001);
        quad(c000, c001, c011, c010).quad(c100, c110, c111, c101);
        return quad(c000, c010, c110, c100).quad(c001, c101, c111, c011);
    }
    /// A slope that rises along +x from `from_x`, at height 0, for `run` metres of level way.
    Scene& ramp(double from_x, double run, double degrees, double half_width = 10) {
        const double rise = run * std::tan(degrees * 0.017453292519943295);
        return quad({from_x, 0, -half_width}, {from_x, 0, half_width}, {from_x + run, rise, half_width},
                    {from_x + run, rise, -half_width});
    }
    /// Stairs up along +x, and a landing behind them.
    Scene& stairs(double from_x, int steps, double rise, double tread, double half_width = 3) {
        for (int i = 0; i < steps; ++i) {
            const double x = from_x + i * tread;
            const double depth = i + 1 == steps ? 10 : tread;
            quad({x, i * rise, -half_width}, {x, i * rise, half_width}, {x, (i + 1) * rise, half_width},
                 {x, (i + 1) * rise, -half_width});
            quad({x, (i + 1) * rise, -half_width}, {x, (i + 1) * rise, half_width},
                 {x + depth, (i + 1) * rise, half_width}, {x + depth, (i + 1) * rise, -half_width});
        }
        return *this;
    }

    [[nodiscard]] Mesh mesh() const {
        const auto mesh = Mesh::build({.vertices = vertices_, .indices = indices_, .surfaces = surfaces_});
        EXPECT_TRUE(mesh.has_value());
        return *mesh;
    }
    [[nodiscard]] World world() const {
        World world;
        EXPECT_TRUE(world.add(mesh()).has_value());
        return world;
    }

private:
    std::vector<vec3> vertices_;
    std::vector<std::uint32_t> indices_;
    std::vector<std::uint32_t> surfaces_;
    std::uint32_t surface_ = 0;
};

/// A character, its settings, and how it got where it is.
struct Actor {
    CharacterSettings settings{};
    CharacterState state{};
    CharacterHooks hooks{};
    double dt = 1.0 / 60;
    std::uint32_t events = 0;  ///< of all ticks so far

    CharacterEvents tick(const World& world, const CharacterInput& input = {}) {
        const StepResult result = step(world, settings, input, dt, state, {}, nullptr, hooks);
        state = result.state;
        events |= result.events.set;
        return result.events;
    }
    void run(const World& world, double seconds, const CharacterInput& input = {}) {
        const int ticks = static_cast<int>(std::lround(seconds / dt));
        for (int i = 0; i < ticks; ++i) tick(world, input);
    }
    [[nodiscard]] bool did(CharacterEvent event) const { return (events & static_cast<std::uint32_t>(event)) != 0; }
    [[nodiscard]] bool on_ground() const { return state.footing == Footing::ground; }
};

/// How far above its ground the reference point of the default ellipsoid rests: its half height and the skin, which is
/// a little more than the setting for an ellipsoid (see grown.hpp).
inline double standing_height(const CharacterSettings& settings = {}) {
    Scene floor;
    floor.floor(-5, 5, -5, 5);
    const World world = floor.world();
    Actor actor{.settings = settings};
    actor.state.position = {0.3, 3, 0.2};
    actor.run(world, 2);
    EXPECT_TRUE(actor.on_ground());
    return actor.state.position.y;
}

}  // namespace surefoot::tests
