/// A contact sheet: many pictures on one, small, each with a line that says what is seen.
#pragma once

#include <span>
#include <string>

#include "view/picture.hpp"

namespace surefoot::view {

/// How wide a picture is on a contact sheet [pixels].
inline constexpr int thumbnail_width = 420;

struct CaptionedPicture {
    Picture picture;
    std::string caption;
};

/// The same picture `thumbnail_width` wide; one that is narrower stays as it is.
[[nodiscard]] Picture thumbnail(const Picture& picture);

/// Lays thumbnails out in rows of three, in their order. The letters are those of the widgets, so an ImGuiAdapter has
/// to be there. Without pictures it is empty.
[[nodiscard]] Picture contact_sheet(std::span<const CaptionedPicture> pictures);

}  // namespace surefoot::view
