// What shines, what is drawn on surfaces, and soft discs.
#include <gtest/gtest.h>
#include <memory>
#include <numeric>

#include "view/display.hpp"
#include "view/pattern.hpp"
#include "view/picture.hpp"
#include "view/renderer.hpp"

namespace surefoot::view {
namespace {

constexpr Colour grey = rgb(0x808080);

Mesh floor_of_nine_metres() {
    const std::vector<vec3> vertices{{-9, 0, -9}, {9, 0, -9}, {9, 0, 9}, {-9, 0, 9}};
    const std::vector<std::uint32_t> indices{0, 3, 2, 0, 2, 1};
    return *Mesh::build({.vertices = vertices, .indices = indices});
}

struct Studio {
    std::unique_ptr<Display> display = std::move(*Display::open({.size = {160, 120}, .headless = true}));
    Renderer renderer;

    /// A floor seen from above, and perhaps a disc on it.
    Picture photo(const Finish& finish, const Disc* disc = nullptr) {
        Camera camera;
        camera.eye = {0, 8, 0.1};
        camera.forward = {0, -1, 0};
        camera.up = {0, 0, -1};
        renderer.begin({camera, display->size(), display->framebuffer_size()});
        const auto model = Model::make(floor_of_nine_metres(), [&](const SourceTriangle&) { return finish; });
        renderer.model(model);
        if (disc != nullptr) renderer.disc(*disc);
        renderer.end(display->framebuffer());
        EXPECT_EQ(gl::take_error(), "");
        return read_picture(display->framebuffer(), display->framebuffer_size());
    }
};

TEST(Finish, what_shines_is_as_bright_without_any_light_and_all_else_is_dark) {
    for (const Effects& effects : {Effects::full(), Effects::software()}) {
        Studio studio;
        studio.renderer.effects = effects;
        studio.renderer.sky.sun = studio.renderer.sky.above = studio.renderer.sky.below = vec3(0);
        EXPECT_LT(studio.photo({grey}).at(80, 60).g, 20);
        EXPECT_GT(studio.photo({grey, 1.0}).at(80, 60).g, 120);
    }
}

TEST(Finish, a_pattern_changes_single_places_and_not_the_whole) {
    Studio studio;
    studio.renderer.effects.shadows = false;
    const Colour plain = studio.photo({grey}).at(80, 60);
    for (const Pattern pattern : {Pattern::patches, Pattern::bricks, Pattern::boards, Pattern::strata}) {
        const Picture drawn = studio.photo({grey, 0, pattern});
        double sum = 0;
        int low = 255;
        int high = 0;
        for (int y = 0; y < 120; ++y)
            for (int x = 0; x < 160; ++x) {
                const int g = drawn.at(x, y).g;
                sum += g;
                low = std::min(low, g);
                high = std::max(high, g);
            }
        EXPECT_NEAR(sum / (160 * 120), plain.g, 8);
        EXPECT_GT(high - low, 15);
    }
}

TEST(Pattern, is_on_the_mean_what_leaves_a_colour_as_it_is) {
    const auto picture = pattern_picture();
    ASSERT_EQ(picture.size(), std::size_t{pattern_texels} * pattern_texels);
    for (std::size_t channel = 0; channel < pattern_count; ++channel) {
        const double sum = std::accumulate(picture.begin(), picture.end(), 0.0,
                                           [&](double so_far, const PatternTexel& t) { return so_far + t[channel]; });
        EXPECT_NEAR(sum / double(picture.size()), 128, 1.5) << channel;
    }
}

TEST(Pattern, joins_itself_at_its_sides_as_well_as_in_its_middle) {
    const auto picture = pattern_picture();
    const auto jump = [&](std::size_t channel, int from, int to, bool rows) {
        double sum = 0;
        for (int i = 0; i < pattern_texels; ++i) {
            const auto at = [&](int k) {
                return double(picture[std::size_t(rows ? k * pattern_texels + i : i * pattern_texels + k)][channel]);
            };
            sum += std::abs(at(from) - at(to));
        }
        return sum / pattern_texels;
    };
    for (std::size_t channel = 0; channel < pattern_count; ++channel)
        for (const bool rows : {true, false}) {
            double worst = 0;  // of the steps that are no seam
            for (int k = 1; k < pattern_texels; ++k) worst = std::max(worst, jump(channel, k - 1, k, rows));
            EXPECT_LE(jump(channel, pattern_texels - 1, 0, rows), worst * 1.05 + 1) << channel << rows;
        }
}

TEST(Disc, shades_what_it_lies_on_or_adds_light_to_it_and_ends_at_its_radius) {
    Studio studio;
    studio.renderer.effects.shadows = false;
    const Colour plain = studio.photo({grey}).at(80, 60);
    const Disc shade{.place = {0, 0.01, 0.1}, .radius = 1, .normal = {0, 1, 0}, .colour = rgb(0x000000, 0.6)};
    EXPECT_LT(studio.photo({grey}, &shade).at(80, 60).g, plain.g - 40);
    EXPECT_EQ(studio.photo({grey}, &shade).at(5, 5).g, studio.photo({grey}).at(5, 5).g);
    Disc light = shade;
    light.colour = rgb(0xFFFFFF, 0.3);
    light.is_light = true;
    EXPECT_GT(studio.photo({grey}, &light).at(80, 60).g, plain.g + 30);
}

TEST(Disc, is_hidden_by_what_is_before_it) {
    Studio studio;
    const Colour plain = studio.photo({grey}).at(80, 60);
    const Disc below{.place = {0, -2, 0.1}, .radius = 1, .colour = rgb(0x000000)};
    EXPECT_EQ(studio.photo({grey}, &below).at(80, 60).g, plain.g);
}

}  // namespace
}  // namespace surefoot::view
