/// Characters that run to the target: a follower for the way, `step` for the feet.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <surefoot/character.hpp>
#include <surefoot/navigation_follow.hpp>

#include "playground/navigation/scene.hpp"

namespace surefoot::playground {

class NavigationRunners {
public:
    static constexpr double tick = 1.0 / 60;  ///< [s]

    struct Runner {
        CharacterState before{};
        CharacterState state{};
        NavigationFollower follower{};

        /// Between the last two ticks.
        [[nodiscard]] dvec3 drawn_position(double waiting) const;
    };

    /// So many, from now on: the first at `start`, the others anywhere from where that can be got to. Those that are
    /// there already stay. None if there is no ground at the start.
    void be(std::size_t count, const NavigationScene& scene, const NavigationQuery& query, const dvec3& start);

    /// Puts all of them somewhere else.
    void scatter(const NavigationScene& scene, const NavigationQuery& query, const dvec3& start);

    /// A tick towards a place of feet; true while anybody moves.
    bool run(const NavigationScene& scene, const NavigationQuery& query, const dvec3& goal);

    [[nodiscard]] const std::vector<Runner>& all() const { return runners_; }

    /// How many run, have arrived and gave up, and why the first of these did.
    [[nodiscard]] std::string words() const;

private:
    std::vector<Runner> runners_;
    std::uint64_t seed_ = 0;
};

}  // namespace surefoot::playground
