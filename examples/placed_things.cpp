// A small world of things that come and go, kept in a Slab: meshes that are placed somewhere, named by handles that
// know when their thing is gone. A player is swept through them. Explained in docs/memory.md.
#include <cstdint>
#include <cstdio>
#include <optional>
#include <vector>

#include <surefoot/surefoot.hpp>

namespace {

// [things]
struct Thing {
    surefoot::Mesh mesh;             // cheap: the triangles are shared with every other thing of this mesh
    surefoot::dvec3 place{0, 0, 0};  // of the mesh's origin in the world [m]
};

using Things = surefoot::Slab<Thing>;

struct ThingHit {
    surefoot::Hit hit;
    Things::Handle thing;  // good to keep: it says by itself when the thing is gone
};

// The first touch among all things. Ties go to the lower slot, so that the answer is the same on every machine.
std::optional<ThingHit> sweep(const Things& things, const surefoot::Volume& volume, const surefoot::Motion& motion) {
    std::optional<ThingHit> first;
    for (auto thing = things.begin(); thing != things.end(); ++thing) {
        const surefoot::Motion local{.from = motion.from - thing->place, .to = motion.to - thing->place};
        auto hit = thing->mesh.sweep(volume, local);
        if (!hit || (first && hit->t >= first->hit.t)) continue;
        hit->point += thing->place;
        first = ThingHit{*hit, thing.handle()};
    }
    return first;
}
// [/things]

std::optional<surefoot::Mesh> make_crate() {
    const std::vector<surefoot::vec3> corners{{-1, 0, -1}, {1, 0, -1}, {1, 2, -1}, {-1, 2, -1},
                                              {-1, 0, 1},  {1, 0, 1},  {1, 2, 1},  {-1, 2, 1}};
    const std::vector<std::uint32_t> triangles{0, 2, 1, 0, 3, 2, 4, 5, 6, 4, 6, 7, 0, 1, 5, 0, 5, 4,
                                               3, 7, 6, 3, 6, 2, 0, 4, 7, 0, 7, 3, 1, 2, 6, 1, 6, 5};
    auto mesh = surefoot::Mesh::build({.vertices = corners, .indices = triangles});
    if (!mesh) {
        std::puts(mesh.error().text.c_str());
        return std::nullopt;
    }
    return *mesh;
}

}  // namespace

int main() {
    const auto crate = make_crate();
    if (!crate) return 1;

    Things things(8);
    const auto near = things.insert(*crate, surefoot::dvec3(0, 0, 6));
    const auto far = things.insert(*crate, surefoot::dvec3(0, 0, 12));

    const surefoot::Ellipsoid player{.radii = {0.4, 0.9, 0.4}};
    const surefoot::Motion walk{.from = {0, 1, 0}, .to = {0, 1, 20}};

    const auto first = sweep(things, player, walk);
    if (!first || first->thing != near) return 1;
    std::printf("walking 20 m, stopped by the near crate after %.3f m\n", 20 * first->hit.t);

    things.erase(near);  // somebody carries it away; whoever kept the handle finds out by asking
    if (things.get(first->thing) != nullptr) return 1;
    std::puts("the near crate is gone, and its handle says so");

    const auto second = sweep(things, player, walk);
    if (!second || second->thing != far) return 1;
    std::printf("walking again, stopped by the far crate after %.3f m\n", 20 * second->hit.t);

    const auto lamp = things.insert(*crate, surefoot::dvec3(50, 0, 0));
    if (lamp.index != near.index || things.get(near) != nullptr) return 1;
    std::puts("a new thing stands in the old slot, and the old handle still finds nothing");
}
