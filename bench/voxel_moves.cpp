// How many axis-by-axis moves a second does one core make? Prints the median of several rounds, and how many of the
// moves were blocked: moves through empty air would prove nothing.
//
//     surefoot_voxel_moves
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <vector>

#include <surefoot/voxels_move.hpp>

#include "clock.hpp"

namespace surefoot::bench {
namespace {

constexpr std::int32_t side = 64;
constexpr std::size_t moves = 50'000;
constexpr int rounds = 15;

class Random {
public:
    double between(double low, double high) {
        state_ = state_ * 6364136223846793005U + 1442695040888963407U;
        return low + (high - low) * static_cast<double>(state_ >> 11) * 0x1p-53;
    }

private:
    std::uint64_t state_ = 1;
};

// Hills, and one cell in fifty solid wherever it is.
std::vector<std::uint8_t> make_world(Random& random) {
    std::vector<std::uint8_t> world;
    for (std::int32_t y = 0; y < side; ++y) {
        for (std::int32_t z = 0; z < side; ++z) {
            for (std::int32_t x = 0; x < side; ++x) {
                const double ground = 20 + 6 * std::sin(0.2 * x) + 5 * std::cos(0.27 * z);
                world.push_back(y < ground || random.between(0, 1) < 0.02 ? 1 : 0);
            }
        }
    }
    return world;
}

int run() {
    Random random;
    const std::vector<std::uint8_t> world = make_world(random);
    const auto solid = [&world](std::int32_t x, std::int32_t y, std::int32_t z) {
        return world[static_cast<std::size_t>((y * side + z) * side + x)] != 0;
    };
    const auto voxels = Voxels::over(solid, {.cells = {side, side, side}});
    if (!voxels) return std::fprintf(stderr, "%s\n", voxels.error().text.c_str()), 1;

    const Box body{{0.3, 0.9, 0.3}};
    std::vector<dvec3> starts;
    std::vector<dvec3> ways;
    for (std::size_t i = 0; i < moves; ++i) {
        const dvec3 above(random.between(2, side - 2), 45, random.between(2, side - 2));
        starts.push_back(move_axis_by_axis(*voxels, body, above, {0, -60, 0}).position);
        const double heading = random.between(0, 6.28);
        const double step = random.between(0.05, 0.1);
        ways.emplace_back(step * std::cos(heading), -0.02, step * std::sin(heading));
    }
    for (const double stride : {1.0, 300.0}) {
        std::vector<double> seconds;
        std::size_t blocked = 0;
        for (int round = 0; round < rounds; ++round) {
            blocked = 0;
            const double begin = thread_seconds();
            for (std::size_t i = 0; i < moves; ++i) {
                const BoxMove moved = move_axis_by_axis(*voxels, body, starts[i], ways[i] * stride);
                blocked += moved.x.blocked || moved.z.blocked ? 1U : 0U;
            }
            seconds.push_back(thread_seconds() - begin);
        }
        std::sort(seconds.begin(), seconds.end());
        const double median = seconds[seconds.size() / 2] / static_cast<double>(moves);
        std::printf("%-18s %6.0f ns a move, %5.2f million moves a second, %4.1f%% meet a wall\n",
                    stride == 1 ? "a frame's way" : "15 to 30 m", 1e9 * median, 1e-6 / median,
                    100.0 * static_cast<double>(blocked) / static_cast<double>(moves));
    }
    return 0;
}

}  // namespace
}  // namespace surefoot::bench

int main() {
    return surefoot::bench::run();
}
