#include "platformer/sound/chord.hpp"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace surefoot::sound {

namespace {

constexpr int lowest = 53, highest = 75;  // where four voices sound neither muddy nor shrill

const std::vector<std::pair<std::string_view, std::vector<int>>>& qualities() {
    static const std::vector<std::pair<std::string_view, std::vector<int>>> table{
        {"", {0, 4, 7}},          {"6", {0, 4, 7, 9}},          {"69", {0, 4, 7, 9, 14}},
        {"maj7", {0, 4, 7, 11}},  {"maj9", {0, 4, 7, 11, 14}},  {"7", {0, 4, 7, 10}},
        {"9", {0, 4, 7, 10, 14}}, {"13", {0, 4, 10, 14, 21}},   {"7b9", {0, 4, 7, 10, 13}},
        {"7sus4", {0, 5, 7, 10}}, {"9sus4", {0, 5, 7, 10, 14}}, {"m", {0, 3, 7}},
        {"m6", {0, 3, 7, 9}},     {"m7", {0, 3, 7, 10}},        {"m9", {0, 3, 7, 10, 14}},
        {"m7b5", {0, 3, 6, 10}},  {"dim7", {0, 3, 6, 9}},       {"add9", {0, 4, 7, 14}},
    };
    return table;
}

/// The pitch class at the beginning of a text, which is shortened by it.
std::optional<int> take_root(std::string_view& text) {
    if (text.empty() || text[0] < 'A' || text[0] > 'G') return std::nullopt;
    constexpr std::array<int, 7> classes{9, 11, 0, 2, 4, 5, 7};
    int root = classes[static_cast<std::size_t>(text[0] - 'A')];
    text.remove_prefix(1);
    if (!text.empty() && (text[0] == '#' || text[0] == 'b')) {
        root += text[0] == '#' ? 1 : -1;
        text.remove_prefix(1);
    }
    return (root + 12) % 12;
}

/// Which of its notes are played: at most four, the root and then the fifth left out of larger ones.
std::vector<int> core_of(const Chord& chord) {
    std::vector<int> core;
    for (const int degree : chord.degrees) {
        if (chord.degrees.size() > 4 && degree == 0) continue;
        core.push_back((chord.root + degree) % 12);
    }
    std::sort(core.begin(), core.end());
    return core;
}

}  // namespace

int Chord::degree(int number) const {
    constexpr std::array<int, 9> major{0, 0, 2, 4, 5, 7, 9, 11, 12};
    const int plain = major[static_cast<std::size_t>(std::clamp(number, 1, 8))];
    if (number == 8) return 12;
    for (const int degree : degrees) {
        // Thirds, fifths, sixths and sevenths come flat or not; a sus4 has its fourth where the third would be.
        if (degree == plain || degree == plain - 1) return degree;
    }
    return number == 7 ? 10 : plain;
}

std::optional<Chord> chord_named(std::string_view symbol) {
    Chord chord;
    const std::optional<int> root = take_root(symbol);
    if (!root) return std::nullopt;
    chord.root = chord.bass = *root;
    if (const std::size_t stroke = symbol.find('/'); stroke != std::string_view::npos) {
        std::string_view below = symbol.substr(stroke + 1);
        const std::optional<int> bass = take_root(below);
        if (!bass || !below.empty()) return std::nullopt;
        chord.bass = *bass;
        symbol = symbol.substr(0, stroke);
    }
    for (const auto& [name, degrees] : qualities()) {
        if (name == symbol) {
            chord.degrees = degrees;
            return chord;
        }
    }
    return std::nullopt;
}

Voicing voiced(const Chord& chord, const std::optional<Voicing>& before) {
    const std::vector<int> core = core_of(chord);
    const Voicing from = before.value_or(Voicing{57, 60, 64, 67});
    Voicing best = from;
    int least = 1 << 30;
    for (int bottom = lowest; bottom <= highest; ++bottom) {
        const auto first = std::find(core.begin(), core.end(), bottom % 12);
        if (first == core.end()) continue;
        Voicing laid{};
        std::size_t index = static_cast<std::size_t>(first - core.begin());
        laid[0] = bottom;
        for (std::size_t voice = 1; voice < laid.size(); ++voice) {
            index = (index + 1) % core.size();
            laid[voice] = laid[voice - 1] + (core[index] - laid[voice - 1] % 12 + 12) % 12;
        }
        if (laid.back() > highest) continue;
        int moved = 0;
        for (std::size_t voice = 0; voice < laid.size(); ++voice) moved += std::abs(laid[voice] - from[voice]);
        // Two voices a semitone apart at the very top or bottom grate; inside they are colour.
        if (laid[3] - laid[2] == 1 || laid[1] - laid[0] == 1) moved += 3;
        // And hands drift home.
        moved += std::abs(laid[0] + laid[3] - 124) / 6;
        if (moved < least) {
            least = moved;
            best = laid;
        }
    }
    return best;
}

}  // namespace surefoot::sound
