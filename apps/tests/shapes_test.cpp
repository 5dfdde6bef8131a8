#include "view/shapes.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace surefoot::view {
namespace {

const Shape all[] = {Sphere{0.7},          Ellipsoid{{0.4, 0.9, 0.6}}, Capsule{0.3, 0.8},
                     Box{{0.3, 0.8, 0.5}}, Cylinder{0.6, 0.4},         Cone{0.5, 1.7}};

TEST(ShapeMesh, is_closed_so_that_every_edge_has_two_faces) {
    for (const Shape& shape : all) {
        const ShapeMesh mesh = mesh_of(shape, 24);
        EXPECT_EQ(2 * mesh.edges.size(), mesh.indices.size()) << shape.index();
    }
}

TEST(ShapeMesh, faces_outwards_with_its_triangles_and_its_normals) {
    for (const Shape& shape : all) {
        const ShapeMesh mesh = mesh_of(shape, 24);
        const vec3 middle(middle_of(shape));
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
            const auto& a = mesh.vertices[mesh.indices[i]];
            const auto& b = mesh.vertices[mesh.indices[i + 1]];
            const auto& c = mesh.vertices[mesh.indices[i + 2]];
            const vec3 face = glm::cross(b.position - a.position, c.position - a.position);
            EXPECT_GT(glm::dot(face, (a.position + b.position + c.position) / 3.0F - middle), 0) << shape.index();
            EXPECT_GT(glm::dot(face, a.normal), 0) << shape.index();
            EXPECT_NEAR(glm::length(a.normal), 1, 1e-5);
        }
    }
}

TEST(ShapeMesh, reaches_as_far_as_it_says) {
    for (const Shape& shape : all) {
        double farthest = 0;
        for (const auto& vertex : mesh_of(shape).vertices)
            farthest = std::max(farthest, double(glm::length(vertex.position)));
        EXPECT_NEAR(farthest, reach_of(shape), 0.01) << shape.index();
    }
}

}  // namespace
}  // namespace surefoot::view
