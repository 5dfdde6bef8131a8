// Spawning inside of things, and random walks in closed levels.
#include "course/scenes/common.hpp"

namespace surefoot::course {
namespace {

constexpr double skin = 0.01;

/// How deep it is in any triangle in the end [m].
double depth_at_end(const Outing& outing) {
    Outing last;
    last.run = outing.run;
    last.spots = {outing.last(), outing.last()};
    return depth(last);
}

Bar out_bar() {
    return {"still in a triangle", "m", 0.1 * skin, "there is room beside it, less than its own size away",
            each(depth_at_end)};
}

Scene spawned() {
    Scene scene{"spawn-inside", "put into walls, floors and corners, its centre outside of them", {}, {}, {}};
    const auto add = [&](const std::string& name, Triangles triangles, const dvec3& ground) {
        scene.runs.push_back(run_at(name, level_of(std::move(triangles)), ground, walk({}), 2));
        scene.runs.back().settle = 0;
    };
    const Triangles ground = Triangles().floor({-10, 0, -10}, {10, 0, 10}, 20);
    for (const double deep : {0.02, 0.1, 0.3, 0.39}) {
        const std::string name = text_of(deep) + " m into ";
        add(name + "a wall", Triangles(ground).block({0, -0.5, -5}, {1, 3, 5}), {deep - 0.4, 0, 0.1});
        add(name + "the floor", ground, {0.1, -deep, 0.2});
        add(name + "a corner", Triangles(ground).block({0, -0.5, -5}, {1, 3, 5}).block({-5, -0.5, 0}, {5, 3, 1}),
            {deep - 0.4, 0, deep - 0.4});
        add(name + "a wall and the floor", Triangles(ground).block({0, -0.5, -5}, {1, 3, 5}), {deep - 0.4, -deep, 0});
        add(name + "a ceiling", Triangles(ground).block({-3, 1.82 - deep, -3}, {0, 3, 3}), {-0.3, 0, 0});
    }
    scene.bars = {out_bar(),
                  rest_bar(0.5),
                  {"on the other side", "m", 0, "the way out is the one on which the centre crosses nothing",
                   each([](const Outing& outing) {
                       const dvec3& at = outing.last().position;
                       const bool is_below = at.y < 0;
                       const bool is_behind =
                           outing.run->start.x < 0 && outing.run->name.find("ceiling") == std::string::npos && at.x > 0;
                       return is_below || is_behind ? 1 : 0;
                   })},
                  {"farther away than it has to", "m", 0.8, "a body's width and more is not needed to get out",
                   each([](const Outing& outing) {
                       const dvec3 way = outing.last().position - outing.run->start;
                       return std::hypot(way.x, way.z);
                   })}};
    // A ceiling is left downwards or sideways, and sideways is a body's width.
    return scene;
}

// A closed room with what levels are made of; everything in it is closed as well.
LevelPointer closed_level() {
    Triangles triangles;
    triangles.room({-8, 0, -8}, {8, 6, 8});
    triangles.block({-3, -0.2, -3}, {-2, 3, 1}).block({1, -0.2, 2}, {4, 0.35, 5}).block({2, -0.2, 3}, {4, 0.7, 5});
    triangles.block({3, -0.2, 3.5}, {4.2, 1.05, 5.2})
        .block({-6, -0.2, 4}, {-2, 2.1, 4.2})
        .block({-5.2, -0.2, 4.9}, {-2, 2, 6});
    triangles.block({4, 1.9, -6}, {7.5, 2.4, -1});
    // A ramp as a closed prism, a steep one beside it, and pillars.
    const auto prism = [&](double x0, double x1, double high, double z0, double z1) {
        const dvec3 a{x0, -0.2, z0}, b{x1, -0.2, z0}, c{x1, high, z0};
        const dvec3 d{x0, -0.2, z1}, e{x1, -0.2, z1}, f{x1, high, z1};
        triangles.triangle(a, c, b).triangle(d, e, f);
        triangles.quad(a, b, e, d).quad(b, c, f, e).quad(c, a, d, f);
    };
    prism(3, 7, 2.4, -7, -5);
    prism(-1, 0.5, 3, -7, -4);
    for (int i = 0; i < 4; ++i) triangles.block({-7.0 + 1.3 * i, -0.2, -6}, {-6.8 + 1.3 * i, 6.2, -5.8});
    return level_of(triangles);
}

// A new wish every quarter of a second, sometimes none, sometimes a dash; a jump now and then.
Script random_walk(std::uint64_t seed, double fastest) {
    return [seed, fastest](double time, const Spot&) {
        Dice dice(seed + 1000 * static_cast<std::uint64_t>(time * 4 + 1e-6));
        const double kind = dice.from(0, 1);
        const double speed = kind < 0.1 ? 0 : kind < 0.2 ? fastest : dice.from(1, 6);
        return Input{heading(dice.from(0, 360), speed), dice.from(0, 1) < 0.4};
    };
}

Scene soak() {
    Scene scene{"soak",
                "random walks and jumps in a closed level, at 15 to 240 Hz, with dashes of 200 m/s",
                {},
                {inside_bar(), depth_bar()},
                {}};
    const LevelPointer level = closed_level();
    std::uint64_t seed = 1;
    for (const double rate : {15.0, 60.0, 240.0}) {
        for (const double fastest : {8.0, 30.0, 200.0}) {
            for (int i = 0; i < 2; ++i) {
                Run run =
                    run_at(text_of(rate) + " Hz, dashes of " + text_of(fastest) + " m/s, seed " + std::to_string(seed),
                           level, {-4, 0, 1}, random_walk(seed, fastest), 30);
                run.rate = rate;
                ++seed;
                scene.runs.push_back(run);
            }
        }
    }
    return scene;
}

}  // namespace

void add_inside(Scenes& scenes) {
    for (const auto make : {spawned, soak}) scenes.push_back(make());
}

}  // namespace surefoot::course
