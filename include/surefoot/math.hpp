/// The vocabulary of numbers: GLM's vectors and quaternions, and the two things every query is made of, a motion and a
/// triangle. Positions are doubles in metres; the axes are right-handed with +Y up unless you say otherwise.
///
/// Only GLM's *types* are used. Every function that decides an answer is compiled inside the library, so that flags
/// such as -ffast-math in your build cannot change it.
#pragma once

#include <cstddef>
#include <glm/ext/quaternion_double.hpp>
#include <glm/ext/vector_double3.hpp>
#include <glm/ext/vector_float3.hpp>
#include <type_traits>

#if defined(GLM_FORCE_DEFAULT_ALIGNED_GENTYPES)
#error "Surefoot needs GLM's packed types: build without GLM_FORCE_DEFAULT_ALIGNED_GENTYPES."
#endif
#if defined(GLM_FORCE_QUAT_DATA_WXYZ)
#error "Surefoot needs GLM's default order of quaternion data (x, y, z, w): build without GLM_FORCE_QUAT_DATA_WXYZ."
#endif

namespace [[gnu::visibility("default")]] surefoot {
inline namespace v0 {

using glm::dquat;
using glm::dvec3;
using glm::vec3;

static_assert(
    sizeof(dvec3) == 3 * sizeof(double) && alignof(dvec3) == alignof(double),
    "Surefoot and its caller must agree that glm::dvec3 is three packed doubles: check your GLM_FORCE_* macros");
static_assert(
    sizeof(vec3) == 3 * sizeof(float) && alignof(vec3) == alignof(float),
    "Surefoot and its caller must agree that glm::vec3 is three packed floats: check your GLM_FORCE_* macros");
static_assert(sizeof(dquat) == 4 * sizeof(double) && offsetof(dquat, x) == 0 &&
                  offsetof(dquat, w) == 3 * sizeof(double),
              "Surefoot and its caller must agree that glm::dquat is x, y, z, w: check your GLM_FORCE_* macros");

/// A straight move of a shape's reference point. Time runs from 0 at `from` to 1 at `to`.
struct Motion {
    dvec3 from{0, 0, 0};  ///< where the reference point starts [m, each within +-1e9]
    dvec3 to{0, 0, 0};    ///< where it would like to be [m, each within +-1e9]
};

/// Three corners, counter-clockwise when seen from the front. A triangle with no area is the segment or the point
/// that it is: it still blocks.
struct Triangle {
    dvec3 a{0, 0, 0};  ///< [m, each within +-1e9]
    dvec3 b{0, 0, 0};  ///< [m, each within +-1e9]
    dvec3 c{0, 0, 0};  ///< [m, each within +-1e9]
};

static_assert(sizeof(Motion) == 48 && std::is_trivially_copyable_v<Motion>);
static_assert(sizeof(Triangle) == 72 && std::is_trivially_copyable_v<Triangle>);

}  // namespace v0
}  // namespace surefoot
