#include "view/pattern.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace surefoot::view {
namespace {

/// 0 to 1, by two whole numbers and a third for which of many such tables it is.
double chance(int x, int y, int table) {
    std::uint32_t h = static_cast<std::uint32_t>(x) * 0x8DA6B343U ^ static_cast<std::uint32_t>(y) * 0xD8163841U ^
                      static_cast<std::uint32_t>(table) * 0xCB1AB31FU;
    h = (h ^ h >> 15U) * 0x2C1B3C6DU;
    h = (h ^ h >> 12U) * 0x297A2D39U;
    return (h ^ h >> 15U) / 4294967296.0;
}

int wrapped(int i, int count) {
    return (i % count + count) % count;
}

double smooth(double low, double high, double x) {
    const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

/// Values at the corners of `across` by `down` cells on the whole picture, smoothly between them.
double soft(double u, double v, int across, int down, int table) {
    const double x = u * across;
    const double y = v * down;
    const int i = static_cast<int>(std::floor(x));
    const int k = static_cast<int>(std::floor(y));
    const double s = smooth(0, 1, x - i);
    const double t = smooth(0, 1, y - k);
    const auto at = [&](int a, int b) { return chance(wrapped(a, across), wrapped(b, down), table); };
    return std::lerp(std::lerp(at(i, k), at(i + 1, k), s), std::lerp(at(i, k + 1), at(i + 1, k + 1), s), t);
}

double patches(double u, double v) {
    const double wide = 0.6 * soft(u, v, 5, 5, 1) + 0.3 * soft(u, v, 13, 13, 2) + 0.1 * soft(u, v, 41, 41, 3);
    const double fleck = smooth(0.80, 0.90, soft(u, v, 47, 47, 4)) - smooth(0.84, 0.92, soft(u, v, 37, 37, 5));
    return smooth(0.40, 0.47, wide) * 0.5 + smooth(0.56, 0.62, wide) * 0.5 + 0.55 * fleck;
}

double bricks(double u, double v) {
    constexpr int rows = 12;
    constexpr int across = 6;
    const double y = v * rows;
    const int row = static_cast<int>(std::floor(y));
    const double x = u * across + (row % 2 == 0 ? 0.0 : 0.5) + 0.12 * (chance(row, 0, 6) - 0.5);
    const int brick = static_cast<int>(std::floor(x));
    const double to_joint = std::min(std::min(y - row, row + 1 - y) * 0.5, std::min(x - brick, brick + 1 - x));
    const double tone = 0.45 + 0.5 * chance(wrapped(brick, across), row, 7) + 0.12 * soft(u, v, 60, 60, 8);
    return tone * smooth(0.006, 0.045, to_joint) - 0.25 * (1 - smooth(0.0, 0.03, to_joint));
}

double boards(double u, double v) {
    constexpr int rows = 20;
    const double y = v * rows;
    const int row = static_cast<int>(std::floor(y));
    const double x = u * 2 + chance(row, 0, 9);
    const int board = static_cast<int>(std::floor(x));
    const double to_joint = std::min(std::min(y - row, row + 1 - y) * 0.3, std::min(x - board, board + 1 - x) * 3);
    const double tone = 0.4 + 0.45 * chance(wrapped(board, 2), row, 10) + 0.3 * soft(u, v, 8, 90, 11);
    return tone * smooth(0.0, 0.035, to_joint);
}

double strata(double u, double v) {
    // Layers of their own height, bent, each of its tone; with a dark joint now and then.
    const double bent = v + 0.020 * std::sin(2 * std::numbers::pi * (u + 0.3)) + 0.018 * (soft(u, v, 9, 5, 12) - 0.5);
    const double y = bent * 9;
    const int layer = static_cast<int>(std::floor(y));
    const double tone = chance(wrapped(layer, 9), 0, 13);
    const double below = chance(wrapped(layer - 1, 9), 0, 13);
    const double crack = smooth(0.86, 0.93, soft(u, bent, 26, 5, 14));
    return std::lerp(below, tone, smooth(0, 0.14, y - layer)) + 0.30 * soft(u, v, 22, 44, 15) - 0.55 * crack;
}

}  // namespace

std::vector<PatternTexel> pattern_picture() {
    constexpr int side = pattern_texels;
    constexpr std::array drawings{patches, bricks, boards, strata};
    std::vector<PatternTexel> picture(static_cast<std::size_t>(side) * side);
    for (std::size_t channel = 0; channel < drawings.size(); ++channel) {
        std::vector<double> tones;
        double sum = 0;
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                tones.push_back(drawings[channel]((x + 0.5) / side, (y + 0.5) / side));
                sum += tones.back();
            }
        const double mean = sum / static_cast<double>(tones.size());
        for (std::size_t i = 0; i < tones.size(); ++i)
            picture[i][channel] =
                static_cast<std::uint8_t>(std::lround(std::clamp(128 + 110 * (tones[i] - mean), 0.0, 255.0)));
    }
    return picture;
}

gl::Texture pattern_texture() {
    const std::vector<PatternTexel> picture = pattern_picture();
    gl::Texture made = gl::Texture::make();
    glBindTexture(GL_TEXTURE_2D, made.id());
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, pattern_texels, pattern_texels, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 picture.data());
    glGenerateMipmap(GL_TEXTURE_2D);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_REPEAT);
    return made;
}

}  // namespace surefoot::view
