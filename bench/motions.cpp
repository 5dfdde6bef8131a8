#include "motions.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>
#include <optional>

#include "scenes/random.hpp"

namespace surefoot::bench {
namespace {

double sign(double x) {
    return x < 0 ? -1 : 1;
}

// The point of an upright shape that is furthest along `n`, from its reference point.
dvec3 furthest(const Sphere& s, const dvec3& n) {
    return s.radius * n;
}
dvec3 furthest(const Ellipsoid& e, const dvec3& n) {
    const dvec3 scaled = e.radii * n;
    return e.radii * scaled / glm::length(scaled);
}
dvec3 furthest(const Capsule& c, const dvec3& n) {
    return c.radius * n + dvec3(0, sign(n.y) * c.half_height, 0);
}
dvec3 furthest(const Box& b, const dvec3& n) {
    return b.half_extents * dvec3(sign(n.x), sign(n.y), sign(n.z));
}
/// The point of a level disc that is furthest along `n`.
dvec3 rim(double radius, const dvec3& n) {
    const double level = std::sqrt(n.x * n.x + n.z * n.z);
    return level > 0 ? dvec3(n.x, 0, n.z) * (radius / level) : dvec3(0, 0, 0);
}
dvec3 furthest(const Cylinder& c, const dvec3& n) {
    return rim(c.radius, n) + dvec3(0, sign(n.y) * c.half_height, 0);
}
dvec3 furthest(const Cone& c, const dvec3& n) {
    const dvec3 disc = rim(c.radius, n) + dvec3(0, c.height, 0);
    return glm::dot(disc, n) > 0 ? disc : dvec3(0, 0, 0);
}

bool is_free(const Mesh& mesh, const Volume& volume, const dvec3& position) {
    return mesh.overlap(volume, position, {}) == 0;
}

/// A random point of a random triangle, and the normal on a side that faces open air.
struct Foothold {
    dvec3 point;
    dvec3 normal;
};

std::optional<Foothold> random_foothold(const Scene& scene, Random& random) {
    const Triangle t = scene.triangle(random.below(static_cast<std::uint32_t>(scene.triangle_count())));
    double u = random.in(0, 1);
    double v = random.in(0, 1);
    const bool flip = !scene.has_fronts && random.chance(0.5);
    const dvec3 across = glm::cross(t.b - t.a, t.c - t.a);
    const double twice_area = glm::length(across);
    if (!(twice_area > 1e-12)) return std::nullopt;
    if (u + v > 1) {
        u = 1 - u;
        v = 1 - v;
    }
    const dvec3 normal = across / twice_area;
    return Foothold{t.a + u * (t.b - t.a) + v * (t.c - t.a), flip ? -normal : normal};
}

dvec3 direction_of_a_step(const dvec3& normal, Random& random) {
    const double kind = random.in(0, 1);
    const dvec3 any = random.direction();
    if (kind < 0.6) {
        const dvec3 along = any - glm::dot(any, normal) * normal;
        return glm::normalize(along - normal * (random.in(0, 0.3) * glm::length(along)));
    }
    if (kind < 0.9) return glm::normalize(dvec3(0.7 * any.x, -1, 0.7 * any.z));
    return any;
}

std::optional<Motion> brief_motion(const Scene& scene, const Mesh& mesh, const Volume& volume, Random& random) {
    const std::optional<Foothold> hold = random_foothold(scene, random);
    if (!hold) return std::nullopt;
    const dvec3 towards = std::visit([&](const auto& shape) { return furthest(shape, -hold->normal); }, volume.shape);
    const dvec3 from = hold->point + hold->normal * random.in(0.005, 0.05) - towards;
    const dvec3 along = direction_of_a_step(hold->normal, random);
    const dvec3 to = from + along * random.in(0.1, 0.5);
    if (!is_free(mesh, volume, from)) return std::nullopt;
    return Motion{from, to};
}

std::optional<Motion> distant_motion(const Scene& scene, const Mesh& mesh, Random& random) {
    const std::optional<Foothold> hold = random_foothold(scene, random);
    if (!hold) return std::nullopt;
    const dvec3 from = hold->point + hold->normal * random.in(0.5, 2);
    dvec3 along = random.direction();
    if (random.chance(0.5)) along = glm::normalize(dvec3(along.x, 0.2 * along.y, along.z));
    const dvec3 to = from + along * random.in(20, 50);
    for (const Body body : bodies)
        if (!is_free(mesh, volume_of(body), from)) return std::nullopt;
    return Motion{from, to};
}

/// The lower 21 bits of `x`, each followed by two zeros.
std::uint64_t spread(std::uint64_t x) {
    x &= 0x1fffff;
    x = (x | x << 32) & 0x1f00000000ffff;
    x = (x | x << 16) & 0x1f0000ff0000ff;
    x = (x | x << 8) & 0x100f00f00f00f00f;
    x = (x | x << 4) & 0x10c30c30c30c30c3;
    return (x | x << 2) & 0x1249249249249249;
}

}  // namespace

std::string_view name_of(Body body) {
    constexpr std::string_view names[] = {"sphere", "ellipsoid", "capsule", "box", "cylinder", "cone"};
    return names[static_cast<std::size_t>(body)];
}

Volume volume_of(Body body) {
    switch (body) {
        case Body::sphere:
            return Sphere{.radius = 0.4};
        case Body::ellipsoid:
            return Ellipsoid{.radii = {0.4, 0.9, 0.4}};
        case Body::capsule:
            return Capsule{.radius = 0.4, .half_height = 0.5};
        case Body::box:
            return Box{.half_extents = {0.4, 0.9, 0.4}};
        case Body::cylinder:
            return Cylinder{.radius = 0.4, .half_height = 0.9};
        case Body::cone:
            break;
    }
    return Cone{.radius = 0.4, .height = 1.8};
}

std::vector<Motion> make_motions(const Scene& scene, const Mesh& mesh, Body body, Path path, std::size_t count) {
    std::vector<Motion> motions;
    if (scene.triangle_count() == 0) return motions;
    motions.reserve(count);
    Random random(path == Path::brief ? 7 + static_cast<std::uint64_t>(body) : 1);
    const Volume volume = volume_of(body);
    // A scene so tight that one start in a hundred is free is no scene for these bodies.
    for (std::size_t attempt = 0; attempt < 100 * count && motions.size() < count; ++attempt) {
        const std::optional<Motion> motion =
            path == Path::brief ? brief_motion(scene, mesh, volume, random) : distant_motion(scene, mesh, random);
        if (motion) motions.push_back(*motion);
    }
    return motions;
}

std::vector<Motion> sorted_in_space(std::vector<Motion> motions) {
    if (motions.empty()) return motions;
    dvec3 low = motions[0].from;
    dvec3 high = low;
    for (const Motion& motion : motions) {
        low = glm::min(low, motion.from);
        high = glm::max(high, motion.from);
    }
    const dvec3 size = high - low;
    const double cell = std::max({size.x, size.y, size.z, 1e-9}) / 0x1fffff;
    std::vector<std::uint64_t> keys;
    for (const Motion& motion : motions) {
        const dvec3 place = (motion.from - low) / cell;
        keys.push_back(spread(static_cast<std::uint64_t>(place.x)) | spread(static_cast<std::uint64_t>(place.y)) << 1 |
                       spread(static_cast<std::uint64_t>(place.z)) << 2);
    }
    std::vector<std::size_t> order(motions.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return keys[a] != keys[b] ? keys[a] < keys[b] : a < b; });
    std::vector<Motion> sorted;
    sorted.reserve(motions.size());
    for (const std::size_t index : order) sorted.push_back(motions[index]);
    return sorted;
}

}  // namespace surefoot::bench
