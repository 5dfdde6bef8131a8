// One triangle of many: what `surefoot::sweep` does once its arguments are known to be valid.
#pragma once

#include <optional>

#include <surefoot/sweep.hpp>

namespace surefoot::internal {

/// The answer to a query that cannot be answered.
[[nodiscard]] Hit blocked(HitStatus status) noexcept;

/// Are volume and motion within the limits?
[[nodiscard]] bool is_valid_query(const Volume& volume, const Motion& motion) noexcept;

/// Requires: all arguments valid. `id` names the triangle in the hit and in the trace. A hit after `limit` [0, 1] is
/// of no interest: it may be reported or not.
[[nodiscard]] std::optional<Hit> sweep_triangle(const Volume& volume, const Motion& motion, const Triangle& triangle,
                                                std::uint32_t id, bool one_sided, double limit, Trace* trace) noexcept;

}  // namespace surefoot::internal
