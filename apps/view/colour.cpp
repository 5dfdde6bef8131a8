#include "view/colour.hpp"

#include <array>
#include <cctype>
#include <string>

namespace surefoot::view {
namespace {

struct Known {
    std::string_view word;
    Colour colour;
};

// The longer word before the one that it holds.
constexpr std::array<Known, 27> known{
    {{"grass", rgb(0x8FA66B)},   {"moss", rgb(0x7E9663)},  {"leaf", rgb(0x7E9A62)},     {"sand", rgb(0xD6C08F)},
     {"dirt", rgb(0x9C8467)},    {"mud", rgb(0x86705A)},   {"gravel", rgb(0xA8A199)},   {"stone", rgb(0xA9A8A2)},
     {"rock", rgb(0x94908A)},    {"brick", rgb(0xB27A62)}, {"concrete", rgb(0xB5B3AD)}, {"tile", rgb(0xB9B4AA)},
     {"plaster", rgb(0xD9D2C3)}, {"wood", rgb(0xB58E63)},  {"plank", rgb(0xB58E63)},    {"ice", rgb(0xBBDDE8)},
     {"snow", rgb(0xE9EEF2)},    {"water", rgb(0x6FA3BF)}, {"metal", rgb(0x8C98A5)},    {"steel", rgb(0x8C98A5)},
     {"rust", rgb(0xA56E4E)},    {"glass", rgb(0xA9CCD2)}, {"lava", rgb(0xCC5B3A)},     {"carpet", rgb(0x9A6B6B)},
     {"wall", rgb(0xCFC8BA)},    {"floor", rgb(0xB9AE9C)}, {"roof", rgb(0xA0705A)}}};

constexpr std::array<Colour, 10> tints{rgb(0xC2B59B), rgb(0x9DB0A3), rgb(0xB99C88), rgb(0x98A9BD), rgb(0xC4B183),
                                       rgb(0xA89BB3), rgb(0x9CB4B4), rgb(0xB3ACA2), rgb(0xAFB68F), rgb(0xC0A3A3)};

}  // namespace

Colour colour_of_surface(std::uint32_t surface, std::string_view name) {
    std::string low(name);
    for (char& c : low) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    for (const auto& [word, colour] : known)
        if (low.find(word) != std::string::npos) return colour;
    return surface == 0 ? rgb(0xC7C1B5) : tints[surface % tints.size()];
}

}  // namespace surefoot::view
