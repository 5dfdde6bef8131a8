#include "playground/walk/level_look.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <glm/common.hpp>
#include <imgui.h>

#include "view/colour.hpp"
#include "view/widgets.hpp"

namespace surefoot::playground {
namespace {

using view::dvec2;
using view::rgb;

constexpr std::array<const char*, 4> kind_names{"open: no neighbour", "convex: an outer edge",
                                                "flat: goes on in the plane", "concave: an inner edge"};
constexpr std::array<view::Colour, 4> kind_colours{rgb(0xD6336C, 1), rgb(0xE8890C, 0.95), rgb(0x5F6B76, 0.35),
                                                   rgb(0x1C7ED6, 0.95)};

// More lines than this are no picture.
constexpr std::size_t most_boxes = 6000;

view::Colour colour_of_depth(int depth) {
    constexpr std::array<view::Colour, 6> colours{rgb(0xD9480F), rgb(0xE8A50C), rgb(0x5C940D),
                                                  rgb(0x0C8599), rgb(0x3B5BDB), rgb(0x9C36B5)};
    return colours[static_cast<std::size_t>(depth) % colours.size()];
}

}  // namespace

LevelLook::LevelLook(LevelLoader::Loaded level) : level_(std::move(level)) {
    const tools::Level& l = level_->level;
    for (std::uint32_t id = 0; id < l.mesh.triangle_count(); ++id) {
        const std::uint32_t surface = l.mesh.surface(id);
        constexpr std::uint32_t most_surfaces = 4096;  // a number may be anything
        if (surface >= most_surfaces) continue;
        if (surface >= surfaces_.size()) surfaces_.resize(surface + 1);
        ++surfaces_[surface].triangles;
    }
    for (std::uint32_t i = 0; i < surfaces_.size(); ++i) {
        const std::string name = tools::surface_name(l, i);
        surfaces_[i].text = name.empty() ? fmt::format("surface {}", i) : name;
        surfaces_[i].colour = view::colour_of_surface(i, name);
        if (surfaces_[i].triangles > 0) by_size_.push_back(i);
    }
    std::stable_sort(by_size_.begin(), by_size_.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return surfaces_[a].triangles > surfaces_[b].triangles; });
    boxes_.resize(l.mesh.tree_boxes({}));
    boxes_.resize(std::min(boxes_.size(), l.mesh.tree_boxes(boxes_)));
    for (const TreeBox& box : boxes_) deepest_ = std::max(deepest_, static_cast<int>(box.depth));
    make_model();
}

void LevelLook::make_model() {
    model_ = view::Model::make(
        level_->level.mesh,
        [&](const SourceTriangle& t) {
            const view::Colour own =
                t.surface < surfaces_.size() ? surfaces_[t.surface].colour : view::colour_of_surface(t.surface, {});
            if (lit_surface_ < 0) return own;
            return static_cast<int>(t.surface) == lit_surface_ ? own : view::mixed(own, rgb(0x6F757B), 0.8);
        },
        smooth ? view::Shading::smooth : view::Shading::flat);
    was_smooth_ = smooth;
    was_lit_ = lit_surface_;
}

void LevelLook::draw(view::Renderer& renderer) {
    if (was_smooth_ != smooth || was_lit_ != lit_surface_) make_model();
    view::ModelLook look;
    if (edges && renderer.effects.fine_edges) look.edges.width = 1;
    if (edge_kinds) {
        look.edges.width = 2;
        std::copy(kind_colours.begin(), kind_colours.end(), std::begin(look.edges.kinds));
    }
    renderer.model(model_, look);
    if (tree_depth < 0) return;
    std::size_t drawn = 0;
    for (const TreeBox& box : boxes_) {
        if (static_cast<int>(box.depth) != tree_depth || ++drawn > most_boxes) continue;
        const view::Colour colour = colour_of_depth(tree_depth);
        renderer.box(box.bounds, {.colour = view::with_opacity(colour, box.triangles > 0 ? 0.55 : 0.9),
                                  .width = box.triangles > 0 ? 1.2 : 1.8,
                                  .behind = 0.15});
    }
}

void LevelLook::draw_ids(view::Renderer& renderer, const dvec3& around, double radius) const {
    if (!ids) return;
    static thread_local std::vector<SourceTriangle> near(4096);
    const Mesh& mesh = level_->level.mesh;
    const std::size_t count = std::min(mesh.gather({around - radius, around + radius}, near), near.size());
    struct Seen {
        double size;
        const SourceTriangle* triangle;
        dvec3 middle;
    };
    std::vector<Seen> seen;
    const view::FrameView& view = renderer.view();
    for (std::size_t i = 0; i < count; ++i) {
        const Triangle& t = near[i].triangle;
        const dvec3 middle = (t.a + t.b + t.c) / 3.0;
        const auto at = view.camera.project(middle, view.size);
        const auto a = view.camera.project(t.a, view.size);
        const auto b = view.camera.project(t.b, view.size);
        const auto c = view.camera.project(t.c, view.size);
        if (!at || !a || !b || !c) continue;
        const dvec2 ab = b->at - a->at;
        const dvec2 ac = c->at - a->at;
        const double area = std::abs(ab.x * ac.y - ab.y * ac.x) / 2;
        if (area > 900) seen.push_back({area, &near[i], middle});
    }
    std::stable_sort(seen.begin(), seen.end(), [](const Seen& a, const Seen& b) { return a.size > b.size; });
    constexpr std::size_t most_ids = 90;
    if (seen.size() > most_ids) seen.resize(most_ids);
    for (const Seen& s : seen) renderer.label({.place = s.middle, .text = std::to_string(s.triangle->id), .behind = 0});
}

void LevelLook::ui() {
    namespace ui = view::ui;
    ui::checkbox("Edges", edges);
    ImGui::SameLine();
    ui::checkbox("Ids", ids);
    ImGui::SameLine();
    ui::checkbox("Rounded", smooth);
    ui::hint("Shades gentle bends as if they were round. What is asked stays flat.");
    ui::checkbox("Edges by kind", edge_kinds);
    ImGui::SameLine();
    bool tree = tree_depth >= 0;
    if (ui::checkbox("Tree", tree)) tree_depth = tree ? std::min(1, deepest_) : -1;
    if (edge_kinds)
        for (std::size_t i = 0; i < 4; ++i) ui::key_colour(view::with_opacity(kind_colours[i], 1), kind_names[i]);
    if (tree_depth >= 0) {
        double depth = tree_depth;
        if (ui::slider("Depth", depth, 0, std::max(deepest_, 0), "%.0f")) tree_depth = static_cast<int>(depth + 0.5);
    }
    if (!ui::section("Surfaces")) return;
    int lit = -1;
    std::size_t shown = 0;
    for (const std::uint32_t i : by_size_) {
        constexpr std::size_t most_shown = 8;  // with the rest of the panel, 720 high
        if (++shown > most_shown) {
            ui::note(fmt::format("and {} more", by_size_.size() - most_shown));
            break;
        }
        ImGui::BeginGroup();
        ui::key_colour(surfaces_[i].colour, surfaces_[i].text);
        ui::at_right(std::to_string(surfaces_[i].triangles));
        ImGui::EndGroup();
        if (ImGui::IsItemHovered()) lit = static_cast<int>(i);
    }
    lit_surface_ = lit;
}

}  // namespace surefoot::playground
