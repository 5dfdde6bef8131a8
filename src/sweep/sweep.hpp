// One triangle of many: what `surefoot::sweep` does once its arguments are known to be valid.
#pragma once

#include <cstdint>
#include <optional>

#include <surefoot/sweep.hpp>

namespace surefoot::internal {

/// The answer to a query that cannot be answered.
[[nodiscard]] Hit blocked(HitStatus status) noexcept;

/// Are volume and motion within the limits?
[[nodiscard]] bool is_valid_query(const Volume& volume, const Motion& motion) noexcept;

/// How a shape that begins in touch is judged: does the motion go deeper?
enum class StartSign : std::uint8_t {
    exact,    ///< as promised of every query
    rounded,  ///< in doubles, for callers that keep a skin and ask of every touch again
};

/// Requires: all arguments valid. `id` names the triangle in the hit and in the trace. A hit after `limit` [0, 1] is
/// of no interest: it may be reported or not.
[[nodiscard]] std::optional<Hit> sweep_triangle(const Volume& volume, const Motion& motion, const Triangle& triangle,
                                                std::uint32_t id, bool one_sided, double limit, Trace* trace,
                                                StartSign sign = StartSign::exact) noexcept;

}  // namespace surefoot::internal
