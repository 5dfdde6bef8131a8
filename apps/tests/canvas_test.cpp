// Flat shapes are where they are said to be, of the size that they are said to have, on any window.
#include "view/canvas.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <gtest/gtest.h>
#include <memory>
#include <numbers>
#include <optional>

#include "view/display.hpp"
#include "view/ortho_pass.hpp"

namespace surefoot::view {
namespace {

using Paint = std::function<void(Canvas&)>;

Letters& letters() {
    static Letters all;
    return all;
}

class FlatPicture : public testing::TestWithParam<GlApi> {
protected:
    void SetUp() override {
        auto display = Display::open({.size = {800, 600}, .headless = true, .api = GetParam()});
        ASSERT_TRUE(display) << display.error().text;
        display_ = std::move(*display);
        pass_.emplace();
    }
    void TearDown() override {
        pass_.reset();
        display_.reset();
    }

    Picture photo(const ivec2& size, const Paint& paint, const Picture* picture = nullptr) {
        if (display_->size() != size) display_->resize(size);
        if (picture != nullptr) pass_->set_picture(*picture);
        Canvas canvas(letters());
        canvas.begin({size, 1});
        paint(canvas);
        glBindFramebuffer(GL_FRAMEBUFFER, display_->framebuffer());
        glClearColor(0, 0, 0, 1);
        glClear(GL_COLOR_BUFFER_BIT);
        pass_->draw(canvas, display_->framebuffer());
        EXPECT_EQ(gl::take_error(), "");
        Picture taken = read_picture(display_->framebuffer(), size);
        if (const char* const folder = std::getenv("SUREFOOT_KEEP_PICTURES")) {
            const auto* const test = testing::UnitTest::GetInstance()->current_test_info();
            std::string name = test->name();
            std::replace(name.begin(), name.end(), '/', '-');
            EXPECT_TRUE(write_png(taken, std::string(folder) + "/" + name + "-" + std::to_string(size.x) + ".png"));
        }
        return taken;
    }

    /// How much is covered, in square layout units.
    static double covered(const Picture& picture) {
        double sum = 0;
        for (const Colour& pixel : picture.pixels) sum += pixel.r / 255.0;
        const double pixels = Layout{picture.size, 1}.pixels();
        return sum / (pixels * pixels);
    }
    static double middle_x(const Picture& picture) {
        double sum = 0;
        double all = 0;
        for (int y = 0; y < picture.size.y; ++y)
            for (int x = 0; x < picture.size.x; ++x) {
                sum += picture.at(x, y).r * (x + 0.5);
                all += picture.at(x, y).r;
            }
        return sum / all / Layout{picture.size, 1}.pixels();
    }

private:
    std::unique_ptr<Display> display_;
    std::optional<OrthoPass> pass_;
};

constexpr Colour white = rgb(0xFFFFFF);

TEST_P(FlatPicture, shapes_cover_the_area_that_geometry_says_on_small_and_large_windows) {
    constexpr double pi = std::numbers::pi;
    const struct {
        const char* name;
        Paint paint;
        double area;
    } shapes[] = {
        {"disc",
         [](Canvas& c) {
             c.disc({400, 300}, 40, white);
         },
         pi * 1600},
        {"box",
         [](Canvas& c) {
             c.box({{350, 280}, {450, 320}}, 0, white);
         },
         4000},
        {"round box",
         [](Canvas& c) {
             c.box({{350, 280}, {450, 320}}, 10, white);
         },
         4000 - (4 - pi) * 100},
        {"ring",
         [](Canvas& c) {
             c.ring({400, 300}, 50, 8, white);
         },
         2 * pi * 50 * 8},
        {"arc",
         [](Canvas& c) {
             c.arc({400, 300}, 50, 8, 0, pi, white);
         },
         pi * 50 * 8 + pi * 16},
        {"triangle",
         [](Canvas& c) {
             c.triangle({400, 250}, {450, 350}, {350, 350}, white);
         },
         5000},
        {"triangle the other way",
         [](Canvas& c) {
             c.triangle({400, 250}, {350, 350}, {450, 350}, white);
         },
         5000},
        {"line",
         [](Canvas& c) {
             c.line({350, 250}, {450, 350}, 6, white);
         },
         std::sqrt(20000.0) * 6 + pi * 9},
    };
    for (const ivec2 size : {ivec2(800, 600), ivec2(1200, 900)}) {
        for (const auto& shape : shapes) {
            const Picture picture = photo(size, shape.paint);
            EXPECT_NEAR(covered(picture) / shape.area, 1, 0.02) << shape.name << " at " << size.x;
        }
    }
}

TEST_P(FlatPicture, is_where_it_was_put_and_no_farther_than_its_bounds_and_its_clip) {
    const Picture shape = photo({800, 600}, [](Canvas& c) {
        c.line({100, 100}, {300, 200}, 10, white);
        const Rect bounds = c.bounds_of(c.items().front());
        EXPECT_NEAR(bounds.low.x, 95, 3);
        EXPECT_NEAR(bounds.high.y, 205, 3);
    });
    EXPECT_NEAR(middle_x(shape), 200, 0.5);
    const Picture half = photo({800, 600}, [](Canvas& c) {
        c.clip(Rect{{0, 0}, {400, 600}});
        c.disc({400, 300}, 40, white);
    });
    EXPECT_NEAR(covered(half), std::numbers::pi * 800, 60);
    EXPECT_EQ(half.at(402, 300).r, 0);
}

TEST_P(FlatPicture, letters_and_signs_are_as_large_on_every_window_and_as_sharp_as_its_pixels) {
    const Paint paint = [](Canvas& c) {
        c.text("Surefoot: 12.34 s, ledge grab", {60, 200}, {.size = 16, .colour = white});
        c.text("LEVEL COMPLETE", {60, 300}, {.size = 60, .colour = white, .face = Face::bold});
        double x = 60;
        for (int i = 0; i < static_cast<int>(Sign::count); ++i, x += 38)
            c.sign(static_cast<Sign>(i), {x, 400}, 32, white);
    };
    const Picture small = photo({800, 600}, paint);
    const Picture large = photo({2400, 1800}, paint);
    EXPECT_NEAR(covered(small) / covered(large), 1, 0.03);
    EXPECT_NEAR(middle_x(small), middle_x(large), 1);
    // Sharp: what is neither lit nor dark is a thin seam, thinner (for its size) on the window with more pixels.
    const auto seam = [](const Picture& picture) {
        const auto blurred = [](const Colour& p) { return p.r > 40 && p.r < 215; };
        return double(std::count_if(picture.pixels.begin(), picture.pixels.end(), blurred)) / picture.size.x;
    };
    EXPECT_LT(seam(large), seam(small) * 1.6);
}

TEST_P(FlatPicture, an_outline_keeps_white_text_legible_on_white) {
    const auto darkest = [&](double width) {
        const Picture picture = photo({800, 600}, [&](Canvas& c) {
            c.box({{0, 0}, {800, 600}}, 0, white);
            c.text("Jump", {300, 300}, {.size = 24, .colour = white, .edge = rgb(0), .edge_width = width});
        });
        const auto less = [](const Colour& x, const Colour& y) { return x.r < y.r; };
        return std::min_element(picture.pixels.begin(), picture.pixels.end(), less)->r;
    };
    EXPECT_LT(darkest(2), 40);
    EXPECT_EQ(darkest(0), 255);
}

TEST_P(FlatPicture, a_part_of_the_picture_is_shown_turned_within_round_corners) {
    Picture plan;
    plan.size = {2, 2};
    plan.pixels = {rgb(0xFF0000), rgb(0x00FF00), rgb(0x0000FF), rgb(0xFFFFFF)};
    const Rect rect{{300, 200}, {500, 400}};
    const Picture taken = photo(
        {800, 600},
        [&](Canvas& c) {
            c.picture(rect, 40, {0.5, 0.5}, {0.5, 0.5}, std::numbers::pi / 2, 1);
        },
        &plan);
    EXPECT_GT(taken.at(320, 250).g, 200);  // a quarter turn: the upper left shows what was at the upper right
    EXPECT_LT(taken.at(320, 250).r, 60);
    EXPECT_EQ(taken.at(302, 202).g, 0);
}

INSTANTIATE_TEST_SUITE_P(Apis, FlatPicture, testing::Values(GlApi::core, GlApi::es),
                         [](const auto& api) { return api.param == GlApi::core ? "core" : "es"; });

TEST(Canvas, a_window_is_always_at_least_800_by_600_units_at_the_usual_scale) {
    for (const ivec2 size :
         {ivec2(320, 240), ivec2(800, 600), ivec2(3840, 2160), ivec2(600, 1200), ivec2(3440, 1440)}) {
        const dvec2 units = Layout{size, 1}.size();
        EXPECT_GE(units.x, 799.99) << size.x;
        EXPECT_GE(units.y, 599.99) << size.x;
    }
    EXPECT_NEAR((Layout{{800, 600}, 2}.size().x), 400, 1e-9);
}

TEST(Canvas, breaks_lines_at_spaces_and_where_the_text_says_so) {
    Canvas canvas(letters());
    canvas.begin({});
    const auto lines =
        canvas.lines_of("one two three\nfour\n\nunbreakablyverylong", canvas.width_of("one two ", {}), {});
    ASSERT_EQ(lines.size(), 5U);
    EXPECT_EQ(lines[0], "one two");
    EXPECT_EQ(lines[1], "three");
    EXPECT_EQ(lines[2], "four");
    EXPECT_EQ(lines[3], "");
    EXPECT_EQ(lines[4], "unbreakablyverylong");
}

TEST(Canvas, takes_any_bytes_as_text) {
    Canvas canvas(letters());
    canvas.begin({});
    for (const char* text : {"", "\xFF\xFE", "caf\xC3\xA9", "\xC3", "\xE2\x82", "\xF0\x9F\x99\x82", "\xC3\x28"})
        EXPECT_GE(canvas.text(text, {100, 100}, {}), 0) << text;
    std::string_view word = "\xC3\xA9!";
    EXPECT_EQ(take_letter(word), U'\u00E9');
    EXPECT_EQ(word, "!");
}

TEST(Letters, begin_anew_when_the_picture_is_full_and_then_have_room_again) {
    Letters few;
    bool full = false;
    for (int size = 36; size > 8 && !full; --size)
        for (char32_t letter = 0x41; letter < 0x250 && !full; ++letter)
            full = letter != 0x7F && (letter < 0x80 || letter > 0xA0) && few.glyph(Face::bold, letter, size).reach <= 0;
    ASSERT_TRUE(full);
    few.next_frame();
    EXPECT_GT(few.glyph(Face::plain, U'A', 30).reach, 0);
}

}  // namespace
}  // namespace surefoot::view
