/// Two clocks: what a thread worked, and what a person waited.
#pragma once

namespace surefoot::bench {

/// Time that this thread spent on a processor [s]. Other programs on the machine do not count, but for the cache that
/// they take. Where a system has no such clock, it is the wall clock.
[[nodiscard]] double thread_seconds();

/// [s]
[[nodiscard]] double wall_seconds();

}  // namespace surefoot::bench
