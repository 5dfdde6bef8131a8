// Reads a level that any program made, and moves an ellipsoid through it:
//
//   first_sweep LEVEL x,y,z x,y,z
//
// The level may be OBJ, glTF, .glb, .ply, .stl, ...; the two points are where the player's centre is and where it would
// like to be.
#include <array>
#include <cstddef>
#include <cstdio>

#include <surefoot/import.hpp>
#include <surefoot/surefoot.hpp>

namespace {

bool read_point(const char* text, surefoot::dvec3& point) {
    return std::sscanf(text, "%lf,%lf,%lf", &point.x, &point.y, &point.z) == 3;
}

}  // namespace

int main(int count, char** words) {
    surefoot::Motion motion;
    if (count != 4 || !read_point(words[2], motion.from) || !read_point(words[3], motion.to)) {
        std::fputs("usage: first_sweep LEVEL x,y,z x,y,z\n", stderr);
        return 2;
    }
    const auto level = surefoot::import_level(words[1]);
    if (!level) {
        std::fprintf(stderr, "%s\n", level.error().text.c_str());
        return 1;
    }
    const auto mesh = surefoot::build_mesh(*level);
    if (!mesh) {
        std::fprintf(stderr, "%s\n", mesh.error().text.c_str());
        return 1;
    }

    const surefoot::Ellipsoid player{.radii = {0.4, 0.9, 0.4}};
    std::printf("%zu triangles\n", mesh->triangle_count());
    const auto hit = mesh->sweep(player, motion);
    if (!hit) {
        std::puts("the way is free");
        return 0;
    }
    constexpr std::array features{"face", "edge", "vertex"};
    std::printf("stopped after %.4f%% of the way by the %s of triangle %u (%s)\n", 100 * hit->t,
                features[static_cast<std::size_t>(hit->feature)], hit->triangle,
                level->surface_names[hit->surface].c_str());
    std::printf("touching at %.4f %.4f %.4f, normal %.4f %.4f %.4f\n", hit->point.x, hit->point.y, hit->point.z,
                hit->normal.x, hit->normal.y, hit->normal.z);
}
