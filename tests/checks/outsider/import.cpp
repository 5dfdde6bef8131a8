// Reads a level with the installed importer and asks it one question.
#include <cstdio>
#include <fstream>

#include <surefoot/import.hpp>
#include <surefoot/surefoot.hpp>

int main() {
    std::ofstream("ramp.obj") << "v -4 0 4\nv 4 0 4\nv 4 2 -4\nv -4 2 -4\nf 1 2 3 4\n";
    const auto level = surefoot::import_level("ramp.obj");
    const auto mesh = level ? surefoot::build_mesh(*level) : tl::unexpected(level.error());
    if (!mesh) {
        std::puts(mesh.error().text.c_str());
        return 1;
    }
    const auto hit = mesh->ray({.from = {1, 5, 0}, .to = {1, -5, 0}});
    if (mesh->triangle_count() != 2 || !hit) {
        std::puts("a ray down onto a ramp of two triangles should hit one of them");
        return 1;
    }
    std::printf("hit triangle %u\n", hit->triangle);
}
