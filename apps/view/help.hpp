/// What F1 shows: which keys do what.
#pragma once

#include <span>
#include <string_view>

namespace surefoot::view {

struct KeyHelp {
    std::string_view keys;  ///< "Right drag"
    std::string_view does;  ///< "moves the camera sideways"
};

struct HelpPage {
    std::string_view title;
    std::span<const KeyHelp> lines;
};

/// Draws the pages over everything; false once the user has read enough.
[[nodiscard]] bool draw_help(std::span<const HelpPage> pages, std::string_view footer);

}  // namespace surefoot::view
