// Sine and cosine of our own: the C library's differ in the last bits from one machine to the next.
#pragma once

namespace surefoot::internal {

/// The cosine of an angle [degrees, 0 to 90], to within 2 units in the last place of 1.
[[nodiscard]] double cosine_deg(double angle) noexcept;

}  // namespace surefoot::internal
