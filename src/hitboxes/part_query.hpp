// One moving part is asked: the motion is carried into the part's own frame, where the part stands still. If anything
// turns, the motion is a curve there. It is then followed in pieces of equal time, each of them a chord; the volume
// that is asked keeps the orientation that it has half way through the piece, and is grown by as much as the truth may
// differ.
#pragma once

#include <cstdint>
#include <optional>

#include <surefoot/hitboxes.hpp>

#include "quat.hpp"
#include "vec.hpp"
#include "world/stance.hpp"

namespace surefoot::internal {

class PartQuery {
public:
    static constexpr std::uint32_t most_pieces = 1024;

    /// `size` is that of the volume that moves [m], 0 for a point. Requires: all numbers within the limits.
    PartQuery(const HitPart& part, const Pose& start, const Pose& end, const Motion& motion, const HitboxQuery& query,
              double size) noexcept;

    [[nodiscard]] std::optional<PartHit> ray() const noexcept;
    [[nodiscard]] std::optional<PartHit> sweep(const Volume& volume) const noexcept;

private:
    /// Where the part is, at a time of the motion [0, 1].
    [[nodiscard]] Stance stance_at(double t) const noexcept;
    /// Where the moving point is in the part's frame.
    [[nodiscard]] Vec place_at(double t) const noexcept;
    [[nodiscard]] double time_of(std::uint32_t piece) const noexcept { return piece / static_cast<double>(pieces_); }
    [[nodiscard]] std::optional<PartHit> overflow() const noexcept;
    [[nodiscard]] PartHit to_world(double t, const Vec& point, const Vec& normal, bool inside) const noexcept;
    template <typename Ask>
    std::optional<PartHit> first(const Ask& ask) const noexcept;

    const HitPart& part_;
    Vec body_start_, body_end_;
    Turn body_turn_;
    Turn part_turn_;
    Vec from_, to_;
    HitboxQuery query_;
    std::uint32_t pieces_ = 1;
    double margin_ = 0;  // how much a piece's volume has to grow [m]
};

}  // namespace surefoot::internal
