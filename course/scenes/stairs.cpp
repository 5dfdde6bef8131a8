// Stairs of all pitches: up, down, across, beside a wall, round a column; and steps that are too high.
#include "course/scenes/common.hpp"

namespace surefoot::course {
namespace {

constexpr double speed = 3;
constexpr double skin = 0.01;
constexpr int steps = 8;

struct Pitch {
    double rise, tread;
    [[nodiscard]] std::string name() const { return text_of(rise) + " x " + text_of(tread); }
    [[nodiscard]] double height() const { return steps * rise; }
    [[nodiscard]] double length() const { return steps * tread; }
};

// Each leaves a centimetre and more to the step height of 0.4 m and the step depth of 0.15 m.
constexpr Pitch pitches[] = {{0.1, 0.2},   {0.1, 0.3}, {0.15, 0.3}, {0.2, 0.25}, {0.2, 0.4},
                             {0.25, 0.25}, {0.3, 0.3}, {0.3, 0.6},  {0.38, 0.4}, {0.38, 1.0}};

LevelPointer level_with(const Pitch& pitch, double half_width = 3) {
    return level_of(
        Triangles().floor({-20, 0, -20}, {0, 0, 20}, 8).stairs(0, steps, pitch.rise, pitch.tread, half_width));
}

// The name of a run begins with how high it has to come; the bars read it there, so that each run has its own.
double asked_height(const Outing& outing) {
    return std::stod(outing.run->name.substr(outing.run->name.rfind(' ')));
}

Bar height_bar() {
    return {"misses the height", "m", 2 * skin, "it stands on the landing, a skin above it",
            each([](const Outing& outing) { return std::abs(feet(outing) - asked_height(outing)); })};
}

Bar pace_bar() {
    return {"short of the way", "of it", 0.1,
            "steps within the step height are no obstacles, so the level way is covered at the speed asked for",
            each([](const Outing& outing) {
                dvec3 way = outing.last().position - outing.scripted().front().position;
                double asked = 0;
                for (const Spot& spot : outing.scripted().subspan(1))
                    asked += std::abs(spot.input.wish.x) * outing.run->dt();
                return 1 - std::abs(way.x) / asked;
            })};
}

Bar only_rises_bar() {
    return {"falls back", "m a tick", skin, "whoever walks up stairs only rises", each([](const Outing& outing) {
                Worst worst;
                const auto spots = outing.scripted();
                for (std::size_t i = 1; i < spots.size(); ++i)
                    worst.take(spots[i - 1].position.y - spots[i].position.y, {});
                return worst.value;
            })};
}

Bar only_falls_bar() {
    return {"rises", "m a tick", skin, "whoever walks down stairs only gets lower", each(rise_in_a_tick)};
}

Scene up() {
    Scene scene{"stairs-up",
                "stairs of all pitches, walked up",
                {},
                {height_bar(), pace_bar(), ground_bar(), only_rises_bar(), depth_bar()},
                {}};
    for (const Pitch& pitch : pitches)
        scene.runs.push_back(run_at(pitch.name() + " to " + text_of(pitch.height()), level_with(pitch), {-1, 0, 0},
                                    walk({speed, 0, 0}), (2.5 + pitch.length()) / speed));
    return scene;
}

Scene down() {
    Scene scene{"stairs-down",
                "the same, walked down",
                {},
                {height_bar(), pace_bar(), ground_bar(), only_falls_bar(), depth_bar()},
                {}};
    for (const Pitch& pitch : pitches)
        scene.runs.push_back(run_at(pitch.name() + " to 0", level_with(pitch), {pitch.length() + 1, pitch.height(), 0},
                                    walk({-speed, 0, 0}), (2.5 + pitch.length()) / speed));
    return scene;
}

Scene diagonal() {
    Scene scene{"stairs-diagonal",
                "stairs that are crossed at 30, 45 and 60 degrees, up and down",
                {},
                {height_bar(), pace_bar(), ground_bar(), depth_bar()},
                {}};
    for (const Pitch& pitch : {Pitch{0.15, 0.3}, Pitch{0.2, 0.25}, Pitch{0.3, 0.3}, Pitch{0.38, 0.4}}) {
        for (const double degrees : {30.0, 45.0, 60.0}) {
            const dvec3 wish = heading(degrees, speed);
            const double seconds = (2.5 + pitch.length()) / wish.x;
            const double aside = 0.5 * wish.z * seconds;
            scene.runs.push_back(run_at(pitch.name() + " at " + text_of(degrees) + " to " + text_of(pitch.height()),
                                        level_with(pitch, 12), {-1, 0, -aside}, walk(wish), seconds));
            scene.runs.push_back(run_at(pitch.name() + " at " + text_of(degrees) + " to 0", level_with(pitch, 12),
                                        {pitch.length() + 1, pitch.height(), aside}, walk(-wish), seconds));
        }
    }
    return scene;
}

Scene beside_wall() {
    Scene scene{"stairs-wall",
                "stairs beside a wall that is pressed into",
                {},
                {height_bar(), pace_bar(), ground_bar(), depth_bar()},
                {}};
    for (const Pitch& pitch : {Pitch{0.15, 0.3}, Pitch{0.2, 0.25}, Pitch{0.3, 0.3}, Pitch{0.38, 0.4}}) {
        Triangles triangles =
            Triangles().floor({-20, 0, -20}, {0, 0, 20}, 8).stairs(0, steps, pitch.rise, pitch.tread, 3);
        triangles.block({-10, -1, 1}, {20, 9, 2});
        const LevelPointer level = level_of(triangles);
        for (const double degrees : {10.0, 30.0, 60.0}) {
            const dvec3 wish = heading(degrees, speed);
            const double seconds = (2.5 + pitch.length()) / wish.x;
            scene.runs.push_back(run_at(pitch.name() + " at " + text_of(degrees) + " to " + text_of(pitch.height()),
                                        level, {-1, 0, 0.5}, walk(wish), seconds));
            scene.runs.push_back(run_at(pitch.name() + " at " + text_of(degrees) + " to 0", level,
                                        {pitch.length() + 1, pitch.height(), 0.5}, walk({-wish.x, 0, wish.z}),
                                        seconds));
        }
    }
    return scene;
}

// Treads of 20 degrees about the y axis, from 0.4 m to 2.6 m, walked at 1.5 m.
constexpr double tread_degrees = 20;
constexpr int spiral_steps = 27;
constexpr double spiral_rise = 0.2;
constexpr double spiral_radius = 1.5;
constexpr double approach_degrees = 35;  // clear of the first riser

LevelPointer spiral_level() {
    Triangles triangles;
    triangles.floor({-10, 0, -10}, {10, 0, 10}, 10);
    const auto at = [](double degrees, double radius, double height) {
        return heading(degrees, radius) + dvec3{0, height, 0};
    };
    for (int i = 0; i < spiral_steps; ++i) {
        const double near = i * tread_degrees, far = near + tread_degrees;
        const double low = i * spiral_rise, high = low + spiral_rise;
        triangles.quad(at(near, 0.4, low), at(near, 2.6, low), at(near, 2.6, high), at(near, 0.4, high));
        triangles.quad(at(near, 0.4, high), at(near, 2.6, high), at(far, 2.6, high), at(far, 0.4, high));
    }
    return level_of(triangles);
}

// Round the axis, back to the radius where it strays from it.
Script around(double direction) {
    return [direction](double, const Spot& now) {
        const double radius = std::hypot(now.position.x, now.position.z);
        const dvec3 out{now.position.x / radius, 0, now.position.z / radius};
        const dvec3 along{-out.z * direction, 0, out.x * direction};
        return Input{along * 2.0 + out * (2 * (spiral_radius - radius))};
    };
}

Scene spiral() {
    Scene scene{"stairs-spiral", "spiral stairs, one and a half turns up and down", {}, {}, {}};
    // Up from just before the first riser to the middle of the last tread.
    const double turn = radians(tread_degrees * (spiral_steps - 0.5) + approach_degrees);
    const double seconds = turn * spiral_radius / 2;
    const LevelPointer level = spiral_level();
    const double top = spiral_steps * spiral_rise;
    scene.runs.push_back(
        run_at("to " + text_of(top), level, heading(-approach_degrees, spiral_radius), around(1), seconds));
    scene.runs.push_back(run_at("to 0", level,
                                heading(tread_degrees * (spiral_steps - 0.5), spiral_radius) + dvec3{0, top, 0},
                                around(-1), seconds));
    scene.bars = {height_bar(), ground_bar(), depth_bar()};
    return scene;
}

const double rates[] = {15, 30, 60, 144, 1000};

Scene every_rate() {
    Scene scene{"stairs-rates",
                "steps that are low enough by a centimetre, at 15 to 1000 Hz",
                {},
                {height_bar(), ground_bar(), depth_bar()},
                {}};
    for (const double rate : rates) {
        for (const Pitch& pitch : {Pitch{0.1, 0.3}, Pitch{0.25, 0.3}, Pitch{0.39, 0.5}}) {
            Run run = run_at(pitch.name() + " at " + text_of(rate) + " Hz to " + text_of(pitch.height()),
                             level_with(pitch), {-1, 0, 0}, walk({speed, 0, 0}), 2.5 + pitch.length() / speed);
            run.rate = rate;
            scene.runs.push_back(run);
        }
    }
    return scene;
}

Scene too_high() {
    Scene scene{"stairs-too-high",
                "steps that are too high by two centimetres and more, at 15 to 1000 Hz",
                {},
                {{"climbs", "m", 2 * skin, "what is higher than the step height is a wall, at any rate", each(climbed)},
                 ground_bar(),
                 depth_bar()},
                {}};
    for (const double rate : rates) {
        for (const double rise : {0.42, 0.5, 0.9}) {
            Run run = run_at(text_of(rise) + " at " + text_of(rate) + " Hz", level_with({rise, 1}), {-1, 0, 0},
                             walk(heading(10, speed)), 2);
            run.rate = rate;
            scene.runs.push_back(run);
        }
    }
    return scene;
}

}  // namespace

void add_stairs(Scenes& scenes) {
    for (const auto make : {up, down, diagonal, beside_wall, spiral, every_rate, too_high}) scenes.push_back(make());
}

}  // namespace surefoot::course
