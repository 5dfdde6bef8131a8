#include "platformer/play/halos.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include <surefoot/world.hpp>

namespace surefoot::platformer {
namespace {

constexpr double shines_from = 0.5;  // of a material's glow
constexpr double one_thing = 0.4;    // triangles so near to each other are one thing [m]
constexpr double pool_reach = 4.5;   // of a lamp above its pool of light [m]
constexpr double seen_from = 60;     // [m]

struct Shining {
    std::uint32_t surface;
    Bounds box;
};

void gather(const game::Level& level, const Mesh& mesh, std::vector<Shining>& found) {
    if (mesh.triangle_count() == 0) return;
    std::vector<SourceTriangle> all(mesh.triangle_count());
    all.resize(mesh.gather(mesh.bounds(), all));
    for (const SourceTriangle& t : all) {
        if (t.surface >= level.materials.size() || level.materials[t.surface].glow < shines_from) continue;
        const dvec3 low = glm::min(glm::min(t.triangle.a, t.triangle.b), t.triangle.c);
        const dvec3 high = glm::max(glm::max(t.triangle.a, t.triangle.b), t.triangle.c);
        const auto near = std::ranges::find_if(found, [&](const Shining& thing) {
            return thing.surface == t.surface && glm::all(glm::lessThan(thing.box.min - one_thing, high)) &&
                   glm::all(glm::lessThan(low, thing.box.max + one_thing));
        });
        if (near == found.end()) {
            found.push_back({t.surface, {low, high}});
        } else {
            near->box.min = glm::min(near->box.min, low);
            near->box.max = glm::max(near->box.max, high);
        }
    }
}

/// Light on the level ground below; none where there is none, smaller where the ground ends near by.
std::optional<view::Disc> pool_below(const World& world, const dvec3& place, view::Colour colour) {
    const auto below = [&](const dvec3& from) { return world.ray({from, from - dvec3(0, pool_reach, 0)}); };
    const auto hit = below(place);
    if (!hit || hit->status != HitStatus::ok || hit->normal.y < 0.98) return std::nullopt;
    const dvec3 foot = hit->point;
    double radius = 2.8;
    for (int i = 0; i < 12; ++i) {
        const double turn = 2 * std::numbers::pi * i / 12;
        for (double r = 0.4; r < radius; r += 0.4) {
            const auto there = below({foot.x + r * std::cos(turn), place.y, foot.z + r * std::sin(turn)});
            if (!there || std::abs(there->point.y - foot.y) > 0.12) radius = r;
        }
    }
    if (radius < 1) return std::nullopt;
    return view::Disc{.place = foot + dvec3(0, 0.03, 0),
                      .radius = radius,
                      .normal = {0, 1, 0},
                      .colour = view::with_opacity(colour, 0.42),
                      .is_light = true};
}

}  // namespace

std::vector<view::Disc> halos_of(const game::Level& level) {
    std::vector<Shining> found;
    gather(level, level.ground, found);
    gather(level, level.decor, found);
    World world;
    if (level.ground.triangle_count() > 0) world.add(level.ground);
    std::vector<view::Disc> halos;
    for (const Shining& thing : found) {
        const game::Material& material = level.materials[thing.surface];
        const auto byte = [](double share) { return std::uint8_t(std::lround(std::clamp(share, 0.0, 1.0) * 255)); };
        const auto rgb = material.colour.value_or(std::array{1.0, 1.0, 1.0});
        const view::Colour colour{byte(rgb[0]), byte(rgb[1]), byte(rgb[2]), 255};
        const dvec3 middle = (thing.box.min + thing.box.max) * 0.5;
        const dvec3 size = thing.box.max - thing.box.min;
        // What is flat is a window, and lights a room.
        if (std::min(size.x, size.z) < 0.3) continue;
        halos.push_back({.place = middle,
                         .radius = std::min(0.5 + 0.7 * glm::length(size), 3.0),
                         .colour = view::with_opacity(colour, 0.55 * material.glow),
                         .is_light = true});
        if (std::max(size.x, size.z) < 0.9)
            if (auto pool = pool_below(world, middle, colour)) halos.push_back(*pool);
    }
    return halos;
}

void draw_halos(view::Renderer& renderer, const std::vector<view::Disc>& halos, double strength) {
    const dvec3 eye = renderer.view().camera.eye;
    for (view::Disc halo : halos) {
        const double away = glm::length(halo.place - eye);
        if (away > seen_from) continue;
        // Who stands in it sees no halo.
        const double near = halo.normal == dvec3(0) ? std::clamp((away - 1.0) / (2 * halo.radius), 0.0, 1.0) : 1;
        halo.colour = view::with_opacity(halo.colour, halo.colour.a / 255.0 * strength * near * (1 - away / seen_from));
        renderer.disc(halo);
    }
}

}  // namespace surefoot::platformer
