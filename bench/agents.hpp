// How many characters can be sent through a town by one core at 60 ticks a second: paths followed, others avoided, and
// every one stepped.
#pragma once

#include <cstddef>
#include <cstdint>

namespace surefoot::bench {

struct AgentsOptions {
    std::size_t agents = 1000;
    std::size_t ticks = 600;      ///< that are measured
    std::size_t settling = 120;   ///< before
    std::uint32_t avoidance = 1;  ///< of `NavigationAvoidance`
    double range = 3;             ///< see `NavigationCrowdOptions`
    std::size_t blocks = 12;      ///< houses along each side of the town, 8 m from middle to middle
};

struct AgentsReport {
    std::size_t polygons = 0;
    double steering = 0;       ///< of all agents in one tick, the median [s]
    double stepping = 0;       ///< the same
    double tick = 0;           ///< both, the median [s]
    double slow_tick = 0;      ///< the slowest of a hundred [s]
    double per_core = 0;       ///< agents that the median tick would let one core do in a 60th of a second
    double sure_per_core = 0;  ///< the same by the slow tick
    std::size_t arrivals = 0;  ///< in the measured ticks; each is sent on at once
    std::size_t gave_up = 0;   ///< the same
    std::size_t plans = 0;     ///< the same
    double speed = 0;          ///< mean, of those who are under way [m/s]
    double touching = 0;       ///< share of those who are closer to another than both their radii, in the end
};

/// Runs on the thread that calls. Throws std::runtime_error when the town cannot be built.
[[nodiscard]] AgentsReport run_agents(const AgentsOptions& options);

}  // namespace surefoot::bench
