/// Characters that run to the target: a navigation crowd for the way and for keeping clear of each other, `step` for
/// the feet.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <surefoot/character.hpp>
#include <surefoot/crowd.hpp>
#include <surefoot/navigation_crowd.hpp>

#include "playground/navigation/scene.hpp"

namespace surefoot::playground {

class NavigationRunners {
public:
    static constexpr double tick = 1.0 / 60;  ///< [s]

    explicit NavigationRunners(const NavigationScene& scene);

    /// So many, from now on: the first at `start`, the others anywhere from where that can be got to. Those that are
    /// there already stay. None if there is no ground at the start.
    void be(std::size_t count, const dvec3& start);

    /// Puts all of them somewhere else.
    void scatter(const dvec3& start);

    /// The mesh has changed: everybody looks for a way anew, those who gave up, too.
    void look_again();

    /// A tick towards a place of feet; true while anybody moves.
    bool run(const dvec3& goal);

    [[nodiscard]] std::size_t size() const { return states_.size(); }
    [[nodiscard]] const CharacterState& state(std::size_t i) const { return states_[i]; }
    [[nodiscard]] const NavigationFollower& follower(std::size_t i) const { return crowd_.follower(i); }

    /// Between the last two ticks.
    [[nodiscard]] dvec3 drawn_position(std::size_t i, double waiting) const;

    /// How many are on the way, have arrived and gave up, and why the first of these did.
    [[nodiscard]] std::string words() const;

private:
    const NavigationScene* scene_;
    NavigationCrowdWorker worker_;
    NavigationCrowd crowd_;
    Crowd feet_;
    std::vector<CharacterState> before_;
    std::vector<CharacterState> states_;
    std::vector<CharacterInput> inputs_;
    std::uint64_t seed_ = 0;
};

}  // namespace surefoot::playground
