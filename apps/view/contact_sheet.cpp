#include "view/contact_sheet.hpp"

#include <algorithm>
#include <cmath>
#include <imgui.h>

#include "view/fonts.hpp"

namespace surefoot::view {
namespace {

constexpr int columns = 3;
constexpr int gap = 18;
constexpr int writing_size = 15;  // [pixels]

Colour& pixel(Picture& picture, int x, int y) {
    return picture
        .pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.size.x) + static_cast<std::size_t>(x)];
}

std::uint8_t byte(double value) {
    return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 255.0)));
}

/// The mean colour of a rectangle of the picture whose sides lie between pixels.
Colour mean(const Picture& picture, const dvec2& low, const dvec2& high) {
    double sums[3] = {0, 0, 0};
    double weight = 0;
    for (int y = static_cast<int>(low.y); y < picture.size.y && y < high.y; ++y)
        for (int x = static_cast<int>(low.x); x < picture.size.x && x < high.x; ++x) {
            const double share = (std::min(high.x, x + 1.0) - std::max(low.x, double(x))) *
                                 (std::min(high.y, y + 1.0) - std::max(low.y, double(y)));
            const Colour& c = picture.at(x, y);
            sums[0] += share * c.r;
            sums[1] += share * c.g;
            sums[2] += share * c.b;
            weight += share;
        }
    return {byte(sums[0] / weight), byte(sums[1] / weight), byte(sums[2] / weight), 255};
}

/// The letters that the widgets are drawn with, as coverage.
class Letters {
public:
    Letters() : font_(*fonts().plain) {
        int bytes = 0;
        ImGui::GetIO().Fonts->GetTexDataAsAlpha8(&cover_, &width_, &height_, &bytes);
    }

    /// Writes one line from `x` on and cuts off, with dots, what does not fit into `room`.
    void write(Picture& picture, int x, int y, int room, const std::string& text) const {
        const float scale = float(writing_size) / font_.FontSize;
        const std::string dots = " ...";
        const auto wide = [&](const std::string& line) {
            return font_.CalcTextSizeA(float(writing_size), 1e6F, 0, line.c_str()).x;
        };
        std::string line = text;
        while (!line.empty() && wide(line == text ? line : line + dots) > float(room)) {
            // A letter may be several bytes; all but its first begin with the bits 10.
            while (!line.empty() && (static_cast<unsigned char>(line.back()) & 0xC0U) == 0x80U) line.pop_back();
            if (!line.empty()) line.pop_back();
        }
        if (line != text) line += dots;
        float pen = static_cast<float>(x);
        for (const char* at = line.c_str(); *at != '\0';) {
            unsigned letter = 0;
            at += code_point(at, letter);
            const ImFontGlyph* const glyph = font_.FindGlyph(static_cast<ImWchar>(letter));
            if (glyph == nullptr) continue;
            draw(picture, *glyph, pen, static_cast<float>(y), scale);
            pen += glyph->AdvanceX * scale;
        }
    }

private:
    /// One letter of UTF-8, and how many bytes it took.
    static int code_point(const char* at, unsigned& letter) {
        const auto byte_at = [&](int i) { return static_cast<unsigned>(static_cast<unsigned char>(at[i])); };
        const unsigned first = byte_at(0);
        const int more = first >= 0xF0 ? 3 : first >= 0xE0 ? 2 : first >= 0xC0 ? 1 : 0;
        letter = more == 0 ? first : first & (0x3FU >> more);
        for (int i = 1; i <= more; ++i) {
            if ((byte_at(i) & 0xC0U) != 0x80U) return i;
            letter = letter << 6U | (byte_at(i) & 0x3FU);
        }
        return more + 1;
    }

    void draw(Picture& picture, const ImFontGlyph& glyph, float pen, float top, float scale) const {
        const float left = pen + glyph.X0 * scale;
        const float right = pen + glyph.X1 * scale;
        const float upper = top + glyph.Y0 * scale;
        const float lower = top + glyph.Y1 * scale;
        for (int y = static_cast<int>(std::floor(upper)); float(y) < lower; ++y)
            for (int x = static_cast<int>(std::floor(left)); float(x) < right; ++x) {
                if (x < 0 || y < 0 || x >= picture.size.x || y >= picture.size.y) continue;
                // Where the middle of this pixel lies in the glyph, and from there in the atlas.
                const float across = (float(x) + 0.5F - left) / std::max(right - left, 1e-3F);
                const float down = (float(y) + 0.5F - upper) / std::max(lower - upper, 1e-3F);
                if (across < 0 || across > 1 || down < 0 || down > 1) continue;
                const double share = coverage((glyph.U0 + (glyph.U1 - glyph.U0) * across) * float(width_) - 0.5F,
                                              (glyph.V0 + (glyph.V1 - glyph.V0) * down) * float(height_) - 0.5F);
                Colour& c = pixel(picture, x, y);
                c.r = byte(c.r + (paint::ink.r - c.r) * share);
                c.g = byte(c.g + (paint::ink.g - c.g) * share);
                c.b = byte(c.b + (paint::ink.b - c.b) * share);
            }
    }

    /// 0 to 1, between the four pixels around.
    [[nodiscard]] double coverage(float u, float v) const {
        const int x = static_cast<int>(std::floor(u));
        const int y = static_cast<int>(std::floor(v));
        const auto at = [&](int i, int k) {
            return cover_[std::clamp(k, 0, height_ - 1) * width_ + std::clamp(i, 0, width_ - 1)] / 255.0;
        };
        const double fu = u - float(x);
        const double fv = v - float(y);
        return (at(x, y) * (1 - fu) + at(x + 1, y) * fu) * (1 - fv) +
               (at(x, y + 1) * (1 - fu) + at(x + 1, y + 1) * fu) * fv;
    }

    const ImFont& font_;
    unsigned char* cover_ = nullptr;
    int width_ = 0;
    int height_ = 0;
};

}  // namespace

Picture thumbnail(const Picture& picture) {
    if (picture.size.x <= thumbnail_width) return picture;
    const double scale = double(picture.size.x) / thumbnail_width;
    Picture small{{thumbnail_width, std::max(static_cast<int>(picture.size.y / scale), 1)}, {}};
    small.pixels.reserve(static_cast<std::size_t>(small.size.x) * static_cast<std::size_t>(small.size.y));
    for (int y = 0; y < small.size.y; ++y)
        for (int x = 0; x < small.size.x; ++x)
            small.pixels.push_back(mean(picture, dvec2(x, y) * scale, dvec2(x + 1, y + 1) * scale));
    return small;
}

Picture contact_sheet(std::span<const CaptionedPicture> pictures) {
    if (pictures.empty()) return {};
    int tallest = 0;
    for (const CaptionedPicture& p : pictures) tallest = std::max(tallest, p.picture.size.y);
    const int across = std::min(columns, static_cast<int>(pictures.size()));
    const int rows = (static_cast<int>(pictures.size()) + columns - 1) / columns;
    const int row_height = tallest + writing_size + 8 + gap;
    Picture sheet{{gap + across * (thumbnail_width + gap), gap + rows * row_height}, {}};
    sheet.pixels.assign(static_cast<std::size_t>(sheet.size.x) * static_cast<std::size_t>(sheet.size.y), paint::paper);
    const Letters letters;
    for (int i = 0; i < static_cast<int>(pictures.size()); ++i) {
        const auto& [picture, caption] = pictures[static_cast<std::size_t>(i)];
        const int left = gap + i % columns * (thumbnail_width + gap);
        const int top = gap + i / columns * row_height;
        for (int y = 0; y < picture.size.y; ++y)
            for (int x = 0; x < std::min(picture.size.x, thumbnail_width); ++x)
                pixel(sheet, left + x, top + y) = picture.at(x, y);
        letters.write(sheet, left, top + tallest + 5, thumbnail_width, caption);
    }
    return sheet;
}

}  // namespace surefoot::view
