/// The parts of a body that shots and blades meet: volumes on a moving pose, apart from the volume that walks.
///
/// The volume that walks is round and generous. A shot may go through it and still miss the body: between the legs,
/// over the shoulder. So what is hit is asked of parts, each with a pose relative to the body, and both the body's pose
/// and the part's go from one to another during the tick, as `pose_between` says.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <type_traits>

#include <surefoot/hit.hpp>
#include <surefoot/math.hpp>
#include <surefoot/pose.hpp>
#include <surefoot/shapes.hpp>

namespace [[gnu::visibility("default")]] surefoot {
inline namespace v0 {

/// A part of a body. Its volume's own orientation is relative to its pose.
struct HitPart {
    Volume volume;
    Pose start{};              ///< relative to the body, when the tick begins
    Pose end{};                ///< and when it ends
    std::uint32_t number = 0;  ///< your own: which part this is
};

/// When a shot or a blow is on its way, and how closely turning parts are followed.
struct HitboxQuery {
    double begin = 0;  ///< when in the tick the motion begins [0, 1]
    double end = 1;    ///< and when it ends [begin, 1]; the same for a shot that takes no time
    /// How far from a part that turns it may be hit [m, > 0]. What does not turn is hit where it is.
    double turn_gap = 0.001;
};

/// The first part that was met.
struct PartHit {
    double t = 0;              ///< when [0 at the motion's `from`, 1 at its `to`]
    dvec3 point{0, 0, 0};      ///< where, at that time [m]
    dvec3 normal{0, 0, 0};     ///< unit, in the world, out of the part; of a ray that begins inside: back along it
    std::uint32_t number = 0;  ///< your own number for the part
    HitStatus status = HitStatus::ok;  ///< anything but `ok` blocks at t = 0
    bool started_inside = false;       ///< the motion begins inside of the part; t is 0
};

static_assert(std::is_trivially_copyable_v<PartHit>);

/// The parts of one body during one tick. It looks at the caller's parts and copies none, so they must outlive it; make
/// a new one for each tick, which allocates nothing and costs a few operations a part.
///
/// Nothing here allocates. Any number of threads may ask at once. The parts are solid: what begins inside of one hits
/// it at t = 0, whichever way it goes. Ties go to the lowest number. Before any part is asked, the motion has to meet a
/// ball about the body that holds them all.
class Hitboxes {
public:
    /// The body goes from `start` to `end` during the tick. Numbers out of range are no error yet: the query says
    /// `invalid`.
    Hitboxes(std::span<const HitPart> parts, const Pose& start, const Pose& end) noexcept;
    /// The body stands still.
    Hitboxes(std::span<const HitPart> parts, const Pose& pose) noexcept : Hitboxes(parts, pose, pose) {}

    /// Where a point that goes along `motion` first meets a part: a bullet, or with one moment as `begin` and `end` a
    /// line of sight.
    [[nodiscard]] std::optional<PartHit> ray(const Motion& motion, const HitboxQuery& query = {}) const noexcept;

    /// Where a volume that goes along `motion` first touches a part: a blade, an arrow, a rolling barrel. A part that
    /// turns is never missed, and is met at most `turn_gap` too early.
    [[nodiscard]] std::optional<PartHit> sweep(const Volume& volume, const Motion& motion,
                                               const HitboxQuery& query = {}) const noexcept;

    /// The radius of the ball about the body's position that holds all parts at all times of the tick [m].
    [[nodiscard]] double radius() const noexcept { return radius_; }

private:
    template <typename Ask>
    std::optional<PartHit> first(double size, const Motion& motion, const HitboxQuery& query,
                                 const Ask& ask) const noexcept;

    std::span<const HitPart> parts_;
    Pose start_;
    Pose end_;
    double radius_ = 0;
    bool valid_ = true;
};

}  // namespace v0
}  // namespace surefoot
