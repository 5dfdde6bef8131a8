// A shape is drawn where the library says that it is: its silhouette is that of the library's own rays.
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <memory>

#include "view/display.hpp"
#include "view/gl.hpp"
#include "view/picture.hpp"
#include "view/renderer.hpp"
#include "view/shapes.hpp"

namespace surefoot::view {
namespace {

constexpr ivec2 size(480, 360);

/// The shape's own surface as triangles, fine enough that rays see it as it is.
Mesh mesh_around(const Shape& shape, const dvec3& position) {
    const ShapeMesh fine = mesh_of(shape, 160);
    std::vector<vec3> vertices;
    for (const auto& vertex : fine.vertices) vertices.push_back(vec3(dvec3(vertex.position) + position));
    return *Mesh::build({.vertices = vertices, .indices = fine.indices});
}

/// How much of what either covers both cover.
double overlap(const Picture& picture, const Picture& empty, const Mesh& mesh, const Camera& camera) {
    double both = 0;
    double either = 0;
    for (int y = 0; y < size.y; ++y) {
        for (int x = 0; x < size.x; ++x) {
            const Colour& a = picture.at(x, y);
            const Colour& b = empty.at(x, y);
            const bool drawn = std::abs(a.r - b.r) + std::abs(a.g - b.g) + std::abs(a.b - b.b) > 60;
            const bool real = pick(mesh, camera, {x + 0.5, y + 0.5}, size).has_value();
            both += drawn && real ? 1 : 0;
            either += drawn || real ? 1 : 0;
        }
    }
    return either > 0 ? both / either : 0;
}

class Silhouette : public testing::TestWithParam<GlApi> {
protected:
    void SetUp() override {
        auto display = Display::open({.size = size, .headless = true, .api = GetParam()});
        ASSERT_TRUE(display) << display.error().text;
        display_ = std::move(*display);
        renderer_ = std::make_unique<Renderer>();
        renderer_->effects.smooth_edges = false;
    }
    void TearDown() override {
        renderer_.reset();
        display_.reset();
    }

    Picture photo(const Camera& camera, const Volume* volume, const dvec3& position) {
        renderer_->begin({camera, size, size});
        if (volume != nullptr)
            renderer_->shape(*volume, position, {.colour = rgb(0xE00000), .opacity = 0.8, .outline = 0});
        renderer_->end(display_->framebuffer());
        EXPECT_EQ(gl::take_error(), "");
        return read_picture(display_->framebuffer(), size);
    }

    static Camera looking_at(const dvec3& place, const dvec3& from) {
        Camera camera;
        camera.eye = place + from;
        camera.forward = -glm::normalize(from);
        return camera;
    }

    std::unique_ptr<Display> display_;
    std::unique_ptr<Renderer> renderer_;
};

TEST_P(Silhouette, of_a_red_ellipsoid_is_that_of_the_librarys_rays_from_three_sides) {
    const dvec3 place(3, 1, -2);
    const Volume volume = Ellipsoid{{0.5, 0.9, 0.7}};
    const Mesh mesh = mesh_around(volume.shape, place);
    for (const dvec3 from : {dvec3(0, 0.5, 4), dvec3(3, 2, -1), dvec3(-2, -2, 2)}) {
        const Camera camera = looking_at(place + dvec3(0.3, 0, 0), from);
        EXPECT_GE(overlap(photo(camera, &volume, place), photo(camera, nullptr, place), mesh, camera), 0.97);
    }
}

TEST_P(Silhouette, of_every_shape_is_that_of_the_librarys_rays) {
    const Shape all[] = {Sphere{0.7}, Capsule{0.3, 0.8}, Box{{0.3, 0.8, 0.5}}, Cylinder{0.6, 0.4}, Cone{0.5, 1.7}};
    const dvec3 place(-1, 0.5, 0);
    for (const Shape& shape : all) {
        const Volume volume = shape;
        const Camera camera = looking_at(place + middle_of(shape), {2, 1.5, 3});
        EXPECT_GE(
            overlap(photo(camera, &volume, place), photo(camera, nullptr, place), mesh_around(shape, place), camera),
            0.97)
            << shape.index();
    }
}

TEST_P(Silhouette, at_a_wrong_place_does_not_match) {
    const dvec3 place(3, 1, -2);
    const Volume volume = Ellipsoid{{0.5, 0.9, 0.7}};
    const Camera camera = looking_at(place, {0, 0.5, 4});
    const Picture wrong = photo(camera, &volume, place + dvec3(0.08, 0, 0));
    EXPECT_LT(overlap(wrong, photo(camera, nullptr, place), mesh_around(volume.shape, place), camera), 0.97);
}

TEST_P(Silhouette, is_as_good_a_thousand_kilometres_from_the_origin) {
    const dvec3 place(1e6, 0, -1e6);
    const Volume volume = Sphere{0.75};
    const Camera camera = looking_at(place, {0, 0.5, 4});
    const Camera near_camera = looking_at({0, 0, 0}, {0, 0.5, 4});
    const Mesh near_mesh = mesh_around(volume.shape, {0, 0, 0});
    EXPECT_GE(overlap(photo(camera, &volume, place), photo(camera, nullptr, place), near_mesh, near_camera), 0.97);
}

INSTANTIATE_TEST_SUITE_P(Apis, Silhouette, testing::Values(GlApi::core, GlApi::es),
                         [](const auto& api) { return api.param == GlApi::core ? "core" : "es"; });

}  // namespace
}  // namespace surefoot::view
