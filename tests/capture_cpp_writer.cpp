// Writes moments as C++ tests into the file that it is given: tests/CMakeLists.txt compiles and runs them.
#include <cmath>
#include <cstdio>
#include <string>

#include "capture_moments.hpp"

int main(int argc, char** argv) {
    using namespace surefoot;
    using namespace surefoot::tests;
    if (argc != 2) return 2;
    const Soup triangles = soup(5, 300, 6);
    const Mesh mesh = triangles.mesh();
    const World world = moving_world(triangles);
    std::vector<Capture> moments;
    for (const Shape& shape : every_shape) {
        moments.push_back(capture_sweep(mesh, Volume(shape, dquat(0.9, 0.1, 0, 0.3)), {{-5, 0, 0}, {5, 1, 0}}));
        moments.push_back(capture_sweep(world, shape, {{-5, 0, 0}, {5, 1, 0}}, {.end = 0.75, .turn_gap = 0.01}));
    }
    moments.push_back(capture_ray(mesh, {{-5, 0, 0}, {5, 1, 0}}, {.one_sided = true}));
    moments.push_back(capture_sweep(mesh, Sphere{0.01}, {{-50, 0, 0}, {-49, 0, 0}}));
    const double infinity = std::numeric_limits<double>::infinity();
    moments.push_back(capture_sweep(mesh, Sphere{-infinity}, {{std::nan(""), -0.0, 0}, {0, infinity, 0}}));
    moments.back().note = "a note\n#error that is C++ unless it is a comment \\\n\"and so on";
    std::FILE* const file = std::fopen(argv[1], "wb");
    if (file == nullptr) return 3;
    for (std::size_t i = 0; i < moments.size(); ++i) {
        const std::string text = capture_cpp_test(moments[i], "moment " + std::to_string(i));
        std::fwrite(text.data(), 1, text.size(), file);
    }
    return std::fclose(file) == 0 ? 0 : 3;
}
