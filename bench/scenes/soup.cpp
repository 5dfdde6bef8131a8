// A soup: nothing is shared, nothing lies in order, every direction is as likely. The worst a tree can be given.
#include "random.hpp"
#include "scene.hpp"

namespace surefoot::bench {
namespace {

/// By Newton's steps: libm's would differ from machine to machine.
double cube_root(double value) {
    double root = 1;
    for (int step = 0; step < 100; ++step) root = (2 * root + value / (root * root)) / 3;
    return root;
}

}  // namespace

Scene make_soup(std::uint32_t triangles) {
    constexpr double edge = 0.5;
    Scene scene{.name = "soup", .has_fronts = false};
    scene.vertices.reserve(std::size_t{3} * triangles);
    scene.indices.reserve(std::size_t{3} * triangles);
    // The cube grows with the count, so that a small soup for a test is as thick as the large one.
    const double side = 200 * cube_root(triangles / 1e6);
    Random random(20221);
    for (std::uint32_t id = 0; id < triangles; ++id) {
        const double x = random.in(-side / 2, side / 2);
        const double y = random.in(-side / 2, side / 2);
        const dvec3 a(x, y, random.in(-side / 2, side / 2));
        const dvec3 along = random.direction();
        const dvec3 b = a + along * random.in(0.8 * edge, 1.2 * edge);
        // Half across and half along the first edge, so that the third is as long as the others.
        const dvec3 other = random.direction();
        const double share = other.x * along.x + other.y * along.y + other.z * along.z;
        dvec3 across = other - along * share;
        const double length = std::sqrt(across.x * across.x + across.y * across.y + across.z * across.z);
        across = length > 1e-3 ? across / length : dvec3(0, 1, 0);
        // One number a line: the order within an expression is the compiler's.
        const double share_along = random.in(0.1 * edge, 0.9 * edge);
        const double share_across = random.in(0.6 * edge, 1.1 * edge);
        const dvec3 c = a + along * share_along + across * share_across;
        for (const dvec3& corner : {a, b, c}) {
            scene.indices.push_back(static_cast<std::uint32_t>(scene.vertices.size()));
            scene.vertices.emplace_back(corner);
        }
    }
    return scene;
}

}  // namespace surefoot::bench
