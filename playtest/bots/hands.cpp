#include "playtest/bots/hands.hpp"

#include <algorithm>
#include <cmath>

#include "playtest/vectors.hpp"

namespace surefoot::playtest {
namespace {

constexpr int between_presses = static_cast<int>(1 / (most_presses_per_second * game::tick_seconds) + 0.5);
constexpr int shortest_hold = 3;      // ticks
constexpr int reaction = 9;           // ticks: 150 ms
constexpr double turn_of_head = 0.1;  // share of the way that a look turns in a tick

}  // namespace

bool Hands::finger(Finger& finger, bool wants) {
    if (finger.holds) {
        ++finger.held;
        if (!wants && finger.held >= shortest_hold) finger.holds = false;
        return finger.holds;
    }
    if (wants && !finger.waits) {
        finger.waits = true;
        finger.late = dice_.whole(0, 2);
    }
    if (!finger.waits) return false;
    if (finger.late > 0) {
        --finger.late;
        return false;
    }
    if (since_press_ < between_presses) {
        // Somebody who no longer wants it while the hand was busy lets it be.
        finger.waits = wants;
        return false;
    }
    finger.waits = false;
    finger.holds = true;
    finger.held = 0;
    since_press_ = 0;
    ++presses_;
    return true;
}

game::HeroInput Hands::act(const Intent& intent) {
    game::HeroInput input;
    ++since_press_;
    const double size = flat_length(intent.move);
    const dvec3 move = size > 1 ? intent.move / size : intent.move;
    input.move_x = static_cast<float>(move.x);
    input.move_z = static_cast<float>(move.z);
    if (finger(fingers_[0], intent.jump)) press(input, game::Button::jump);
    if (finger(fingers_[1], intent.crouch)) press(input, game::Button::crouch);
    if (finger(fingers_[2], intent.dash)) press(input, game::Button::dash);

    const dvec3 look = length(intent.look) > 0 ? intent.look : intent.move;
    if (flat_length(look) > 0.05) {
        const double turn = std::remainder(yaw_of(look) - double(yaw_), 360.0);
        yaw_ = static_cast<float>(std::remainder(double(yaw_) + turn * turn_of_head, 360.0));
    }
    input.look_yaw_deg = yaw_;
    input.look_pitch_deg = pitch_;
    return input;
}

bool Reaction::after(bool is_so, Dice& dice) {
    if (!is_so) {
        for_ = 0;
        return false;
    }
    if (for_ == 0) needs_ = reaction + dice.whole(-2, 3);
    return ++for_ > needs_;
}

double yaw_of(const dvec3& direction) {
    return std::atan2(-direction.x, -direction.z) * (180 / 3.14159265358979323846);
}

}  // namespace surefoot::playtest
