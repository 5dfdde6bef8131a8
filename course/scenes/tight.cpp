// Little room: ceilings, wedges, crevices, lintels.
#include "course/scenes/common.hpp"

namespace surefoot::course {
namespace {

constexpr double speed = 4;
constexpr double skin = 0.01;
constexpr double tall = 1.8;
constexpr double wide = 0.8;

// A floor, and a ceiling that comes down towards +x and meets it at x = 6.
LevelPointer wedge(double degrees) {
    const double high = 4, run = high / std::tan(radians(degrees));
    return level_of(Triangles()
                        .floor({-30, 0, -20}, {6, 0, 20}, 20)
                        .sheet({6 - run, high, -20}, {6, 0, -20}, {6, 0, 20}, {6 - run, high, 20}, 9, 9));
}

Scene wedges() {
    Scene scene{"wedge",
                "between a floor and a ceiling that comes down to it",
                {},
                {stop_bar(), level_bar(), ground_bar(), depth_bar()},
                {}};
    for (const double degrees : {10.0, 20.0, 30.0, 45.0, 60.0, 80.0})
        scene.runs.push_back(run_at(text_of(degrees) + " degrees", wedge(degrees),
                                    {6 - 2.2 / std::tan(radians(degrees)) - 3, 0, 0.1}, walk({speed, 0, 0}),
                                    degrees < 15 ? 4 : 2));
    return scene;
}

Scene wedges_along() {
    Scene scene{"wedge-along",
                "along such a wedge, pressed into it",
                {},
                {{"speed along it is off", "", 1e-3, "the floor and the ceiling leave the part of the wish along both",
                  each([](const Outing& outing) {
                      const auto spots = outing.scripted();
                      Worst worst;
                      for (std::size_t i = 1; i < spots.size(); ++i)
                          worst.take(std::abs((spots[i].position.z - spots[i - 1].position.z) /
                                                  (spots[i].input.wish.z * outing.run->dt()) -
                                              1),
                                     {});
                      return worst.value;
                  })},
                 level_bar(),
                 ground_bar(),
                 depth_bar()},
                {}};
    for (const double degrees : {20.0, 30.0, 45.0, 60.0, 80.0})
        scene.runs.push_back(run_at(text_of(degrees) + " degrees", wedge(degrees),
                                    {6 - 2.2 / std::tan(radians(degrees)) - 1, 0, -8}, walk(heading(50, speed)), 3));
    return scene;
}

Scene ceilings() {
    Scene scene{"ceiling-jump", "jumping under ceilings, level and sloped", {}, {}, {}};
    for (const double room : {0.05, 0.3, 1.0}) {
        for (const double tilt : {0.0, 20.0}) {
            const double rise = 10 * std::tan(radians(tilt)), high = tall + 2 * skin + room;
            const LevelPointer level = level_of(Triangles()
                                                    .floor({-10, 0, -10}, {10, 0, 10}, 7)
                                                    .sheet({-10, high - rise, -10}, {10, high + rise, -10},
                                                           {10, high + rise, 10}, {-10, high - rise, 10}, 7, 7));
            scene.runs.push_back(run_at(
                text_of(room) + " m of room, tilted " + text_of(tilt), level, {tilt > 0 ? 0.5 : 0, 0, 0},
                [](double time, const Spot&) {
                    return Input{{}, time < 3 && std::fmod(time, 1) < 0.5};
                },
                4));
        }
    }
    scene.bars = {
        depth_bar(),
        rest_bar(0.5),
        {"misses the ground", "m", 2 * skin, "every jump ends on the floor",
         each([](const Outing& outing) { return std::abs(feet(outing)); })},
        {"short of the ceiling", "m", 0,
         "a level ceiling within a jump's height is reached, all but a skin, what an apex is kept off the floor by "
         "beyond that, and what rounding adds",
         each([](const Outing& outing) {
             const double room = std::stod(outing.run->name);
             const bool is_level = outing.run->name.ends_with(" 0");
             const double kept_off = gap_below(outing.run->settings) - skin;
             const double least = std::min(room - kept_off, hero().jump_height - 0.1) - 3 * skin;
             return is_level ? short_of(least, climbed(outing)) : 0;
         })}};
    return scene;
}

// Two blocks that leave a passage of some width along x, from x = 0 to x = 4.
LevelPointer passage(double width) {
    return level_of(Triangles()
                        .floor({-10, 0, -10}, {20, 0, 10}, 10)
                        .block({0, -0.5, width / 2}, {4, 3, 8})
                        .block({0, -0.5, -8}, {4, 3, -width / 2}));
}

Scene wide_enough() {
    Scene scene{"crevice-wide",
                "passages that leave a centimetre and more beside the skin",
                {},
                {speed_bar(), level_bar(), ground_bar(), depth_bar()},
                {}};
    for (const double width : {wide + 2 * skin + 0.01, 0.85, 0.9, 1.2})
        scene.runs.push_back(run_at(text_of(width) + " m", passage(width), {-1, 0, 0}, walk({speed, 0, 0}), 2));
    return scene;
}

Scene too_narrow() {
    Scene scene{"crevice-narrow",
                "passages that are too narrow",
                {},
                {stop_bar(),
                 level_bar(),
                 ground_bar(),
                 depth_bar(),
                 {"goes in", "m", 0, "a round body comes no farther than its own radius",
                  each([](const Outing& outing) { return std::max(0.0, outing.last().position.x); })}},
                {}};
    for (const double width : {0.78, 0.7, 0.5, 0.2, 0.02}) {
        scene.runs.push_back(run_at(text_of(width) + " m", passage(width), {-1, 0, 0}, walk({speed, 0, 0}), 2));
        scene.runs.push_back(
            run_at(text_of(width) + " m, beside the middle", passage(width), {-1, 0, 0.05}, walk({speed, 0, 0}), 3));
    }
    return scene;
}

Scene lintels() {
    Scene scene{"lintel",
                "a step under a lintel that leaves no room above it",
                {},
                {stop_bar(),
                 {"goes under", "m", 0, "under the lintel there is no room for its centre",
                  each([](const Outing& outing) { return std::max(0.0, outing.last().position.x - 0.1); })},
                 {"climbs", "m", 2 * skin, "it may lean on the step's edge but not get higher than the step",
                  each([](const Outing& outing) { return climbed(outing) - std::stod(outing.run->name); })},
                 ground_bar(),
                 depth_bar()},
                {}};
    for (const double rise : {0.1, 0.3, 0.39}) {
        for (const double room : {tall - 0.02, tall - 0.5}) {
            const LevelPointer level = level_of(Triangles()
                                                    .floor({-10, 0, -10}, {0, 0, 10}, 5)
                                                    .block({0, -0.5, -10}, {5, rise, 10})
                                                    .block({0.1, rise + room, -10}, {5, 6, 10}));
            scene.runs.push_back(run_at(text_of(rise) + " m, " + text_of(room) + " m of room", level, {-1, 0, 0},
                                        walk({speed, 0, 0}), 2));
        }
    }
    return scene;
}

}  // namespace

void add_tight(Scenes& scenes) {
    for (const auto make : {wedges, wedges_along, ceilings, wide_enough, too_narrow, lintels}) scenes.push_back(make());
}

}  // namespace surefoot::course
