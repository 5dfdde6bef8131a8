/// The classic analytic test, candidate by candidate: an ellipsoid becomes the ball of radius 1, and that is asked when
/// it touches the interior of the triangle, each of its edges and each of its corners. The least of the times that pass
/// every check is the answer. Written down as it is taught; the library decides by planes (docs/method.md), and a test
/// sees that both agree.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include <surefoot/hit.hpp>
#include <surefoot/math.hpp>
#include <surefoot/shapes.hpp>

#include "debugger/equation.hpp"

namespace surefoot::debugger {

/// Which root of a quadratic is taken for the time of touch.
enum class Root : std::uint8_t {
    lower,  ///< where the ball begins to touch
    upper,  ///< WRONG ON PURPOSE, for teaching: where it ceases to
};

enum class Reason : std::uint8_t {
    first_touch,        ///< kept, and the least: the answer
    later,              ///< kept, but another one is earlier
    outside,            ///< the contact is not on the triangle, or beyond an end of the edge
    moving_away,        ///< the distance grows
    after_end,          ///< comes only after END
    before_start,       ///< at START the ball already cuts the endless line, or the plane
    no_root,            ///< passes by
    parallel,           ///< the distance never changes
    degenerate,         ///< there is no such feature: no area, no length
    from_behind,        ///< one-sided, and the motion is not against the front
    in_touch_at_start,  ///< another rule decides
};

/// What the test asks about one feature. Squashed coordinates are seen from START, which is their origin.
struct Candidate {
    Feature feature = Feature::face;
    std::uint8_t index = 0;  ///< edge (0: ab, 1: bc, 2: ca) or vertex (0: a, 1: b, 2: c)
    std::string name;        ///< "interior", "edge ab", "vertex c"
    /// For the interior: height over the plane minus 1. Else: squared distance to the line or the corner, minus 1.
    Equation equation;
    Roots roots;
    std::optional<double> t;                ///< the root that is looked at, if there is one
    std::optional<dvec3> contact;           ///< where the ball touches the plane, the line or the corner then [m]
    std::optional<dvec3> squashed_contact;  ///< the same in squashed space
    std::optional<dvec3> weights;           ///< interior: its barycentrics, one of them negative when it is outside
    std::optional<double> along;  ///< edge: how far along it the contact is, 0 at its first end, 1 at its second
    bool kept = false;            ///< passes all checks
    Reason reason = Reason::no_root;
    std::string why;  ///< the same in words
};

struct MethodTable {
    Triangle squashed_triangle;  ///< seen from START
    dvec3 squashed_motion{0, 0, 0};
    std::array<Candidate, 7> candidates;  ///< the interior, ab, bc, ca, a, b, c
    double gap_at_start = 0;              ///< distance to the triangle minus 1, squashed
    std::optional<double> t;              ///< the answer
    std::optional<std::size_t> answer;    ///< which candidate it is; none for a start in touch
    std::string conclusion;               ///< a sentence
};

struct MethodOptions {
    bool one_sided = false;
    Root root = Root::lower;
};

/// Requires: a valid sphere or ellipsoid (`is_squashable`).
[[nodiscard]] MethodTable method_table(const Volume& volume, const Motion& motion, const Triangle& triangle,
                                       const MethodOptions& options = {});

}  // namespace surefoot::debugger
