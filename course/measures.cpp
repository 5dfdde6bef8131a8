#include "course/measures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

namespace surefoot::course {
namespace {

double size_of(const dvec3& v) {
    return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
}

double dot(const dvec3& a, const dvec3& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

dvec3 cross(const dvec3& a, const dvec3& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// The largest of what `of` says about each tick of the script, given the spots before and after it. NaN stays.
template <typename OfTick>
double worst_tick(const Outing& outing, const OfTick& of) {
    Worst worst;
    const std::span<const Spot> spots = outing.scripted();
    for (std::size_t i = 1; i < spots.size(); ++i) worst.take(of(spots[i - 1], spots[i]), {});
    return worst.value;
}

/// The solid angle of a triangle seen from a point, signed by its front.
double solid_angle(const dvec3& a, const dvec3& b, const dvec3& c) {
    const double la = size_of(a), lb = size_of(b), lc = size_of(c);
    const double below = la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb;
    return 2 * std::atan2(dot(a, cross(b, c)), below);
}

double winding(const Level& level, double time, const dvec3& point) {
    double sum = 0;
    const std::vector<Pose> poses = poses_at(level, time);
    for (std::size_t body = 0; body < poses.size(); ++body) {
        const Triangles& triangles = level.bodies[body].triangles;
        const auto corner = [&](std::size_t i) {
            return to_world(poses[body], dvec3(triangles.vertices[triangles.indices[i]])) - point;
        };
        for (std::size_t i = 0; i < triangles.indices.size(); i += 3)
            sum += solid_angle(corner(i), corner(i + 1), corner(i + 2));
    }
    return sum / (4 * std::numbers::pi);
}

}  // namespace

Measure each(std::function<double(const Outing&)> of_one) {
    return [of_one](std::span<const Outing> outings) {
        Worst worst;
        for (const Outing& outing : outings) worst.take(of_one(outing), outing.run->name);
        return worst;
    };
}

double height_change(const Outing& outing) {
    const double level = outing.scripted().front().position.y;
    return worst_tick(outing, [&](const Spot&, const Spot& after) { return std::abs(after.position.y - level); });
}

double speed_error(const Outing& outing) {
    const double dt = outing.run->dt();
    return worst_tick(outing, [&](const Spot& before, const Spot& after) {
        const double asked = size_of(after.input.wish);
        if (!(asked > 0) || before.time < 0.5 * dt) return 0.0;
        dvec3 moved = after.position - before.position;
        moved.y = 0;
        return std::abs(size_of(moved) / (asked * dt) - 1);
    });
}

double drift(const Outing& outing) {
    const std::span<const Spot> spots = outing.scripted();
    const dvec3 wish = outing.last().input.wish;
    const dvec3 ahead = wish / size_of(wish);
    return worst_tick(outing, [&](const Spot&, const Spot& after) {
        dvec3 way = after.position - spots.front().position;
        way.y = 0;
        const double asked = size_of(wish) * after.time;
        return size_of(way - ahead * dot(way, ahead)) / asked;
    });
}

double airborne(const Outing& outing) {
    const std::span<const Spot> spots = outing.scripted();
    const auto in_air = std::count_if(spots.begin() + 1, spots.end(), [](const Spot& spot) { return !spot.grounded; });
    return static_cast<double>(in_air) / static_cast<double>(spots.size() - 1);
}

double unrest(const Outing& outing, double seconds) {
    const double from = outing.last().time - seconds;
    return worst_tick(outing, [&](const Spot& before, const Spot& after) {
        return before.time < from ? 0 : size_of(after.position - before.position);
    });
}

double motion_once_stopped(const Outing& outing) {
    int stopped = 0;
    const double worst = worst_tick(outing, [&](const Spot& before, const Spot& after) {
        const double moved = size_of(after.position - before.position);
        if (stopped > 0) return ++stopped > 2 ? moved : 0;
        if (moved < 0.05 * size_of(after.input.wish) * outing.run->dt()) stopped = 1;
        return 0.0;
    });
    return stopped > 2 ? worst : std::numeric_limits<double>::infinity();
}

double depth(const Outing& outing) {
    LevelWorld level(*outing.run->level);
    const Volume volume = outing.run->settings.volume;
    const dvec3 reference = reference_from_centre(outing.run->settings);
    std::vector<Overlap> found(256);
    return worst_tick(outing, [&](const Spot&, const Spot& after) {
        level.move_to(std::max(0.0, after.time));
        const std::size_t touched =
            level.world().overlap(volume, after.position + reference, found, {.begin = 1, .end = 1});
        double deepest = 0;
        for (std::size_t i = 0; i < std::min(touched, found.size()); ++i) {
            // A place that is no place is as deep as can be.
            const bool is_answer = found[i].status == HitStatus::ok;
            deepest = std::max(deepest, is_answer ? found[i].depth : std::numeric_limits<double>::infinity());
        }
        return deepest;
    });
}

double rise_in_a_tick(const Outing& outing) {
    return worst_tick(outing,
                      [](const Spot& before, const Spot& after) { return after.position.y - before.position.y; });
}

double climbed(const Outing& outing) {
    const double level = outing.scripted().front().position.y;
    return worst_tick(outing, [&](const Spot&, const Spot& after) { return after.position.y - level; });
}

double outside(const Outing& outing) {
    const double free = winding(*outing.run->level, 0, outing.run->start);
    return worst_tick(outing, [&](const Spot&, const Spot& after) {
        return std::abs(winding(*outing.run->level, std::max(0.0, after.time), after.position) - free);
    });
}

Measure divergence(std::function<double(const Run&)> allowed) {
    return [allowed](std::span<const Outing> outings) {
        const auto faster = [](const Outing& a, const Outing& b) { return a.run->rate < b.run->rate; };
        const Outing& reference = *std::max_element(outings.begin(), outings.end(), faster);
        // By the nearest microsecond, since ticks of different lengths do not add up to the same double.
        std::map<long long, dvec3> places;
        const auto key = [](double time) { return std::llround(time * 1e6); };
        for (const Spot& spot : reference.scripted()) places[key(spot.time)] = spot.position;
        Worst worst;
        for (const Outing& outing : outings) {
            for (const Spot& spot : outing.scripted()) {
                const auto same = places.find(key(spot.time));
                if (same == places.end()) continue;
                worst.take(size_of(spot.position - same->second) - allowed(*outing.run), outing.run->name);
            }
        }
        return worst;
    };
}

double gone(const Outing& outing, const dvec3& direction) {
    return dot(outing.last().position - outing.scripted().front().position, direction);
}

Bar level_bar(double noise) {
    return {"height changes", "m", 0.1 * hero().skin + noise,
            "the floor is level: what carries the character never changes height, but for the noise of its vertices; "
            "a tenth of the skin is room for rounding",
            each(height_change)};
}

Bar speed_bar(double most) {
    return {"speed is off", "", most, "nothing is in the way, so each tick covers what was asked for",
            each(speed_error)};
}

Bar drift_bar() {
    return {"drifts sideways", "", 1e-3, "nothing pushes sideways", each(drift)};
}

Bar ground_bar() {
    return {"ticks in the air", "", 0, "there is ground within the snap distance all the way", each(airborne)};
}

Bar depth_bar(double scale) {
    return {"in a triangle", "m", 0.1 * hero().skin * scale,
            "a body that is kept off by a skin is never inside of anything; a tenth of it is room for rounding",
            each(depth)};
}

Bar rest_bar(double seconds) {
    return {"moves at rest", "m a tick", 1e-9, "what has nowhere to go does not move at all",
            each([seconds](const Outing& outing) { return unrest(outing, seconds); })};
}

Bar stop_bar() {
    return {"moves once stopped", "m a tick", 1e-9,
            "the planes that it touches leave no motion towards the wish: zero from the second tick on",
            each(motion_once_stopped)};
}

Bar inside_bar() {
    return {"out of the level", "turns", 0.5, "the winding number about its centre stays that of the free space",
            each(outside)};
}

}  // namespace surefoot::course
