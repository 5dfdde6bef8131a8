// Walls that are slid along, corners that are pressed into, edges that are walked around.
#include "course/scenes/common.hpp"

namespace surefoot::course {
namespace {

constexpr double speed = 4;
constexpr double skin = 0.01;

// A wall along z at x = 0 that faces -x, of panels of 0.25 m, leaning: 90 degrees stand upright, less leans back.
Triangles wall(double lean_degrees, int panels) {
    const double run = lean_degrees == 90 ? 0 : 4 / std::tan(radians(lean_degrees));
    return Triangles().sheet({0, 0, -20}, {0, 0, 20}, {run, 4, 20}, {run, 4, -20}, panels, 4);
}

// The speed along a wall whose normal is -x, against the part of the wish that goes along it.
double slide_error(const Outing& outing) {
    Worst worst;
    const std::span<const Spot> spots = outing.scripted();
    const double dt = outing.run->dt();
    for (std::size_t i = 1; i < spots.size(); ++i) {
        const double asked = spots[i].input.wish.z;
        worst.take(std::abs((spots[i].position.z - spots[i - 1].position.z) / (asked * dt) - 1), {});
    }
    return worst.value;
}

Bar slide_bar() {
    return {"speed along the wall is off", "", 1e-3,
            "the motion nearest to the wish that does not enter the wall keeps all of the wish that goes along it",
            each(slide_error)};
}

// Has it come up to the wall, and how far is it off?
Bar gap_bar() {
    return {"off the wall", "m", 2 * skin, "it presses on, so it is a skin away from it and not more than two",
            each([](const Outing& outing) {
                return std::abs(-outing.last().position.x - half_width(outing.run->settings));
            })};
}

Scene walls_alone() {
    Scene scene{"wall-alone",
                "a wall in free space, met at all angles, without gravity",
                {},
                {slide_bar(), gap_bar(), depth_bar()},
                {}};
    const LevelPointer level = level_of(wall(90, 160));
    for (double degrees = 5; degrees <= 85; degrees += 5) {
        Run run = run_at(text_of(degrees) + " degrees", level, {-1, 1, -10}, walk(heading(degrees, speed)), 4);
        run.settings.gravity = 0;
        scene.runs.push_back(run);
    }
    return scene;
}

Scene walls_on_floor() {
    Scene scene{"wall-floor",
                "a wall on a floor, met at all angles",
                {},
                {slide_bar(), gap_bar(), level_bar(), ground_bar(), depth_bar()},
                {}};
    const LevelPointer level = level_of(wall(90, 160).floor({-20, 0, -20}, {20, 0, 20}, 50));
    for (double degrees = 5; degrees <= 85; degrees += 5)
        scene.runs.push_back(
            run_at(text_of(degrees) + " degrees", level, {-1, 0, -10}, walk(heading(degrees, speed)), 4));
    return scene;
}

Scene walls_of_bodies() {
    Scene scene{"wall-bodies",
                "a wall of separate bodies on a floor that is another",
                {},
                {slide_bar(), gap_bar(), level_bar(), ground_bar(), depth_bar()},
                {}};
    auto level = std::make_shared<Level>();
    level->add(Triangles().floor({-20, 0, -20}, {20, 0, 20}, 10));
    for (int i = 0; i < 40; ++i)
        level->add(Triangles().block({0, -0.5, 0}, {1, 4, 1}), {.position = {0, 0, -20.0 + i}});
    for (const double degrees : {10.0, 30.0, 45.0, 60.0, 80.0})
        scene.runs.push_back(
            run_at(text_of(degrees) + " degrees", level, {-1, 0, -10}, walk(heading(degrees, speed)), 4));
    return scene;
}

Scene leaning_walls() {
    Scene scene{"wall-leaning",
                "walls that lean back or over, on a floor",
                {},
                {slide_bar(), level_bar(), ground_bar(), depth_bar()},
                {}};
    for (const double lean : {60.0, 70.0, 80.0, 87.0, 93.0, 100.0, 110.0, 120.0, 135.0}) {
        const LevelPointer level = level_of(wall(lean, 160).floor({-20, 0, -20}, {20, 0, 20}, 50));
        for (const double degrees : {30.0, 75.0}) {
            scene.runs.push_back(run_at("leaning " + text_of(lean) + ", at " + text_of(degrees), level, {-4, 0, -10},
                                        walk(heading(degrees, speed)), degrees < 60 ? 4 : 2));
        }
    }
    return scene;
}

// Two walls that meet at the origin and open towards -x.
Triangles corner(double degrees) {
    const double half = radians(degrees / 2);
    const dvec3 left{-12 * std::cos(half), 0, -12 * std::sin(half)};
    const dvec3 right{-12 * std::cos(half), 0, 12 * std::sin(half)};
    const dvec3 up{0, 4, 0};
    return Triangles().quad({0, 0, 0}, left, left + up, up).quad({0, 0, 0}, up, right + up, right);
}

Scene corners() {
    Scene scene{"corners",
                "corners of 10 to 170 degrees, pressed into along their middle and beside it",
                {},
                {stop_bar(), level_bar(), ground_bar(), depth_bar()},
                {}};
    for (double degrees = 10; degrees <= 170; degrees += 10) {
        const LevelPointer level = level_of(corner(degrees).floor({-20, 0, -20}, {20, 0, 20}, 20));
        for (const double off : {0.0, 5.0, 20.0}) {
            // Pressed into a wall at right angles it does not get to the corner.
            if (off + 4 >= 90 - degrees / 2 && off > 0) continue;
            scene.runs.push_back(run_at(text_of(degrees) + " degrees, " + text_of(off) + " off the middle", level,
                                        {-9, 0, 0}, walk(heading(off, speed)), degrees > 140 || off > 10 ? 16 : 6));
        }
    }
    return scene;
}

Scene corners_of_bodies() {
    Scene scene{"corner-bodies",
                "the same where floor and walls are three bodies",
                {},
                {stop_bar(), level_bar(), ground_bar(), depth_bar()},
                {}};
    for (double degrees = 20; degrees <= 150; degrees += 10) {
        auto level = std::make_shared<Level>();
        level->add(Triangles().floor({-20, 0, -20}, {20, 0, 20}, 3));
        const Triangles both = corner(degrees);
        for (const std::size_t first : {0UL, 6UL}) {
            Triangles one;
            one.vertices.assign(both.vertices.begin() + static_cast<std::ptrdiff_t>(first),
                                both.vertices.begin() + static_cast<std::ptrdiff_t>(first + 6));
            one.indices = {0, 1, 2, 3, 4, 5};
            level->add(one);
        }
        scene.runs.push_back(
            run_at(text_of(degrees) + " degrees", level, {-9, 0, 0}, walk(heading(5, speed)), degrees > 140 ? 16 : 6));
    }
    return scene;
}

Scene convex_edges() {
    // The contact turns with the edge: from an offset d of a radius R it takes R/v ln(cot(asin(d/R)/2)) to be round it.
    Scene scene{"convex-edge", "the outer corner of a block, met head on and beside", {}, {}, {}};
    const LevelPointer level =
        level_of(Triangles().floor({-20, 0, -20}, {20, 0, 20}, 20).block({0, -0.5, 0}, {3, 4, 6}));
    for (const double off : {0.05, 0.1, 0.2, 0.3, 0.38}) {
        scene.runs.push_back(run_at(text_of(off) + " m beside it", level, {-3, 0, -off}, walk({speed, 0, 0}), 2.5));
        scene.runs.push_back(run_at(text_of(off) + " m beside it, at 45 degrees", level,
                                    {-2 + 0.7071 * off, 0, -2 - 0.7071 * off}, walk(heading(45, speed)), 2.5));
    }
    scene.bars = {level_bar(),
                  ground_bar(),
                  depth_bar(),
                  {"short of the way round", "m", 0,
                   "a round body that slides about an edge loses less than half a second on the way; a flat side that "
                   "meets a flat side head on stays",
                   each([](const Outing& outing) {
                       const bool is_straight = outing.last().input.wish.z == 0;
                       if (is_straight && std::holds_alternative<Box>(outing.run->settings.volume.shape)) return 0.0;
                       // Head on it goes on beside the block; at 45 degrees along the side that it came to.
                       const double least = is_straight ? 4 * (2.5 - 0.5) : 4 * 0.7071 * (2.5 - 0.5);
                       return short_of(least, std::max(gone(outing, {1, 0, 0}), gone(outing, {0, 0, 1})));
                   })}};
    return scene;
}

}  // namespace

void add_walls(Scenes& scenes) {
    for (const auto make :
         {walls_alone, walls_on_floor, walls_of_bodies, leaning_walls, corners, corners_of_bodies, convex_edges})
        scenes.push_back(make());
}

}  // namespace surefoot::course
