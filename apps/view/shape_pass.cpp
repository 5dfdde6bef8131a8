#include "view/shape_pass.hpp"

#include <algorithm>
#include <cstddef>
#include <variant>

namespace surefoot::view {
namespace {

struct Same {
    const Shape& other;

    bool operator()(const Sphere& a) const { return a.radius == std::get<Sphere>(other).radius; }
    bool operator()(const Ellipsoid& a) const { return a.radii == std::get<Ellipsoid>(other).radii; }
    bool operator()(const Capsule& a) const {
        const auto& b = std::get<Capsule>(other);
        return a.radius == b.radius && a.half_height == b.half_height;
    }
    bool operator()(const Box& a) const { return a.half_extents == std::get<Box>(other).half_extents; }
    bool operator()(const Cylinder& a) const {
        const auto& b = std::get<Cylinder>(other);
        return a.radius == b.radius && a.half_height == b.half_height;
    }
    bool operator()(const Cone& a) const {
        const auto& b = std::get<Cone>(other);
        return a.radius == b.radius && a.height == b.height;
    }
};

bool same(const Shape& a, const Shape& b) {
    return a.index() == b.index() && std::visit(Same{b}, a);
}

}  // namespace

void ShapeModel::draw() const {
    glBindVertexArray(array.id());
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(mesh.indices.size()), GL_UNSIGNED_INT, nullptr);
}

std::shared_ptr<const ShapeModel> ShapeStore::get(const Shape& shape) {
    for (const auto& model : models_) {
        if (!same(model->shape, shape)) continue;
        model->last_used = frame_;
        return model;
    }
    auto model = std::make_shared<ShapeModel>();
    model->shape = shape;
    model->mesh = mesh_of(shape);
    model->last_used = frame_;
    model->array = gl::VertexArray::make();
    model->vertices = gl::Buffer::make();
    model->indices = gl::Buffer::make();
    glBindVertexArray(model->array.id());
    const auto& vertices = model->mesh.vertices;
    const auto& indices = model->mesh.indices;
    glBindBuffer(GL_ARRAY_BUFFER, model->vertices.id());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(vertices[0])), vertices.data(),
                 GL_STATIC_DRAW);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, model->indices.id());
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(indices.size() * sizeof(indices[0])), indices.data(),
                 GL_STATIC_DRAW);
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(ShapeMesh::Vertex), nullptr);
    glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, sizeof(ShapeMesh::Vertex),
                          reinterpret_cast<const void*>(offsetof(ShapeMesh::Vertex, normal)));
    glEnableVertexAttribArray(0);
    glEnableVertexAttribArray(1);
    glBindVertexArray(0);
    models_.push_back(model);
    return model;
}

void ShapeStore::next_frame() {
    ++frame_;
    std::erase_if(models_, [&](const auto& model) { return model->last_used + 120 < frame_; });
}

}  // namespace surefoot::view
