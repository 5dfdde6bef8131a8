// Lifts, trains, turntables, walls that push and plates that crush.
#include "course/scenes/common.hpp"

namespace surefoot::course {
namespace {

constexpr double skin = 0.01;

// A platform whose top is at y = 0 when its pose is at the origin.
Triangles platform() {
    return Triangles().block({-3, -0.5, -3}, {3, 0, 3});
}

LevelPointer moving(Triangles triangles, std::function<Pose(double)> path) {
    auto level = std::make_shared<Level>();
    level->add(std::move(triangles), {}, std::move(path));
    return level;
}

Pose body_at(const Outing& outing, double time) {
    return outing.run->level->bodies.front().path(std::max(0.0, time));
}

/// How far the place on the first body that it stood on has moved under it, but for what was walked [m].
double slipped(const Outing& outing) {
    const auto spots = outing.scripted();
    const dvec3 first = to_body(body_at(outing, 0), spots.front().position);
    Worst worst;
    for (const Spot& spot : spots) {
        const dvec3 now = to_body(body_at(outing, spot.time), spot.position);
        const dvec3 walked = spot.input.wish * spot.time;
        worst.take(std::hypot(now.x - first.x - walked.x, now.z - first.z - walked.z), {});
    }
    return worst.value;
}

/// How much its height above the first body's origin changes [m].
double lost_height(const Outing& outing) {
    const auto spots = outing.scripted();
    Worst worst;
    for (const Spot& spot : spots) {
        const double above = spot.position.y - body_at(outing, spot.time).position.y;
        worst.take(std::abs(above - (spots.front().position.y - body_at(outing, 0).position.y)), {});
    }
    return worst.value;
}

Bar carried_bar() {
    return {"slips", "m", 0.01, "what stands on a body goes where that body's surface goes", each(slipped)};
}

Bar height_bar() {
    return {"height above it changes", "m", skin, "it is kept off by a skin; no more than that is lost or gained",
            each(lost_height)};
}

std::function<Pose(double)> straight(const dvec3& velocity) {
    return [velocity](double time) { return Pose{.position = velocity * time}; };
}

// To and fro with a largest acceleration, beginning at rest.
std::function<Pose(double)> swinging(const dvec3& direction, double amplitude, double acceleration) {
    const double rate = std::sqrt(acceleration / amplitude);
    return [=](double time) { return Pose{.position = direction * (amplitude * (1 - std::cos(rate * time)))}; };
}

Scene lifts() {
    Scene scene{"lift",
                "lifts up and down at 0.5 to 5 m/s and at up to 10 m/s^2, standing and walking",
                {},
                {height_bar(), carried_bar(), ground_bar(), depth_bar()},
                {}};
    for (const double v : {-5.0, -2.0, -0.5, 0.5, 2.0, 5.0})
        scene.runs.push_back(
            run_at(text_of(v) + " m/s", moving(platform(), straight({0, v, 0})), {0.2, 0, 0.1}, walk({}), 2));
    for (const double a : {2.0, 10.0})
        scene.runs.push_back(
            run_at(text_of(a) + " m/s^2", moving(platform(), swinging({0, 1, 0}, 2, a)), {0.2, 0, 0.1}, walk({}), 5));
    scene.runs.push_back(
        run_at("walking on it, up", moving(platform(), straight({0, 2, 0})), {-1.5, 0, 0}, walk({1.5, 0, 0}), 2));
    scene.runs.push_back(
        run_at("walking on it, down", moving(platform(), straight({0, -2, 0})), {-1.5, 0, 0}, walk({1.5, 0, 0}), 2));
    return scene;
}

Scene trains() {
    Scene scene{"train",
                "trains of 3 to 30 m/s and of 5 m/s^2, standing and walking, with a seam under the feet",
                {},
                {carried_bar(), height_bar(), ground_bar(), depth_bar()},
                {}};
    for (const double v : {3.0, 30.0})
        scene.runs.push_back(
            run_at(text_of(v) + " m/s", moving(platform(), straight({v, 0, 0.3 * v})), {0.2, 0, 0.1}, walk({}), 3));
    scene.runs.push_back(run_at("5 m/s^2", moving(platform(), swinging({1, 0, 0}, 5, 5)), {0, 0, 0}, walk({}), 5));
    scene.runs.push_back(
        run_at("up a track of 20 degrees", moving(platform(), straight({10, 3.64, 0})), {0.2, 0, 0.1}, walk({}), 3));
    scene.runs.push_back(
        run_at("walking against it", moving(platform(), straight({10, 0, 0})), {1.5, 0, 0}, walk({-1.5, 0, 0}), 2));
    return scene;
}

Scene turntables() {
    Scene scene{"turntable",
                "turntables of 0.5 to 4 rad/s, off their axis",
                {},
                {carried_bar(), height_bar(), ground_bar(), depth_bar()},
                {}};
    for (const double turn : {0.5, 2.0, -4.0}) {
        for (const double radius : {0.0, 1.0, 2.5}) {
            const auto path = [turn](double time) {
                return Pose{.orientation = dquat(std::cos(0.5 * turn * time), 0, std::sin(0.5 * turn * time), 0)};
            };
            scene.runs.push_back(run_at(text_of(turn) + " rad/s, " + text_of(radius) + " m off",
                                        moving(platform(), path), {radius, 0, 0}, walk({}), 3));
        }
    }
    return scene;
}

Scene pushers() {
    Scene scene{
        "pusher", "walls that push what stands before them, straight and at an angle, at 0.5 to 10 m/s", {}, {}, {}};
    for (const double v : {0.5, 2.0, 10.0}) {
        for (const double degrees : {0.0, 30.0}) {
            auto level = std::make_shared<Level>();
            const dvec3 way = heading(degrees, v);
            level->add(Triangles().block({-2, -0.4, -20}, {-1, 3, 20}), {},
                       [way](double time) { return Pose{.position = way * std::min(time, 1.5)}; });
            for (int i = 0; i < 20; ++i)
                level->add(Triangles().block({0, -1, -20}, {3, 0, 20}), {.position = {3.0 * i - 20, 0, 0}});
            scene.runs.push_back(
                run_at(text_of(v) + " m/s at " + text_of(degrees) + " degrees", level, {0, 0, 0}, walk({}), 2));
        }
    }
    scene.bars = {depth_bar(),
                  inside_bar(),
                  level_bar(),
                  ground_bar(),
                  {"left behind", "m", 2 * skin, "a wall that comes takes along what stands before it",
                   each([](const Outing& outing) {
                       const double face = body_at(outing, outing.last().time).position.x - 1;
                       const double least = std::max(face + 0.4, outing.run->start.x);
                       return short_of(least, outing.last().position.x + 1e-9);
                   })}};
    return scene;
}

Scene crushers() {
    Scene scene{"crusher", "a plate that comes down to a metre, stays and goes up again", {}, {}, {}};
    for (const double v : {0.5, 2.0, 10.0}) {
        auto level = std::make_shared<Level>();
        // From 2.2 m down to 1 m, two seconds there, and up.
        level->add(Triangles().block({-3, 0, -3}, {3, 1, 3}), {}, [v](double time) {
            const double away = time < 3.5 ? std::max(1.0, 2.2 - v * time) : std::min(2.2, 1 + v * (time - 3.5));
            return Pose{.position = {0, away, 0}};
        });
        level->add(Triangles().block({-20, -1, -20}, {20, 0, 20}));
        scene.runs.push_back(run_at(text_of(v) + " m/s", level, {0.2, 0, 0.1}, walk({}), 7));
    }
    scene.bars = {{"through the floor", "m", 0, "its centre stays above the floor, crushed or not",
                   each([](const Outing& outing) {
                       Worst worst;
                       for (const Spot& spot : outing.scripted()) worst.take(-spot.position.y, {});
                       return worst.value;
                   })},
                  {"through the plate", "m", 0, "its centre stays below the plate, crushed or not",
                   each([](const Outing& outing) {
                       Worst worst;
                       for (const Spot& spot : outing.scripted())
                           worst.take(spot.position.y - body_at(outing, spot.time).position.y, {});
                       return worst.value;
                   })},
                  {"misses the ground", "m", 2 * skin, "when the plate is gone it stands where it stood",
                   each([](const Outing& outing) { return std::abs(feet(outing)); })},
                  rest_bar(0.5)};
    return scene;
}

}  // namespace

void add_moving(Scenes& scenes) {
    for (const auto make : {lifts, trains, turntables, pushers, crushers}) scenes.push_back(make());
}

}  // namespace surefoot::course
