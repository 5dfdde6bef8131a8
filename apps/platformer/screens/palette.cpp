#include "platformer/screens/palette.hpp"

#include <algorithm>
#include <array>

namespace surefoot::platformer {
namespace {

using view::rgb;

constexpr std::size_t visions = static_cast<std::size_t>(ColourVision::count);
constexpr std::array<std::string_view, visions> labels{"Usual", "Red and green alike", "Blue and yellow alike",
                                                       "High contrast"};
constexpr std::array<std::string_view, visions> words{"usual", "red_green", "blue_yellow", "contrast"};

constexpr Palette usual{.ink = rgb(0x141B22),
                        .paper = rgb(0xF4F6F8),
                        .quiet = rgb(0xA9B7C4),
                        .accent = rgb(0x4FD1B8),
                        .health = rgb(0xF2545B),
                        .coin = rgb(0xFFC93C),
                        .star = rgb(0xFFE98A),
                        .goal = rgb(0x5CE06E),
                        .checkpoint = rgb(0x58B6FF),
                        .key = rgb(0xE59BFF),
                        .danger = rgb(0xFF5A4F),
                        .gold = rgb(0xFFD24A),
                        .silver = rgb(0xCBD5DF),
                        .bronze = rgb(0xD9905A)};

// Blue against orange and yellow, apart in lightness too: what eyes without a red or green cone tell best.
constexpr Palette red_green{.ink = usual.ink,
                            .paper = usual.paper,
                            .quiet = usual.quiet,
                            .accent = rgb(0x6CB8FF),
                            .health = rgb(0xFF9F40),
                            .coin = rgb(0xFFE14D),
                            .star = rgb(0xFFF6C2),
                            .goal = rgb(0x3D9BFF),
                            .checkpoint = rgb(0x9FD3FF),
                            .key = rgb(0xF4F6F8),
                            .danger = rgb(0xFF8A1F),
                            .gold = rgb(0xFFDD55),
                            .silver = rgb(0xCBD5DF),
                            .bronze = rgb(0xB5651D)};

// Red against blue-green, apart in lightness too, for eyes without a blue cone.
constexpr Palette blue_yellow{.ink = usual.ink,
                              .paper = usual.paper,
                              .quiet = usual.quiet,
                              .accent = rgb(0x35D0C0),
                              .health = rgb(0xFF4F6A),
                              .coin = rgb(0xFFB3C0),
                              .star = rgb(0xFFE3E8),
                              .goal = rgb(0x20C9B0),
                              .checkpoint = rgb(0xA5F0E6),
                              .key = rgb(0xF4F6F8),
                              .danger = rgb(0xFF3348),
                              .gold = rgb(0xFFC4CC),
                              .silver = rgb(0xC4CFD2),
                              .bronze = rgb(0xB0505F)};

constexpr Palette contrast{.ink = rgb(0x000000),
                           .paper = rgb(0xFFFFFF),
                           .quiet = rgb(0xE0E0E0),
                           .accent = rgb(0xFFFF00),
                           .health = rgb(0xFF6070),
                           .coin = rgb(0xFFFF00),
                           .star = rgb(0xFFFFFF),
                           .goal = rgb(0x00FF66),
                           .checkpoint = rgb(0x66CCFF),
                           .key = rgb(0xFF99FF),
                           .danger = rgb(0xFF7A00),
                           .gold = rgb(0xFFE000),
                           .silver = rgb(0xFFFFFF),
                           .bronze = rgb(0xFFA060)};

}  // namespace

std::string_view label_of(ColourVision vision) {
    return labels[static_cast<std::size_t>(vision)];
}

std::string_view word_of(ColourVision vision) {
    return words[static_cast<std::size_t>(vision)];
}

ColourVision colour_vision_named(std::string_view word) {
    const auto found = std::find(words.begin(), words.end(), word);
    return found == words.end() ? ColourVision::usual : static_cast<ColourVision>(found - words.begin());
}

view::Colour key_colour(std::string_view door, ColourVision vision) {
    constexpr std::size_t known = 6;
    constexpr std::array<std::string_view, known> names{"red", "blue", "green", "yellow", "violet", "white"};
    using Colours = std::array<view::Colour, known>;
    constexpr std::array<Colours, visions> colours{
        Colours{rgb(0xF0463A), rgb(0x3E8CFF), rgb(0x49C75A), rgb(0xF7CC2E), rgb(0xB07BFF), rgb(0xF3EFE6)},
        // Without red or green: from dark to light along orange and blue.
        Colours{rgb(0xE06A00), rgb(0x2F7DFF), rgb(0xBFE3FF), rgb(0xFFE45C), rgb(0x7A5CFF), rgb(0xFFFFFF)},
        // Without blue: from dark to light along red and blue-green.
        Colours{rgb(0xF0283C), rgb(0x12B5A6), rgb(0xA8F0DC), rgb(0xFFC4CC), rgb(0xA03A5A), rgb(0xFFFFFF)},
        Colours{rgb(0xFF5A50), rgb(0x66CCFF), rgb(0x00FF66), rgb(0xFFFF00), rgb(0xFF99FF), rgb(0xFFFFFF)}};
    const auto found = std::ranges::find(names, door);
    std::size_t which = std::size_t(found - names.begin());
    if (found == names.end()) {
        std::uint32_t sum = 0;
        for (const char letter : door) sum = sum * 31 + static_cast<unsigned char>(letter);
        which = sum % known;
    }
    return colours[static_cast<std::size_t>(vision)][which];
}

std::string key_sign(std::string_view door) {
    if (door.empty()) return {};
    const char first = door.front();
    return {first >= 'a' && first <= 'z' ? char(first - 'a' + 'A') : first};
}

const Palette& palette_for(ColourVision vision) {
    switch (vision) {
        case ColourVision::red_green:
            return red_green;
        case ColourVision::blue_yellow:
            return blue_yellow;
        case ColourVision::contrast:
            return contrast;
        case ColourVision::usual:
        case ColourVision::count:
            break;
    }
    return usual;
}

}  // namespace surefoot::platformer
