#include <glm/common.hpp>
#include <gtest/gtest.h>
#include <vector>

#include <surefoot/mesh.hpp>

namespace {

using surefoot::dvec3;
using surefoot::Mesh;
using surefoot::TreeBox;
using surefoot::vec3;

Mesh hills(std::uint32_t side) {
    std::vector<vec3> vertices;
    std::vector<std::uint32_t> indices;
    for (std::uint32_t z = 0; z <= side; ++z)
        for (std::uint32_t x = 0; x <= side; ++x)
            vertices.emplace_back(float(x), float((x * 7 + z * 13) % 5), float(z));
    for (std::uint32_t z = 0; z < side; ++z) {
        for (std::uint32_t x = 0; x < side; ++x) {
            const std::uint32_t a = z * (side + 1) + x;
            for (const std::uint32_t i : {a, a + side + 1, a + 1, a + 1, a + side + 1, a + side + 2})
                indices.push_back(i);
        }
    }
    return *Mesh::build({.vertices = vertices, .indices = indices});
}

std::vector<TreeBox> boxes_of(const Mesh& mesh) {
    std::vector<TreeBox> boxes(mesh.tree_boxes({}));
    EXPECT_EQ(mesh.tree_boxes(boxes), boxes.size());
    return boxes;
}

bool within(const surefoot::Bounds& inner, const surefoot::Bounds& outer) {
    for (int axis = 0; axis < 3; ++axis)
        if (inner.min[axis] < outer.min[axis] || inner.max[axis] > outer.max[axis]) return false;
    return true;
}

TEST(TreeBoxes, leaves_hold_every_triangle_once) {
    const Mesh mesh = hills(40);
    std::size_t triangles = 0;
    for (const TreeBox& box : boxes_of(mesh)) triangles += box.triangles;
    EXPECT_EQ(triangles, mesh.triangle_count());
}

TEST(TreeBoxes, every_triangle_lies_in_a_leaf) {
    const Mesh mesh = hills(20);
    const std::vector<TreeBox> boxes = boxes_of(mesh);
    for (std::uint32_t id = 0; id < mesh.triangle_count(); ++id) {
        const surefoot::Triangle t = mesh.triangle(id);
        const surefoot::Bounds own{glm::min(t.a, glm::min(t.b, t.c)), glm::max(t.a, glm::max(t.b, t.c))};
        bool found = false;
        for (const TreeBox& box : boxes) found = found || (box.triangles > 0 && within(own, box.bounds));
        EXPECT_TRUE(found) << id;
    }
}

TEST(TreeBoxes, boxes_below_lie_in_one_above) {
    const std::vector<TreeBox> boxes = boxes_of(hills(40));
    for (const TreeBox& box : boxes) {
        if (box.depth == 0) continue;
        bool found = false;
        for (const TreeBox& above : boxes)
            found = found || (above.depth + 1 == box.depth && above.triangles == 0 && within(box.bounds, above.bounds));
        EXPECT_TRUE(found);
    }
}

TEST(TreeBoxes, an_empty_mesh_has_none_and_a_short_span_is_filled_from_the_front) {
    EXPECT_EQ(Mesh::build({})->tree_boxes({}), 0U);
    const Mesh mesh = hills(20);
    const std::vector<TreeBox> all = boxes_of(mesh);
    std::vector<TreeBox> few(3);
    EXPECT_EQ(mesh.tree_boxes(few), all.size());
    for (std::size_t i = 0; i < few.size(); ++i) EXPECT_EQ(few[i].bounds.min, all[i].bounds.min);
}

}  // namespace
