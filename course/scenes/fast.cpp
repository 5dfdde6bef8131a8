// Thin walls at speed, falls, ledges.
#include "course/scenes/common.hpp"

namespace surefoot::course {
namespace {

constexpr double skin = 0.01;

Scene thin_walls() {
    Scene scene{"thin-wall", "walls without thickness at 10 m/s to 10 km/s, at 15 and 60 Hz", {}, {}, {}};
    const LevelPointer sheet =
        level_of(Triangles().quad({5, -50, -30000}, {5, -50, 30000}, {5, 50, 30000}, {5, 50, -30000}));
    const LevelPointer panels =
        level_of(Triangles().sheet({5, -20, -20}, {5, -20, 20}, {5, 20, 20}, {5, 20, -20}, 80, 80));
    for (const double rate : {15.0, 60.0}) {
        for (const double v : {10.0, 100.0, 340.0, 1000.0, 10000.0}) {
            for (const double degrees : {0.0, 60.0, 85.0}) {
                Run run = run_at(text_of(v) + " m/s at " + text_of(degrees) + " degrees, " + text_of(rate) + " Hz",
                                 sheet, {0, 0, 0}, walk(heading(degrees, v)), degrees > 80 ? 8 : 1.2);
                if (v > 5000 && degrees > 80) run.seconds = 2;
                run.rate = rate;
                run.settings.gravity = 0;
                scene.runs.push_back(run);
                if (degrees > 0) continue;
                run.name = text_of(v) + " m/s against panels, " + text_of(rate) + " Hz";
                run.level = panels;
                scene.runs.push_back(run);
            }
        }
    }
    scene.bars = {{"through the wall", "m", 1e-6, "its centre stays a radius before the wall, whatever the speed",
                   each([](const Outing& outing) {
                       Worst worst;
                       for (const Spot& spot : outing.spots) worst.take(spot.position.x - (5 - 0.4), {});
                       return worst.value;
                   })},
                  {"short of the wall", "m", 2 * skin, "what flies at a wall gets to it",
                   each([](const Outing& outing) { return 5 - 0.4 - outing.last().position.x; })}};
    return scene;
}

Scene falls() {
    Scene scene{"thin-floor", "falls on a floor without thickness, at up to 10 km/s", {}, {}, {}};
    const LevelPointer level = level_of(Triangles().floor({-50, 0, -50}, {50, 0, 50}, 20));
    for (const double rate : {15.0, 60.0}) {
        for (const double gravity : {20.0, 1000.0, 1e5}) {
            Run run = run_at("gravity " + text_of(gravity) + " m/s^2, " + text_of(rate) + " Hz", level, {0.3, 300, 0.2},
                             walk({}), 8);
            run.settle = 0;
            run.rate = rate;
            run.settings.gravity = gravity;
            run.settings.terminal_speed = 1e4;
            scene.runs.push_back(run);
        }
    }
    scene.bars = {{"through the floor", "m", 1e-6, "its feet stay above the floor, whatever the speed",
                   each([](const Outing& outing) {
                       Worst worst;
                       for (const Spot& spot : outing.spots)
                           worst.take(standing(outing.run->settings) - spot.position.y, {});
                       return worst.value;
                   })},
                  {"misses the ground", "m", 2 * skin, "it stands on it in the end",
                   each([](const Outing& outing) { return std::abs(feet(outing)); })},
                  rest_bar(1)};
    return scene;
}

// Ground that ends at x = 0, `drop` above the ground behind.
LevelPointer ledge(double drop) {
    return level_of(Triangles()
                        .floor({0, -drop, -20}, {40, -drop, 20}, 10)
                        .floor({-20, 0, -20}, {0, 0, 20}, 10)
                        .sheet({0, -drop, -20}, {0, 0, -20}, {0, 0, 20}, {0, -drop, 20}, 1, 10));
}

double drop_of(const Outing& outing) {
    return std::stod(outing.run->name);
}

Bar landing_bar() {
    return {"misses the ground", "m", 2 * skin, "it stands on the lower ground in the end",
            each([](const Outing& outing) { return std::abs(feet(outing) + drop_of(outing)); })};
}

Scene high_ledges() {
    Scene scene{"ledge-high", "walking off ledges of 1 to 5 m at 0.5 to 8 m/s", {}, {}, {}};
    for (const double drop : {1.0, 3.0, 5.0}) {
        for (const double v : {0.5, 2.0, 8.0})
            scene.runs.push_back(run_at(text_of(drop) + " m at " + text_of(v) + " m/s", ledge(drop), {-0.5, 0, 0},
                                        walk({v, 0, 0}), v < 1 ? 5 : 3));
    }
    scene.bars = {
        landing_bar(),
        depth_bar(),
        {"rises", "m a tick", 0.1 * skin, "nothing lifts what walks off a ledge", each(rise_in_a_tick)},
        {"speed is off", "of the way", 0.01,
         "nothing is in the way, neither on the ledge nor in the air; an end that is higher than wide is wedged off "
         "the "
         "edge that it falls past, from where it does not hold any more to its whole width",
         each([](const Outing& outing) {
             const CharacterSettings& settings = outing.run->settings;
             const double asked = outing.last().input.wish.x * outing.last().time;
             const double off = gone(outing, {1, 0, 0}) - asked;
             const bool is_wedge = tapered_end(settings) > half_width(settings);
             const double wedged = is_wedge ? half_width(settings) + skin - settings.perch_distance : 0;
             return (off > 0 ? std::max(0.0, off - wedged) : -off) / asked;
         })},
        {"ticks on the way down", "of those of a free fall", 0.2,
         "a fall of h takes sqrt(2 h / g); rolling off the edge adds a little", each([](const Outing& outing) {
             const double drop = drop_of(outing), top = outing.scripted().front().position.y;
             const double end = std::min(tapered_end(outing.run->settings), drop);
             double time = 0;
             for (const Spot& spot : outing.scripted()) {
                 const double fallen = top - spot.position.y;
                 if (fallen > end && fallen < drop - 0.05) time += outing.run->dt();
             }
             // From there on the end that rolls is off the edge, and it has at least the speed of a fall along it.
             const double all = std::sqrt(2 * drop / 20), first = std::sqrt(2 * end / 20);
             return std::max(0.0, (time - outing.run->dt() - (all - first)) / all);
         })}};
    return scene;
}

Scene low_ledges() {
    Scene scene{"ledge-low",
                "walking off ledges within the snap distance",
                {},
                {landing_bar(),
                 ground_bar(),
                 depth_bar(),
                 {"rises", "m a tick", 0.1 * skin, "nothing lifts what walks off a ledge", each(rise_in_a_tick)}},
                {}};
    for (const double drop : {0.05, 0.2, 0.38}) {
        for (const double v : {0.5, 2.0, 8.0})
            scene.runs.push_back(run_at(text_of(drop) + " m at " + text_of(v) + " m/s", ledge(drop), {-0.5, 0, 0},
                                        walk({v, 0, 0}), v < 1 ? 4 : 2));
    }
    return scene;
}

Scene perches() {
    Scene scene{"ledge-perch",
                "put on an edge, the centre 0.05 to 0.38 m beyond it",
                {},
                {{"moves at rest", "m a tick", 1e-9, "it stays or it slips off; either way it comes to rest",
                  each([](const Outing& outing) { return unrest(outing, 1); })},
                 {"between", "m", 2 * skin, "it stands on the edge or on the ground below, and nowhere between",
                  each([](const Outing& outing) {
                      // On the edge a ball of radius r whose centre is d beyond it is r - sqrt(r^2 - d^2) lower, an
                      // ellipsoid as much more as it is higher than wide, a cone by its slope, a flat end not at all.
                      const double sunk = dip(outing.run->settings, outing.last().position.x);
                      return std::min(std::abs(feet(outing) + 2), std::abs(feet(outing) + sunk));
                  })},
                 depth_bar()},
                {}};
    for (const double beyond : {0.05, 0.15, 0.25, 0.35, 0.38}) {
        scene.runs.push_back(run_at(text_of(beyond) + " m", ledge(2), {beyond, 0, 0}, walk({}), 4));
        scene.runs.back().settle = 0;
    }
    return scene;
}

Scene beams() {
    Scene scene{"beam",
                "along beams 5 to 20 cm wide, on their middle and beside it",
                {},
                {level_bar(), speed_bar(), ground_bar(), depth_bar()},
                {}};
    for (const double width : {0.05, 0.1, 0.2}) {
        auto level = std::make_shared<Level>();
        for (int i = 0; i < 20; ++i)
            level->add(Triangles().block({0, -0.3, -width / 2}, {1, 0, width / 2}), {.position = {-5.0 + i, 0, 0}});
        for (const double off : {0.0, 0.4 * width})
            scene.runs.push_back(run_at(text_of(width) + " m, " + text_of(off) + " m beside the middle", level,
                                        {-4, 0, off}, walk({3, 0, 0}), 4));
    }
    return scene;
}

}  // namespace

void add_fast(Scenes& scenes) {
    for (const auto make : {thin_walls, falls, high_ledges, low_ledges, perches, beams}) scenes.push_back(make());
}

}  // namespace surefoot::course
