#include "view/shared_corners.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace surefoot::view {
namespace {

/// A bumpy sheet: every triangle with a normal of its own.
std::vector<SharedCorners::Face> sheet(int wide, bool flat, int colours) {
    std::vector<SharedCorners::Face> faces;
    const auto place = [](int x, int z) {
        return gl::vec3(static_cast<float>(x), static_cast<float>((x * 7 + z * 5) % 11), static_cast<float>(z));
    };
    const auto add = [&](const gl::vec3& a, const gl::vec3& b, const gl::vec3& c) {
        const auto own = static_cast<std::int8_t>(faces.size() % 127);
        const auto corner = [&](const gl::vec3& p) {
            return SharedCorners::Corner{p, {flat ? own : static_cast<std::int8_t>(p.y), 0, 0, 0}};
        };
        const auto colour = static_cast<std::uint8_t>(faces.size() % static_cast<std::size_t>(colours));
        faces.push_back({{{corner(a), corner(b), corner(c)}}, {colour, 0, 0, 255}});
    };
    for (int z = 0; z < wide; ++z)
        for (int x = 0; x < wide; ++x) {
            add(place(x, z), place(x, z + 1), place(x + 1, z + 1));
            add(place(x, z), place(x + 1, z + 1), place(x + 1, z));
        }
    return faces;
}

SharedCorners shared(const std::vector<SharedCorners::Face>& faces, bool flat) {
    SharedCorners corners(flat);
    corners.begin_chunk();
    for (const auto& face : faces) corners.add(face);
    return corners;
}

TEST(SharedCorners, every_face_keeps_its_corners_its_winding_and_its_colour) {
    for (const bool flat : {true, false}) {
        const auto faces = sheet(12, flat, 3);
        const SharedCorners corners = shared(faces, flat);
        ASSERT_EQ(corners.indices().size(), 3 * faces.size());
        for (std::size_t i = 0; i < faces.size(); ++i) {
            const auto vertex = [&](std::size_t k) { return corners.vertices()[corners.indices()[3 * i + k % 3]]; };
            std::size_t turn = 0;
            while (turn < 3 && vertex(turn).position != faces[i].corners[0].position) ++turn;
            for (std::size_t k = 0; k < 3; ++k) {
                EXPECT_EQ(vertex(turn + k).position, faces[i].corners[k].position) << i;
                EXPECT_TRUE(flat || vertex(turn + k).normal == faces[i].corners[k].normal) << i;
            }
            EXPECT_EQ(vertex(2).colour.r, faces[i].colour.r) << i;
            EXPECT_TRUE(!flat || vertex(2).normal == faces[i].corners[0].normal) << i;
        }
    }
}

TEST(SharedCorners, a_common_mesh_has_about_as_many_vertices_as_triangles) {
    const auto faces = sheet(40, true, 3);
    EXPECT_LT(shared(faces, true).vertices().size(), faces.size() * 11 / 10);
}

TEST(SharedCorners, triangles_that_look_alike_share_all_their_corners) {
    auto faces = sheet(40, true, 1);
    for (auto& face : faces)
        for (auto& corner : face.corners) corner.normal = {0, 127, 0, 0};
    EXPECT_EQ(shared(faces, true).vertices().size(), 41U * 41U);
}

TEST(SharedCorners, nothing_is_shared_between_chunks) {
    const auto faces = sheet(1, true, 1);
    SharedCorners corners(true);
    for (int chunk = 0; chunk < 2; ++chunk) {
        corners.begin_chunk();
        for (const auto& face : faces) corners.add(face);
    }
    const auto& i = corners.indices();
    EXPECT_LT(*std::max_element(i.begin(), i.begin() + 6), *std::min_element(i.begin() + 6, i.end()));
}

}  // namespace
}  // namespace surefoot::view
