// The room that docs/playground.md shows, and that it works.
#include <gtest/gtest.h>

#include "playground/room.hpp"
#include "view/orbit_camera.hpp"
#include "view/widgets.hpp"

namespace surefoot::playground {
namespace {

// [pond]
class Pond final : public Room {
public:
    void enter(Stage& stage) override { stage_ = &stage; }
    bool event(const view::InputEvent& event) override { return camera_.event(event, stage_->display.size()); }
    bool update(double dt) override { return camera_.update(dt); }  // true: draw me again
    [[nodiscard]] view::Camera camera() const override { return camera_.camera(); }
    void draw(view::Renderer& renderer) override {
        renderer.shape(Sphere{radius_}, {0, 1, 0}, {.colour = view::paint::hit});
        renderer.arrow({0, 1, 0}, {0, 3, 0}, {.colour = view::paint::normal, .width = 3});
        renderer.label({.place = {0, 3, 0}, .text = "up"});
    }
    void ui() override {
        if (view::ui::begin("Pond", {})) view::ui::slider("Radius", radius_, 0.1, 2);
        view::ui::end();
    }

private:
    Stage* stage_ = nullptr;
    view::OrbitCamera camera_;
    double radius_ = 0.5;
};
// [/pond]

TEST(Pond, draws_a_shape_an_arrow_and_a_label) {
    auto display = view::Display::open({.size = {320, 200}, .headless = true});
    ASSERT_TRUE(display);
    view::Renderer renderer;
    Pond pond;
    renderer.begin({pond.camera(), {320, 200}, {320, 200}});
    pond.draw(renderer);
    renderer.end((*display)->framebuffer());
    EXPECT_EQ(renderer.counts().shapes, 1U);
    EXPECT_EQ(renderer.labels().size(), 1U);
    EXPECT_GT(renderer.counts().lines, 2U);
}

}  // namespace
}  // namespace surefoot::playground
