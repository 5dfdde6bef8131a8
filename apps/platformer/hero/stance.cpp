#include "platformer/hero/stance.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numbers>

namespace surefoot::platformer {
namespace {

constexpr double turn = 2 * std::numbers::pi;

/// Of a left or right thing: its place mirrored.
dvec3 on_side(int side, const dvec3& of_left) {
    return side == on_left ? of_left : dvec3(-of_left.x, of_left.y, of_left.z);
}

Stance idle(const StanceMoment& m) {
    Stance s;
    const double breath = std::sin(m.clock * 2.6);
    s.body.y += 0.012 * breath;
    s.head.y = 0.010 * std::sin(m.clock * 2.6 - 0.7);
    for (const int side : {on_left, on_right}) s.hands[side].y += 0.016 * std::sin(m.clock * 2.6 - 0.4);
    // Looks around now and then.
    const double glance = std::sin(m.clock * 0.55) * std::sin(m.clock * 0.83);
    s.head_yaw = 0.65 * glance * std::abs(glance);
    s.head_roll = 0.12 * glance;
    s.tail = 0.25 * std::sin(m.clock * 1.7);
    return s;
}

Stance run(const StanceMoment& m) {
    Stance s;
    const double effort = std::min(m.speed / 6.5, 1.3);
    const double swing = std::sin(turn * m.stride);
    s.body.y += -0.03 * effort + 0.045 * effort * std::cos(2 * turn * m.stride);
    s.pitch = 0.22 * effort;
    s.twist = 0.22 * effort * swing;
    s.roll = 0.06 * effort * swing;
    s.head.y = -0.02 * effort * std::cos(2 * turn * m.stride + 0.6);
    s.head_pitch = -0.16 * effort;
    s.head_yaw = -0.12 * effort * swing;
    for (const int side : {on_left, on_right}) {
        const double fore = side == on_left ? -swing : swing;
        s.hands[side] = on_side(side, {0.29, 0.54 + 0.12 * effort * std::max(fore, -0.4), 0.04 + 0.33 * effort * fore});
    }
    s.ears = 0.45 * effort;
    s.tail = 0.5 * effort + 0.15 * std::sin(2 * turn * m.stride);
    return s;
}

Stance jump(const StanceMoment& m) {
    Stance s;
    s.body.y = 0.64;
    s.pitch = 0.06;
    s.hands[on_left] = {0.30, 1.02, 0.16};
    s.hands[on_right] = {-0.38, 0.66, -0.06};
    s.feet[on_left] = {0.13, 0.02, -0.14};
    s.feet[on_right] = {-0.12, 0.24, 0.15};
    s.toes[on_left] = 0.9;
    s.toes[on_right] = 0.25;
    s.head_pitch = -0.22;
    s.ears = 0.7;
    s.tail = -0.4 + 0.05 * std::min(m.time, 1.0);
    return s;
}

Stance fall(const StanceMoment& m) {
    Stance s;
    const double flail = std::sin(m.clock * 15) * std::min(m.time * 2, 1.0);
    s.body.y = 0.64;
    s.pitch = 0.10;
    for (const int side : {on_left, on_right}) {
        const double mine = side == on_left ? flail : -flail;
        s.hands[side] = on_side(side, {0.43, 0.92 + 0.07 * mine, 0.05 * mine});
        s.feet[side] = on_side(side, {0.16, 0.06 + 0.05 * mine, 0.05 - 0.12 * mine});
        s.toes[side] = 0.35;
    }
    s.head_pitch = 0.24;
    s.ears = -0.3;
    s.tail = 0.9;
    return s;
}

Stance crouch(const StanceMoment& m) {
    Stance s;
    s.body = {0, 0.30 + 0.006 * std::sin(m.clock * 2.6), -0.04};
    s.pitch = 0.45;
    s.head = {0, -0.15, 0.02};
    s.head_pitch = -0.35;
    s.hands[on_left] = {0.27, 0.16, 0.24};
    s.hands[on_right] = {-0.27, 0.16, 0.24};
    if (m.speed > 0.3) {
        const double swing = std::sin(turn * m.stride);
        s.hands[on_left].z -= 0.10 * swing;
        s.hands[on_right].z += 0.10 * swing;
        s.roll = 0.08 * swing;
    }
    s.ears = 1;
    return s;
}

Stance slide(const StanceMoment& m) {
    Stance s;
    s.body = {0, 0.27, -0.10};
    s.pitch = -0.55;
    s.twist = -0.25;
    s.head = {0, -0.16, 0.06};
    s.head_pitch = 0.42;
    s.head_yaw = 0.2;
    s.hands[on_left] = {0.33, 0.12, -0.26};
    s.hands[on_right] = {-0.30, 0.55 + 0.03 * std::sin(m.clock * 20), -0.12};
    s.feet[on_left] = {0.12, 0.02, 0.46};
    s.feet[on_right] = {-0.13, 0.10, 0.30};
    s.toes[on_left] = -0.6;
    s.toes[on_right] = -0.3;
    s.ears = 1;
    s.tail = 0.3;
    return s;
}

Stance hang(const StanceMoment& m) {
    Stance s;
    const double sway = std::sin(m.clock * 2.2);
    s.body = {0.015 * sway, 0.84, -0.05};
    s.roll = 0.05 * sway;
    s.head_pitch = -0.38;
    s.hands[on_left] = {0.17, 1.68, 0.30};
    s.hands[on_right] = {-0.17, 1.68, 0.30};
    s.feet[on_left] = {0.11, 0.20, -0.04 + 0.05 * sway};
    s.feet[on_right] = {-0.11, 0.27, 0.02 - 0.05 * sway};
    s.toes[on_left] = 0.8;
    s.toes[on_right] = 0.7;
    s.tail = -0.5;
    return s;
}

Stance climb(const StanceMoment&) {
    Stance s;
    s.body = {0, 0.66, 0.02};
    s.pitch = 0.55;
    s.head_pitch = -0.5;
    s.hands[on_left] = {0.22, 0.8, 0.36};
    s.hands[on_right] = {-0.22, 0.8, 0.36};
    s.feet[on_left] = {0.16, 0.44, 0.16};
    s.feet[on_right] = {-0.11, 0.08, -0.10};
    s.toes[on_left] = 0.1;
    s.toes[on_right] = 0.9;
    s.ears = 0.3;
    s.tail = 0.5;
    return s;
}

Stance wall_slide(const StanceMoment& m) {
    Stance s;
    const int near = m.wall_side > 0 ? on_left : on_right;
    const int far = 1 - near;
    s.body = {-0.04 * m.wall_side, 0.62, 0};
    s.roll = -0.16 * m.wall_side;
    s.hands[near] = on_side(near, {0.33, 1.12 + 0.012 * std::sin(m.clock * 30), 0.06});
    s.hands[far] = on_side(far, {0.42, 0.86, 0.02});
    s.feet[near] = on_side(near, {0.27, 0.30, 0.06});
    s.feet[far] = on_side(near, {0.24, 0.05, -0.02});
    s.toes[near] = s.toes[far] = 0.3;
    s.head_yaw = -0.75 * m.wall_side;
    s.head_roll = 0.1 * m.wall_side;
    s.ears = -0.25;
    s.tail = 0.8;
    return s;
}

Stance swim(const StanceMoment& m) {
    Stance s;
    const double prone = std::clamp(m.speed / 2.5, 0.0, 1.0);
    const double stroke = m.clock * (4.5 + 3 * prone);
    const double kick = m.clock * (7 + 6 * prone);
    s.body = {0, 0.70 + 0.03 * std::sin(m.clock * 2), 0.05 * prone};
    s.pitch = 0.15 + 1.05 * prone;
    s.head_pitch = -0.85 * prone;
    const double out = 0.5 - 0.5 * std::cos(stroke);
    for (const int side : {on_left, on_right}) {
        const double mine = side == on_left ? 1 : -1;
        s.hands[side] =
            on_side(side, {0.16 + 0.34 * out, 0.72 + 0.05 * std::sin(stroke), 0.20 + 0.40 * prone * std::cos(stroke)});
        const double beat = std::sin(kick) * mine;
        s.feet[side] = on_side(side, {0.12, 0.18 + 0.42 * prone + 0.10 * beat, -0.08 - 0.44 * prone + 0.06 * beat});
        s.toes[side] = 0.8 + 0.5 * prone;
    }
    s.ears = 0.5 + 0.3 * prone;
    s.tail = 0.3 * std::sin(kick * 0.5);
    return s;
}

Stance ladder(const StanceMoment& m) {
    Stance s;
    const double reach = std::sin(turn * m.stride);
    s.body = {0.02 * reach, 0.62, -0.04};
    s.roll = 0.07 * reach;
    s.hands[on_left] = {0.17, 1.14 + 0.17 * reach, 0.29};
    s.hands[on_right] = {-0.17, 1.14 - 0.17 * reach, 0.29};
    s.feet[on_left] = {0.12, 0.17 - 0.15 * reach, 0.19};
    s.feet[on_right] = {-0.12, 0.17 + 0.15 * reach, 0.19};
    s.head_pitch = m.rise < -0.1 ? 0.3 : -0.3;
    s.tail = -0.2;
    return s;
}

Stance dash(const StanceMoment& m) {
    Stance s;
    s.body = {0, 0.62, 0.04};
    s.pitch = 0.95;
    s.head_pitch = -0.75;
    s.hands[on_left] = {0.28, 0.62, -0.34};
    s.hands[on_right] = {-0.28, 0.62, -0.34};
    s.feet[on_left] = {0.12, 0.34, -0.46};
    s.feet[on_right] = {-0.12, 0.26, -0.52};
    s.toes[on_left] = s.toes[on_right] = 1.2;
    s.ears = 1;
    s.tail = 0.2;
    if (!m.reduced_motion) s.stretch = {0.90, 0.92, 1.20};
    return s;
}

Stance hurt(const StanceMoment& m) {
    Stance s;
    s.body = {0, 0.62, -0.10};
    s.pitch = -0.5;
    s.head_pitch = -0.2;
    const double shake = m.reduced_motion ? 0 : 0.12 * std::sin(m.time * 50) * std::exp(-6 * m.time);
    s.head_roll = shake;
    s.hands[on_left] = {0.42, 0.90, 0.20};
    s.hands[on_right] = {-0.42, 0.90, 0.20};
    s.feet[on_left] = {0.16, 0.16, 0.32};
    s.feet[on_right] = {-0.14, 0.04, 0.18};
    s.toes[on_left] = -0.7;
    s.toes[on_right] = -0.4;
    s.eyes = 0;
    s.ears = 0.8;
    s.tail = 1.1;
    return s;
}

/// Up with a start, once around, and gone like a soap bubble.
Stance dead(const StanceMoment& m) {
    Stance s = hurt(m);
    s.body.y += 0.5 * m.time;
    for (const int side : {on_left, on_right}) {
        s.hands[side] = on_side(side, {0.44, 0.98 + 0.5 * m.time, 0.02});
        s.feet[side] = on_side(side, {0.22, 0.16 + 0.5 * m.time, 0.04});
    }
    if (!m.reduced_motion) s.twist = 14 * m.time * std::max(1 - m.time, 0.4);
    const double swell = 1 + 0.5 * std::min(m.time / 0.45, 1.0) * (m.reduced_motion ? 0.0 : 0.5);
    s.stretch = m.time < 0.45 ? dvec3(swell) : dvec3(0);
    return s;
}

Stance win(const StanceMoment& m) {
    Stance s;
    const double beat = m.time * 2.1;  // hops a second
    const double hop = m.reduced_motion ? 0 : std::abs(std::sin(0.5 * turn * beat));
    const double sway = std::sin(0.5 * turn * beat);
    const double around = m.reduced_motion ? 0 : 0.4 * sway;
    s.body = {0.05 * sway, 0.60 + 0.16 * hop, 0};
    s.twist = around;
    s.roll = 0.14 * sway;
    s.head_roll = -0.22 * sway;
    s.head_pitch = -0.12;
    s.hands[on_left] = {0.36, 1.16 + 0.22 * sway + 0.1 * hop, 0.10};
    s.hands[on_right] = {-0.36, 1.16 - 0.22 * sway + 0.1 * hop, 0.10};
    s.feet[on_left] = {0.13, 0.13 * hop + 0.05 * std::max(sway, 0.0), 0.02};
    s.feet[on_right] = {-0.13, 0.13 * hop + 0.05 * std::max(-sway, 0.0), 0.02};
    s.toes[on_left] = s.toes[on_right] = 0.3 * hop;
    s.eyes = 0.18;
    s.tail = 0.5 + 0.5 * std::sin(turn * beat);
    return s;
}

constexpr std::size_t number_count = sizeof(Stance) / sizeof(double);
using Numbers = std::array<double, number_count>;
static_assert(sizeof(Stance) == sizeof(Numbers));

}  // namespace

Stance mixed(const Stance& a, const Stance& b, double share) {
    Numbers x = std::bit_cast<Numbers>(a);
    const Numbers y = std::bit_cast<Numbers>(b);
    for (std::size_t i = 0; i < number_count; ++i) x[i] += (y[i] - x[i]) * share;
    return std::bit_cast<Stance>(x);
}

Stance stance_of(HeroAct act, const StanceMoment& m) {
    switch (act) {
        case HeroAct::idle:
            return idle(m);
        case HeroAct::run:
            return run(m);
        case HeroAct::jump:
            return jump(m);
        case HeroAct::fall:
            return fall(m);
        case HeroAct::crouch:
            return crouch(m);
        case HeroAct::slide:
            return slide(m);
        case HeroAct::hang:
            return hang(m);
        case HeroAct::climb:
            return climb(m);
        case HeroAct::wall_slide:
            return wall_slide(m);
        case HeroAct::swim:
            return swim(m);
        case HeroAct::ladder:
            return ladder(m);
        case HeroAct::dash:
            return dash(m);
        case HeroAct::hurt:
            return hurt(m);
        case HeroAct::dead:
            return dead(m);
        case HeroAct::win:
            break;
    }
    return win(m);
}

double stride_length(double speed) {
    return 0.75 + 0.19 * std::min(speed, 9.0);
}

double ground_share(double speed) {
    return std::clamp(0.62 - 0.045 * speed, 0.34, 0.60);
}

}  // namespace surefoot::platformer
