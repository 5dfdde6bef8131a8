// A city of boxes: what levels are mostly made of. Large floors beside small steps, flat against flat, corners
// everywhere.
#include "random.hpp"
#include "scene.hpp"

namespace surefoot::bench {
namespace {

constexpr double plot = 24;          // a house and the street around it [m]
constexpr double house = 16;         // [m]
constexpr double storey = 3.2;       // floor to floor [m]
constexpr double slab = 0.2;         // thickness of a floor [m]
constexpr double wall = 0.25;        // thickness of a wall [m]
constexpr int steps = 16;            // a flight; each riser is storey / steps = 0.2 m
constexpr double tread = 0.3;        // [m]
constexpr double stair_width = 1.4;  // [m]

/// Puts boxes into a scene, at a place.
class Builder {
public:
    explicit Builder(Scene& scene) : scene_(scene) {}

    void move_to(const dvec3& origin) { origin_ = origin; }

    /// All six sides, facing outwards, eight vertices.
    void box(const dvec3& low, const dvec3& high) {
        const auto first = static_cast<std::uint32_t>(scene_.vertices.size());
        for (int corner = 0; corner < 8; ++corner) {
            const dvec3 p((corner & 1) != 0 ? high.x : low.x, (corner & 2) != 0 ? high.y : low.y,
                          (corner & 4) != 0 ? high.z : low.z);
            scene_.vertices.emplace_back(origin_ + p);
        }
        constexpr std::uint32_t sides[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                               {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
        for (const auto& side : sides) quad(first + side[0], first + side[1], first + side[2], first + side[3]);
    }

    /// Flat ground, cut into squares.
    void ground(double size, std::uint32_t cells) {
        const auto first = static_cast<std::uint32_t>(scene_.vertices.size());
        const std::uint32_t row = cells + 1;
        for (std::uint32_t j = 0; j < row; ++j)
            for (std::uint32_t i = 0; i < row; ++i)
                scene_.vertices.emplace_back(origin_ + dvec3(size * i / cells, 0, size * j / cells));
        for (std::uint32_t j = 0; j < cells; ++j) {
            for (std::uint32_t i = 0; i < cells; ++i) {
                const std::uint32_t a = first + j * row + i;
                quad(a, a + row, a + row + 1, a + 1);
            }
        }
    }

private:
    void quad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
        for (const std::uint32_t index : {a, b, c, a, c, d}) scene_.indices.push_back(index);
    }

    Scene& scene_;
    dvec3 origin_{0, 0, 0};
};

/// A wall along x from 0 to `house` at z, with openings every 4 m: doors down to the floor, windows above a sill.
void wall_along_x(Builder& builder, Random& random, double y, double z, bool doors) {
    constexpr double bay = 4;
    constexpr double pier = 1.3;  // solid on both sides of an opening 1.4 m wide
    const double top = y + storey - slab;
    for (double x = 0; x < house; x += bay) {
        builder.box({x, y, z}, {x + pier, top, z + wall});
        builder.box({x + bay - pier, y, z}, {x + bay, top, z + wall});
        builder.box({x + pier, y + 2.1, z}, {x + bay - pier, top, z + wall});
        if (!doors || random.chance(0.5)) builder.box({x + pier, y, z}, {x + bay - pier, y + 0.9, z + wall});
    }
}

/// The same along z, without openings but for one door in the middle.
void wall_along_z(Builder& builder, double y, double x) {
    const double top = y + storey - slab;
    constexpr double door = 1.2;
    builder.box({x, y, wall}, {x + wall, top, (house - door) / 2});
    builder.box({x, y, (house + door) / 2}, {x + wall, top, house});
    builder.box({x, y + 2.1, (house - door) / 2}, {x + wall, top, (house + door) / 2});
}

/// A floor with a hole where the stairs come up.
void floor_with_hole(Builder& builder, double y) {
    constexpr double hole_x = 1;
    constexpr double hole_z = 1;
    constexpr double far_x = hole_x + steps * tread;
    constexpr double far_z = hole_z + stair_width;
    builder.box({0, y - slab, 0}, {house, y, hole_z});
    builder.box({0, y - slab, far_z}, {house, y, house});
    builder.box({0, y - slab, hole_z}, {hole_x, y, far_z});
    builder.box({far_x, y - slab, hole_z}, {house, y, far_z});
}

void flight(Builder& builder, double y) {
    constexpr double rise = storey / steps;
    for (int step = 0; step < steps; ++step) {
        const double x = 1 + step * tread;
        builder.box({x, y + step * rise - 0.05, 1}, {x + tread, y + (step + 1) * rise, 1 + stair_width});
    }
}

void furniture(Builder& builder, Random& random, double y) {
    for (int piece = 0; piece < 14; ++piece) {
        const double width = random.in(0.3, 1.6);
        const double depth = random.in(0.3, 1.2);
        const double x = random.in(0.5, house - 2.2);
        const double z = random.in(3, house - 2);
        builder.box({x, y, z}, {x + width, y + random.in(0.3, 1.9), z + depth});
    }
}

void build_house(Builder& builder, Random& random) {
    const std::uint32_t floors = 3 + random.below(3);
    for (std::uint32_t level = 0; level < floors; ++level) {
        const double y = slab + level * storey;
        if (level == 0) builder.box({0, 0, 0}, {house, slab, house});
        if (level > 0) floor_with_hole(builder, y);
        wall_along_x(builder, random, y, 0, level == 0);
        wall_along_x(builder, random, y, house - wall, level == 0);
        for (const double x : {0.0, house / 2, house - wall}) wall_along_z(builder, y, x);
        if (level + 1 < floors) flight(builder, y);
        furniture(builder, random, y);
    }
    const double roof = slab + floors * storey;
    builder.box({0, roof - slab, 0}, {house, roof, house});
}

}  // namespace

Scene make_city(std::uint32_t blocks) {
    Scene scene{.name = "city"};
    Builder builder(scene);
    Random random(1914);
    const double size = plot * blocks;
    builder.move_to({-size / 2, 0, -size / 2});
    builder.ground(size, 6 * blocks);
    for (std::uint32_t j = 0; j < blocks; ++j) {
        for (std::uint32_t i = 0; i < blocks; ++i) {
            builder.move_to({plot * i + 4 - size / 2, 0, plot * j + 4 - size / 2});
            build_house(builder, random);
        }
    }
    return scene;
}

}  // namespace surefoot::bench
