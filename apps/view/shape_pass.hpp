/// Shapes, whole or translucent: their meshes are made once and kept while they are of use.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <surefoot/shapes.hpp>

#include "view/gl.hpp"
#include "view/shapes.hpp"

namespace surefoot::view {

/// A shape's mesh on the graphics card.
struct ShapeModel {
    Shape shape;
    ShapeMesh mesh;
    gl::VertexArray array;
    gl::Buffer vertices;
    gl::Buffer indices;
    std::uint64_t last_used = 0;

    void draw() const;
};

class ShapeStore {
public:
    /// The model of this shape, made if there is none yet.
    [[nodiscard]] std::shared_ptr<const ShapeModel> get(const Shape& shape);

    /// Forgets what was not asked for in the last frames.
    void next_frame();

private:
    std::vector<std::shared_ptr<ShapeModel>> models_;
    std::uint64_t frame_ = 0;
};

}  // namespace surefoot::view
