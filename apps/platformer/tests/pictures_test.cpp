// The screens and the display, drawn: as large on every window, within OpenGL ES 3.0 too. With SUREFOOT_KEEP_PICTURES
// set to a folder, they are kept there to be looked at.
#include <cstdlib>
#include <gtest/gtest.h>
#include <memory>
#include <optional>

#include "platformer/hud/hud.hpp"
#include "platformer/screens/draw_screens.hpp"
#include "view/display.hpp"
#include "view/ortho_pass.hpp"
#include "view/renderer.hpp"

namespace surefoot::platformer {
namespace {

using view::Canvas;
using view::ivec2;
using view::Key;
using view::Picture;

std::vector<LevelCard> six_levels() {
    std::vector<LevelCard> all;
    const char* const titles[] = {"First Steps", "Rope Bridge", "The Long Slide", "Clockwork", "Under the Lake",
                                  "Storm Tower", "Moon"};
    for (int i = 0; i < 7; ++i) {
        LevelCard card{.id = titles[i], .title = titles[i]};
        card.idea = "Jumping: high, far, and with nothing below.";
        card.gold = 90 + i;
        card.silver = 121.5;
        card.bronze = 171;
        card.coins_all = 40;
        card.locked = i > 3;
        card.locked_why = i == 6 ? "Collect 12 stars." : "Win Clockwork first.";
        card.secret = i == 6;
        if (i < 3) {
            card.best = 101.5 + 20 * i;
            card.medal = static_cast<Medal>(3 - i);
            card.stars = 3 - i;
            card.coins = 31 + i;
            card.has_recording = true;
        }
        all.push_back(card);
    }
    return all;
}

class Pictures : public testing::TestWithParam<view::GlApi> {
protected:
    void SetUp() override {
        auto display = view::Display::open({.size = {800, 600}, .headless = true, .api = GetParam()});
        ASSERT_TRUE(display) << display.error().text;
        display_ = std::move(*display);
        renderer_ = std::make_unique<view::Renderer>();
        renderer_->effects = view::Effects::software();
        pass_.emplace();
    }
    void TearDown() override {
        pass_.reset();
        renderer_.reset();
        display_.reset();
    }

    /// A hero on a floor among blocks, as the game would draw them.
    void draw_world(const HudView& hud) {
        renderer_->begin({hud.camera, display_->size(), display_->framebuffer_size()});
        for (int i = 0; i < 14; ++i)
            renderer_->shape(Box{{2.4, 0.4, 2.4}}, {(i * 37 % 11) * 2.0 - 10, -0.4 + i * 0.35, -3.0 * i},
                             {.colour = view::rgb(0x8FA37E), .outline = 0});
        renderer_->shape(Ellipsoid{{0.35, 0.8, 0.35}}, hud.hero, {.colour = view::rgb(0xE0803E), .outline = 0});
        renderer_->end(display_->framebuffer());
    }

    Picture finish(const Canvas& canvas, const std::string& name) {
        pass_->draw(canvas, display_->framebuffer());
        EXPECT_EQ(view::gl::take_error(), "");
        const ivec2 size = display_->framebuffer_size();
        Picture picture = view::read_picture(display_->framebuffer(), size);
        if (const char* const folder = std::getenv("SUREFOOT_KEEP_PICTURES");
            folder != nullptr && GetParam() != view::GlApi::es) {
            EXPECT_TRUE(
                view::write_png(picture, std::string(folder) + "/" + name + "-" + std::to_string(size.y) + ".png"));
        }
        return picture;
    }

    static std::size_t differing(const Picture& a, const Picture& b) {
        std::size_t count = 0;
        for (std::size_t i = 0; i < a.pixels.size(); ++i)
            if (std::abs(a.pixels[i].r - b.pixels[i].r) + std::abs(a.pixels[i].g - b.pixels[i].g) > 24) ++count;
        return count;
    }

    static HudView busy(const ivec2& window) {
        HudView hud;
        hud.health = 2;
        hud.coins = 12;
        hud.coins_all = 40;
        hud.stars = 1;
        hud.keys = {"red"};
        hud.seconds = 83.456;
        hud.section = "The long bridge";
        hud.section_age = 1;
        hud.section_split = -1.25;
        hud.prompt = prompt_parts("Press {jump} in the air for a second jump, then {dash}.", Bindings::defaults(),
                                  Device::keyboard);
        hud.hero = {0, 0.8, 0};
        hud.camera.eye = {0.4, 2.8, 5.5};
        hud.camera.forward = glm::normalize(dvec3(0, -0.3, -1));
        hud.camera.field_of_view = 1.05;
        hud.window = window;
        hud.markers = {{HudMarker::Kind::goal, {60, 9, -20}},
                       {HudMarker::Kind::checkpoint, {-30, 4, -4}},
                       {HudMarker::Kind::key, {6, 2, 40}},
                       {HudMarker::Kind::star, {-3, 40, -20}}};
        hud.hurts = {{{5, 1, 3}, 0.2}};
        hud.map = {{MapItem::Kind::coin, {3, 0, -3}},   {MapItem::Kind::coin, {4, 0, -5}},
                   {MapItem::Kind::enemy, {-6, 5, -8}}, {MapItem::Kind::star, {9, 0, 4}},
                   {MapItem::Kind::goal, {60, 9, -20}}, {MapItem::Kind::checkpoint, {-8, 0, -4}}};
        return hud;
    }
    static Plan plan() {
        std::vector<dvec3> corners;
        for (int i = 0; i < 14; ++i) {
            const dvec3 m((i * 37 % 11) * 2.0 - 10, i * 0.35, -3.0 * i);
            const dvec3 a = m + dvec3(-2.4, 0, -2.4);
            const dvec3 b = m + dvec3(-2.4, 0, 2.4);
            const dvec3 c = m + dvec3(2.4, 0, 2.4);
            const dvec3 d = m + dvec3(2.4, 0, -2.4);
            corners.insert(corners.end(), {a, b, c, a, c, d});
        }
        return make_plan(corners);
    }

    Screens some_screens() {
        Screens screens;
        screens.set_levels(six_levels());
        screens.set_layout({display_->framebuffer_size(), 1});
        return screens;
    }

    Picture show(const Screens& screens, const std::string& name) {
        draw_world(busy(display_->size()));
        Canvas canvas(letters_);
        canvas.begin(screens.layout());
        draw_screens(canvas, screens, 0);
        return finish(canvas, name);
    }

    std::unique_ptr<view::Display> display_;
    std::unique_ptr<view::Renderer> renderer_;
    std::optional<view::OrthoPass> pass_;
    view::Letters letters_;
};

TEST_P(Pictures, of_the_display_have_it_as_large_on_4k_as_at_800_by_600) {
    const Plan level = plan();
    pass_->set_picture(level.picture);
    double first = 0;
    for (const ivec2 size : {ivec2(800, 600), ivec2(2880, 2160)}) {
        display_->resize(size);
        const HudView hud = busy(size);
        draw_world(hud);
        const Picture bare = view::read_picture(display_->framebuffer(), size);
        Canvas canvas(letters_);
        canvas.begin({size, 1});
        draw_hud(canvas, hud, &level, {});
        EXPECT_LT(canvas.items().size(), 400U);
        const double share = double(differing(bare, finish(canvas, "hud"))) / (double(size.x) * size.y);
        EXPECT_GT(share, 0.05);
        if (first > 0) {
            EXPECT_NEAR(share / first, 1, 0.08);
        }
        first = share;
    }
}

TEST_P(Pictures, of_the_display_leave_the_hero_as_he_was_drawn) {
    const Plan level = plan();
    pass_->set_picture(level.picture);
    const HudView hud = busy({800, 600});
    draw_world(hud);
    const Picture bare = view::read_picture(display_->framebuffer(), {800, 600});
    Canvas canvas(letters_);
    canvas.begin({{800, 600}, 1});
    draw_hud(canvas, hud, &level, {});
    const Picture with = finish(canvas, "hero");
    const view::Rect hero = hero_box(hud, {800, 600});
    for (int y = static_cast<int>(hero.low.y); y < static_cast<int>(hero.high.y); ++y)
        for (int x = static_cast<int>(hero.low.x); x < static_cast<int>(hero.high.x); ++x)
            ASSERT_EQ(bare.at(x, y).r, with.at(x, y).r) << x << ", " << y;
}

TEST_P(Pictures, of_every_screen_show_something_of_their_own) {
    std::vector<std::pair<std::string, Screens>> all;
    const auto add = [&](const std::string& name, const Screens& screens) { all.emplace_back(name, screens); };
    const auto press = [](Screens& screens, std::initializer_list<Key> keys) {
        for (const Key key : keys) screens.event(view::KeyPress{.key = key});
    };
    Screens screens = some_screens();
    add("title", screens);
    press(screens, {Key::down, Key::enter});
    add("levels", screens);
    press(screens, {Key::enter});
    add("level", screens);
    press(screens, {Key::escape, Key::escape, Key::down, Key::enter});
    press(screens, {Key::down, Key::down, Key::down});
    add("options", screens);
    press(screens, {Key::up, Key::up, Key::up, Key::enter});
    press(screens, {Key::down, Key::down, Key::down, Key::down});
    add("bindings", screens);
    press(screens, {Key::escape, Key::escape, Key::down, Key::enter});
    add("help", screens);
    press(screens, {Key::escape, Key::down, Key::enter});
    add("credits", screens);
    press(screens, {Key::escape, Key::escape});
    add("quit", screens);
    screens.begin_level("Rope Bridge");
    screens.pause();
    add("pause", screens);
    screens.show_win({.seconds = 99.87,
                      .best_before = 121.5,
                      .medal = Medal::gold,
                      .coins = 38,
                      .coins_all = 40,
                      .stars = 3,
                      .deaths = 1});
    add("win", screens);
    screens.show_lose({.why = "You fell out of the level.", .section = "The long bridge"});
    add("lose", screens);
    screens.show_replay_end();
    add("replay_end", screens);
    screens.begin_level("Rope Bridge");
    screens.show_getting_ready();
    add("getting_ready", screens);
    screens.begin_level("Rope Bridge");
    EXPECT_TRUE(screens.ask({.id = "asked",
                             .title = "Before you play",
                             .words = {"We test the game and not you."},
                             .fields = {{.label = "Your letter", .text = "B"},
                                        {.kind = FormField::Kind::choice,
                                         .label = "You play games",
                                         .choices = {"never", "sometimes", "often"}}}}));
    add("form", screens);
    screens.open_title();
    screens.show_trouble(
        "castle.glb cannot be played",
        "levels/castle.glb: it has 0 nodes of kind 'goal', and needs one: an empty node where the level "
        "ends. " +
            std::string(90, 'x') + " is a word that fits on no line.");
    add("trouble", screens);
    ASSERT_EQ(all.size(), static_cast<std::size_t>(ScreenId::count));
    std::vector<Picture> pictures;
    for (const auto& [name, one] : all) {
        pictures.push_back(show(one, name));
        for (std::size_t i = 0; i + 1 < pictures.size(); ++i)
            EXPECT_GT(differing(pictures[i], pictures.back()), 1500U) << name << " and " << all[i].first;
    }
}

TEST_P(Pictures, of_screens_at_4k_and_with_large_letters) {
    if (GetParam() == view::GlApi::es) GTEST_SKIP() << "one of them is enough for what is only larger";
    Screens screens = some_screens();
    screens.event(view::KeyPress{.key = Key::down});
    screens.event(view::KeyPress{.key = Key::enter});
    screens.set_layout({{800, 600}, 1.5});
    EXPECT_GT(show(screens, "levels-large").colours(), 100U);
    display_->resize({3840, 2160});
    screens.set_layout({{3840, 2160}, 1});
    EXPECT_GT(show(screens, "levels").colours(), 100U);
    screens.open_title();
    EXPECT_GT(show(screens, "title").colours(), 100U);
}

INSTANTIATE_TEST_SUITE_P(Apis, Pictures, testing::Values(view::GlApi::core, view::GlApi::es),
                         [](const auto& api) { return api.param == view::GlApi::core ? "core" : "es"; });

}  // namespace
}  // namespace surefoot::platformer
