#include "playtest/report/frame_camera.hpp"

#include <algorithm>

#include "playtest/vectors.hpp"

namespace surefoot::playtest {
namespace {

constexpr double degree = 3.14159265358979323846 / 180;
constexpr double distance = 6.2;      // from the hero, where there is room [m]
constexpr double liked_pitch = 0.36;  // how high the eye stands by itself [rad]
constexpr double lowest_pitch = -0.35;
constexpr double highest_pitch = 1.25;
constexpr double look_height = 0.55;  // of what it looks at, over the middle of the hero [m]
constexpr double eye_radius = 0.25;   // nothing is so near to the eye [m]
constexpr double enough = 0.4;        // of that distance: with less room the eye looks for more of it higher up
constexpr double nearest = 1.6;       // any nearer, and the hero would fill the picture [m]

}  // namespace

FrameCamera frame_camera(const game::Game& game, const game::HeroInput& input) {
    const double yaw = double(input.look_yaw_deg) * degree;
    const double looks_up = double(input.look_pitch_deg) * degree;
    const double wished = looks_up == 0 ? liked_pitch : std::clamp(-looks_up, lowest_pitch, highest_pitch);
    const dvec3 ahead{-std::sin(yaw), 0, -std::cos(yaw)};
    const dvec3 look_at = game.hero().body.position + dvec3{0, look_height, 0};
    const auto towards = [&](double pitch) { return ahead * std::cos(pitch) - dvec3{0, std::sin(pitch), 0}; };
    double best = wished;
    double best_share = -1;
    for (const double pitch : {wished, 0.75, 1.1, 1.54}) {
        if (pitch < wished || best_share >= enough) continue;
        const dvec3 eye = look_at - towards(pitch) * distance;
        const auto hit = game.world().sweep(Sphere{eye_radius}, {look_at, eye}, {.begin = 1, .end = 1});
        const double share = hit ? hit->t : 1;
        if (share > best_share) {
            best = pitch;
            best_share = share;
        }
    }
    FrameCamera camera;
    camera.forward = towards(best);
    camera.right = {-ahead.z, 0, ahead.x};
    camera.up = ahead * std::sin(best) + dvec3{0, std::cos(best), 0};
    camera.eye = look_at - camera.forward * (distance * std::max(best_share, nearest / distance));
    return camera;
}

}  // namespace surefoot::playtest
