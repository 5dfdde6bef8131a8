// What a level file says beside its triangles: surfaces, and places with meaning for the game.
#include <cstdio>

#include <surefoot/import.hpp>

int main(int argc, char** argv) {
    const auto level = surefoot::import_level(argc > 1 ? argv[1] : "castle.glb");
    if (!level) return std::puts(level.error().text.c_str()), 1;
    const auto mesh = surefoot::build_mesh(*level);
    if (!mesh) return std::puts(mesh.error().text.c_str()), 1;

    std::printf("%zu triangles of", mesh->triangle_count());
    for (const auto& surface : level->surface_names) std::printf(" \"%s\"", surface.c_str());
    std::puts("");
    for (const auto& marker : level->markers)
        if (marker.kind == "spawn" || marker.kind == "goal")
            std::printf("%s is at %g %g %g\n", marker.kind.c_str(), marker.position.x, marker.position.y,
                        marker.position.z);
}
