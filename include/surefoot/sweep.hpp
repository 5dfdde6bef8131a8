/// The exact sweep: a shape moves in a straight line; when does it first touch this triangle?
///
/// What is promised (and proved, see docs/proof.md), with K the shape, T the triangle, g(t) the signed distance between
/// them (in squashed space for an ellipsoid), and every input a number up to 1e9:
///  - never missed: if K reaches T exactly, there is a hit;
///  - never late: K does not cut into T before or at the reported t;
///  - never early by more than a hair: at t the gap along the normal is at most 1e-10 of the largest number in the
///  query;
///  - starting in touch or inside is a hit at t = 0 if and only if K would go deeper. Leaving, sliding along and
///    standing still are no hits, so a character in contact is never stuck. Ask `overlap` for those.
#pragma once

#include <optional>

#include <surefoot/hit.hpp>
#include <surefoot/math.hpp>
#include <surefoot/shapes.hpp>
#include <surefoot/trace.hpp>

namespace [[gnu::visibility("default")]] surefoot {
inline namespace v0 {

struct SweepOptions {
    /// A one-sided triangle exists only for motions against its front: (to - from) . N < 0, decided exactly. A triangle
    /// without area has no front and does not exist for them.
    bool one_sided = false;
};

/// When does `volume`, moving along `motion`, first touch `triangle`?
///
/// Guarantees: allocates nothing; the same bits on every machine; vertices of the triangle in any order give the same
/// t. Data outside the limits (see shapes.hpp, and 1e9 for coordinates), NaN and infinity give a hit at t = 0 with
/// status `invalid` and a zero normal, never a free pass.
[[nodiscard]] std::optional<Hit> sweep(const Volume& volume, const Motion& motion, const Triangle& triangle,
                                       const SweepOptions& options = {}, Trace* trace = nullptr) noexcept;

}  // namespace v0
}  // namespace surefoot
