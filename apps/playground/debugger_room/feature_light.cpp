#include "playground/debugger_room/feature_light.hpp"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <vector>

#include "debugger/question.hpp"
#include "view/camera.hpp"
#include "view/shapes.hpp"

namespace surefoot::playground {
namespace {

constexpr int around = 40;

void quad(view::Renderer& renderer, const std::array<dvec3, 4>& corners, view::Colour colour, double fill) {
    renderer.triangle(corners[0], corners[1], corners[2], view::with_opacity(colour, fill));
    renderer.triangle(corners[0], corners[2], corners[3], view::with_opacity(colour, fill));
}

/// The plane in which the centre is when the ball touches the triangle's own, and the triangle lifted into it.
void light_interior(view::Renderer& renderer, const DrawnWorld& world, const Volume& volume, const dvec3& start,
                    const Triangle& t) {
    using debugger::squashed;
    dvec3 normal = glm::cross(squashed(volume, t.b - t.a), squashed(volume, t.c - t.a));
    if (glm::length(normal) == 0) return;
    normal = glm::normalize(normal);
    if (glm::dot(normal, squashed(volume, start - t.a)) < 0) normal = -normal;
    const dvec3 lift = debugger::unsquashed(volume, normal);
    const view::Colour colour = colour_of(Feature::face);
    const std::array<dvec3, 3> corners = debugger::corners_of(t);
    std::vector<dvec3> lifted;
    for (const dvec3& corner : corners) {
        lifted.push_back(world.point(corner + lift));
        renderer.line(world.point(corner), lifted.back(), {.colour = colour, .width = 1, .behind = 0.3});
    }
    renderer.polyline(lifted, {.colour = colour, .width = 2.5, .behind = 0.4}, true);
    renderer.triangle(lifted[0], lifted[1], lifted[2], view::with_opacity(colour, 0.2));
    // The plane goes on beyond the triangle, which is what the candidate has to be careful about.
    const dvec3 middle = (t.a + t.b + t.c) / 3.0;
    std::vector<dvec3> wide;
    for (const dvec3& corner : corners) wide.push_back(world.point(middle + (corner - middle) * 1.25 + lift));
    renderer.polyline(wide, {.colour = view::with_opacity(colour, 0.6), .width = 1.2, .behind = 0.3}, true);
}

void light_edge(view::Renderer& renderer, const DrawnWorld& world, const Volume& volume, const dvec3& from,
                const dvec3& to) {
    const dvec3 along = debugger::squashed(volume, to - from);
    if (glm::length(along) == 0) return;
    const auto [u, v] = view::across(glm::normalize(along));
    const view::Colour colour = colour_of(Feature::edge);
    std::vector<dvec3> near_ring;
    std::vector<dvec3> far_ring;
    for (int i = 0; i < around; ++i) {
        const double angle = 2 * std::numbers::pi * i / around;
        const dvec3 out = debugger::unsquashed(volume, u * std::cos(angle) + v * std::sin(angle));
        near_ring.push_back(world.point(from + out));
        far_ring.push_back(world.point(to + out));
    }
    for (std::size_t i = 0; i < near_ring.size(); ++i) {
        const std::size_t next = (i + 1) % near_ring.size();
        quad(renderer, {near_ring[i], near_ring[next], far_ring[next], far_ring[i]}, colour, 0.13);
        if (i % 5 == 0)
            renderer.line(near_ring[i], far_ring[i],
                          {.colour = view::with_opacity(colour, 0.7), .width = 1, .behind = 0.3});
    }
    renderer.polyline(near_ring, {.colour = colour, .width = 2, .behind = 0.4}, true);
    renderer.polyline(far_ring, {.colour = colour, .width = 2, .behind = 0.4}, true);
    renderer.line(world.point(from), world.point(to), {.colour = colour, .width = 4, .behind = 0.5});
}

}  // namespace

view::Colour colour_of(Feature feature) {
    if (feature == Feature::face) return view::paint::face;
    return feature == Feature::edge ? view::paint::edge : view::paint::vertex;
}

void light_feature(view::Renderer& renderer, const DrawnWorld& world, const Volume& volume, const dvec3& start,
                   const Triangle& triangle, Feature feature, std::uint8_t index) {
    const std::array<dvec3, 3> corners = debugger::corners_of(triangle);
    if (feature == Feature::face) light_interior(renderer, world, volume, start, triangle);
    if (feature == Feature::edge) light_edge(renderer, world, volume, corners[index], corners[(index + 1U) % 3]);
    if (feature == Feature::vertex) {
        const dvec3 corner = world.point(corners[index]);
        renderer.shape(world.volume, corner, {.colour = colour_of(feature), .opacity = 0.2, .casts_shadow = false});
        renderer.point(corner, 10, colour_of(feature));
    }
}

void light_plane(view::Renderer& renderer, const Volume& volume, const dvec3& position, const Triangle& triangle,
                 const dvec3& normal, view::Colour colour) {
    double height = -1e300;
    for (const dvec3& corner : debugger::corners_of(triangle)) height = std::max(height, glm::dot(corner, normal));
    const dvec3 middle = position + normal * (height - glm::dot(position, normal));
    const auto [u, v] = view::across(normal);
    const double half = 1.6 * view::reach_of(volume.shape);
    const std::array<dvec3, 4> corners{middle + (u + v) * half, middle + (u - v) * half, middle - (u + v) * half,
                                       middle - (u - v) * half};
    quad(renderer, corners, colour, 0.22);
    renderer.polyline(corners, {.colour = colour, .width = 2, .behind = 0.4}, true);
    renderer.arrow(middle, middle + normal * (0.5 * half), {.colour = colour, .width = 2.5, .behind = 0.4});
}

}  // namespace surefoot::playground
