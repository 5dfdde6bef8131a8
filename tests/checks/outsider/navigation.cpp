// Finds a path with an installed Surefoot.
#include <array>
#include <cstdio>

#include <surefoot/navigation_query.hpp>
#include <surefoot/surefoot.hpp>

int main() {
    const std::array<surefoot::vec3, 4> corners{surefoot::vec3{0, 0, 0}, {0, 0, 8}, {8, 0, 8}, {8, 0, 0}};
    const std::array<std::uint32_t, 6> indices{0, 1, 2, 0, 2, 3};
    const auto floor = surefoot::Mesh::build({.vertices = corners, .indices = indices});
    surefoot::World world;
    if (!floor || !world.add(*floor)) return 1;
    const auto mesh = surefoot::NavigationMesh::build(world, surefoot::CharacterSettings{});
    if (!mesh) {
        std::puts(mesh.error().text.c_str());
        return 1;
    }
    const surefoot::NavigationQuery query(*mesh);
    const auto from = query.under({1, 1, 1}, 2, 1);
    const auto to = query.under({7, 1, 7}, 2, 1);
    const auto path = from && to ? query.path(*from, *to) : std::nullopt;
    if (!path || path->partial || path->length < 8.4 || path->length > 8.6) {
        std::puts("over a floor there is a path of 8.5 m");
        return 1;
    }
    std::printf("a path of %.1f m\n", path->length);
}
