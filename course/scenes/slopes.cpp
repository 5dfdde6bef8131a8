// Slopes from 0 to 89 degrees, crests, grooves, funnels and bowls. The limit is 50 degrees; nothing is asked of what is
// within a degree of it.
#include "course/scenes/common.hpp"

namespace surefoot::course {
namespace {

constexpr double speed = 3;
constexpr double skin = 0.01;
constexpr double limit = 50;

// A slope up along +x through the origin, 40 m of it to both sides, in `pieces` x `pieces` pieces.
Triangles slope(double degrees, int pieces = 1) {
    const double c = 40 * std::cos(radians(degrees)), s = 40 * std::sin(radians(degrees));
    return Triangles().sheet({-c, -s, -20}, {-c, -s, 20}, {c, s, 20}, {c, s, -20}, pieces, pieces);
}

// A run that begins on such a slope at level distance x: a ball that touches it is r / cos above it.
Run on_slope(const std::string& name, const Triangles& triangles, double degrees, double x, Script script,
             double seconds) {
    Run run = run_at(name, level_of(triangles), {0, 0, 0}, std::move(script), seconds);
    const double c = std::cos(radians(degrees));
    run.rests_on = {-std::sin(radians(degrees)), c, 0};
    run.start = {x, x * std::tan(radians(degrees)) + (reach(run.settings, -run.rests_on) + 2 * skin) / c, 0};
    return run;
}

double degrees_of(const Outing& outing) {
    return std::stod(outing.run->name);
}

Scene stand() {
    Scene scene{
        "slope-stand", "standing on slopes of 0 to 49 degrees", {}, {rest_bar(3), ground_bar(), depth_bar()}, {}};
    for (double degrees = 0; degrees < limit; degrees += 7)
        scene.runs.push_back(on_slope(text_of(degrees) + " degrees", slope(degrees, 20), degrees, 0.3, walk({}), 3));
    return scene;
}

Scene slip() {
    Scene scene{
        "slope-slip",
        "put on slopes of 51 to 89 degrees",
        {},
        {{"short of sliding", "m", 0,
          "its level wish of zero is reached at once, which takes the level part of its slide away tick by tick; "
          "what gravity adds in a tick is left, g dt sin^2(a)",
          each([](const Outing& outing) {
              const double s = std::sin(radians(degrees_of(outing)));
              const double least = outing.run->settings.gravity * outing.run->dt() * s * s;
              return short_of(least * outing.last().time, gone(outing, {0, -1, 0}));
          })},
         {"stands", "of the ticks", 0, "what is too steep is no ground",
          each([](const Outing& outing) { return 1 - airborne(outing); })},
         depth_bar()},
        {}};
    for (const double degrees : {51.0, 55.0, 60.0, 70.0, 80.0, 85.0, 89.0}) {
        scene.runs.push_back(on_slope(text_of(degrees) + " degrees", slope(degrees, 20), degrees, -0.3, walk({}), 1));
        scene.runs.back().settle = 0.1;
    }
    return scene;
}

// Up, across and diagonally: the speed stays what it was in the first tick, whichever way a mover reads "speed".
double unsteady(const Outing& outing) {
    const auto spots = outing.scripted();
    const auto way = [&](std::size_t i) {
        return std::hypot(spots[i].position.x - spots[i - 1].position.x, spots[i].position.z - spots[i - 1].position.z);
    };
    Worst worst;
    for (std::size_t i = 4; i < spots.size(); ++i) worst.take(std::abs(way(i) / way(3) - 1), {});
    return worst.value;
}

Bar slope_pace_bar() {
    return {
        "short of the way", "of it", 0.01,
        "a walkable slope stops nothing: the level way is the speed asked for, or its part along the ground where a "
        "mover measures speed there",
        each([](const Outing& outing) {
            const auto spots = outing.scripted();
            const dvec3 way = outing.last().position - spots.front().position;
            const double asked = speed * outing.last().time * std::cos(radians(degrees_of(outing)));
            return std::max(0.0, 1 - std::hypot(way.x, way.z) / asked);
        })};
}

Scene walked() {
    Scene scene{"slope-walk",
                "walking up, down, across and diagonally on slopes of up to 49 degrees",
                {},
                {{"speed changes", "", 1e-3, "the slope is the same everywhere", each(unsteady)},
                 slope_pace_bar(),
                 ground_bar(),
                 depth_bar()},
                {}};
    for (const double degrees : {5.0, 15.0, 30.0, 45.0, 49.0}) {
        for (const double direction : {0.0, 40.0, 90.0, 180.0, 215.0}) {
            scene.runs.push_back(on_slope(text_of(degrees) + " degrees, heading " + text_of(direction),
                                          slope(degrees, 80), degrees, 0.3, walk(heading(direction, speed)), 2));
        }
    }
    return scene;
}

Triangles floor_and_ramp(double degrees) {
    return Triangles().floor({-20, 0, -20}, {0, 0, 20}, 20).ramp(0, degrees > 80 ? 2 : 8, degrees, 20, 10);
}

Scene climb() {
    Scene scene{"slope-climb",
                "from level ground up slopes of up to 49 degrees",
                {},
                {slope_pace_bar(), ground_bar(), depth_bar()},
                {}};
    for (double degrees = 7; degrees < limit; degrees += 7)
        scene.runs.push_back(run_at(text_of(degrees) + " degrees", level_of(floor_and_ramp(degrees)), {-2, 0, 0},
                                    walk({speed, 0, 0}), 2.5));
    return scene;
}

Scene too_steep() {
    Scene scene{"slope-too-steep",
                "from level ground against slopes of 51 to 89 degrees, straight and at an angle",
                {},
                {{"climbs", "m", 2 * skin, "what is steeper than the limit is a wall to feet", each(climbed)},
                 ground_bar(),
                 depth_bar()},
                {}};
    for (const double degrees : {51.0, 55.0, 60.0, 70.0, 80.0, 85.0, 89.0}) {
        for (const double direction : {0.0, 60.0})
            scene.runs.push_back(run_at(text_of(degrees) + " degrees, heading " + text_of(direction),
                                        level_of(floor_and_ramp(degrees)), {-1, 0, -3}, walk(heading(direction, speed)),
                                        3));
    }
    return scene;
}

Scene jumped() {
    Scene scene{"slope-jump", "jumping against slopes that are too steep, for six seconds", {}, {}, {}};
    for (const double degrees : {55.0, 65.0, 75.0, 85.0}) {
        const Script script = [](double time, const Spot&) {
            return Input{time < 6 ? dvec3{speed, 0, 0} : dvec3{0, 0, 0}, time < 6 && std::fmod(time, 0.5) < 0.2};
        };
        scene.runs.push_back(
            run_at(text_of(degrees) + " degrees", level_of(floor_and_ramp(degrees)), {-1, 0, 0}, script, 8));
    }
    scene.bars = {{"gains", "m", hero().jump_height + 2 * skin,
                   "a jump begins on ground, and the only ground is the floor: one jump's height is the most there is",
                   each(climbed)},
                  {"keeps", "m", 2 * skin, "what a jump gained on a slope that is too steep is given back",
                   each([](const Outing& outing) { return std::abs(feet(outing)); })},
                  depth_bar()};
    return scene;
}

Scene crests() {
    Scene scene{"crest", "over roofs of 10 to 40 degrees at 2 to 8 m/s", {}, {}, {}};
    constexpr double half = 3;
    for (const double degrees : {10.0, 20.0, 30.0, 40.0}) {
        const double top = half * std::tan(radians(degrees));
        const LevelPointer level =
            level_of(Triangles()
                         .floor({-20, 0, -20}, {-half, 0, 20}, 5)
                         .sheet({-half, 0, -20}, {-half, 0, 20}, {0, top, 20}, {0, top, -20}, 6, 6)
                         .sheet({0, top, -20}, {0, top, 20}, {half, 0, 20}, {half, 0, -20}, 6, 6)
                         .floor({half, 0, -20}, {30, 0, 20}, 5));
        for (const double v : {2.0, 4.0, 8.0})
            scene.runs.push_back(run_at(text_of(degrees) + " degrees at " + text_of(v) + " m/s", level, {-4, 0, 0.2},
                                        walk({v, 0, 0}), 12 / v));
    }
    scene.bars = {
        ground_bar(),
        depth_bar(),
        {"launched", "m", 2 * skin, "nothing lifts it above where it stands on the ridge",
         each([](const Outing& outing) { return climbed(outing) - half * std::tan(radians(degrees_of(outing))); })},
        {"misses the ground", "m", 2 * skin, "it comes down to the level ground behind",
         each([](const Outing& outing) { return std::abs(feet(outing)); })}};
    return scene;
}

LevelPointer groove(double degrees) {
    const double wide = 6 * std::cos(radians(degrees)), high = 6 * std::sin(radians(degrees));
    return level_of(Triangles()
                        .sheet({-20, 0, 0}, {-20, high, -wide}, {20, high, -wide}, {20, 0, 0}, 5, 50)
                        .sheet({-20, high, wide}, {-20, 0, 0}, {20, 0, 0}, {20, high, wide}, 5, 50));
}

Scene grooves() {
    Scene scene{"groove", "grooves of two slopes of 20 to 75 degrees: along them, and standing in them", {}, {}, {}};
    for (const double degrees : {20.0, 40.0, 49.0, 60.0, 75.0}) {
        Run run = run_at(text_of(degrees) + " degrees, along", groove(degrees), {-10, 0, 0}, walk({speed, 0, 0}), 3);
        // Both slopes are as far from it, so one stands for both.
        run.rests_on = {0, std::cos(radians(degrees)), std::sin(radians(degrees))};
        run.start.y = (reach(run.settings, -run.rests_on) + 2 * skin) / run.rests_on.y;
        scene.runs.push_back(run);
        run.name = text_of(degrees) + " degrees, standing";
        run.script = walk({});
        scene.runs.push_back(run);
    }
    scene.bars = {{"speed is off", "", 1e-3, "along a groove nothing is in the way", each(speed_error)},
                  {"moves at rest", "m a tick", 1e-9, "held from both sides it cannot slide, so it stands",
                   each([](const Outing& outing) { return outing.last().input.wish.x > 0 ? 0 : unrest(outing, 2); })},
                  level_bar(),
                  ground_bar(),
                  depth_bar()};
    return scene;
}

Triangles cone(double degrees, int sides) {
    Triangles triangles;
    const double wide = 3, high = wide * std::tan(radians(degrees));
    for (int i = 0; i < sides; ++i) {
        const auto rim = [&](int k) { return heading(k * 360.0 / sides, wide) + dvec3{0, high, 0}; };
        triangles.triangle({0, 0, 0}, rim(i + 1), rim(i));
    }
    return triangles;
}

Scene funnels() {
    Scene scene{"funnel", "dropped into steep funnels of 3 to 24 sides", {}, {}, {}};
    for (const int sides : {3, 4, 7, 24}) {
        for (const double degrees : {55.0, 65.0, 75.0}) {
            Run run = run_at(text_of(degrees) + " degrees, " + text_of(sides) + " sides",
                             level_of(cone(degrees, sides)), {0.17, 4, 0.05}, walk({}), 5);
            run.settle = 0.1;
            scene.runs.push_back(run);
        }
    }
    scene.bars = {rest_bar(1),
                  depth_bar(),
                  {"in the air at the end", "", 0, "held from all sides it cannot slide, so it stands",
                   each([](const Outing& outing) { return outing.last().grounded ? 0 : 1; })}};
    return scene;
}

Scene bowls() {
    Scene scene{"bowl", "walking and jumping out of a round bowl", {}, {}, {}};
    constexpr double radius = 6;
    constexpr int rings = 18, sides = 36;
    Triangles triangles;
    const auto at = [](int ring, int side) {
        const double polar = 90.0 * ring / rings;
        return heading(360.0 * side / sides, radius * std::sin(radians(polar))) +
               dvec3{0, radius * (1 - std::cos(radians(polar))), 0};
    };
    for (int side = 0; side < sides; ++side) {
        triangles.triangle(at(0, 0), at(1, side + 1), at(1, side));
        for (int ring = 1; ring < rings; ++ring)
            triangles.quad(at(ring, side), at(ring, side + 1), at(ring + 1, side + 1), at(ring + 1, side));
    }
    const LevelPointer level = level_of(triangles);
    for (const double direction : {0.0, 33.0, 90.0, 200.0}) {
        scene.runs.push_back(
            run_at("walking, heading " + text_of(direction), level, {0, 0, 0}, walk(heading(direction, speed)), 6));
        scene.runs.push_back(run_at(
            "jumping, heading " + text_of(direction), level, {0, 0, 0},
            [direction](double time, const Spot&) {
                return Input{heading(direction, speed), std::fmod(time, 1) < 0.5};
            },
            6));
    }
    // Facets of 5 degrees: the first that is too steep begins within 5 degrees of the limit. In a bowl of R a body
    // touches at R (1 - cos a), and its own lowest point is below that: r (1 - cos a) for a ball of r.
    const auto highest = [](const Outing& outing) {
        const CharacterSettings& settings = outing.run->settings;
        return radius * (1 - std::cos(radians(limit + 5))) + touches_below(settings, limit + 5) - standing(settings);
    };
    scene.bars = {{"climbs too high", "m", hero().jump_height + 2 * skin,
                   "ground ends where the bowl gets too steep, and one jump is the most that is added",
                   each([highest](const Outing& outing) { return climbed(outing) - highest(outing); })},
                  {"climbs too high on foot", "m", 2 * skin, "ground ends where the bowl gets too steep",
                   each([highest](const Outing& outing) {
                       return outing.run->name.starts_with("walking") ? climbed(outing) - highest(outing) : 0;
                   })},
                  depth_bar()};
    return scene;
}

}  // namespace

void add_slopes(Scenes& scenes) {
    for (const auto make : {stand, slip, walked, climb, too_steep, jumped, crests, grooves, funnels, bowls})
        scenes.push_back(make());
}

}  // namespace surefoot::course
