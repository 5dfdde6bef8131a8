// Drops a ball onto a floor with an installed Surefoot.
#include <cstdio>

#include <surefoot/surefoot.hpp>

int main() {
    if (surefoot::library_version() != surefoot::header_version) {
        std::puts("the headers and the library are not of one version");
        return 1;
    }
    const surefoot::Triangle floor{{-4, 0, 4}, {4, 0, 4}, {0, 0, -4}};
    const auto hit = surefoot::sweep(surefoot::Sphere{.radius = 1}, {.from = {0, 3, 0}, .to = {0, -1, 0}}, floor);
    if (!hit || hit->t > 0.5 || hit->t < 0.5 - 1e-9) {
        std::puts("a ball of radius 1 that falls from 3 m should touch the floor half way down to -1 m");
        return 1;
    }

    // Errors are values, so that all of this works without exceptions too.
    const std::array<std::uint32_t, 3> beyond{0, 1, 2};
    const auto mesh = surefoot::Mesh::build({.vertices = {}, .indices = beyond});
    if (mesh || mesh.error().code != surefoot::ErrorCode::invalid) {
        std::puts("a mesh whose indices lead nowhere should be refused");
        return 1;
    }
    std::printf("stopped after %.0f%%\n", 100 * hit->t);
}
