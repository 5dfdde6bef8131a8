// Small solids are drawn where they are said to be, many at once, and lie right before and behind other things.
#include <cmath>
#include <gtest/gtest.h>
#include <memory>

#include "view/display.hpp"
#include "view/gl.hpp"
#include "view/picture.hpp"
#include "view/renderer.hpp"

namespace surefoot::view {
namespace {

constexpr ivec2 size(320, 240);

dmat4x3 at(const dvec3& place, const dvec3& radii) {
    return {dvec3(radii.x, 0, 0), dvec3(0, radii.y, 0), dvec3(0, 0, radii.z), place};
}

class Pieces : public testing::TestWithParam<GlApi> {
protected:
    void SetUp() override {
        auto display = Display::open({.size = size, .headless = true, .api = GetParam()});
        ASSERT_TRUE(display) << display.error().text;
        display_ = std::move(*display);
        renderer_ = std::make_unique<Renderer>();
        renderer_->effects.smooth_edges = false;
        camera_.eye = {0, 0, 5};
    }
    void TearDown() override {
        renderer_.reset();
        display_.reset();
    }

    template <typename Collect>
    Picture photo(const Collect& collect) {
        renderer_->begin({camera_, size, size});
        collect(*renderer_);
        renderer_->end(display_->framebuffer());
        EXPECT_EQ(gl::take_error(), "");
        return read_picture(display_->framebuffer(), size);
    }

    [[nodiscard]] const Colour& seen_at(const Picture& picture, const dvec3& place) const {
        const auto projected = camera_.project(place, size);
        return picture.at(int(projected->at.x), int(projected->at.y));
    }

    Camera camera_;
    std::unique_ptr<Display> display_;
    std::unique_ptr<Renderer> renderer_;
};

TEST_P(Pieces, that_are_balls_cover_the_pixels_that_shapes_of_their_size_cover) {
    const dvec3 radii(0.9, 0.5, 0.7);
    const Picture empty = photo([](Renderer&) {});
    const Picture piece = photo([&](Renderer& r) { r.piece({Solid::ball, at({0.3, 0, 0}, radii), rgb(0xE00000)}); });
    const Picture shape = photo([&](Renderer& r) {
        r.shape(Volume{Ellipsoid{radii}}, {0.3, 0, 0}, {.colour = rgb(0xE00000), .opacity = 1, .outline = 0});
    });
    const auto differs = [](const Colour& a, const Colour& b) {
        return std::abs(a.r - b.r) + std::abs(a.g - b.g) + std::abs(a.b - b.b) > 60;
    };
    int both = 0;
    int either = 0;
    for (std::size_t i = 0; i < empty.pixels.size(); ++i) {
        const bool one = differs(piece.pixels[i], empty.pixels[i]);
        const bool other = differs(shape.pixels[i], empty.pixels[i]);
        both += one && other ? 1 : 0;
        either += one || other ? 1 : 0;
    }
    EXPECT_GT(both, 2000);
    EXPECT_GT(double(both) / either, 0.97);
}

TEST_P(Pieces, hide_what_is_behind_them_whatever_was_said_first) {
    for (const bool near_first : {true, false}) {
        const Picture picture = photo([&](Renderer& r) {
            const Piece near{Solid::cube, at({0, 0, 1}, dvec3(0.3)), rgb(0x00D000), 1.0F};
            const Piece far{Solid::drum, at({0, 0, -1}, dvec3(0.6)), rgb(0xD00000), 1.0F};
            r.piece(near_first ? near : far);
            r.piece(near_first ? far : near);
        });
        EXPECT_GT(seen_at(picture, {0, 0, 1}).g, 150);
        EXPECT_LT(seen_at(picture, {0, 0, 1}).r, 90);
    }
}

TEST_P(Pieces, that_are_seen_through_let_what_is_behind_shine_through) {
    const Picture picture = photo([&](Renderer& r) {
        r.piece({Solid::ball, at({0, 0, 1}, dvec3(0.5)), rgb(0x00D000, 0.5), 1.0F});
        r.piece({Solid::ball, at({0, 0, -1}, dvec3(0.5)), rgb(0xD00000), 1.0F});
    });
    const Colour& middle = seen_at(picture, {0, 0, 1});
    EXPECT_GT(middle.g, 80);
    EXPECT_GT(middle.r, 80);
}

TEST_P(Pieces, out_of_sight_and_of_no_opacity_cost_no_triangle) {
    photo([](Renderer& r) {
        r.piece({Solid::ball, at({0, 0, 20}, dvec3(0.5)), rgb(0xD00000)});
        r.piece({Solid::ball, at({0, 0, 0}, dvec3(0.5)), rgb(0xD00000, 0)});
    });
    EXPECT_EQ(renderer_->counts().pieces, 2U);
    EXPECT_EQ(renderer_->counts().triangles, 0U);
}

TEST_P(Pieces, that_are_small_on_the_picture_have_fewer_triangles) {
    photo([](Renderer& r) { r.piece({Solid::ball, at({0, 0, 0}, dvec3(1)), rgb(0xD00000)}); });
    const std::size_t near = renderer_->counts().triangles;
    photo([](Renderer& r) { r.piece({Solid::ball, at({0, 0, -200}, dvec3(1)), rgb(0xD00000)}); });
    const std::size_t far = renderer_->counts().triangles;
    EXPECT_GT(far, 0U);
    EXPECT_LT(far * 8, near);
}

INSTANTIATE_TEST_SUITE_P(OnEveryApi, Pieces, testing::Values(GlApi::core, GlApi::es),
                         [](const auto& given) { return given.param == GlApi::core ? "core" : "es"; });

}  // namespace
}  // namespace surefoot::view
