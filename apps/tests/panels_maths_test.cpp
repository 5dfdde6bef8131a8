// The panels Mathematics, Strategies and Search, each in a small room of its own and without a display. Where
// SUREFOOT_PICTURES names a folder the pictures are kept there.
#include "playground/debugger_room/panels_maths.hpp"

#include <cstdlib>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "debugger/worlds.hpp"
#include "view/gl.hpp"
#include "view/imgui_adapter.hpp"
#include "view/model.hpp"
#include "view/orbit_camera.hpp"
#include "view/picture.hpp"
#include "view/text.hpp"
#include "view/widgets.hpp"

namespace surefoot::playground {
namespace {

using debugger::Question;
using debugger::WorldKind;
using view::dvec2;
using view::ivec2;

std::shared_ptr<view::Model> model_of(const std::vector<Triangle>& triangles) {
    std::vector<vec3> vertices;
    std::vector<std::uint32_t> indices;
    for (const Triangle& t : triangles) {
        for (const dvec3& corner : {t.a, t.b, t.c}) {
            indices.push_back(static_cast<std::uint32_t>(vertices.size()));
            vertices.push_back(vec3(corner));
        }
    }
    return view::Model::make(*Mesh::build({.vertices = vertices, .indices = indices}));
}

/// One panel and what is around it in the Debugger room.
class Studio {
public:
    Studio(std::unique_ptr<Panel> panel, const Question& question, const ivec2& size = ivec2(1280, 720))
        : Studio(std::move(panel), question, debugger::Arena(question.triangles), size) {
        model_ = model_of(question_.triangles);
    }
    Studio(std::unique_ptr<Panel> panel, const Question& question, const Mesh& level,
           const ivec2& size = ivec2(1280, 720))
        : Studio(std::move(panel), question, debugger::Arena(level), size) {
        model_ = view::Model::make(level);
    }
    ~Studio() { EXPECT_EQ(view::gl::take_error(), ""); }
    Studio(const Studio&) = delete;
    Studio& operator=(const Studio&) = delete;

    void frames(int count) {
        for (int i = 0; i < count; ++i) frame();
    }

    void move(const dvec2& at) {
        imgui_->event(view::PointerMove{.at = at});
        frames(2);
    }
    void press(const dvec2& at, bool down) {
        imgui_->event(view::ButtonPress{.button = view::MouseButton::left, .down = down, .at = at});
        frames(2);
    }
    void click(const char* label) {
        frames(2);
        const auto at = view::ui::find_item(label);
        ASSERT_TRUE(at) << label << " is not among " << view::ui::known_items();
        move(*at);
        press(*at, true);
        press(*at, false);
    }

    view::Picture photo(const std::string& name = {}) {
        frames(3);
        const auto picture = view::read_picture(display_->framebuffer(), display_->framebuffer_size());
        const char* const folder = std::getenv("SUREFOOT_PICTURES");
        if (folder != nullptr && !name.empty()) {
            const auto kept = view::write_png(picture, std::string(folder) + "/" + name + ".png");
            EXPECT_TRUE(kept) << kept.error().text;
        }
        return picture;
    }

    Inquiry& inquiry() { return *inquiry_; }
    Panel& panel() { return *panel_; }
    const view::Renderer& renderer() const { return *renderer_; }
    view::OrbitCamera camera;

private:
    Studio(std::unique_ptr<Panel> panel, const Question& question, debugger::Arena arena, const ivec2& size)
        : question_(question),
          arena_(std::move(arena)),
          display_(std::move(*view::Display::open({.size = size, .headless = true}))),
          renderer_(std::make_unique<view::Renderer>()),
          imgui_(std::make_unique<view::ImGuiAdapter>(*display_)),
          panel_(std::move(panel)) {
        hit_ = arena_.sweep(question_.volume(), question_.motion, question_.one_sided);
        inquiry_.emplace(Inquiry{question_, arena_, hit_, hit_ ? hit_->t : 1});
        panel_->changed(*inquiry_);
        const Motion& motion = question_.motion;
        view::OrbitCamera::Stand stand{.pivot = (motion.from + motion.to) * 0.5, .yaw = 0.35, .pitch = 0.42};
        stand.distance = 2.1 * glm::length(motion.to - motion.from) + 3;
        camera.jump_to(stand);
        if (const auto places = panel_->scene_places(); !places.empty()) {
            camera.frame(places, {{0, 0}, dvec2(size)}, size);
            camera.arrive();
            stand = camera.stand();
        }
        // What is looked at stands in the middle of what the panel leaves free.
        const view::Camera seen = camera.camera();
        stand.pivot += seen.right() * (seen.unit_at(stand.distance, display_->size()) * 215);
        camera.jump_to(stand);
    }

    void frame() {
        static_cast<void>(panel_->update(1.0 / 60, *inquiry_));
        imgui_->begin_frame(1.0 / 60);
        renderer_->begin({camera.camera(), display_->size(), display_->framebuffer_size()});
        renderer_->model(model_, {.edges = {.width = 1}});
        const Volume volume = question_.volume();
        const Motion& motion = question_.motion;
        renderer_->shape(volume, motion.from, {.colour = view::paint::start});
        renderer_->shape(volume, motion.to, {.colour = view::paint::end});
        if (hit_)
            renderer_->shape(volume, motion.from + (motion.to - motion.from) * hit_->t, {.colour = view::paint::hit});
        renderer_->arrow(motion.from, motion.to, {});
        panel_->draw(*renderer_, *inquiry_);
        renderer_->end(display_->framebuffer());
        view::draw_labels(renderer_->view(), renderer_->labels());
        const std::string title(panel_->name());
        const double high = display_->size().y - 28;
        if (view::ui::begin(title.c_str(),
                            {.corner = view::ui::Panel::Corner::upper_right, .width = 430, .most_height = high}))
            panel_->ui(*inquiry_);
        view::ui::end();
        glBindFramebuffer(GL_FRAMEBUFFER, display_->framebuffer());
        glViewport(0, 0, display_->framebuffer_size().x, display_->framebuffer_size().y);
        imgui_->end_frame();
        imgui_->paint();
    }

    Question question_;
    debugger::Arena arena_;
    std::unique_ptr<view::Display> display_;
    std::shared_ptr<view::Model> model_;  // after the display, whose context it needs to go
    std::unique_ptr<view::Renderer> renderer_;
    std::unique_ptr<view::ImGuiAdapter> imgui_;
    std::unique_ptr<Panel> panel_;
    std::optional<Hit> hit_;
    std::optional<Inquiry> inquiry_;
};

bool same(const view::Picture& a, const view::Picture& b) {
    return std::equal(a.pixels.begin(), a.pixels.end(), b.pixels.begin(), b.pixels.end(),
                      [](auto x, auto y) { return x.r == y.r && x.g == y.g && x.b == y.b; });
}

Mesh hills() {
    constexpr std::uint32_t side = 40;
    std::vector<vec3> vertices;
    std::vector<std::uint32_t> indices;
    for (std::uint32_t row = 0; row <= side; ++row)
        for (std::uint32_t column = 0; column <= side; ++column)
            vertices.push_back({float(column), float((row * 7 + column * 11) % 13) * 0.09F, float(row)});
    for (std::uint32_t row = 0; row < side; ++row) {
        for (std::uint32_t column = 0; column < side; ++column) {
            const std::uint32_t a = row * (side + 1) + column;
            const std::uint32_t c = a + side + 1;
            for (const std::uint32_t index : {a, c, a + 1, a + 1, c, c + 1}) indices.push_back(index);
        }
    }
    return *Mesh::build({.vertices = vertices, .indices = indices});
}

Question over_the_hills() {
    Question q;
    q.world = WorldKind::level;
    q.sizes.ellipsoid.radii = {0.4, 0.9, 0.4};
    q.motion = {{9.3, 5, 12.1}, {25.2, 0.2, 21.7}};
    return q;
}

TEST(MathematicsPanel, shows_the_squashed_world_and_scrubs_t_by_dragging_on_the_graph) {
    Studio studio(make_mathematics_panel(), debugger::default_question(WorldKind::triangle));
    const view::Picture before = studio.photo("mathematics");
    EXPECT_GT(before.colours(), 500U);
    const auto graph = view::ui::find_item("Graph of g(t)");
    ASSERT_TRUE(graph);
    studio.move(*graph);
    studio.press(*graph, true);
    studio.move(*graph - dvec2(60, 0));
    const double early = studio.inquiry().t;
    studio.move(*graph + dvec2(2000, 0));
    EXPECT_EQ(studio.inquiry().t, 1);
    studio.press(*graph, false);
    EXPECT_GT(early, 0.1);
    EXPECT_LT(early, 0.5);
}

TEST(MathematicsPanel, a_row_lights_its_feature_in_both_worlds_while_it_is_pointed_at_or_pinned) {
    for (const char* const row : {"edge ca", "interior", "vertex b"}) {
        Studio studio(make_mathematics_panel(), debugger::default_question(WorldKind::triangle));
        const auto seen = [&] {
            const view::FrameCounts& counts = studio.renderer().counts();
            return std::pair(counts.shapes, counts.lines);
        };
        const dvec2 away(5, 5);
        studio.move(away);
        studio.frames(1);
        const auto dark = seen();
        const auto place = view::ui::find_item(row);
        ASSERT_TRUE(place) << row;
        studio.move(*place);
        studio.frames(1);
        const auto lit = seen();
        EXPECT_EQ(lit.first, dark.first + (row[0] == 'v' ? 2 : 0)) << row;
        EXPECT_GT(lit.second, dark.second) << row;
        studio.move(away);
        studio.frames(1);
        EXPECT_EQ(seen(), dark) << row;
        studio.click(row);
        studio.move(away);
        studio.photo(std::string("mathematics-") + row[0]);
        EXPECT_EQ(seen(), lit) << row;
        studio.click(row);
        studio.move(away);
        studio.frames(1);
        EXPECT_EQ(seen(), dark) << row;
    }
}

TEST(MathematicsPanel, the_larger_root_moves_the_answer_of_the_table_and_not_the_librarys) {
    Studio studio(make_mathematics_panel(), debugger::default_question(WorldKind::triangle));
    const view::Picture right = studio.photo();
    studio.click("Larger root (wrong on purpose)");
    studio.move({5, 5});
    EXPECT_FALSE(same(right, studio.photo("mathematics-wrong-root")));
    ASSERT_TRUE(studio.inquiry().hit);
    EXPECT_NEAR(studio.inquiry().hit->t, 0.4711, 1e-4);
}

TEST(MathematicsPanel, squashing_plays_back_to_the_world_as_it_is_and_comes_to_rest) {
    Studio studio(make_mathematics_panel(), debugger::default_question(WorldKind::triangle));
    studio.click("Unsquash");
    studio.frames(20);
    EXPECT_TRUE(studio.panel().update(0, studio.inquiry()));
    static_cast<void>(studio.photo("mathematics-half-way"));
    studio.frames(120);
    EXPECT_FALSE(studio.panel().update(0, studio.inquiry()));
    studio.click("Squash");
    EXPECT_TRUE(studio.panel().update(0, studio.inquiry()));
}

TEST(MathematicsPanel, of_a_box_is_a_table_of_planes_and_there_is_no_world_beside) {
    Question q = debugger::default_question(WorldKind::wedge);
    q.shape = debugger::ShapeName::box;
    Studio studio(make_mathematics_panel(), q);
    EXPECT_TRUE(studio.panel().scene_places().empty());
    studio.click("face");
    studio.move({5, 5});
    static_cast<void>(studio.photo("mathematics-box"));
}

TEST(MathematicsPanel, fits_a_small_window) {
    Studio small(make_mathematics_panel(), debugger::default_question(WorldKind::fold), ivec2(800, 600));
    static_cast<void>(small.photo("mathematics-small"));
}

TEST(MathematicsPanel, of_a_level_is_about_the_triangle_that_was_hit) {
    Studio studio(make_mathematics_panel(), over_the_hills(), hills());
    static_cast<void>(studio.photo("mathematics-level"));
    EXPECT_TRUE(view::ui::find_item("Triangle"));
}

TEST(MathematicsPanel, says_why_there_is_nothing_to_take_apart) {
    Question q = debugger::default_question(WorldKind::triangle);
    q.sizes.ellipsoid.radii.x = 0;
    const debugger::Arena arena(q.triangles);
    const std::optional<Hit> none;
    Studio studio(make_mathematics_panel(), debugger::default_question(WorldKind::triangle));
    Inquiry refused{q, arena, none};
    for (const auto& make : {make_mathematics_panel, make_strategies_panel, make_search_panel}) {
        const auto panel = make();
        panel->changed(refused);
        EXPECT_FALSE(panel->update(1, refused));
    }
}

TEST(StrategiesPanel, shows_tunnelling_at_few_frames_a_second_and_none_at_many) {
    Studio studio(make_strategies_panel(), debugger::default_question(WorldKind::triangle));
    const view::Picture tunnelled = studio.photo("strategies");
    const std::size_t few = studio.renderer().counts().shapes;
    const auto rate = view::ui::find_item("Frames a second");
    ASSERT_TRUE(rate);
    studio.move(*rate);
    studio.press(*rate, true);
    studio.press(*rate, false);
    EXPECT_FALSE(same(tunnelled, studio.photo("strategies-finer")));
    EXPECT_GT(studio.renderer().counts().shapes, few);
}

TEST(StrategiesPanel, fits_a_small_window) {
    Studio studio(make_strategies_panel(), debugger::default_question(WorldKind::wedge), ivec2(800, 600));
    EXPECT_GT(studio.photo("strategies-small").colours(), 500U);
}

TEST(SearchPanel, steps_through_what_was_asked_of_a_level_and_compares_three_ways) {
    Studio studio(make_search_panel(), over_the_hills(), hills());
    studio.frames(30);
    const view::Picture all = studio.photo("search");
    const std::size_t lines = studio.renderer().counts().lines;
    const auto slider = view::ui::find_item("Step");
    ASSERT_TRUE(slider);
    studio.move(*slider);
    studio.press(*slider, true);
    studio.press(*slider, false);
    EXPECT_FALSE(same(all, studio.photo("search-half-way")));
    EXPECT_LT(studio.renderer().counts().lines, lines);
    EXPECT_FALSE(studio.panel().update(0, studio.inquiry()));
    studio.click("Play");
    EXPECT_TRUE(studio.panel().update(0, studio.inquiry()));
}

TEST(SearchPanel, of_a_few_triangles_lists_them) {
    Studio studio(make_search_panel(), debugger::default_question(WorldKind::wedge), ivec2(800, 600));
    EXPECT_GT(studio.photo("search-few").colours(), 500U);
    EXPECT_FALSE(studio.panel().update(1, studio.inquiry())) << "there is nothing to compare";
}

}  // namespace
}  // namespace surefoot::playground
