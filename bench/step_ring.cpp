// What does it cost that the last seconds can always be told again? Characters walk over hills: alone, with a ring that
// is always on, and with a trace in every step; and the ring alone. Prints the medians of rounds that are taken in
// turns.
//
//     surefoot_step_ring
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <vector>

#include <surefoot/surefoot.hpp>

#include "clock.hpp"
#include "scenes/scene.hpp"

namespace surefoot::bench {
namespace {

constexpr std::size_t walkers = 100;
constexpr std::size_t ticks = 60;  // in a round
constexpr std::size_t kept = 600;  // ticks in a ring: ten seconds
constexpr int rounds = 41;
constexpr double dt = 1.0 / 60;

enum Mode { plain, with_ring, with_trace, ring_alone, modes };
constexpr std::array<const char*, modes> names{"a step alone", "with the ring", "with a trace", "the ring alone"};

struct Walker {
    CharacterState state{};
    CharacterInput input{};
    std::vector<RingTick> room{kept};
    StepRing ring{room};
};

std::vector<Walker> place(const World& world, const Bounds& bounds) {
    std::vector<Walker> all(walkers);
    const dvec3 middle = (bounds.min + bounds.max) * 0.5;
    const dvec3 quarter = (bounds.max - bounds.min) * 0.25;
    for (std::size_t i = 0; i < walkers; ++i) {
        const double x = middle.x + quarter.x * (static_cast<double>(i % 10) / 5 - 1);
        const double z = middle.z + quarter.z * (static_cast<double>(i / 10) / 5 - 1);
        const auto ground = world.ray({{x, bounds.max.y + 10, z}, {x, bounds.min.y - 10, z}});
        all[i].state.position = {x, ground ? ground->point.y + 1 : bounds.max.y, z};
        const double heading = static_cast<double>(i);
        all[i].input.wish = {6 * std::cos(heading), 0, 6 * std::sin(heading)};
    }
    return all;
}

// Seconds for a step.
double round_of(const World& world, std::vector<Walker> all, Mode mode, std::vector<StepRecord>& records) {
    const CharacterSettings settings;
    for (Walker& walker : all) walker.ring = StepRing(walker.room);
    const double begin = thread_seconds();
    for (std::size_t tick = 0; tick < ticks; ++tick) {
        for (Walker& walker : all) {
            StepTrace trace(records);
            if (mode == with_ring || mode == ring_alone) walker.ring.push(walker.input, dt, walker.state);
            if (mode == ring_alone) continue;
            walker.state =
                step(world, settings, walker.input, dt, walker.state, {}, mode == with_trace ? &trace : nullptr).state;
        }
    }
    return (thread_seconds() - begin) / static_cast<double>(ticks * walkers);
}

int run() {
    const Scene scene = make_terrain(256);
    const auto mesh = Mesh::build({.vertices = scene.vertices, .indices = scene.indices});
    if (!mesh) return std::fprintf(stderr, "%s\n", mesh.error().text.c_str()), 1;
    World world;
    if (!world.add(*mesh)) return 1;
    std::vector<Walker> all = place(world, mesh->bounds());
    for (int i = 0; i < 120; ++i) {
        for (Walker& walker : all) walker.state = step(world, {}, walker.input, dt, walker.state).state;
    }
    std::vector<StepRecord> records(1024);
    std::array<std::vector<double>, modes> seconds;
    for (int round = 0; round < rounds; ++round) {
        for (int mode = 0; mode < modes; ++mode) {
            seconds[static_cast<std::size_t>(mode)].push_back(round_of(world, all, static_cast<Mode>(mode), records));
        }
    }
    double alone = 0;
    for (std::size_t mode = 0; mode < modes; ++mode) {
        std::vector<double>& times = seconds[mode];
        std::sort(times.begin(), times.end());
        const double median = times[times.size() / 2];
        if (mode == plain) alone = median;
        const double more = mode == ring_alone ? median : median - alone;
        std::printf("%-14s %7.0f ns, %4.1f %% of a step\n", names[mode], 1e9 * median,
                    100 * (mode == plain ? 1 : more / alone));
    }
    return 0;
}

}  // namespace
}  // namespace surefoot::bench

int main() {
    return surefoot::bench::run();
}
