#include "playground/debugger_room/voxel_view.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "playground/debugger_room/framing.hpp"
#include "playground/debugger_room/lesson_view.hpp"
#include "playground/debugger_room/scenery.hpp"

namespace surefoot::playground {

namespace {

using debugger::VoxelScene;
using debugger::VoxelStep;
using view::rgb;
namespace paint = view::paint;

constexpr view::Colour block = rgb(0x9AA7B2);
constexpr view::Colour walker = paint::accent;

/// Where a place of the scene is seen: about the middle of its blocks, turned so that the box walks away from where one
/// usually stands, and to the left or to the right of the other method, as seen from there.
class Placing {
public:
    Placing(const VoxelScene& scene, bool right) {
        const VoxelWindow& window = scene.window;
        middle_ = dvec3(window.first.x, 0, window.first.z) + dvec3(window.cells.x, 0, window.cells.z) * 0.5;
        const double apart = (window.cells.x + window.cells.z) * 0.375;
        offset_ = rightwards * (right ? apart : -apart);
    }

    [[nodiscard]] dvec3 operator()(const dvec3& p) const { return half_turned(p - middle_) + offset_; }
    [[nodiscard]] dvec3 of(const Cell& cell) const { return (*this)(dvec3(cell.x, cell.y, cell.z) + 0.5); }
    [[nodiscard]] const dvec3& offset() const { return offset_; }

private:
    dvec3 middle_;
    dvec3 offset_;
};

void draw_cell(view::Renderer& renderer, const dvec3& middle, double grown, const view::ShapeLook& look) {
    renderer.shape(Box{dvec3(0.5 + grown)}, middle, look);
}

/// The cells that overlap the box at a place and hold a block.
std::vector<Cell> blocks_around(const VoxelScene& scene, const dvec3& position) {
    std::vector<Cell> found;
    for (const Cell& cell : scene.solid) {
        const dvec3 apart = glm::abs(dvec3(cell.x, cell.y, cell.z) + 0.5 - position);
        const dvec3 touch = scene.box.half_extents + 0.5;
        if (apart.x < touch.x && apart.y < touch.y && apart.z < touch.z) found.push_back(cell);
    }
    return found;
}

bool holds(const std::vector<Cell>& cells, const Cell& cell) {
    return std::find(cells.begin(), cells.end(), cell) != cells.end();
}

}  // namespace

view::Colour colour_of_axis(int axis) {
    static constexpr std::array<view::Colour, 3> all{paint::vertex, rgb(0x67B35B), rgb(0x3E78DA)};
    return all[static_cast<std::size_t>(axis)];
}

void VoxelView::build(const VoxelScene& scene) {
    Scenery scenery;
    for (const bool right : {false, true}) {
        const Placing placing(scene, right);
        const double x = scene.window.cells.x * 0.5;
        const dvec3 top[] = {{-x, 1, 0}, {x, 1, 0}};
        scenery.add({.top = top,
                     .base = 0.55,
                     .half = scene.window.cells.z * 0.5,
                     .offset = placing.offset(),
                     .turned = true,
                     .colour = rgb(0xC6C0B2),
                     .side = rgb(0x8F989F)});
    }
    floor_ = scenery.model();
}

void VoxelView::draw_side(view::Renderer& renderer, const VoxelPlay& play, const VoxelTale& tale) const {
    const bool right = tale.method == debugger::VoxelMethod::each_from_the_last;
    const VoxelScene& scene = play.story().scene;
    const Placing place(scene, right);
    const VoxelStep* const step = play.step(tale);
    const dvec3 now = play.position(tale);
    const std::vector<Cell> pierced = blocks_around(scene, now);

    // Lines between the cells of the floor.
    const Cell& first = scene.window.first;
    const Cell end{first.x + scene.window.cells.x, first.y + scene.window.cells.y, first.z + scene.window.cells.z};
    constexpr double above_floor = 1.002;
    const view::Stroke grid{.colour = view::with_opacity(paint::ink, 0.28), .width = 1, .behind = 0};
    for (int x = first.x; x <= end.x; ++x)
        renderer.line(place({x, above_floor, first.z}), place({x, above_floor, end.z}), grid);
    for (int z = first.z; z <= end.z; ++z)
        renderer.line(place({first.x, above_floor, z}), place({end.x, above_floor, z}), grid);

    for (const Cell& cell : scene.solid) {
        if (cell.y == 0 || cell.x >= end.x) continue;
        const bool stops = step != nullptr && step->stopped_by == cell;
        const bool holds_box = holds(pierced, cell);
        view::ShapeLook look{.colour = block, .opacity = 0.55, .outline = 1.2, .behind = 0.15};
        if (stops) look = {.colour = voxel_paint::stopper, .opacity = 0.85, .outline = 3, .behind = 0.5};
        if (holds_box) look = {.colour = voxel_paint::trap, .opacity = 0.30, .outline = 3, .behind = 0.5};
        draw_cell(renderer, place.of(cell), 0, look);
    }

    constexpr double a_hair = 0.004;  // that faces which touch do not flicker
    const auto box = [&](const dvec3& position, view::Colour colour, double opacity, double outline, double behind) {
        renderer.shape(Box{scene.box.half_extents - a_hair}, place(position),
                       {.colour = colour,
                        .opacity = opacity,
                        .outline = outline,
                        .behind = behind,
                        .casts_shadow = opacity > 0.5});
    };
    const dvec3 start = play.move_start(tale);
    if (now != start) box(start, paint::start, 0.08, 1.6, 0.3);
    box(now, pierced.empty() ? walker : voxel_paint::trap, 0.8, 2.5, 0.8);
    if (step != nullptr) {
        for (const Cell& cell : step->looked_at) {
            if (cell.y == 0) continue;
            draw_cell(renderer, place.of(cell), -0.04,
                      {.colour = voxel_paint::looked_at,
                       .opacity = 0.13,
                       .outline = 1,
                       .behind = 0.2,
                       .casts_shadow = false});
        }
        // What was tried need not be what is moved: the wrong one tries from START, wherever it is by now.
        if (step->tried_from != step->moved_from) box(step->tried_to, colour_of_axis(step->axis), 0.08, 1.6, 0.6);
        const double above = scene.box.half_extents.y + 0.12;
        const dvec3 up(0, above, 0);
        const view::Stroke stroke{.colour = colour_of_axis(step->axis), .width = 5, .behind = 0.85};
        renderer.arrow(place(step->tried_from + up), place(step->tried_to + up), stroke, 16);
    }
    // Titles lie before the near corner, and the rest is told above and below the box, where nothing is in the way.
    renderer.label({.place = place.offset() + dvec3(0, 0.55, 0) + eyewards * (0.68 * scene.window.cells.x),
                    .text = right ? "right: each axis\nfrom the last" : "wrong: all axes\nfrom START",
                    .colour = right ? rgb(0x9FE0B0) : rgb(0xFFB3AA),
                    .offset = {0, 26}});
    const dvec3 half_up(0, scene.box.half_extents.y, 0);
    if (now != start)
        renderer.label({.place = place(start - half_up), .text = "START", .colour = rgb(0xFFB3AA), .offset = {0, 26}});
    if (!pierced.empty())
        renderer.label({.place = place(dvec3(now.x, end.y, now.z)),
                        .text = "inside the block",
                        .colour = rgb(0xFFB3AA),
                        .offset = {0, -40}});
}

std::vector<dvec3> VoxelView::places(const VoxelPlay& play) {
    const VoxelScene& scene = play.story().scene;
    int top = scene.window.first.y + 1;
    for (const Cell& cell : scene.solid) top = std::max(top, cell.y + 1);
    const dvec3 half(scene.window.cells.x * 0.5, 0, scene.window.cells.z * 0.5);
    std::vector<dvec3> corners;
    for (const bool right : {false, true}) {
        const dvec3 middle = Placing(scene, right).offset();
        append_corners(corners, {middle - half + dvec3(0, 0.55, 0), middle + half + dvec3(0, top, 0)});
    }
    return corners;
}

void VoxelView::draw(view::Renderer& renderer, const VoxelPlay& play) {
    if (!floor_ || built_ != play.chosen()) {
        build(play.story().scene);
        built_ = play.chosen();
    }
    renderer.model(floor_, {.edges = {.width = 0}});
    draw_side(renderer, play, play.wrong());
    draw_side(renderer, play, play.right());
}

}  // namespace surefoot::playground
