/// A shape against a shape: for characters that meet characters, for stomps, bullets and blasts.
///
/// Which pairs are answered how:
///  - sphere, capsule, box and cylinder among themselves, as long as their axes agree (all upright, or all turned the
///    same way; a sphere agrees with everything; capsules and cylinders may spin about their own axis): closed form;
///  - box against box and capsule against capsule, turned any way: closed form;
///  - two ellipsoids of the same proportions, turned alike: closed form while they are apart;
///  - everything else, other ellipsoids and cones among it: conservative advancement over the distance of the two
///    shapes, in a bounded number of steps.
///
/// All of them are judged by planes between the two shapes, so none of them can be late by more than rounding. Both are
/// called touching while the gap is at most the tolerance below (or 2^-44 of their distance or motion, if that is more:
/// a grain of dust that crosses a country), and a touch is reported no earlier than that.
#pragma once

#include <optional>
#include <type_traits>

#include <surefoot/hit.hpp>
#include <surefoot/math.hpp>
#include <surefoot/shapes.hpp>

namespace [[gnu::visibility("default")]] surefoot {
inline namespace v0 {

/// How close two shapes are when a closed form calls them touching [share of their sizes together, the size of a shape
/// being the greatest distance of its points from its reference point].
inline constexpr double pair_tolerance = 1e-9;

/// The same where a search answers [share of their sizes together]. The distance of two shapes found by their farthest
/// points has half the digits of a double.
inline constexpr double pair_search_tolerance = 1e-7;

/// How two shapes overlap. Moving the first by `normal * depth`, or the second by the opposite, parts them, just
/// touching.
struct PairOverlap {
    dvec3 point{0, 0, 0};              ///< where they touch once parted, seen from the second shape, which stays [m]
    dvec3 normal{0, 0, 0};             ///< unit, in the world: from the second towards the first; zero if not `ok`
    double depth = 0;                  ///< how far to move [m, >= 0]; 0 is just touching
    HitStatus status = HitStatus::ok;  ///< `overflow`: they overlap, but which way is out was not found
};

/// The first touch of two shapes, at least one of which moves.
struct PairHit {
    double t = 0;                      ///< time of first touch [0 at `from`, 1 at `to`]
    dvec3 point{0, 0, 0};              ///< where they touch, at that time [m]
    dvec3 normal{0, 0, 0};             ///< unit, in the world: from the second towards the first; zero if not `ok`
    HitStatus status = HitStatus::ok;  ///< anything but `ok` blocks the move at t = 0
    bool started_inside = false;       ///< already touching or overlapping at the start, and going deeper; t is 0
};

static_assert(std::is_trivially_copyable_v<PairOverlap> && sizeof(PairOverlap) == 64);
static_assert(std::is_trivially_copyable_v<PairHit> && sizeof(PairHit) == 64);

/// Do two shapes touch, and which way is out?
///
/// How short the way out is: the shortest there is for the closed forms above, and wherever a sphere or a capsule
/// overlaps something with its round part only; else a way that is shortest among its neighbours, see docs/overlap.md
/// for how much that was measured to cost.
///
/// Guarantees: allocates nothing; swapping the two gives the same depth and the negated normal, bit for bit; data
/// outside the limits answer with status `invalid`, zero normal and zero depth.
[[nodiscard]] std::optional<PairOverlap> pair_overlap(const Volume& a, const dvec3& position_a, const Volume& b,
                                                      const dvec3& position_b) noexcept;

/// When do two moving shapes first touch? Both move during the same time, each along its own motion.
///
/// Starting in touch or inside is a hit at t = 0 if and only if they go deeper; leaving, sliding along and keeping
/// still are none. What goes no deeper than the tolerance before it leaves again slides.
///
/// Guarantees: allocates nothing; swapping the two gives the same t and the negated normal, bit for bit; data outside
/// the limits give a hit at t = 0 with status `invalid`, and a search beyond its bound one with `overflow`, never a
/// free pass.
[[nodiscard]] std::optional<PairHit> pair_sweep(const Volume& a, const Motion& motion_a, const Volume& b,
                                                const Motion& motion_b) noexcept;

/// The same, against a shape that stands still.
[[nodiscard]] std::optional<PairHit> pair_sweep(const Volume& a, const Motion& motion_a, const Volume& b,
                                                const dvec3& position_b) noexcept;

}  // namespace v0
}  // namespace surefoot
