// What the four kinds of enemies look like.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "platformer/hero/enemy.hpp"
#include "platformer/hero/frame.hpp"

namespace surefoot::platformer {
namespace {

using view::Colour;
using view::Piece;
using view::rgb;
using view::Solid;

constexpr Colour dark = rgb(0x2B1D2A);
constexpr Colour white = rgb(0xFFFFFF);

class Builder {
public:
    Builder(std::vector<Piece>& pieces, const EnemyPose& pose) : pieces_(pieces), p_(pose) {}

    void build();

private:
    void add(const Frame& frame, const dvec3& at, const dvec3& radii, Colour colour, Solid solid = Solid::ball,
             const dmat3& turn = dmat3(1), float glow = 0) {
        Piece made = piece(frame, at, radii, colour, solid, turn);
        made.glow = glow;
        made.casts_shadow = true;
        pieces_.push_back(made);
    }
    void eye(const Frame& frame, const dvec3& at, double size, double frown);
    void chaser(const Frame& root);
    void patroller(const Frame& root);
    void jumper(const Frame& root);
    void shooter(const Frame& root);
    void mark(const Frame& standing);

    [[nodiscard]] double step(double length, double offset) const {
        return std::sin(2 * std::numbers::pi * (p_.stride / length + offset));
    }

    std::vector<Piece>& pieces_;
    const EnemyPose& p_;
};

/// White with a dark pupil; a lid comes down over it, towards the nose, when it is angry.
void Builder::eye(const Frame& frame, const dvec3& at, double size, double frown) {
    const double side = at.x < 0 ? -1 : 1;
    add(frame, at, dvec3(size, size * 1.1, size * 0.7), white, Solid::ball, dmat3(1), 0.25F);
    add(frame, at + dvec3(-side * size * 0.15, -size * 0.05, size * 0.48), dvec3(size * 0.5, size * 0.6, size * 0.35),
        dark);
    if (frown > 0.05)
        add(frame, at + dvec3(0, size * (1.25 - 0.55 * frown), size * 0.25),
            dvec3(size * 1.15, size * 0.32, size * 0.7), dark, Solid::ball, rolled(side * 0.45 * frown));
}

void Builder::chaser(const Frame& root) {
    const Colour shell = rgb(0xC92F45);
    const double bob = 0.02 * std::abs(step(0.8, 0));
    const Frame body = root.inside({0, 0.36 + bob, 0}, pitched(0.18 * p_.alarm) * rolled(0.06 * step(0.8, 0)));
    add(body, {0, 0, 0}, {0.44, 0.34, 0.46}, shell);
    add(body, {0, 0.025, -0.03}, {0.022, 0.335, 0.46}, dark);  // where its wings meet
    for (const dvec3& spot : {dvec3(0.22, 0.22, -0.12), dvec3(0.30, 0.10, 0.16), dvec3(0.30, 0.06, -0.26)})
        for (const double side : {1.0, -1.0}) add(body, {side * spot.x, spot.y, spot.z}, {0.085, 0.07, 0.085}, dark);
    const Frame head = body.inside({0, -0.02, 0.38});
    add(head, {0, 0, 0}, {0.26, 0.23, 0.18}, dark);
    for (const double side : {1.0, -1.0}) {
        eye(head, {side * 0.115, 0.09, 0.11}, 0.088, p_.alarm);
        // Pincers, that open and shut when it is after somebody.
        const double bite = 0.35 + 0.35 * p_.alarm * std::sin(p_.clock * 18);
        add(head, {side * 0.10, -0.10, 0.15}, {0.045, 0.17, 0.045}, rgb(0xF3D9B0), Solid::cone,
            turned(-side * bite) * pitched(1.5));
        const double wave = 0.15 * std::sin(p_.clock * 5 + side);
        add(head, {side * 0.12, 0.17, 0.02}, {0.018, 0.20, 0.018}, dark, Solid::cone, rolled(side * (0.5 + wave)));
        add(head, {side * (0.12 + 0.2 * std::sin(0.5 + wave)), 0.17 + 0.19 * std::cos(0.5 + wave), 0.02}, dvec3(0.04),
            shell);
        for (int leg = 0; leg < 3; ++leg) {
            const double swing = step(0.8, 0.33 * leg + (side > 0 ? 0 : 0.5));
            add(root, {side * 0.36, 0.06 + 0.05 * std::max(swing, 0.0), 0.24 - 0.24 * leg + 0.09 * swing},
                {0.085, 0.065, 0.10}, dark);
        }
    }
}

void Builder::patroller(const Frame& root) {
    const Colour iron = rgb(0x5B3A8C);
    const bool alert = p_.mood == EnemyMood::notice || p_.mood == EnemyMood::attack;
    const Colour light = alert ? rgb(0xFF5A3C) : rgb(0xFFD25A);
    const double sway = step(1.1, 0);
    const Frame body =
        root.inside({0, 0.80 + 0.03 * std::abs(sway), 0}, rolled(0.09 * sway) * pitched(0.15 * p_.alarm));
    add(body, {0, -0.36, 0}, {0.26, 0.06, 0.26}, iron, Solid::drum);
    add(body, {0, 0.0, 0}, {0.215, 0.31, 0.215}, light, Solid::drum, dmat3(1), 0.75F);
    for (int bar = 0; bar < 4; ++bar) {
        const double angle = std::numbers::pi / 4 + std::numbers::pi / 2 * bar;
        add(body, {0.225 * std::sin(angle), 0, 0.225 * std::cos(angle)}, {0.035, 0.32, 0.035}, iron, Solid::drum);
    }
    add(body, {0, 0.32, 0}, {0.34, 0.26, 0.34}, iron, Solid::cone);
    add(body, {0, 0.58, 0}, {0.05, 0.05, 0.05}, iron);
    // A ring to carry it by.
    for (int i = 0; i < 8; ++i) {
        const double angle = 2 * std::numbers::pi * i / 8;
        add(body, {0.085 * std::cos(angle), 0.69 + 0.085 * std::sin(angle), 0}, {0.04, 0.04, 0.028}, iron);
    }
    for (const double side : {1.0, -1.0}) {
        eye(body, {side * 0.095, 0.06, 0.20}, 0.082, p_.alarm);
        const double swing = side * sway;
        add(root, {side * 0.13, 0.27 + 0.04 * std::max(swing, 0.0), 0.07 * swing}, {0.05, 0.17, 0.05}, iron,
            Solid::drum, pitched(-0.35 * swing));
        add(root, {side * 0.13, 0.07 + 0.07 * std::max(swing, 0.0), 0.13 * swing + 0.05}, {0.11, 0.07, 0.16}, dark);
    }
}

void Builder::jumper(const Frame& root) {
    const Colour skin = rgb(0x7CC53A);
    const Colour belly = rgb(0xEAF3B5);
    const double crouch = p_.on_ground ? 0.5 + 0.5 * std::sin(p_.clock * 4) : -1.4;
    const double height = 0.50 - 0.05 * crouch;
    // Its spring.
    for (int turn = 0; turn < 5; ++turn)
        add(root, {0.03 * std::sin(turn * 2.4), 0.06 + (height - 0.20) * turn / 5.0, 0.03 * std::cos(turn * 2.4)},
            {0.20 - 0.012 * turn, 0.035, 0.20 - 0.012 * turn}, turn % 2 == 0 ? rgb(0x8C97A3) : rgb(0xC3CCD4),
            Solid::drum, rolled(0.12) * pitched(0.1));
    const Frame body = root.inside({0, height + 0.06, 0}, pitched(p_.on_ground ? 0.05 : -0.25));
    add(body, {0, 0, 0}, {0.36, 0.26, 0.33}, skin);
    add(body, {0, -0.05, 0.06}, {0.30, 0.19, 0.29}, belly);
    add(body, {0, -0.02, 0.30}, {0.20, 0.018, 0.05}, rgb(0x43701C));  // a wide mouth
    for (const double side : {1.0, -1.0}) {
        add(body, {side * 0.19, 0.23, 0.12}, dvec3(0.125), skin);
        eye(body, {side * 0.19, 0.26, 0.20}, 0.092, p_.alarm);
        const double spread = p_.on_ground ? 0 : 0.12;
        add(body, {side * (0.37 + spread), -0.08, 0.0}, {0.10, 0.15, 0.14}, skin);
        add(body, {side * (0.40 + 1.6 * spread), -0.22, 0.08}, {0.12, 0.05, 0.15}, rgb(0x5E9A2A));
    }
}

void Builder::shooter(const Frame& root) {
    const Colour leaf = rgb(0x3C8F5A);
    const Colour petal = rgb(0x3C6FD6);
    add(root, {0, 0.16, 0}, {0.30, 0.16, 0.30}, rgb(0xB5623C), Solid::drum);
    add(root, {0, 0.32, 0}, {0.35, 0.055, 0.35}, rgb(0xC9744A), Solid::drum);
    add(root, {0, 0.36, 0}, {0.29, 0.04, 0.29}, rgb(0x4A3328));
    const double sway = 0.06 * std::sin(p_.clock * 2.3);
    const double recoil = p_.reduced_motion ? 0 : 0.20 * std::exp(-p_.since_fire * 9);
    for (int joint = 0; joint < 4; ++joint) {
        const double up = joint / 3.0;
        add(root, {sway * up, 0.42 + 0.36 * up, -0.08 * std::sin(up * 3.0) - recoil * up * 0.5}, {0.065, 0.11, 0.065},
            leaf);
    }
    for (const double side : {1.0, -1.0})
        add(root, {side * 0.24, 0.50 + 0.02 * std::sin(p_.clock * 2.3 + side), 0.02}, {0.22, 0.035, 0.10}, leaf,
            Solid::ball, rolled(-side * 0.5));
    const Frame head = root.inside({sway, 0.92, -0.02 - recoil}, pitched(-p_.pitch));
    // The petals lie back, and come forward when it takes aim.
    const double open = 0.35 + 0.75 * (1 - p_.alarm);
    for (int i = 0; i < 7; ++i) {
        const double angle = 2 * std::numbers::pi * i / 7 + 0.2 * std::sin(p_.clock * 0.8);
        const dmat3 around = rolled(angle);
        const Frame here = head.inside(dvec3(0), around);
        add(here, {0, 0.16 + 0.14 * std::sin(open), 0.10 * std::cos(open) - 0.02}, {0.115, 0.185, 0.045},
            i % 2 == 0 ? petal : rgb(0x5E8CE8), Solid::ball, pitched(1.57 - open - 0.2));
    }
    add(head, {0, 0, 0}, {0.22, 0.22, 0.20}, rgb(0xF2C33C));
    const double mouth = 0.065 + 0.035 * p_.alarm + 0.05 * std::exp(-p_.since_fire * 8);
    add(head, {0, -0.06, 0.13}, {mouth, mouth, 0.10}, dark);
    for (const double side : {1.0, -1.0}) eye(head, {side * 0.095, 0.085, 0.155}, 0.062, p_.alarm);
}

/// That it has seen somebody is said over its head.
void Builder::mark(const Frame& standing) {
    const double age = p_.mood_time;
    if (age > 0.9) return;
    const double size = std::min(age * 9, 1.0) * std::clamp((0.9 - age) * 6, 0.0, 1.0);
    const double tall = p_.kind == EnemyKind::patroller ? 1.78 : p_.kind == EnemyKind::shooter ? 1.50 : 1.12;
    const Frame at = standing.inside({0, tall, 0}, scaled(dvec3(std::max(size, 1e-3))));
    add(at, {0, 0.24, 0}, {0.075, 0.26, 0.075}, rgb(0xFFD84A), Solid::cone, pitched(std::numbers::pi), 0.7F);
    add(at, {0, -0.10, 0}, dvec3(0.06), rgb(0xFFD84A), Solid::ball, dmat3(1), 0.7F);
}

void Builder::build() {
    const Frame standing{turned(p_.facing), p_.soles};
    double tall = 1 + p_.squash;
    double size = 1;
    if (p_.mood == EnemyMood::stomped) {
        if (p_.mood_time > stomped_time) return;
        // Flat at once, then gone.
        tall = 0.22 + 0.78 * std::exp(-p_.mood_time * 30);
        size = std::clamp((stomped_time - p_.mood_time) * 4, 0.02, 1.0);
    }
    const double wide = std::min(1 / std::sqrt(tall), 1.5);
    const Frame root = standing.inside(dvec3(0), scaled(dvec3(wide, tall, wide) * size));
    switch (p_.kind) {
        case EnemyKind::chaser:
            chaser(root);
            break;
        case EnemyKind::patroller:
            patroller(root);
            break;
        case EnemyKind::jumper:
            jumper(root);
            break;
        case EnemyKind::shooter:
            shooter(root);
            break;
    }
    if (p_.mood == EnemyMood::notice) mark(standing);
}

}  // namespace

void add_pieces(std::vector<Piece>& pieces, const EnemyPose& pose) {
    Builder(pieces, pose).build();
}

}  // namespace surefoot::platformer
