// A player for tests: goes from place to place, and waits for what it rides on.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "platforms.hpp"

namespace day {

// [autopilot]
struct Leg {
    dvec3 to;                            // where it runs to,
    std::optional<std::size_t> rides{};  // or the platform that it takes to its other end
};

class Autopilot {
public:
    explicit Autopilot(std::vector<Leg> legs) : legs_(std::move(legs)) {}

    [[nodiscard]] bool is_done() const { return at_ == legs_.size(); }

    [[nodiscard]] dvec3 wish(const surefoot::World& world, const std::vector<Mover>& movers,
                             const surefoot::CharacterState& hero) {
        if (is_done()) return {0, 0, 0};
        const Leg& leg = legs_[at_];
        const dvec3 feet = feet_of(hero);
        if (!leg.rides) {
            const dvec3 way{leg.to.x - feet.x, 0, leg.to.z - feet.z};
            if (glm::length(way) < 0.2) ++at_;
            return towards(feet, leg.to, 6);
        }
        const Mover& mover = movers[*leg.rides];
        const dvec3 place = world.poses(mover.body).end.position;
        if (hero.ground_body == mover.id) {  // on it: stand in its middle until it is there
            if (place == mover.to) ++at_;
            return towards(feet, place, 2);
        }
        return place == mover.from ? towards(feet, place, 6) : dvec3{0, 0, 0};  // get on while it waits
    }

private:
    std::vector<Leg> legs_;
    std::size_t at_ = 0;
};
// [/autopilot]

}  // namespace day
