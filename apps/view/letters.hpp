/// Letters and signs as fields of distance to their outline, in one picture that grows as they are asked for. Fields
/// stay crisp at any size, and give outlines and shadows for nothing. No OpenGL here: whoever measures text needs none.
#pragma once

#include <array>
#include <cstdint>
#include <glm/ext/vector_double2.hpp>
#include <memory>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "view/signs.hpp"

namespace surefoot::view {

using glm::dvec2;

enum class Face : std::uint8_t { plain, bold, count };

/// Where a letter or sign is in the picture, and on the page about the pen.
struct Glyph {
    dvec2 low{0, 0};  ///< of its field, from the pen on the line of writing; y downwards [em]
    dvec2 high{0, 0};
    dvec2 texel_low{0, 0};  ///< in the picture [0 to 1]
    dvec2 texel_high{0, 0};
    double reach = 0;  ///< the distance for which the field runs through its whole range [em]; 0: nothing to see
};

class Letters {
public:
    Letters();
    Letters(const Letters&) = delete;
    Letters& operator=(const Letters&) = delete;
    ~Letters();

    /// How far the pen goes on after a letter that is followed by another, or by 0 [em].
    [[nodiscard]] double advance(Face face, char32_t letter, char32_t next = 0) const;

    /// Of capitals, above the line of writing [em].
    [[nodiscard]] double capital_height(Face face) const;

    /// Made for about this many pixels an em. What does not fit any more comes back empty until `next_frame`.
    [[nodiscard]] Glyph glyph(Face face, char32_t letter, double pixels);
    [[nodiscard]] Glyph glyph(Sign sign, double pixels);

    /// Begins the picture anew if it is full: of many sizes, most are those of a window that was another size.
    void next_frame();

    static constexpr int side = 2048;  ///< of the picture [texels]

    /// Distances, row by row from the top: 128 on the outline, more inside.
    [[nodiscard]] const std::vector<std::uint8_t>& texels() const { return texels_; }

    /// Rows of texels that are written, and a number that changes whenever they change.
    [[nodiscard]] int rows() const { return shelf_ + shelf_height_; }
    [[nodiscard]] std::uint64_t version() const { return version_; }

private:
    struct Font;
    struct Patch {
        int width = 0;
        int height = 0;
        std::vector<std::uint8_t> texels;
    };

    [[nodiscard]] Glyph made_from(const Font& font, char32_t letter, int size);
    [[nodiscard]] Glyph made_from(Sign sign, int size);
    [[nodiscard]] bool place(const Patch& patch, Glyph& glyph);

    std::array<std::unique_ptr<Font>, static_cast<std::size_t>(Face::count)> fonts_;
    std::unordered_map<std::uint64_t, Glyph> glyphs_;
    std::vector<std::uint8_t> texels_;
    int pen_ = 0;  // where the next patch goes on the shelf at hand
    int shelf_ = 0;
    int shelf_height_ = 0;
    bool full_ = false;
    std::uint64_t version_ = 1;
};

/// The letters of a text, one after the other; what is not UTF-8 becomes U+FFFD.
[[nodiscard]] char32_t take_letter(std::string_view& text);

}  // namespace surefoot::view
