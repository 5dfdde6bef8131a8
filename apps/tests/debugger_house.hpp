/// The playground with the Debugger open, without a display, and what tests do with it.
#pragma once

#include <filesystem>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <memory>
#include <string>

#include "debugger/question_text.hpp"
#include "debugger/worlds.hpp"
#include "playground/app.hpp"
#include "view/gl.hpp"

namespace surefoot::playground {

struct DebuggerHouse {
    explicit DebuggerHouse(const std::string& level = {}, const view::ivec2& size = {1024, 760}) {
        Options options;
        options.headless = true;
        options.room = "debugger";
        options.level = level;
        options.size = size;
        options.frames = 1000000;
        options.timing = true;        // every frame is drawn, as in a window
        options.preset = "software";  // no shadows: what is drawn is the shapes alone
        auto opened = App::open(options);
        EXPECT_TRUE(opened) << opened.error().text;
        if (opened) app = std::move(*opened);
        play("wait 3");
    }

    void play(const std::string& script) const {
        app->play(*view::parse_script(script + "\nquit", "test"));
        for (int i = 0; i < 2000 && app->frame(); ++i) {
        }
        EXPECT_EQ(app->failure(), "");
    }

    /// As the room itself tells it, by the clipboard.
    [[nodiscard]] debugger::Question question() const {
        play("key Control+C");
        const auto read = debugger::from_line(app->stage().display.clipboard(),
                                              debugger::default_question(debugger::WorldKind::triangle));
        EXPECT_TRUE(read) << app->stage().display.clipboard();
        return read ? *read : debugger::Question{};
    }

    [[nodiscard]] view::Camera camera() const { return app->current().camera(); }

    [[nodiscard]] view::dvec2 on_picture(const dvec3& place) const {
        const auto at = camera().project(place, app->stage().display.size());
        EXPECT_TRUE(at);
        return at ? at->at : view::dvec2(0, 0);
    }

    void click(const dvec3& place) const {
        const auto at = on_picture(place);
        play(fmt::format("click {} {}\nwait 60", at.x, at.y));
    }

    void drag(const view::dvec2& from, const view::dvec2& by) const {
        play(fmt::format("drag {} {} {} {} 8\nwait 60", from.x, from.y, from.x + by.x, from.y + by.y));
    }

    void expect_a_picture() const {
        EXPECT_EQ(view::gl::take_error(), "");
        EXPECT_GT(app->picture().colours(), 500U);
    }

    [[nodiscard]] std::string last_toast() const {
        const auto texts = app->stage().toasts.texts();
        return texts.empty() ? "" : texts.back();
    }

    std::unique_ptr<App> app;
};

}  // namespace surefoot::playground
