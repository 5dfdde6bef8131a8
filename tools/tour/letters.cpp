#include "tour/letters.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <vector>

namespace surefoot::tools {
namespace {

constexpr double pi = 3.14159265358979323846;

/// A straight stroke from (a, b) to (c, d), or an arc about (a, b) of radius c from angle d to angle e [degrees].
struct Stroke {
    enum Kind : char { line, arc } kind;
    float a, b, c, d, e = 0;
};

struct Glyph {
    char letter;
    float width;
    std::vector<Stroke> strokes;
};

Stroke line(float a, float b, float c, float d) {
    return {Stroke::line, a, b, c, d};
}
Stroke arc(float a, float b, float r, float from, float to) {
    return {Stroke::arc, a, b, r, from, to};
}
Stroke bowl() {
    return arc(.5F, .5F, .5F, 0, 360);
}
Stroke dot(float x, float y) {
    return line(x, y, x, y);
}

/// Units of the height of a small x; the base line is 0.
const std::vector<Glyph>& glyphs() {
    static const std::vector<Glyph> all{
        {'a', 1, {bowl(), line(1, 0, 1, 1)}},
        {'b', 1, {bowl(), line(0, 0, 0, 1.6F)}},
        {'c', .85F, {arc(.5F, .5F, .5F, 45, 315)}},
        {'d', 1, {bowl(), line(1, 0, 1, 1.6F)}},
        {'e', 1, {arc(.5F, .5F, .5F, 0, 318), line(0, .5F, 1, .5F)}},
        {'f', .55F, {arc(.5F, 1.3F, .3F, 70, 180), line(.2F, 1.3F, .2F, 0), line(0, 1, .5F, 1)}},
        {'g', 1, {bowl(), line(1, 1, 1, -.1F), arc(.5F, -.1F, .5F, 215, 360)}},
        {'h', .9F, {line(0, 0, 0, 1.6F), arc(.45F, .55F, .45F, 0, 180), line(.9F, .55F, .9F, 0)}},
        {'i', 0, {line(0, 0, 0, 1), dot(0, 1.4F)}},
        {'j', .2F, {line(.2F, 1, .2F, -.3F), arc(-.05F, -.3F, .25F, 270, 360), dot(.2F, 1.4F)}},
        {'k', .75F, {line(0, 0, 0, 1.6F), line(0, .38F, .7F, 1), line(.26F, .62F, .75F, 0)}},
        {'l', 0, {line(0, 0, 0, 1.6F)}},
        {'m',
         1.4F,
         {line(0, 0, 0, 1), arc(.35F, .65F, .35F, 0, 180), line(.7F, .65F, .7F, 0), arc(1.05F, .65F, .35F, 0, 180),
          line(1.4F, .65F, 1.4F, 0)}},
        {'n', .9F, {line(0, 0, 0, 1), arc(.45F, .55F, .45F, 0, 180), line(.9F, .55F, .9F, 0)}},
        {'o', 1, {bowl()}},
        {'p', 1, {bowl(), line(0, -.55F, 0, 1)}},
        {'q', 1, {bowl(), line(1, -.55F, 1, 1)}},
        {'r', .6F, {line(0, 0, 0, 1), arc(.45F, .55F, .45F, 65, 180)}},
        {'s', .66F, {arc(.33F, .75F, .25F, 25, 270), arc(.33F, .25F, .25F, -155, 90)}},
        {'t', .55F, {line(.22F, 1.4F, .22F, .3F), arc(.52F, .3F, .3F, 180, 270), line(0, 1, .55F, 1)}},
        {'u', .9F, {line(0, 1, 0, .45F), arc(.45F, .45F, .45F, 180, 360), line(.9F, 1, .9F, 0)}},
        {'v', .9F, {line(0, 1, .45F, 0), line(.45F, 0, .9F, 1)}},
        {'w', 1.4F, {line(0, 1, .35F, 0), line(.35F, 0, .7F, 1), line(.7F, 1, 1.05F, 0), line(1.05F, 0, 1.4F, 1)}},
        {'x', .85F, {line(0, 0, .85F, 1), line(0, 1, .85F, 0)}},
        {'y', .9F, {line(0, 1, .45F, 0), line(.9F, 1, .2F, -.55F)}},
        {'z', .8F, {line(0, 1, .8F, 1), line(.8F, 1, 0, 0), line(0, 0, .8F, 0)}},
        {'0',
         .9F,
         {arc(.45F, 1.05F, .45F, 0, 180), line(0, 1.05F, 0, .45F), arc(.45F, .45F, .45F, 180, 360),
          line(.9F, .45F, .9F, 1.05F)}},
        {'1', .45F, {line(.05F, 1.2F, .4F, 1.5F), line(.4F, 1.5F, .4F, 0)}},
        {'2', .9F, {arc(.45F, 1.05F, .45F, -32, 170), line(.83F, .81F, 0, 0), line(0, 0, .9F, 0)}},
        {'3', .8F, {arc(.4F, 1.13F, .37F, -90, 150), arc(.4F, .38F, .38F, -150, 90)}},
        {'4', .95F, {line(.7F, 0, .7F, 1.5F), line(.7F, 1.5F, 0, .45F), line(0, .45F, .95F, .45F)}},
        {'5', .9F, {line(.8F, 1.5F, .16F, 1.5F), line(.16F, 1.5F, .1F, .86F), arc(.42F, .48F, .48F, -145, 130)}},
        {'6', .9F, {arc(.45F, .45F, .45F, 0, 360), line(.06F, .66F, .62F, 1.5F)}},
        {'7', .85F, {line(0, 1.5F, .85F, 1.5F), line(.85F, 1.5F, .3F, 0)}},
        {'8', .84F, {arc(.42F, 1.14F, .36F, 0, 360), arc(.42F, .39F, .39F, 0, 360)}},
        {'9', .9F, {arc(.45F, 1.05F, .45F, 0, 360), line(.84F, .84F, .28F, 0)}},
        {'.', 0, {dot(0, 0)}},
        {',', .1F, {line(.1F, .05F, 0, -.25F)}},
        {'-', .5F, {line(0, .5F, .5F, .5F)}},
        {'_', .8F, {line(0, -.1F, .8F, -.1F)}},
        {':', 0, {dot(0, .15F), dot(0, .85F)}},
        {'/', .6F, {line(0, -.2F, .6F, 1.6F)}},
        {'(', .25F, {arc(1.2F, .65F, 1.2F, 130, 230)}},
        {')', .25F, {arc(-.95F, .65F, 1.2F, -50, 50)}},
        {'+', .7F, {line(0, .5F, .7F, .5F), line(.35F, .15F, .35F, .85F)}},
        {'=', .7F, {line(0, .3F, .7F, .3F), line(0, .7F, .7F, .7F)}},
    };
    return all;
}

const Glyph* find_glyph(char letter) {
    const char small = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    for (const Glyph& glyph : glyphs())
        if (glyph.letter == small) return &glyph;
    return nullptr;
}

constexpr double space_width = 0.55;
constexpr double between = 0.42;  // from the last stroke of a letter to the first of the next
constexpr double half_stroke = 0.085;

double distance(const Stroke& s, double x, double y) {
    if (s.kind == Stroke::line) {
        const double dx = s.c - s.a;
        const double dy = s.d - s.b;
        const double square = dx * dx + dy * dy;
        const double f = square > 0 ? std::clamp(((x - s.a) * dx + (y - s.b) * dy) / square, 0.0, 1.0) : 0.0;
        return std::hypot(x - s.a - f * dx, y - s.b - f * dy);
    }
    const double sweep = s.e - s.d;
    double angle = std::atan2(y - s.b, x - s.a) * 180 / pi - s.d;
    angle -= 360 * std::floor(angle / 360);
    if (angle <= sweep) return std::abs(std::hypot(x - s.a, y - s.b) - s.c);
    double nearest = 1e300;
    for (const double end : {double{s.d}, double{s.e}})
        nearest = std::min(
            nearest, std::hypot(x - s.a - s.c * std::cos(end * pi / 180), y - s.b - s.c * std::sin(end * pi / 180)));
    return nearest;
}

double advance(const Glyph* glyph) {
    return glyph == nullptr ? space_width : glyph->width + between;
}

void draw_glyph(Canvas& canvas, const Glyph& glyph, double x, double y, double size, const Colour& colour) {
    const int left = static_cast<int>(std::floor(x - 0.4 * size - 1));
    const int right = static_cast<int>(std::ceil(x + (glyph.width + 0.4) * size + 1));
    const int top = static_cast<int>(std::floor(y - 1.8 * size - 1));
    const int bottom = static_cast<int>(std::ceil(y + 0.8 * size + 1));
    for (int py = top; py <= bottom; ++py)
        for (int px = left; px <= right; ++px) {
            double nearest = 1e300;
            for (const Stroke& stroke : glyph.strokes)
                nearest = std::min(nearest, distance(stroke, (px + 0.5 - x) / size, (y - py - 0.5) / size));
            canvas.blend(px, py, colour, std::clamp((half_stroke - nearest) * size + 0.5, 0.0, 1.0));
        }
}

}  // namespace

double text_width(std::string_view text, double size) {
    double width = 0;
    for (const char letter : text) width += advance(find_glyph(letter)) * size;
    return width;
}

void draw_text(Canvas& canvas, double x, double y, double size, std::string_view text, const Colour& colour) {
    for (const char letter : text) {
        const Glyph* const glyph = find_glyph(letter);
        if (glyph != nullptr) draw_glyph(canvas, *glyph, x, y, size, colour);
        x += advance(glyph) * size;
    }
}

}  // namespace surefoot::tools
