#include "view/letters.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <imgui.h>
#include <iterator>

#define STB_TRUETYPE_IMPLEMENTATION
#define STBTT_STATIC
#include <stb/stb_truetype.h>

namespace surefoot::view {
namespace {

constexpr double outline = 128.0 / 255;  // the value on the outline
constexpr int gap = 1;                   // between patches, so that they do not bleed into each other

/// The sizes that fields are made at: each small one for itself, since letters of few pixels live by their exact place;
/// large ones bend well.
int size_for(double pixels) {
    if (!(pixels > 8)) return 8;
    if (pixels <= 36) return static_cast<int>(pixels + 0.5);
    return pixels <= 80 ? 64 : 112;
}

/// How far around the outline distances are told [texels].
int padding_for(int size) {
    return std::max(3, size / 6);
}

std::vector<std::uint8_t> bytes_of(const char* name) {
    namespace fs = std::filesystem;
    for (const char* folder : {"/usr/share/fonts/truetype/dejavu", "/usr/share/fonts/dejavu-sans-fonts",
                               "/usr/share/fonts/TTF", "/usr/local/share/fonts"}) {
        std::ifstream file(fs::path(folder) / name, std::ios::binary);
        if (file) return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    }
    // The small font that Dear ImGui brings.
    ImFontAtlas atlas;
    atlas.AddFontDefault();
    const auto* const data = static_cast<const std::uint8_t*>(atlas.ConfigData[0].FontData);
    return {data, data + atlas.ConfigData[0].FontDataSize};
}

}  // namespace

struct Letters::Font {
    std::vector<std::uint8_t> bytes;
    stbtt_fontinfo info{};
    double em = 0;  // of one unit of the font

    explicit Font(const char* name) : bytes(bytes_of(name)) {
        stbtt_InitFont(&info, bytes.data(), stbtt_GetFontOffsetForIndex(bytes.data(), 0));
        em = static_cast<double>(stbtt_ScaleForMappingEmToPixels(&info, 1));
    }
};

Letters::Letters() : texels_(std::size_t{side} * side) {
    fonts_[0] = std::make_unique<Font>("DejaVuSans.ttf");
    fonts_[1] = std::make_unique<Font>("DejaVuSans-Bold.ttf");
}

Letters::~Letters() = default;

double Letters::advance(Face face, char32_t letter, char32_t next) const {
    const Font& font = *fonts_[static_cast<std::size_t>(face)];
    int width = 0;
    int bearing = 0;
    stbtt_GetCodepointHMetrics(&font.info, static_cast<int>(letter), &width, &bearing);
    if (next != 0) width += stbtt_GetCodepointKernAdvance(&font.info, static_cast<int>(letter), static_cast<int>(next));
    return width * font.em;
}

double Letters::capital_height(Face face) const {
    const Font& font = *fonts_[static_cast<std::size_t>(face)];
    int x0 = 0;
    int y0 = 0;
    int x1 = 0;
    int y1 = 0;
    stbtt_GetCodepointBox(&font.info, 'H', &x0, &y0, &x1, &y1);
    return y1 * font.em;
}

Glyph Letters::glyph(Face face, char32_t letter, double pixels) {
    const int size = size_for(pixels);
    const std::uint64_t name = std::uint64_t{letter} << 16 | static_cast<std::uint64_t>(face) << 8 | unsigned(size);
    const auto found = glyphs_.find(name);
    if (found != glyphs_.end()) return found->second;
    return glyphs_[name] = made_from(*fonts_[static_cast<std::size_t>(face)], letter, size);
}

Glyph Letters::glyph(Sign sign, double pixels) {
    const int size = size_for(pixels);
    const std::uint64_t name = std::uint64_t{1} << 63 | static_cast<std::uint64_t>(sign) << 8 | unsigned(size);
    const auto found = glyphs_.find(name);
    if (found != glyphs_.end()) return found->second;
    return glyphs_[name] = made_from(sign, size);
}

Glyph Letters::made_from(const Font& font, char32_t letter, int size) {
    const int padding = padding_for(size);
    Patch patch;
    int x = 0;
    int y = 0;
    std::uint8_t* const field =
        stbtt_GetCodepointSDF(&font.info, static_cast<float>(font.em * size), static_cast<int>(letter), padding, 128,
                              127.0F / static_cast<float>(padding), &patch.width, &patch.height, &x, &y);
    Glyph glyph;
    if (field == nullptr) return glyph;  // a space
    patch.texels.assign(field, field + static_cast<std::ptrdiff_t>(patch.width) * patch.height);
    stbtt_FreeSDF(field, nullptr);
    if (!place(patch, glyph)) return {};
    glyph.low = dvec2(x, y) / double(size);
    glyph.high = dvec2(x + patch.width, y + patch.height) / double(size);
    glyph.reach = 255.0 / 127 * padding / size;
    return glyph;
}

Glyph Letters::made_from(Sign sign, int size) {
    const int padding = padding_for(size);
    Patch patch;
    patch.width = patch.height = size + 2 * padding;
    for (int y = 0; y < patch.height; ++y) {
        for (int x = 0; x < patch.width; ++x) {
            const dvec2 at = (dvec2(x + 0.5, y + 0.5) - double(padding)) * (2.0 / size) - 1.0;
            const double texels = distance_to(sign, at) * size / 2;
            const double value = outline * 255 - texels * 127 / padding;
            patch.texels.push_back(static_cast<std::uint8_t>(std::clamp(value, 0.0, 255.0) + 0.5));
        }
    }
    Glyph glyph;
    if (!place(patch, glyph)) return {};
    const double half = 0.5 + double(padding) / size;
    glyph.low = dvec2(-half);
    glyph.high = dvec2(half);
    glyph.reach = 255.0 / 127 * padding / size;
    return glyph;
}

bool Letters::place(const Patch& patch, Glyph& glyph) {
    if (pen_ + patch.width + gap > side) {
        shelf_ += shelf_height_ + gap;
        shelf_height_ = 0;
        pen_ = 0;
    }
    if (shelf_ + patch.height + gap > side) {
        full_ = true;
        return false;
    }
    for (int y = 0; y < patch.height; ++y)
        std::memcpy(texels_.data() + static_cast<std::ptrdiff_t>(shelf_ + y) * side + pen_,
                    patch.texels.data() + static_cast<std::ptrdiff_t>(y) * patch.width,
                    static_cast<std::size_t>(patch.width));
    glyph.texel_low = dvec2(pen_, shelf_) / double(side);
    glyph.texel_high = dvec2(pen_ + patch.width, shelf_ + patch.height) / double(side);
    pen_ += patch.width + gap;
    shelf_height_ = std::max(shelf_height_, patch.height);
    ++version_;
    return true;
}

void Letters::next_frame() {
    if (!full_) return;
    glyphs_.clear();
    std::fill(texels_.begin(), texels_.end(), std::uint8_t{0});
    pen_ = shelf_ = shelf_height_ = 0;
    full_ = false;
    ++version_;
}

char32_t take_letter(std::string_view& text) {
    const auto first = static_cast<unsigned char>(text.front());
    text.remove_prefix(1);
    if (first < 0x80) return first;
    const int more = first >= 0xF0 && first < 0xF5   ? 3
                     : first >= 0xE0 && first < 0xF0 ? 2
                     : first >= 0xC2 && first < 0xE0 ? 1
                                                     : 0;
    if (more == 0) return 0xFFFD;
    char32_t letter = first & (0x3FU >> more);
    for (int i = 0; i < more; ++i) {
        if (text.empty() || (static_cast<unsigned char>(text.front()) & 0xC0U) != 0x80) return 0xFFFD;
        letter = letter << 6 | (static_cast<unsigned char>(text.front()) & 0x3FU);
        text.remove_prefix(1);
    }
    return letter;
}

}  // namespace surefoot::view
