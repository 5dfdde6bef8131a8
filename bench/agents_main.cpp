// Prints how many agents one core does at 60 ticks a second: surefoot_agents [AGENTS] [TICKS].
#include <cstdio>
#include <cstdlib>
#include <exception>

#include "agents.hpp"

int main(int argc, char** argv) {
    using namespace surefoot::bench;
    AgentsOptions options;
    if (argc > 1) options.agents = std::strtoul(argv[1], nullptr, 10);
    if (argc > 2) options.ticks = std::strtoul(argv[2], nullptr, 10);
    if (options.agents == 0 || options.ticks == 0) {
        std::fputs("surefoot_agents [AGENTS] [TICKS]: both at least 1\n", stderr);
        return 2;
    }
    const char* const names[] = {"none", "few", "medium", "many"};
    try {
        std::printf("%zu agents in a town of %zu x %zu houses, %zu ticks of 1/60 s, one thread\n", options.agents,
                    options.blocks, options.blocks, options.ticks);
        std::printf("%-10s %9s %9s %9s %9s %10s %10s %9s %8s %6s %7s %9s\n", "avoidance", "steer ms", "step ms",
                    "p50 ms", "p99 ms", "per core", "at p99", "arrivals", "gave up", "plans", "m/s", "touching");
        for (std::uint32_t avoidance = 0; avoidance < 4; ++avoidance) {
            options.avoidance = avoidance;
            const AgentsReport r = run_agents(options);
            std::printf("%-10s %9.2f %9.2f %9.2f %9.2f %10.0f %10.0f %9zu %8zu %6zu %7.2f %8.1f%%\n", names[avoidance],
                        1e3 * r.steering, 1e3 * r.stepping, 1e3 * r.tick, 1e3 * r.slow_tick, r.per_core,
                        r.sure_per_core, r.arrivals, r.gave_up, r.plans, r.speed, 100 * r.touching);
        }
    } catch (const std::exception& problem) {
        std::fprintf(stderr, "surefoot_agents: %s\n", problem.what());
        return 1;
    }
    return 0;
}
