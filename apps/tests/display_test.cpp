#include "view/display.hpp"

#include <algorithm>
#include <filesystem>
#include <gtest/gtest.h>
#include <memory>

#include "view/gl.hpp"
#include "view/picture.hpp"
#include "view/renderer.hpp"

namespace surefoot::view {
namespace {

Mesh wall_and_floor() {
    const std::vector<vec3> vertices{{-9, 0, -9}, {9, 0, -9}, {9, 0, 9}, {-9, 0, 9},
                                     {-1, 0, 0},  {1, 0, 0},  {1, 3, 0}, {-1, 3, 0}};
    const std::vector<std::uint32_t> indices{0, 3, 2, 0, 2, 1, 4, 5, 6, 4, 6, 7};
    return *Mesh::build({.vertices = vertices, .indices = indices});
}

struct Studio {
    std::unique_ptr<Display> display = std::move(*Display::open({.size = {320, 240}, .headless = true}));
    Renderer renderer;

    Picture photo(const std::shared_ptr<Model>& model, const Camera& camera) {
        renderer.begin({camera, display->size(), display->framebuffer_size()});
        renderer.model(model, {.edges = {.width = 1}});
        renderer.end(display->framebuffer());
        EXPECT_EQ(gl::take_error(), "");
        return read_picture(display->framebuffer(), display->framebuffer_size());
    }
};

Camera from_above() {
    Camera camera;
    camera.eye = {0, 9, 9};
    camera.forward = {0, -0.70710678, -0.70710678};
    return camera;
}

TEST(Renderer, keeps_the_shadow_map_while_nothing_of_it_moves) {
    Studio studio;
    const auto model = Model::make(wall_and_floor());
    static_cast<void>(studio.photo(model, from_above()));
    EXPECT_TRUE(studio.renderer.counts().shadow_drawn);
    Camera other = from_above();
    other.eye.x = 1;
    static_cast<void>(studio.photo(model, other));
    EXPECT_FALSE(studio.renderer.counts().shadow_drawn);
    studio.renderer.sky.towards_sun.x += 0.1;
    static_cast<void>(studio.photo(model, other));
    EXPECT_TRUE(studio.renderer.counts().shadow_drawn);
}

TEST(Renderer, a_wall_throws_a_shadow_in_the_very_first_frame_and_the_software_preset_throws_none) {
    Studio studio;
    const auto model = Model::make(wall_and_floor());
    studio.renderer.sky.towards_sun = {0, 1, -0.8};
    const Camera camera = from_above();
    const auto place = camera.project({0, 0, 0.8}, studio.display->size());
    const auto at_place = [&](const Picture& p) {
        return p.at(static_cast<int>(place->at.x), static_cast<int>(place->at.y));
    };
    const Colour shaded = at_place(studio.photo(model, camera));
    studio.renderer.effects = Effects::software();
    const Colour lit = at_place(studio.photo(model, camera));
    EXPECT_GT(lit.r, shaded.r + 40);
}

TEST(Renderer, what_is_out_of_sight_is_not_drawn) {
    Studio studio;
    const auto model = Model::make(wall_and_floor());
    Camera away = from_above();
    away.forward = {0, 0.6, 0.8};
    static_cast<void>(studio.photo(model, away));
    EXPECT_EQ(studio.renderer.counts().triangles, 0U);
}

TEST(Renderer, is_a_sink_of_the_cores_debug_drawing) {
    Studio studio;
    studio.renderer.begin({from_above(), {320, 240}, {320, 240}});
    const DebugDraw draw(studio.renderer);
    draw.line({-1, 0, 0}, {1, 0, 0}, rgb(0xFF0000));
    draw.triangle({0, 0, 0}, {2, 0, 0}, {0, 0, 2}, rgb(0x00FF00));
    draw.text({0, 0, 0}, "here", rgb(0xFFFFFF));
    studio.renderer.end(studio.display->framebuffer());
    EXPECT_EQ(studio.renderer.labels().at(0).text, "here");
    const Camera camera = from_above();
    const auto at = camera.project({0.5, 0, 0.5}, {320, 240});
    const Colour seen = read_picture(studio.display->framebuffer(), {320, 240})
                            .at(static_cast<int>(at->at.x), static_cast<int>(at->at.y));
    EXPECT_GT(seen.g, 240);
    EXPECT_LT(seen.r, 40);
}

TEST(Renderer, lines_and_heads_of_arrows_grow_with_letters) {
    Studio studio;
    const auto photo = [&](double scale, double width) {
        studio.renderer.begin({from_above(), {320, 240}, {320, 240}, scale});
        studio.renderer.arrow({-1, 0, 0}, {1, 0, 0}, {.colour = rgb(0xFF0000), .width = width}, 4 * width);
        studio.renderer.point({0, 0, 2}, 3 * width, rgb(0x0000FF));
        studio.renderer.end(studio.display->framebuffer());
        return read_picture(studio.display->framebuffer(), {320, 240}).pixels;
    };
    const auto same = [](Colour a, Colour b) { return a.r == b.r && a.g == b.g && a.b == b.b; };
    const auto twice = photo(2, 3);
    EXPECT_TRUE(std::ranges::equal(twice, photo(1, 6), same));
    EXPECT_FALSE(std::ranges::equal(twice, photo(1, 3), same));
}

TEST(Renderer, a_window_made_small_to_nothing_is_no_error) {
    Studio studio;
    studio.renderer.begin({from_above(), {0, 0}, {0, 0}});
    studio.renderer.line({0, 0, 0}, {1, 0, 0}, Stroke{});
    studio.renderer.end(studio.display->framebuffer());
    EXPECT_EQ(gl::take_error(), "");
}

TEST(Display, without_a_screen_a_window_is_an_error_in_words) {
    if (std::getenv("DISPLAY") != nullptr || std::getenv("WAYLAND_DISPLAY") != nullptr)
        GTEST_SKIP() << "there is a display";
    const auto display = Display::open({});
    ASSERT_FALSE(display);
    EXPECT_EQ(display.error().code, ErrorCode::unsupported);
    EXPECT_NE(display.error().text.find("--headless"), std::string::npos);
}

TEST(Picture, that_cannot_be_written_says_so) {
    EXPECT_FALSE(write_png({{1, 1}, {Colour{}}}, "/there/is/no/such/folder/a.png"));
}

}  // namespace
}  // namespace surefoot::view
