// The orange shape is drawn where the library says that the motion stops: its silhouette, from three cameras, is that
// of the library's own rays against a shape at the t of the library's own sweep.
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <memory>

#include <surefoot/pose.hpp>
#include <surefoot/sweep.hpp>

#include "playground/debugger_room/scene.hpp"
#include "view/display.hpp"
#include "view/gl.hpp"
#include "view/picture.hpp"
#include "view/shapes.hpp"

namespace surefoot::playground {
namespace {

using view::Colour;
using view::Picture;

Mesh mesh_of_triangles(const std::vector<Triangle>& triangles) {
    std::vector<vec3> vertices;
    std::vector<std::uint32_t> indices;
    for (const Triangle& t : triangles)
        for (const dvec3& corner : {t.a, t.b, t.c}) {
            indices.push_back(static_cast<std::uint32_t>(vertices.size()));
            vertices.push_back(vec3(corner));
        }
    return *Mesh::build({.vertices = vertices, .indices = indices});
}

/// The shape's own surface, at the place of time `t`.
Mesh mesh_at(const debugger::Question& question, double t) {
    const Volume volume = question.volume();
    const Pose pose{.position = question.motion.from + t * (question.motion.to - question.motion.from),
                    .orientation = volume.orientation};
    const view::ShapeMesh fine = view::mesh_of(volume.shape, 160);
    std::vector<vec3> vertices;
    for (const auto& vertex : fine.vertices) vertices.push_back(vec3(to_world(pose, dvec3(vertex.position))));
    return *Mesh::build({.vertices = vertices, .indices = fine.indices});
}

double first_touch(const debugger::Question& question) {
    double t = 1;
    for (const Triangle& triangle : question.triangles)
        if (const auto hit = surefoot::sweep(question.volume(), question.motion, triangle)) t = std::min(t, hit->t);
    return t;
}

/// How much of what either covers both cover.
double agreement(const Picture& with, const Picture& without, const Mesh& shape, const Mesh& world,
                 const view::Camera& camera) {
    double both = 0;
    double either = 0;
    for (int y = 0; y < with.size.y; ++y) {
        for (int x = 0; x < with.size.x; ++x) {
            const Colour& a = with.at(x, y);
            const Colour& b = without.at(x, y);
            const bool drawn = std::abs(a.r - b.r) + std::abs(a.g - b.g) + std::abs(a.b - b.b) > 40;
            const view::dvec2 at(x + 0.5, y + 0.5);
            const auto met = view::pick(shape, camera, at, with.size);
            const auto wall = met ? view::pick(world, camera, at, with.size) : std::nullopt;
            const bool real = met && (!wall || met->t < wall->t);
            both += drawn && real ? 1 : 0;
            either += drawn || real ? 1 : 0;
        }
    }
    return either > 0 ? both / either : 0;
}

class DebuggerSilhouette : public testing::TestWithParam<debugger::ShapeName> {
protected:
    DebuggerSilhouette() {
        renderer_.effects = view::Effects::software();  // no shadows: what differs is the shape alone
        scene_.look = {.start = false, .end = false, .result = false, .contact = false, .ways = false, .labels = false};
        asked_.apply(debugger::ChooseShape{GetParam()});
    }

    /// As the room draws it, with the orange shape or without.
    Picture photo(const view::Camera& camera, bool with_hit) {
        scene_.look.hit = with_hit;
        renderer_.begin({camera, size, size});
        scene_.draw(renderer_, asked_, 1);
        renderer_.end(display_->framebuffer());
        EXPECT_EQ(view::gl::take_error(), "");
        return view::read_picture(display_->framebuffer(), size);
    }

    static constexpr view::ivec2 size{720, 640};
    std::unique_ptr<view::Display> display_ = std::move(*view::Display::open({.size = size, .headless = true}));
    view::Renderer renderer_;
    Scene scene_;
    Investigation asked_;
};

TEST_P(DebuggerSilhouette, of_the_orange_shape_is_that_of_the_librarys_answer_from_three_cameras) {
    const debugger::Question& question = asked_.question();
    const double t = first_touch(question);
    ASSERT_GT(t, 0);
    ASSERT_LT(t, 0.9);
    const Mesh right = mesh_at(question, t);
    const Mesh wrong = mesh_at(question, t + 0.05);
    const Mesh world = mesh_of_triangles(question.triangles);
    // So near that the width of an outline is little of the shape.
    const dvec3 middle = (right.bounds().min + right.bounds().max) * 0.5;
    const double far = glm::length(right.bounds().max - middle) * 2.3;
    for (const dvec3 from : {dvec3(1, 0.6, 0.2), dvec3(0.3, 0.9, -1), dvec3(0.9, -0.4, -0.3)}) {
        view::Camera camera;
        camera.eye = middle + glm::normalize(from) * far;
        camera.forward = -glm::normalize(from);
        const Picture with = photo(camera, true);
        const Picture without = photo(camera, false);
        EXPECT_GE(agreement(with, without, right, world, camera), 0.97) << from.x;
        EXPECT_LT(agreement(with, without, wrong, world, camera), 0.97) << from.x;
    }
}

std::string name_of(const testing::TestParamInfo<debugger::ShapeName>& shape) {
    constexpr const char* names[] = {"sphere", "ellipsoid", "capsule", "box", "cylinder", "cone"};
    return names[static_cast<std::size_t>(shape.param)];
}

INSTANTIATE_TEST_SUITE_P(Shapes, DebuggerSilhouette,
                         testing::Values(debugger::ShapeName::sphere, debugger::ShapeName::ellipsoid,
                                         debugger::ShapeName::capsule, debugger::ShapeName::box,
                                         debugger::ShapeName::cylinder, debugger::ShapeName::cone),
                         name_of);

}  // namespace
}  // namespace surefoot::playground
