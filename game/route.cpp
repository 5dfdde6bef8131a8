#include "game/route.hpp"

#include <cmath>

#include "game/vectors.hpp"

namespace surefoot::game {
namespace {

double leg_time(const Route& route, std::size_t from, std::size_t to) {
    return length(route.stops[to] - route.stops[from]) / route.speed;
}

// How many legs one round has, and between which stops the one of this number goes.
std::size_t leg_count(const Route& route) {
    const std::size_t between = route.stops.size() - 1;
    if (route.loop == PathLoop::back) return 2 * between;
    return route.loop == PathLoop::round ? between + 1 : between;
}

struct Leg {
    std::size_t from;
    std::size_t to;
};

Leg leg(const Route& route, std::size_t number) {
    const std::size_t last = route.stops.size() - 1;
    if (number < last) return {number, number + 1};
    if (route.loop == PathLoop::round) return {last, 0};
    return {2 * last - number, 2 * last - number - 1};
}

}  // namespace

double round_time(const Route& route) {
    if (route.stops.size() < 2) return 0;
    double time = 0;
    for (std::size_t i = 0; i < leg_count(route); ++i) {
        const Leg at = leg(route, i);
        time += route.pause + leg_time(route, at.from, at.to);
    }
    return time;
}

dvec3 place_on(const Route& route, double clock) {
    const double whole = round_time(route);
    if (!(whole > 0) || !(clock > 0)) return {0, 0, 0};
    if (route.loop == PathLoop::once) {
        if (clock >= whole) return route.stops.back();
    } else {
        clock -= std::floor(clock / whole) * whole;
    }
    for (std::size_t i = 0; i < leg_count(route); ++i) {
        const Leg at = leg(route, i);
        if (clock < route.pause) return route.stops[at.from];
        clock -= route.pause;
        const double time = leg_time(route, at.from, at.to);
        if (clock < time) {
            const double share = clock / time;
            const double gently = share * share * (3 - 2 * share);
            return route.stops[at.from] + (route.stops[at.to] - route.stops[at.from]) * gently;
        }
        clock -= time;
    }
    return route.stops[leg(route, leg_count(route) - 1).to];
}

dquat turned(const dquat& orientation, double deg) {
    // The tangent of half of a small angle by its series, so that nothing of libm decides where a body is.
    const double half = deg * (3.14159265358979323846 / 360);
    const double tangent = half + half * half * half / 3;
    const dquat made = dquat(1, 0, tangent, 0) * orientation;
    const double size = std::sqrt(made.w * made.w + made.x * made.x + made.y * made.y + made.z * made.z);
    return {made.w / size, made.x / size, made.y / size, made.z / size};
}

}  // namespace surefoot::game
