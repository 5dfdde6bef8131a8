// What can be taken by the hand, with a camera and no window.
#include "playground/debugger_room/grips.hpp"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "debugger/worlds.hpp"

namespace surefoot::playground {
namespace {

using view::dvec2;
constexpr view::ivec2 size(800, 600);

view::Camera from_the_side() {
    view::Camera camera;
    camera.eye = {6, 1, 24};
    camera.forward = {0, 0, -1};
    return camera;
}

dvec2 seen(const dvec3& place) {
    return from_the_side().project(place, size)->at;
}

debugger::Question question() {
    return debugger::default_question(debugger::WorldKind::triangle);
}

TEST(Grips, the_body_under_the_pointer_is_grabbed_on_its_surface) {
    const auto grips = grips_of(question(), std::nullopt, from_the_side(), size);
    const auto grabbed = grab(grips, from_the_side(), seen(question().motion.from), size);
    ASSERT_TRUE(grabbed);
    EXPECT_EQ(grabbed->grip.target.kind, Target::Kind::start);
    EXPECT_NEAR(grabbed->at.z, question().motion.from.z + 0.8, 0.05);
}

TEST(Grips, nothing_is_grabbed_beside_everything) {
    const auto grips = grips_of(question(), std::nullopt, from_the_side(), size);
    EXPECT_FALSE(grab(grips, from_the_side(), {5, 5}, size));
}

TEST(Grips, arrows_go_before_the_body_that_they_begin_in) {
    const Target start{};
    const auto grips = grips_of(question(), start, from_the_side(), size);
    const dvec2 at = seen(question().motion.from + dvec3(0, 1.4 + 0.6, 0));
    const auto grabbed = grab(grips, from_the_side(), at, size);
    ASSERT_TRUE(grabbed);
    EXPECT_EQ(grabbed->grip.kind, Grip::Kind::arrow);
    EXPECT_EQ(grabbed->grip.axis, 1);
}

TEST(Grips, an_arrow_that_is_dragged_moves_along_its_axis_as_far_as_the_pointer) {
    const Target start{};
    const auto grips = grips_of(question(), start, from_the_side(), size);
    const dvec2 at = seen(question().motion.from + dvec3(0, 2, 0));
    const auto grabbed = grab(grips, from_the_side(), at, size);
    ASSERT_TRUE(grabbed);
    const Drag drag(*grabbed, question());
    const auto still = drag.to(from_the_side(), at, size, 0);
    ASSERT_TRUE(still);
    EXPECT_LT(glm::length(*still - question().motion.from), 1e-9);
    const auto to = drag.to(from_the_side(), seen(question().motion.from + dvec3(0.4, 3, 0)), size, 0);
    ASSERT_TRUE(to);
    EXPECT_EQ(to->x, question().motion.from.x);
    EXPECT_EQ(to->z, question().motion.from.z);
    EXPECT_NEAR(to->y, question().motion.from.y + 1, 0.02);
}

TEST(Grips, a_plane_seen_edge_on_moves_nothing) {
    const Target start{};
    view::Camera level = from_the_side();
    level.eye.y = question().motion.from.y + 1.4 * 1.12;  // in the plane of the box's upper face
    const auto grips = grips_of(question(), start, level, size);
    for (const Grip& grip : grips) {
        if (grip.kind != Grip::Kind::face || grip.axis != 1 || grip.towards < 0) continue;
        const Drag drag({grip, grip.place}, question());
        EXPECT_FALSE(drag.to(level, {500, 300}, size, 0));
    }
}

TEST(Grips, only_what_moves_is_snapped) {
    debugger::Question q = question();
    q.motion.from = {7.3, 4.1, 4.4};
    const Target start{};
    for (const Grip& grip : grips_of(q, start, from_the_side(), size)) {
        if (grip.kind != Grip::Kind::face || grip.axis != 2) continue;
        const Drag drag({grip, grip.place}, q);
        const auto to = drag.to(from_the_side(), seen(grip.place) + dvec2(30, 5), size, 0.5);
        ASSERT_TRUE(to);
        EXPECT_EQ(to->z, 4.4);
        EXPECT_EQ(std::remainder(to->x, 0.5), 0);
        EXPECT_EQ(std::remainder(to->y, 0.5), 0);
    }
}

TEST(Grips, a_shape_that_is_none_leaves_the_corners_to_be_grabbed) {
    debugger::Question q = question();
    q.sizes.ellipsoid.radii.x = 0;
    const auto grips = grips_of(q, Target{}, from_the_side(), size);
    EXPECT_EQ(grips.size(), 3U);
}

}  // namespace
}  // namespace surefoot::playground
