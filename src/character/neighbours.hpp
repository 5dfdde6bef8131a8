// The other characters, as one that takes a step meets them: still, where the tick begins for them; and those that come
// towards it also where the two would touch half way.
//
// Why still: what a step does not go deeper into is where the other was. So two that overlap never get deeper into each
// other, whatever else they are pushed by, and two that do not can come to overlap by no more than either of them
// moves.
#pragma once

#include <array>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include <surefoot/character_neighbour.hpp>

#include "character/carry.hpp"
#include "character/surroundings.hpp"

namespace surefoot::internal {

class Neighbours {
public:
    /// `body` and `given` must outlive it. Heeds the first `most_neighbours`.
    Neighbours(const Body& body, double skin, std::span<const Neighbour> given) noexcept;

    [[nodiscard]] bool empty() const noexcept { return count_ == 0; }
    [[nodiscard]] bool overflow() const noexcept { return given_.size() > count_; }
    [[nodiscard]] std::uint32_t id(std::size_t index) const noexcept { return given_[index].id; }

    /// Puts them where they are for this part of the tick: taken along by what carries them, for a body at `position`
    /// that moves at `velocity` [m/s]; the whole tick takes `tick` [s]. Before it nobody is met.
    void place(const World& world, const Vec& position, const Vec& velocity, double tick,
               const TickPart& part) noexcept;

    /// The touches of the hard ones on the way from `from` by `motion`, added to `touches`.
    void sweep(const Vec& from, const Vec& motion, Touches& touches) const noexcept;

    /// The time of the first of these, if that is before `limit`; else `limit`.
    [[nodiscard]] double first(const Vec& from, const Vec& motion, double limit) const noexcept;

    /// The way out of what overlaps the body.
    struct Parting {
        Vec way;               ///< [m]
        std::uint32_t id = 0;  ///< of the one that is deepest in it
        double depth = 0;      ///< by so much [m], half a skin included
    };

    /// The body's share, one half, of the way out of all that it overlaps: by at most `farthest` [m], and by at most
    /// `softly` [m] out of each of the soft ones.
    [[nodiscard]] Parting way_apart(const Vec& position, double farthest, double softly) const noexcept;

private:
    struct Met {
        double t;
        Vec normal;
        Vec point;
        HitStatus status = HitStatus::ok;
        bool started_inside = false;
    };
    struct Push {
        Vec normal;
        double depth;  // how far to go along `normal` [m]
    };
    [[nodiscard]] std::optional<Met> meet(std::size_t index, const Vec& from, const Vec& motion, const Vec& place,
                                          const Vec& its_motion) const noexcept;
    [[nodiscard]] std::optional<Push> overlap(std::size_t index, const Vec& position, double by) const noexcept;
    static Vec way_out_of(std::span<const Push> pushes, double enough) noexcept;
    [[nodiscard]] bool is_near(std::size_t index, const Vec& place, const Box3& box) const noexcept;
    template <typename Visit>
    void each_hit(const Vec& from, const Vec& motion, const Visit& visit) const noexcept;

    const Body& body_;
    double skin_;
    double size_ = 0;   // no point of the body, kept off, is farther from its position [m]
    double wider_ = 0;  // how much farther it may reach, kept off in proportion [m]
    std::span<const Neighbour> given_;
    std::size_t count_ = 0;
    bool placed_ = false;
    std::array<Vec, most_neighbours> places_;    // [m]
    std::array<Vec, most_neighbours> meetings_;  // where the two would touch, if they come towards each other [m]
    std::array<double, most_neighbours> sizes_;  // no point of it is farther from its reference point [m]
    std::bitset<most_neighbours> comes_;
};

}  // namespace surefoot::internal
