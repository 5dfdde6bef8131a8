/// What is heard of a game: which sound each happening makes, and where.
#pragma once

#include "game/game.hpp"
#include "platformer/hero/pose.hpp"
#include "platformer/sound/speaker.hpp"
#include "view/camera.hpp"

namespace surefoot::platformer {

class Ears {
public:
    explicit Ears(sound::Speaker& speaker) : speaker_(speaker) {}

    /// After each tick.
    void tick(const game::Game& game, const HeroPose& before, const HeroPose& pose);

    /// Where it is heard from.
    void listen(const view::Camera& camera);

private:
    void play(sound::Effect effect, const dvec3& place, double gain = 1, double pitch = 1);

    sound::Speaker& speaker_;
    double slide_wait_ = 0;  // until the sound of sliding is played again [s]
};

/// What is underfoot, by the name of its material.
[[nodiscard]] sound::Ground ground_of(const game::Level& level, std::uint32_t surface);

}  // namespace surefoot::platformer
