// Terrain, blocks and one's own broad phase as triangle sources. docs/sources.md is cut from it.
#include <cstdint>
#include <cstdio>
#include <vector>

#include <surefoot/surefoot.hpp>

namespace {

bool terrain() {
    // [height_field]
    const std::uint32_t side = 129;
    std::vector<std::uint16_t> levels(side * side, 100);  // row by row, x along the row
    levels[64 * side + 64] = 400;                         // one hill
    auto ground = surefoot::HeightField::build(
        {.columns = side, .rows = side, .levels = levels, .cell_x = 0.5, .cell_z = 0.5, .height_scale = 0.01});
    if (!ground) return std::puts(ground.error().text.c_str()), false;

    const auto hit = ground->sweep(surefoot::Sphere{0.4}, {.from = {20, 1.5, 32}, .to = {40, 1.5, 32}});
    const std::vector<std::uint16_t> flat(9, 100);
    const auto dug = ground->set({.column = 63, .row = 63, .columns = 3, .rows = 3, .levels = flat});
    const bool gone = !ground->sweep_any(surefoot::Sphere{0.4}, {.from = {20, 1.5, 32}, .to = {40, 1.5, 32}});
    // [/height_field]
    return hit && dug && gone;
}

bool blocks() {
    // [voxels]
    static constexpr surefoot::BlockBox stairs[] = {{{0, 0, 0}, {1, 0.5F, 1}}, {{0.5F, 0.5F, 0}, {1, 1, 1}}};
    const auto world = [](std::int32_t x, std::int32_t y, std::int32_t) {
        if (x == 5 && y == 1) return surefoot::Block::of(stairs);
        return y < 1 ? surefoot::Block::full(7) : surefoot::Block::empty();  // 7: your own number for grass
    };
    const auto voxels = surefoot::Voxels::over(world, {.cells = {64, 32, 64}, .boxes_per_block = 2});
    if (!voxels) return std::puts(voxels.error().text.c_str()), false;

    const auto hit = voxels->sweep(surefoot::Ellipsoid{}, {.from = {2, 2, 2}, .to = {9, 2, 2}});
    const auto moved = surefoot::move_axis_by_axis(*voxels, surefoot::Box{}, {2, 3, 2}, {6, -9, 0});
    const bool grounded = moved.y.blocked && moved.y.surface == 7;  // and moved.x.blocked: the first step of the stairs
    // [/voxels]
    return hit && grounded && moved.x.blocked;
}

// [visited]
struct MyLevel {
    std::vector<surefoot::Triangle> triangles;  // or your own tree, grid, physics world

    surefoot::Bounds bounds() const { return {{-100, -100, -100}, {100, 100, 100}}; }
    void visit(const surefoot::Bounds& /*near*/, const surefoot::TriangleSink& sink) const {
        for (std::uint32_t id = 0; id < triangles.size(); ++id) sink(triangles[id], id);
    }
    surefoot::Triangle triangle(std::uint32_t id) const { return triangles[id]; }
    std::uint32_t surface(std::uint32_t /*id*/) const { return 0; }
};
// [/visited]

bool own_broad_phase() {
    const MyLevel level{{{{-5, 0, -5}, {0, 0, 5}, {5, 0, -5}}}};
    const surefoot::VisitedSource source(level);
    return source.sweep(surefoot::Capsule{}, {.from = {0, 2, 0}, .to = {0, 0, 0}}).has_value();
}

}  // namespace

int main() {
    const bool good = terrain() && blocks() && own_broad_phase();
    std::puts(good ? "three sources, and every one answers" : "something is wrong");
    return good ? 0 : 1;
}
