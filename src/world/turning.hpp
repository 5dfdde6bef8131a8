// A sweep against a body that turns while it is asked. The tick is cut into pieces of equal time. In each the body
// stands still in the question: the volume keeps the orientation that it has in the body's frame half way, moves
// straight between the two places that are exact, and is grown by as much as the true motion may differ from that.
#pragma once

#include <optional>

#include <surefoot/world.hpp>

#include "world/ask.hpp"

namespace surefoot::internal {

class TurningSweep {
public:
    static constexpr std::uint32_t most_pieces = 4096;

    /// `volume` null asks a ray. Requires: a valid query; the body turns, and the query takes time.
    TurningSweep(const WorldBody& body, const Volume* volume, const Motion& motion, const WorldQuery& query) noexcept;

    /// Anything but `ok`: it cannot be answered.
    [[nodiscard]] HitStatus status() const noexcept { return status_; }

    /// The first touch, in the world; nothing that begins after `limit` needs to be found.
    [[nodiscard]] std::optional<Hit> first(double limit) const noexcept;

private:
    [[nodiscard]] double margin(double pieces) const noexcept;
    [[nodiscard]] double time_of(std::uint32_t piece) const noexcept { return piece / static_cast<double>(pieces_); }
    [[nodiscard]] Stance stance_at(double t) const noexcept;
    [[nodiscard]] Vec place_at(double t) const noexcept;
    [[nodiscard]] bool is_clear(std::uint32_t first, std::uint32_t count) const noexcept;
    void choose_pieces() noexcept;
    void ask_piece(std::uint32_t piece, FirstHit& first) const noexcept;
    void ask_what_touches(std::uint32_t piece, const Volume& volume, const Motion& chord,
                          FirstHit& first) const noexcept;

    const WorldBody& body_;
    const WorldQuery& query_;
    const Volume* volume_;
    Vec from_;   // the reference point, from the body's origin, in the world, when the query begins
    Vec to_;     // and when it ends
    Vec begin_;  // the body's place
    Vec end_;
    Quat turned_begin_;  // of unit length, or near it
    Quat turned_end_;
    double bend_ = 0;     // the largest second derivative of the path in the body's frame [m]
    double roll_ = 0;     // how far the volume's surface goes along its normals by turning [m]
    double hair_ = 0;     // rounding [m]
    double reserve_ = 0;  // how far a piece's volume is from the true one at most [m]
    GrownVolume grown_;
    std::uint32_t pieces_ = 1;
    HitStatus status_ = HitStatus::ok;
};

}  // namespace surefoot::internal
