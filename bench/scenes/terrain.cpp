// Fractal terrain: octaves of value noise, each half as wide as the one before and a little less than half as high.
#include "random.hpp"
#include "scene.hpp"

namespace surefoot::bench {
namespace {

/// A height in [-1, 1] for every point of a grid of whole numbers.
double lattice(std::uint32_t octave, std::int64_t x, std::int64_t z) {
    const auto column = static_cast<std::uint64_t>(x) * 0x9e3779b97f4a7c15ULL;
    const auto row = static_cast<std::uint64_t>(z) * 0xc2b2ae3d27d4eb4fULL;
    return 2 * to_unit(scramble(scramble(column ^ octave) ^ row)) - 1;
}

/// Smooth between the points of the grid: weights 3w^2 - 2w^3.
double value_noise(std::uint32_t octave, double x, double z) {
    const double floor_x = std::floor(x);
    const double floor_z = std::floor(z);
    const auto i = static_cast<std::int64_t>(floor_x);
    const auto j = static_cast<std::int64_t>(floor_z);
    const auto smooth = [](double w) { return w * w * (3 - 2 * w); };
    const double u = smooth(x - floor_x);
    const double v = smooth(z - floor_z);
    const double near = lattice(octave, i, j) * (1 - u) + lattice(octave, i + 1, j) * u;
    const double far = lattice(octave, i, j + 1) * (1 - u) + lattice(octave, i + 1, j + 1) * u;
    return near * (1 - v) + far * v;
}

/// Hills 100 m apart and some 15 m high, down to bumps of a few centimetres at every quad.
double height(double x, double z) {
    double sum = 0;
    double width = 100;
    double amplitude = 14;
    for (std::uint32_t octave = 0; octave < 8; ++octave) {
        sum += amplitude * value_noise(octave, x / width, z / width);
        width *= 0.5;
        amplitude *= 0.44;
    }
    return sum;
}

}  // namespace

Scene make_terrain(std::uint32_t quads) {
    constexpr double side = 0.5;
    Scene scene{.name = "terrain"};
    const std::uint32_t row = quads + 1;
    scene.vertices.reserve(std::size_t{row} * row);
    scene.indices.reserve(std::size_t{quads} * quads * 6);
    for (std::uint32_t j = 0; j < row; ++j) {
        for (std::uint32_t i = 0; i < row; ++i) {
            const double x = side * (i - 0.5 * quads);
            const double z = side * (j - 0.5 * quads);
            scene.vertices.emplace_back(static_cast<float>(x), static_cast<float>(height(x, z)), static_cast<float>(z));
        }
    }
    for (std::uint32_t j = 0; j < quads; ++j) {
        for (std::uint32_t i = 0; i < quads; ++i) {
            const std::uint32_t a = j * row + i;
            const std::uint32_t corners[6] = {a, a + row, a + 1, a + 1, a + row, a + row + 1};
            scene.indices.insert(scene.indices.end(), corners, corners + 6);
        }
    }
    return scene;
}

}  // namespace surefoot::bench
