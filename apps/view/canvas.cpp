#include "view/canvas.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>

namespace surefoot::view {

Fill Fill::edged(Colour colour, double width) const {
    Fill fill = *this;
    fill.edge = colour;
    fill.edge_width = width;
    return fill;
}

Fill Fill::soft(double units) const {
    Fill fill = *this;
    fill.softness = units;
    return fill;
}

double Layout::pixels() const {
    const double fits = std::min(framebuffer.x / 800.0, framebuffer.y / 600.0);
    return std::max(fits * std::clamp(user_scale, 0.5, 2.0), 0.05);
}

dvec2 Layout::size() const {
    return dvec2(framebuffer) / pixels();
}

void Canvas::begin(const Layout& layout) {
    layout_ = layout;
    pixels_ = layout.pixels();
    items_.clear();
    opacity_ = 1;
    clip(std::nullopt);
    letters_.next_frame();
}

void Canvas::clip(const std::optional<Rect>& to) {
    clip_ = to ? glm::vec4(glm::dvec4(to->low, to->high) * pixels_) : glm::vec4(-1e6F, -1e6F, 1e6F, 1e6F);
}

void Canvas::add(CanvasItem::Kind kind, const dvec2& middle, const dvec2& half, const dvec2& turn, const Fill& fill,
                 const glm::vec4& a, const glm::vec4& b) {
    const auto faded = [&](Colour colour) { return with_opacity(colour, colour.a / 255.0 * opacity_); };
    const double softness = std::max(fill.softness * pixels_, 1.0);
    items_.push_back({glm::vec2(middle * pixels_), glm::vec2(half * pixels_),
                      glm::vec4(turn.x, turn.y, fill.edge_width * pixels_, softness), a,
                      glm::vec4(b.x, b.y, b.z, static_cast<float>(kind)), clip_, faded(fill.top), faded(fill.bottom),
                      faded(fill.edge)});
}

Rect Canvas::bounds_of(const CanvasItem& item) const {
    const dvec2 turn(item.turn_and_widths.x, item.turn_and_widths.y);
    const dvec2 half = dvec2(item.half) + double(item.turn_and_widths.z);
    const dvec2 reach(std::abs(turn.x) * half.x + std::abs(turn.y) * half.y,
                      std::abs(turn.y) * half.x + std::abs(turn.x) * half.y);
    const dvec2 middle(item.middle);
    return {(middle - reach) / pixels_, (middle + reach) / pixels_};
}

void Canvas::box(const Rect& rect, double radius, const Fill& fill) {
    const dvec2 half = rect.size() / 2.0;
    if (!(half.x > 0 && half.y > 0)) return;
    const double round = std::min({radius, half.x, half.y}) * pixels_;
    add(CanvasItem::Kind::box, rect.middle(), half, {1, 0}, fill, {}, {0, 0, static_cast<float>(round), 0});
}

void Canvas::disc(const dvec2& middle, double radius, const Fill& fill) {
    box({middle - radius, middle + radius}, radius, fill);
}

void Canvas::ring(const dvec2& middle, double radius, double width, const Fill& fill) {
    arc(middle, radius, width, 0, 2 * std::numbers::pi, fill);
}

void Canvas::arc(const dvec2& middle, double radius, double width, double angle, double sweep, const Fill& fill) {
    const double half_sweep = std::clamp(sweep / 2, 0.0, std::numbers::pi);
    if (!(radius > 0 && half_sweep > 0)) return;
    const glm::vec4 a(radius * pixels_, width / 2 * pixels_, std::sin(half_sweep), std::cos(half_sweep));
    // No more than the part that is seen: a short arc of a wide ring is no reason to look at all that is within.
    const dvec2 turn(std::cos(angle), std::sin(angle));
    const double across = (half_sweep < std::numbers::pi / 2 ? radius * std::sin(half_sweep) : radius) + width / 2;
    const double top = -radius - width / 2;
    const double bottom = -radius * std::cos(half_sweep) + width / 2;
    const double ahead = (top + bottom) / 2;
    add(CanvasItem::Kind::arc, middle + dvec2(-turn.y, turn.x) * ahead, {across, (bottom - top) / 2}, turn, fill, a,
        {0, static_cast<float>(-ahead * pixels_), 0, 0});
}

void Canvas::progress(const dvec2& middle, double radius, double width, double share, const Fill& fill) {
    const double sweep = std::clamp(share, 0.0, 1.0) * 2 * std::numbers::pi;
    arc(middle, radius, width, sweep / 2, sweep, fill);
}

void Canvas::triangle(const dvec2& a, const dvec2& b, const dvec2& c, const Fill& fill, double radius) {
    const dvec2 low = glm::min(glm::min(a, b), c);
    const dvec2 high = glm::max(glm::max(a, b), c);
    const dvec2 middle = (low + high) / 2.0;
    const auto local = [&](const dvec2& p) { return (p - middle) * pixels_; };
    add(CanvasItem::Kind::triangle, middle, (high - low) / 2.0 + radius, {1, 0}, fill,
        glm::vec4(glm::dvec4(local(a), local(b))),
        glm::vec4(local(c).x, local(c).y, static_cast<float>(radius * pixels_), 0));
}

void Canvas::line(const dvec2& from, const dvec2& to, double width, const Fill& fill) {
    const dvec2 along = to - from;
    const double length = glm::length(along);
    const dvec2 turn = length > 0 ? along / length : dvec2(1, 0);
    const double half = width / 2;
    add(CanvasItem::Kind::box, (from + to) / 2.0, {length / 2 + half, half}, turn, fill, {},
        {0, 0, static_cast<float>(half * pixels_), 0});
}

void Canvas::sign(Sign sign, const dvec2& middle, double size, const Fill& fill, double turn) {
    const Glyph glyph = letters_.glyph(sign, size * pixels_);
    if (glyph.reach <= 0) return;
    add(CanvasItem::Kind::glyph, middle, glyph.high * size, {std::cos(turn), std::sin(turn)}, fill,
        glm::vec4(glm::dvec4(glyph.texel_low, glyph.texel_high)),
        {static_cast<float>(glyph.reach * size * pixels_), 0, 0, 0});
}

void Canvas::picture(const Rect& rect, double radius, const dvec2& middle, const dvec2& half, double turn,
                     double opacity) {
    const Fill fill(rgb(0xFFFFFF, opacity));
    add(CanvasItem::Kind::picture, rect.middle(), rect.size() / 2.0, {1, 0}, fill, glm::vec4(glm::dvec4(middle, half)),
        {static_cast<float>(std::cos(turn)), static_cast<float>(std::sin(turn)), static_cast<float>(radius * pixels_),
         0});
}

double Canvas::width_of(std::string_view words, const TextLook& look) const {
    double width = 0;
    while (!words.empty()) {
        const char32_t letter = take_letter(words);
        std::string_view rest = words;
        width += letters_.advance(look.face, letter, rest.empty() ? 0 : take_letter(rest));
    }
    return width * look.size;
}

double Canvas::text(std::string_view words, const dvec2& at, const TextLook& look) {
    const double width = width_of(words, look);
    const double share = look.align == Align::left ? 0 : look.align == Align::middle ? 0.5 : 1;
    dvec2 pen = at - dvec2(width * share, 0);
    // Whole pixels: letters that begin anywhere are as blurred as their place is odd.
    pen = glm::round(pen * pixels_) / pixels_;
    const Fill fill = Fill(look.colour).edged(look.edge, look.edge_width);
    while (!words.empty()) {
        const char32_t letter = take_letter(words);
        std::string_view rest = words;
        const Glyph glyph = letters_.glyph(look.face, letter, look.size * pixels_);
        if (glyph.reach > 0) {
            const dvec2 low = pen + glyph.low * look.size;
            const dvec2 high = pen + glyph.high * look.size;
            add(CanvasItem::Kind::glyph, (low + high) / 2.0, (high - low) / 2.0, {1, 0}, fill,
                glm::vec4(glm::dvec4(glyph.texel_low, glyph.texel_high)),
                {static_cast<float>(glyph.reach * look.size * pixels_), 0, 0, 0});
        }
        pen.x += letters_.advance(look.face, letter, rest.empty() ? 0 : take_letter(rest)) * look.size;
    }
    return width;
}

double Canvas::text_in(std::string_view words, const Rect& rect, const TextLook& look) {
    const double x = look.align == Align::left     ? rect.low.x
                     : look.align == Align::middle ? rect.middle().x
                                                   : rect.high.x;
    return text(words, {x, rect.middle().y + letters_.capital_height(look.face) * look.size / 2}, look);
}

std::vector<std::string_view> Canvas::lines_of(std::string_view words, double width, const TextLook& look) const {
    std::vector<std::string_view> lines;
    std::size_t begin = 0;
    while (begin < words.size()) {
        std::size_t end = begin;  // of what fits for sure
        for (std::size_t at = begin; at <= words.size(); ++at) {
            const bool is_end = at == words.size() || words[at] == '\n';
            if (!is_end && words[at] != ' ') continue;
            if (end > begin && width_of(words.substr(begin, at - begin), look) > width) break;
            end = at;
            if (is_end) break;
        }
        lines.push_back(words.substr(begin, end - begin));
        begin = end + 1;
    }
    return lines;
}

double Canvas::wrapped(std::string_view words, const dvec2& at, double width, const TextLook& look) {
    const double share = look.align == Align::left ? 0 : look.align == Align::middle ? 0.5 : 1;
    double y = at.y + look.size;
    for (const std::string_view line : lines_of(words, width, look)) {
        static_cast<void>(text(line, {at.x + width * share, y}, look));
        y += line_height(look);
    }
    return y - at.y - look.size;
}

Rect anchored(const dvec2& frame, const dvec2& anchor, const dvec2& size, double margin) {
    const dvec2 low = (frame - size) * (anchor + 1.0) / 2.0 - anchor * margin;
    return {low, low + size};
}

}  // namespace surefoot::view
