// Level ground, cut in every way that exporters cut it.
#include "course/scenes/common.hpp"

namespace surefoot::course {
namespace {

constexpr double speed = 4;

// Directions along the cuts, across them, along their diagonals and none of these.
void add_walks(Scene& scene, const LevelPointer& level, double seconds = 3) {
    for (const double degrees : {0.0, 17.0, 45.0, 90.0, 133.0, 180.0, 225.0, 290.0})
        scene.runs.push_back(
            run_at(text_of(degrees) + " degrees", level, {0.13, 0, -0.21}, walk(heading(degrees, speed)), seconds));
}

Scene scene_of(std::string name, std::string title, double noise = 0) {
    return {std::move(name),
            std::move(title),
            {},
            {level_bar(noise), speed_bar(), drift_bar(), ground_bar(), depth_bar()},
            {}};
}

Scene seams() {
    Scene scene = scene_of("floor-seams", "a level floor of 20,000 triangles");
    add_walks(scene, level_of(Triangles().floor({-15, 0, -15}, {15, 0, 15}, 100)));
    return scene;
}

Scene slivers() {
    Scene scene = scene_of("floor-slivers", "triangles 30 m long and down to a millimetre wide");
    Triangles triangles;
    double x = -15;
    for (int i = 0; x < 15; ++i) {
        const double wide = i % 7 == 0 ? 0.001 : i % 3 == 0 ? 0.01 : 0.05;
        triangles.quad({x, 0, -15}, {x, 0, 15}, {x + wide, 0, 15}, {x + wide, 0, -15});
        x += wide;
    }
    add_walks(scene, level_of(triangles));
    // A fan: all corners in one point, which is walked over.
    Triangles fan;
    constexpr int spokes = 360;
    for (int i = 0; i < spokes; ++i) {
        const auto rim = [](int k) { return heading(k * 360.0 / spokes, 15) + dvec3{1, 0, 0}; };
        fan.triangle({1, 0, 0}, rim(i + 1), rim(i));
    }
    scene.runs.push_back(run_at("over the hub of a fan", level_of(fan), {-2, 0, 0}, walk({speed, 0, 0}), 1.5));
    return scene;
}

Scene t_junctions() {
    Scene scene = scene_of("floor-t-junctions", "rows of tiles whose corners lie in their neighbours' edges");
    Triangles triangles;
    for (int row = 0; row < 60; ++row) {
        const double x = -15 + 0.5 * row;
        triangles.sheet({x, 0, -15}, {x, 0, 15}, {x + 0.5, 0, 15}, {x + 0.5, 0, -15}, 30 + 7 * (row % 5), 1);
    }
    add_walks(scene, level_of(triangles));
    return scene;
}

Scene bodies() {
    Scene scene = scene_of("floor-bodies", "a floor of 400 separate bodies");
    auto level = std::make_shared<Level>();
    for (int i = 0; i < 20; ++i) {
        for (int k = 0; k < 20; ++k)
            level->add(Triangles().block({0, -1, 0}, {1.5, 0, 1.5}), {.position = {-15 + 1.5 * i, 0, -15 + 1.5 * k}});
    }
    add_walks(scene, level);
    return scene;
}

Scene noise() {
    constexpr double amplitude = 0.002;
    Scene scene =
        scene_of("floor-noise", "vertices that are up to 2 mm off, and tiles that do not quite meet", 2 * amplitude);
    Dice dice(1);
    Triangles triangles = Triangles().floor({-15, 0, -15}, {15, 0, 15}, 60);
    // Every corner by itself, so that neighbours do not meet.
    for (vec3& vertex : triangles.vertices) vertex.y = static_cast<float>(dice.from(-amplitude, amplitude));
    add_walks(scene, level_of(triangles));
    auto level = std::make_shared<Level>();
    for (int i = 0; i < 20; ++i) {
        for (int k = 0; k < 20; ++k)
            level->add(Triangles().block({0, -1, 0}, {1.5, 0, 1.5}),
                       {.position = {-15 + 1.5 * i, dice.from(-amplitude, amplitude), -15 + 1.5 * k}});
    }
    scene.runs.push_back(run_at("bodies at 17 degrees", level, {0.13, 0, -0.21}, walk(heading(17, speed))));
    scene.runs.push_back(run_at("bodies at 180 degrees", level, {0.13, 0, -0.21}, walk(heading(180, speed))));
    return scene;
}

Scene standing_still() {
    Scene scene{"floor-stand", "standing on a seam, on a corner of four bodies, on a vertex", {}, {}, {}};
    auto level = std::make_shared<Level>();
    for (const double x : {-2.0, 0.0}) {
        for (const double z : {-2.0, 0.0})
            level->add(Triangles().block({0, -1, 0}, {2, 0, 2}), {.position = {x, 0, z}});
    }
    scene.runs.push_back(
        run_at("a seam", level_of(Triangles().floor({-2, 0, -2}, {2, 0, 2}, 4)), {0.5, 0, 0}, walk({})));
    scene.runs.push_back(
        run_at("a vertex", level_of(Triangles().floor({-2, 0, -2}, {2, 0, 2}, 4)), {0, 0, 0}, walk({})));
    scene.runs.push_back(run_at("four bodies", level, {0, 0, 0}, walk({})));
    scene.bars = {rest_bar(3), ground_bar(), depth_bar()};
    return scene;
}

}  // namespace

void add_floors(Scenes& scenes) {
    for (const auto make : {seams, slivers, t_junctions, bodies, noise, standing_still}) scenes.push_back(make());
}

}  // namespace surefoot::course
