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
    const CharacterSettings hero{.crouched = Volume(Box{{0.3, 0.5, 0.3}}), .air_jumps = 2};
    const std::array<SurfaceRule, 2> rules{{{.grip = 0.5}, {.conveyor = {1, 0, -0.0}, .one_way = true}}};
    CharacterSettings on_rules = hero;
    on_rules.surfaces = std::span<const SurfaceRule>(rules);
    const Neighbour other{.volume = Capsule{0.3, 0.4}, .position = {0.5, 0.5, 0}, .id = 7};
    const std::array<StepCapture, 3> steps{
        capture_step(world, on_rules, {.wish = {3, 0, 1}, .jump = true}, 1.0 / 60, {.position = {0, 0.5, 0}},
                     {&other, 1}),
        capture_step(world, hero, {.wish = {0, 0, -4}, .crouch = true}, 0.3,
                     {.position = {4, 2, -3}, .velocity = {0, -9, 0}}),
        capture_step(world, hero, {.wish = {infinity, 0, 0}}, 1.0 / 60, {.position = {1, 1, 1}})};
    std::FILE* const file = std::fopen(argv[1], "wb");
    if (file == nullptr) return 3;
    for (std::size_t i = 0; i < moments.size(); ++i) {
        const std::string text = capture_cpp_test(moments[i], "moment " + std::to_string(i));
        std::fwrite(text.data(), 1, text.size(), file);
    }
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const std::string text = capture_cpp_test(steps[i], "step " + std::to_string(i));
        std::fwrite(text.data(), 1, text.size(), file);
    }
    return std::fclose(file) == 0 ? 0 : 3;
}
