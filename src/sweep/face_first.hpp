// What most sweeps are: the triangle's own plane keeps the shape away all along, or the shape meets the middle of the
// face. Both are decided by one plane, before any edge or corner is asked.
#pragma once

#include "sweep/planes.hpp"
#include "sweep/query.hpp"

namespace surefoot::internal {

struct FaceFirst {
    enum class Verdict : std::uint8_t {
        undecided,  ///< ask all features
        free,       ///< the triangle's plane has a gap over the whole motion, or until after the limit: no hit
        hit,        ///< at `t` the face's plane gives way, and `point` is of the shape and well inside the triangle
    };
    Verdict verdict = Verdict::undecided;
    Plane plane{};
    double t = 0;
    Vec point;  ///< in the shape's frame, relative to `from`
};

[[nodiscard]] FaceFirst ask_face_first(const SweepQuery& query, double limit) noexcept;

/// For a shape that touches the middle of the face at `from`, or leaves it so little that the motion only grazes it:
/// whether the motion goes deeper, to rounding; what ask_face_first left undecided, from its answer.
[[nodiscard]] FaceFirst ask_touching_face(const SweepQuery& query, FaceFirst face) noexcept;

}  // namespace surefoot::internal
