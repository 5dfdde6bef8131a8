// The bar of the Debugger's panels, with two panels that only count what is asked of them.
#include "playground/debugger_room/panel_bar.hpp"

#include <gtest/gtest.h>

#include "debugger/worlds.hpp"
#include "view/gl.hpp"
#include "view/imgui_adapter.hpp"
#include "view/widgets.hpp"

namespace surefoot::playground {
namespace {

struct Counts {
    int changed = 0;
    int shown = 0;
};

class Counter final : public Panel {
public:
    Counter(std::string_view name, Counts& counts) : name_(name), counts_(counts) {}
    [[nodiscard]] std::string_view name() const override { return name_; }
    void changed(const Inquiry& /*inquiry*/) override { ++counts_.changed; }
    void draw(view::Renderer& /*renderer*/, const Inquiry& /*inquiry*/) override {}
    void ui(Inquiry& inquiry) override {
        ++counts_.shown;
        inquiry.t = 0.25;
    }

private:
    std::string_view name_;
    Counts& counts_;
};

class PanelBarTest : public testing::Test {
protected:
    PanelBarTest() {
        std::vector<std::unique_ptr<Panel>> panels;
        panels.push_back(std::make_unique<Counter>("First", first_));
        panels.push_back(std::make_unique<Counter>("Second", second_));
        bar_.emplace(std::move(panels));
        frame();
        frame();
    }

    bool frame() {
        imgui_.begin_frame(1.0 / 60);
        const bool other = bar_->ui(inquiry_, 80);
        imgui_.end_frame();
        imgui_.paint();
        return other;
    }

    /// True if the bar told of another panel.
    bool click(const char* label) {
        const auto at = view::ui::find_item(label);
        EXPECT_TRUE(at) << label;
        if (!at) return false;
        bool other = false;
        const auto send = [&](const view::InputEvent& event) {
            static_cast<void>(imgui_.event(event));
            other = frame() || other;
        };
        send(view::PointerMove{*at, {0, 0}, {}});
        send(view::PointerMove{*at, {0, 0}, {}});
        send(view::ButtonPress{view::MouseButton::left, true, *at, {}});
        send(view::ButtonPress{view::MouseButton::left, false, *at, {}});
        return frame() || other;
    }

    std::unique_ptr<view::Display> display_ = std::move(*view::Display::open({.size = {800, 600}, .headless = true}));
    view::ImGuiAdapter imgui_{*display_};
    debugger::Question question_ = debugger::default_question(debugger::WorldKind::triangle);
    debugger::Arena arena_{question_.triangles};
    std::optional<Hit> hit_ = arena_.sweep(question_.volume(), question_.motion);
    Inquiry inquiry_{question_, arena_, hit_};
    Counts first_;
    Counts second_;
    std::optional<PanelBar> bar_;
};

TEST_F(PanelBarTest, nothing_is_open_at_first_and_nothing_is_computed) {
    bar_->changed(inquiry_);
    frame();
    EXPECT_EQ(bar_->open(), nullptr);
    EXPECT_EQ(first_.changed + second_.changed + first_.shown + second_.shown, 0);
}

TEST_F(PanelBarTest, a_toggle_opens_its_panel_closes_the_other_and_closes_its_own) {
    EXPECT_TRUE(click("First"));
    ASSERT_NE(bar_->open(), nullptr);
    EXPECT_EQ(bar_->open()->name(), "First");
    EXPECT_EQ(inquiry_.t, 0.25);
    EXPECT_TRUE(click("Second"));
    EXPECT_EQ(bar_->open()->name(), "Second");
    EXPECT_TRUE(click("Second"));
    EXPECT_EQ(bar_->open(), nullptr);
}

TEST_F(PanelBarTest, a_panel_is_told_of_a_change_once_when_it_is_open_or_opens) {
    click("First");
    EXPECT_EQ(first_.changed, 1);
    bar_->changed(inquiry_);
    bar_->changed(inquiry_);
    EXPECT_EQ(first_.changed, 3);
    EXPECT_EQ(second_.changed, 0);
    click("Second");
    EXPECT_EQ(second_.changed, 1);
    click("First");
    EXPECT_EQ(first_.changed, 3) << "nothing has changed since";
}

}  // namespace
}  // namespace surefoot::playground
