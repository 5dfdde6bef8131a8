// The same walk far from the origin, by characters of all sizes, and at all rates.
#include "course/scenes/common.hpp"

namespace surefoot::course {
namespace {

double distance(const dvec3& a, const dvec3& b) {
    return std::sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y) + (a.z - b.z) * (a.z - b.z));
}

// A floor, a ramp beside it, stairs, a wall at the end and a block in the way, all times `scale`.
Triangles grounds(double scale) {
    Triangles triangles;
    triangles.floor({-20, 0, -20}, {0, 0, 20}, 40);
    triangles.stairs(0, 6, 0.25, 0.4, 4, 6);
    triangles.sheet({0, 0, -12}, {0, 0, -4}, {4, 1.5, -4}, {4, 1.5, -12}, 8, 8);
    triangles.block({-6, -0.5, -2}, {-5, 2, 0.3});
    triangles.block({8, -1, -20}, {9, 6, 20});
    for (vec3& vertex : triangles.vertices) vertex = vec3(dvec3(vertex) * scale);
    return triangles;
}

// Round the block, up the stairs, along the wall at the end; or up the ramp and over its end.
Script tour(double scale, double first_heading) {
    return [scale, first_heading](double time, const Spot&) {
        const double degrees = time < 2 ? first_heading : time < 4 ? -first_heading : 20;
        return Input{heading(degrees, 3 * scale), time > 5 && time < 5.2};
    };
}

Scene far_away() {
    Scene scene{"far", "the same walks at 0 to 1e7 m from the origin", {}, {}, {}};
    for (const double far : {0.0, 1e3, 1e4, 1e5, 1e6, 1e7}) {
        for (const double first : {3.0, 35.0}) {
            const dvec3 origin = dvec3{1, 0.25, -0.5} * far;
            Run run = run_at(text_of(far) + " m, heading " + text_of(first), level_of(grounds(1), {.position = origin}),
                             dvec3{-9, 0, -1.2} + origin, tour(1, first), 7);
            scene.runs.push_back(run);
        }
    }
    scene.bars = {{"differs from the walk at the origin", "m", 0.001,
                   "doubles are 2e-9 m apart at 1e7 m; a millimetre is a tenth of the skin",
                   [](std::span<const Outing> outings) {
                       Worst worst;
                       for (std::size_t i = 2; i < outings.size(); ++i) {
                           const Outing& near = outings[i % 2];
                           for (std::size_t k = 0; k < near.spots.size(); ++k)
                               worst.take(distance(outings[i].spots[k].position - outings[i].run->start,
                                                   near.spots[k].position - near.run->start),
                                          outings[i].run->name);
                       }
                       return worst;
                   }},
                  depth_bar()};
    return scene;
}

Scene sizes() {
    Scene scene{"sizes", "the same walks by characters of 1 cm to 1 km, everything scaled", {}, {}, {}};
    for (const double tall : {1.8, 0.01, 0.1, 20.0, 1000.0}) {
        const double scale = tall / 1.8;
        for (const double first : {3.0, 35.0}) {
            Run run = run_at(text_of(tall) + " m, heading " + text_of(first), level_of(grounds(scale)), {0, 0, 0},
                             tour(scale, first), 7);
            CharacterSettings& settings = run.settings;
            const Capsule capsule = capsule_of(settings);
            settings.volume = Capsule{.radius = capsule.radius * scale, .half_height = capsule.half_height * scale};
            for (double* length :
                 {&settings.skin, &settings.step_up, &settings.step_depth, &settings.snap_down,
                  &settings.perch_distance, &settings.jump_height, &settings.gravity, &settings.terminal_speed})
                *length *= scale;
            run.start = dvec3{-9, 0, -1.2} * scale + dvec3{0, standing(settings) + 2 * settings.skin, 0};
            scene.runs.push_back(run);
        }
    }
    scene.bars = {{"differs from the walk of 1.8 m", "of its size", 0.001,
                   "geometry has no size: all lengths, speeds and gravity are scaled, and so is the way",
                   [](std::span<const Outing> outings) {
                       Worst worst;
                       for (std::size_t i = 2; i < outings.size(); ++i) {
                           const Outing& own = outings[i % 2];
                           const double scale = standing(outings[i].run->settings) / standing(own.run->settings);
                           for (std::size_t k = 0; k < own.spots.size(); ++k)
                               worst.take(distance(outings[i].spots[k].position * (1 / scale), own.spots[k].position),
                                          outings[i].run->name);
                       }
                       return worst;
                   }},
                  {"in a triangle", "of its size", 0.001,
                   "a body that is kept off by a skin is never inside of anything", each([](const Outing& outing) {
                       return depth(outing) * half_width(hero()) / half_width(outing.run->settings);
                   })}};
    return scene;
}

const double rates[] = {15, 30, 60, 120, 240, 960};

Scene open_ground() {
    Scene scene{"rates-open", "rolling ground, random wishes that change every 1/15 s, at 15 to 960 Hz", {}, {}, {}};
    Triangles triangles;
    const auto at = [](int i, int k) {
        return dvec3{1.0 * i, 0.4 * std::sin(0.7 * i) + 0.5 * std::sin(0.45 * k + 0.3 * i), 1.0 * k};
    };
    for (int i = -25; i < 25; ++i) {
        for (int k = -25; k < 25; ++k) triangles.quad(at(i, k), at(i, k + 1), at(i + 1, k + 1), at(i + 1, k));
    }
    const LevelPointer level = level_of(triangles);
    std::vector<dvec3> wishes;
    Dice dice(7);
    for (int i = 0; i < 100; ++i) wishes.push_back(heading(dice.from(0, 360), dice.from(1, 5)));
    for (const double rate : rates) {
        Run run = run_at(
            text_of(rate) + " Hz", level, {0.3, 0.2, 0.2},
            [wishes](double time, const Spot&) {
                return Input{wishes[static_cast<std::size_t>(time * 15 + 1e-6) % wishes.size()]};
            },
            6);
        run.rate = rate;
        run.settle = 2;
        scene.runs.push_back(run);
    }
    scene.bars = {{"diverges beyond 1 cm + 0.1 v dt", "m", 0,
                   "the ground is the same, so the way is; a tick's motion may be led by one facet instead of the next",
                   divergence([](const Run& run) { return 0.01 + 0.1 * 5 * run.dt(); })},
                  ground_bar(),
                  depth_bar()};
    return scene;
}

Scene landings() {
    Scene scene{"rates-land", "falls on slopes that can be stood on, at 15 to 960 Hz", {}, {}, {}};
    for (const double degrees : {10.0, 25.0, 40.0}) {
        const double c = 20 * std::cos(radians(degrees)), s = 20 * std::sin(radians(degrees));
        const LevelPointer level =
            level_of(Triangles().sheet({-c, -s, -20}, {-c, -s, 20}, {c, s, 20}, {c, s, -20}, 20, 20));
        for (const double rate : rates) {
            Run run = run_at(text_of(degrees) + " degrees, " + text_of(rate) + " Hz", level, {0, 1.5, 0}, walk({}), 2);
            run.rate = rate;
            run.settle = 0;
            scene.runs.push_back(run);
        }
    }
    scene.bars = {
        {"slides on landing beyond 1 cm + 0.1 v dt", "m", 0,
         "ground that can be stood on ends a fall where it is met; a tick's motion is the most that is uncertain",
         each([](const Outing& outing) {
             const double v = std::sqrt(2 * hero().gravity * 1.5);
             const dvec3 way = outing.last().position - outing.run->start;
             return std::hypot(way.x, way.z) - 0.01 - 0.1 * v * outing.run->dt();
         })},
        rest_bar(0.5),
        depth_bar()};
    return scene;
}

Scene jumps() {
    Scene scene{"rates-jump", "how high a jump is, at 15 to 960 Hz", {}, {}, {}};
    const LevelPointer level = level_of(Triangles().floor({-10, 0, -10}, {10, 0, 10}, 5));
    for (const double rate : rates) {
        Run run = run_at(
            text_of(rate) + " Hz", level, {0, 0, 0},
            [](double time, const Spot&) {
                return Input{{}, time < 1};
            },
            2);
        run.rate = rate;
        scene.runs.push_back(run);
    }
    scene.bars = {{"off the height beyond g dt^2 / 8", "m", hero().skin,
                   "a jump is a parabola; ticks that miss its top by half a tick are g dt^2 / 8 below it",
                   each([](const Outing& outing) {
                       const double dt = outing.run->dt();
                       return std::abs(climbed(outing) - hero().jump_height) - hero().gravity * dt * dt / 8;
                   })},
                  depth_bar(),
                  rest_bar(0.5)};
    return scene;
}

// Ground up to x = 0 and again from x = `width` on, with a pit between.
Scene gaps() {
    Scene scene{
        "rates-gap", "jumps over a gap that is wide enough or too wide by half a metre, at 15 to 960 Hz", {}, {}, {}};
    for (const double rate : rates) {
        for (const double width : {1.6, 3.4}) {
            const LevelPointer level = level_of(Triangles()
                                                    .block({-20, -8, -10}, {0, 0, 10})
                                                    .block({width, -8, -10}, {width + 20, 0, 10})
                                                    .floor({-20, -8, -10}, {30, -8, 10}));
            Run run = run_at(
                text_of(width) + " m at " + text_of(rate) + " Hz", level, {-4, 0, 0},
                [](double time, const Spot&) {
                    return Input{{4, 0, 0}, time > 0.9 && time < 1.9};
                },
                3);
            run.rate = rate;
            scene.runs.push_back(run);
        }
    }
    // It leaves at x = -0.27 and comes down sqrt(8 h / g) = 0.69 s and 2.77 m later.
    scene.bars = {
        {"the wrong outcome", "", 0, "a jump of 2.77 m from 0.27 m before the edge ends at 2.5 m, at any rate",
         each([](const Outing& outing) {
             const bool is_over = feet(outing) > -0.1;
             return is_over == (std::stod(outing.run->name) < 2) ? 0 : 1;
         })},
        depth_bar()};
    return scene;
}

}  // namespace

void add_scale(Scenes& scenes) {
    for (const auto make : {far_away, sizes, open_ground, landings, jumps, gaps}) scenes.push_back(make());
}

}  // namespace surefoot::course
