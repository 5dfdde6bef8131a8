// The playground without a display, small, in a room: what tests of the whole program begin with.
#pragma once

#include <gtest/gtest.h>
#include <memory>
#include <string>
#include <utility>

#include "playground/app.hpp"

namespace surefoot::playground {

inline std::unique_ptr<App> open(const std::string& room, const std::string& level = {},
                                 const std::string& sheet = {}) {
    Options options;
    options.headless = true;
    options.room = room;
    options.level = level;
    options.contact_sheet = sheet;
    options.size = view::ivec2(640, 400);
    options.frames = 100000;
    auto app = App::open(options);
    EXPECT_TRUE(app) << app.error().text;
    return app ? std::move(*app) : nullptr;
}

}  // namespace surefoot::playground
