#include "surface_words.hpp"

#include <algorithm>
#include <array>

namespace surefoot::tools {
namespace {

struct Word {
    std::string_view word;
    SurfaceMeaning meaning;
};

constexpr std::array<Word, 9> words{{
    {"ice", {.rule = {.grip = 0.03}, .ground = SurfaceGround::ice}},
    {"mud", {.ground = SurfaceGround::mud}},
    {"water", {.ground = SurfaceGround::water}},
    {"ladder", {.rule = {.ladder = true}}},
    {"slippery", {.rule = {.slippery = true}}},
    {"lava", {.ground = SurfaceGround::forbidden}},
    {"acid", {.ground = SurfaceGround::forbidden}},
    {"spikes", {.ground = SurfaceGround::forbidden}},
    {"deadly", {.ground = SurfaceGround::forbidden}},
}};

constexpr bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

constexpr char lower(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

bool is_word(std::string_view part, std::string_view word) {
    return std::equal(part.begin(), part.end(), word.begin(), word.end(), [](char a, char b) { return lower(a) == b; });
}

}  // namespace

SurfaceMeaning surface_meaning(std::string_view name) {
    while (!name.empty()) {
        const auto begin = std::find_if(name.begin(), name.end(), is_letter);
        const auto end = std::find_if_not(begin, name.end(), is_letter);
        const std::string_view part(begin, end);
        for (const Word& known : words)
            if (is_word(part, known.word)) return known.meaning;
        name = {end, name.end()};
    }
    return {};
}

std::vector<SurfaceRule> surface_rules(std::span<const std::string> names) {
    std::vector<SurfaceRule> rules;
    for (const std::string& name : names) rules.push_back(surface_meaning(name).rule);
    return rules;
}

}  // namespace surefoot::tools
