/// An axis-aligned box in space.
#pragma once

#include <surefoot/math.hpp>

namespace [[gnu::visibility("default")]] surefoot {
inline namespace v0 {

/// Everything between two corners, the faces included.
struct Bounds {
    dvec3 min{0, 0, 0};  ///< [m]
    dvec3 max{0, 0, 0};  ///< [m, each at least min's]
};

}  // namespace v0
}  // namespace surefoot
