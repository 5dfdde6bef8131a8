/// How the level is shown: surfaces and their legend, edges by kind, the tree, triangle ids.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "playground/level_loader.hpp"
#include "view/renderer.hpp"

namespace surefoot::playground {

class LevelLook {
public:
    explicit LevelLook(LevelLoader::Loaded level);

    void draw(view::Renderer& renderer);
    void draw_ids(view::Renderer& renderer, const dvec3& around, double radius) const;
    void ui();

    bool edges = true;        ///< lines on edges
    bool edge_kinds = false;  ///< in the colours of their kinds
    bool ids = false;
    int tree_depth = -1;  ///< of the boxes that are drawn; -1 for none
    bool smooth = false;

    [[nodiscard]] int deepest() const { return deepest_; }

private:
    struct Surface {
        std::string text;
        view::Colour colour;
        std::size_t triangles = 0;
    };

    void make_model();

    LevelLoader::Loaded level_;
    std::shared_ptr<view::Model> model_;
    std::vector<Surface> surfaces_;  // by number
    std::vector<std::uint32_t> by_size_;
    std::vector<TreeBox> boxes_;
    int deepest_ = -1;
    int lit_surface_ = -1;  // the one that the pointer rests on in the legend
    bool was_smooth_ = false;
    int was_lit_ = -1;
};

}  // namespace surefoot::playground
