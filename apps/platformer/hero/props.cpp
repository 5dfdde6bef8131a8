#include "platformer/hero/props.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "platformer/hero/frame.hpp"

namespace surefoot::platformer {
namespace {

using view::Colour;
using view::Renderer;
using view::rgb;
using view::Solid;

constexpr double pi = std::numbers::pi;
constexpr Colour gold = rgb(0xFFC533);
constexpr Colour pale_gold = rgb(0xFFE38A);

void put(Renderer& renderer, const Frame& frame, const dvec3& at, const dvec3& radii, Colour colour,
         Solid solid = Solid::ball, const dmat3& turn = dmat3(1), double glow = 0) {
    view::Piece made = piece(frame, at, radii, colour, solid, turn);
    made.glow = static_cast<float>(glow);
    renderer.piece(made);
}

/// Spins and bobs; neighbours a little after each other.
Frame floating(const dvec3& place, const PropMoment& moment, double turns_per_second) {
    const double offset = 0.35 * (place.x + place.z);
    const double bob = moment.calm ? 0 : 0.06 * std::sin(moment.clock * 2.4 + offset);
    const double size = std::max(moment.shown, 1e-3);
    return {turned(2 * pi * turns_per_second * moment.clock + offset) * scaled(dvec3(size)), place + dvec3(0, bob, 0)};
}

}  // namespace

void draw_coin(Renderer& renderer, const dvec3& place, const PropMoment& moment) {
    if (moment.shown <= 0) return;
    const Frame frame = floating(place, moment, 0.55);
    // A drum's axis is Y: laid on its side it is a coin.
    put(renderer, frame, {0, 0, 0}, {0.26, 0.045, 0.26}, rgb(0xF0A820), Solid::drum, pitched(pi / 2), 0.25);
    put(renderer, frame, {0, 0, 0}, {0.185, 0.056, 0.185}, pale_gold, Solid::drum, pitched(pi / 2), 0.35);
}

void draw_star(Renderer& renderer, const dvec3& place, const PropMoment& moment, bool found_before) {
    if (moment.shown <= 0) return;
    const Frame frame = floating(place, moment, 0.4);
    const Colour colour = found_before ? rgb(0xA9C4D8) : rgb(0xFFD93B);
    const double glow = found_before ? 0.15 : 0.45;
    for (int i = 0; i < 5; ++i)
        put(renderer, frame, {0, 0, 0}, {0.215, 0.50, 0.11}, colour, Solid::cone, rolled(2 * pi * i / 5), glow);
    put(renderer, frame, {0, 0, 0}, {0.25, 0.25, 0.15}, colour, Solid::ball, dmat3(1), glow);
    for (const double side : {1.0, -1.0})
        for (const double face : {1.0, -1.0})
            put(renderer, frame, {side * 0.075, 0.02, face * 0.135}, {0.028, 0.06, 0.02}, rgb(0x4A3208));
}

void draw_heart(Renderer& renderer, const dvec3& place, const PropMoment& moment) {
    if (moment.shown <= 0) return;
    const double beat = moment.calm ? 1 : 1 + 0.07 * std::pow(std::max(std::sin(moment.clock * 5), 0.0), 6);
    const Frame frame = floating(place, moment, 0.3).inside(dvec3(0), scaled(dvec3(beat)));
    const Colour red = rgb(0xE8344E);
    for (const double side : {1.0, -1.0})
        put(renderer, frame, {side * 0.115, 0.08, 0}, {0.155, 0.19, 0.12}, red, Solid::ball, rolled(side * 0.35), 0.25);
    put(renderer, frame, {0, 0.10, 0}, {0.235, 0.40, 0.115}, red, Solid::cone, rolled(pi), 0.25);
    put(renderer, frame, {0.14, 0.15, 0.085}, {0.05, 0.065, 0.035}, rgb(0xFFC4CB), Solid::ball, dmat3(1), 0.6);
}

void draw_key(Renderer& renderer, const dvec3& place, const PropMoment& moment, Colour colour) {
    if (moment.shown <= 0) return;
    const Frame frame = floating(place, moment, 0.4);
    for (int i = 0; i < 10; ++i) {
        const double angle = 2 * pi * i / 10;
        put(renderer, frame, {0.14 * std::cos(angle), 0.24 + 0.14 * std::sin(angle), 0}, {0.065, 0.065, 0.05}, colour,
            Solid::ball, dmat3(1), 0.25);
    }
    put(renderer, frame, {0, -0.10, 0}, {0.045, 0.22, 0.045}, colour, Solid::drum, dmat3(1), 0.25);
    for (const double y : {-0.17, -0.28})
        put(renderer, frame, {0.09, y, 0}, {0.08, 0.036, 0.036}, colour, Solid::cube, dmat3(1), 0.25);
}

void draw_checkpoint(Renderer& renderer, const dvec3& place, const PropMoment& moment, double raised) {
    const Frame frame{dmat3(1), place};
    const Colour flag = view::mixed(rgb(0x8A97A3), rgb(0x2FB56B), raised);
    put(renderer, frame, {0, 0.05, 0}, {0.28, 0.05, 0.28}, rgb(0x6B7783), Solid::drum);
    put(renderer, frame, {0, 1.15, 0}, {0.042, 1.1, 0.042}, rgb(0xD9DEE3), Solid::drum);
    put(renderer, frame, {0, 2.28, 0}, dvec3(0.08), raised > 0.5 ? gold : rgb(0xB0BAC4));
    const double height = 0.45 + 1.45 * std::clamp(raised, 0.0, 1.0);
    const double wind = moment.calm ? 0.35 : 1;
    dvec3 at(0.05, height, 0);
    double yaw = 0;
    // Strips of cloth, each turned a little further by the wind; the last are narrower.
    for (int strip = 0; strip < 6; ++strip) {
        yaw = wind * 0.10 * (strip + 1) * std::sin(moment.clock * 4 - strip * 0.8 + place.x);
        const dvec3 along(std::cos(yaw), 0, -std::sin(yaw));
        at += along * 0.075;
        put(renderer, frame, at, {0.082, 0.26 - 0.028 * strip, 0.018}, flag, Solid::cube, turned(yaw), 0.15);
        at += along * 0.075;
    }
}

void draw_goal(Renderer& renderer, const dvec3& place, const PropMoment& moment, double radius, bool open) {
    const Frame frame{dmat3(1), place};
    const Colour colour = open ? rgb(0x35D3E0) : rgb(0x8A97A3);
    put(renderer, frame, {0, 0.06, 0}, {radius, 0.06, radius}, rgb(0xE9EEF2), Solid::drum);
    put(renderer, frame, {0, 0.09, 0}, {radius * 0.82, 0.05, radius * 0.82}, colour, Solid::drum, dmat3(1),
        open ? 0.6 : 0);
    for (int post = 0; post < 4; ++post) {
        const double angle = pi / 4 + pi / 2 * post;
        const dvec3 at(radius * std::sin(angle), 0, radius * std::cos(angle));
        put(renderer, frame, at + dvec3(0, 0.45, 0), {0.09, 0.45, 0.09}, rgb(0xE9EEF2), Solid::drum);
        put(renderer, frame, at + dvec3(0, 1.0, 0), dvec3(0.14), gold, Solid::ball, dmat3(1), 0.3);
    }
    if (!open) return;
    const double speed = moment.calm ? 0.15 : 0.4;
    for (int ring = 0; ring < 5; ++ring) {
        const double rise = std::fmod(moment.clock * speed + ring / 5.0, 1.0);
        const double width = radius * (0.8 - 0.45 * rise);
        put(renderer, frame, {0, 0.2 + 2.6 * rise, 0}, {width, 0.035, width},
            view::with_opacity(colour, 0.75 * (1 - rise)), Solid::drum, dmat3(1), 0.8);
    }
    // A column of light that is seen from far away.
    put(renderer, frame, {0, 6, 0}, {radius * 0.30, 6, radius * 0.30}, view::with_opacity(colour, 0.16), Solid::drum,
        dmat3(1), 1);
    const double bob = moment.calm ? 0 : 0.12 * std::sin(moment.clock * 2);
    draw_star(renderer, place + dvec3(0, 1.75 + bob, 0), {moment.clock, 1, true});
    renderer.disc({.place = place + dvec3(0, 1.6, 0),
                   .radius = radius * 2.2,
                   .colour = view::with_opacity(colour, 0.30),
                   .is_light = true});
}

void draw_bullet(Renderer& renderer, const dvec3& place, const dvec3& velocity, double radius) {
    const double speed = glm::length(velocity);
    Frame frame{dmat3(1), place};
    if (speed > 1e-6) {
        const dvec3 along = velocity / speed;
        const auto [side, other] = view::across(along);
        frame.axes = dmat3(glm::cross(other, along), other, along);
    }
    put(renderer, frame, {0, 0, 0}, dvec3(radius), rgb(0xFF6A3A), Solid::ball, dmat3(1), 0.6);
    put(renderer, frame, {0, 0, radius * 0.3}, dvec3(radius * 0.78), rgb(0xFFE08A), Solid::ball, dmat3(1), 0.9);
    for (int i = 1; i <= 3; ++i)
        put(renderer, frame, {0, 0, -radius * (0.7 + 0.75 * i)}, dvec3(radius * (0.85 - 0.2 * i)),
            view::with_opacity(rgb(0xFF6A3A), 0.5 - 0.12 * i), Solid::ball, dmat3(1), 0.7);
}

void draw_ground_shade(Renderer& renderer, const World& world, const dvec3& soles, double radius, double reach,
                       const WorldQuery& query) {
    WorldQuery now = query;
    now.begin = now.end = 1;
    const dvec3 from = soles + dvec3(0, 0.35, 0);
    const auto hit = world.ray({from, from - dvec3(0, reach + 0.35, 0)}, now);
    if (!hit || hit->status != HitStatus::ok || hit->normal.y < 0.2) return;
    const double height = std::max(hit->t * (reach + 0.35) - 0.35, 0.0);
    // Farther below it is paler, but never gone: it says where one lands.
    const double share = height / reach;
    renderer.disc({.place = hit->point + hit->normal * 0.02,
                   .radius = radius * (1.25 - 0.3 * share),
                   .normal = hit->normal,
                   .colour = rgb(0x0A1018, 0.62 * (1 - 0.45 * share)),
                   .core = 0.25});
}

}  // namespace surefoot::platformer
