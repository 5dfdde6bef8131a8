#include "platformer/hud/hud.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>
#include <vector>

#include "platformer/screens/draw_screens.hpp"

namespace surefoot::platformer {
namespace {

using view::Align;
using view::Canvas;
using view::Colour;
using view::dvec2;
using view::Face;
using view::Fill;
using view::Rect;
using view::Sign;
using view::with_opacity;

constexpr double margin = 16;  // from the window's edges

struct Painter {
    Canvas& canvas;
    const HudView& hud;
    const Palette& palette;
    const HudLook& look;
    Rect hero;

    [[nodiscard]] Fill ringed(Colour colour) const { return Fill(colour).edged(with_opacity(palette.ink, 0.9), 1.8); }

    /// How much larger something is for having just changed.
    [[nodiscard]] double swell(double since) const {
        if (look.reduced_motion || !(since >= 0 && since < 0.3)) return 1;
        return 1 + 0.35 * std::sin(since / 0.3 * std::numbers::pi);
    }

    void hearts() const {
        // The last heart beats, which is a warning and not an ornament; with less motion it has a frame instead.
        const bool last = hud.health == 1 && hud.most_health > 1;
        for (int i = 0; i < hud.most_health; ++i) {
            const dvec2 at(margin + 15 + 32.0 * i, margin + 14);
            const bool full = i < hud.health;
            double size = 28 * (i == hud.health - 1 || i == hud.health ? swell(hud.since_health) : 1);
            if (last && full && !look.reduced_motion) size *= 1 + 0.08 * std::sin(hud.seconds * 7);
            if (last && full && look.reduced_motion) canvas.ring(at, 18, 2, palette.health);
            canvas.sign(Sign::heart, at, size, ringed(full ? palette.health : with_opacity(palette.ink, 0.55)));
        }
    }

    void counts() const {
        const double y = margin + 48;
        const view::TextLook words{.size = 20, .colour = palette.paper, .face = Face::bold, .edge_width = 1.8};
        double x = margin + 15;
        canvas.sign(Sign::coin, {x, y}, 24 * swell(hud.since_coin), ringed(palette.coin));
        x += 20;
        x += canvas.text(fmt::format("{}", hud.coins), {x, y + 7}, words) + 3;
        view::TextLook small = words;
        small.size = 14;
        small.colour = palette.quiet;
        x += canvas.text(fmt::format("/ {}", hud.coins_all), {x, y + 7}, small) + 22;
        for (int i = 0; i < hud.stars_all; ++i, x += 24)
            canvas.sign(Sign::star, {x, y}, 22, ringed(i < hud.stars ? palette.star : with_opacity(palette.ink, 0.55)));
        x = margin + 15;
        for (const std::string& key : hud.keys) {
            canvas.sign(Sign::key, {x, y + 32}, 24, ringed(key_colour(key, look.colours)));
            x += 18;
            x += canvas.text(key, {x, y + 37}, small) + 22;
        }
    }

    void clock() const {
        const double right = canvas.size().x - margin;
        const std::string time = time_text(hud.seconds);
        const view::TextLook words{
            .size = 24, .colour = palette.paper, .face = Face::bold, .align = Align::right, .edge_width = 2};
        // Steady digits: the sign does not dance with the width of ones.
        canvas.text(time, {right, margin + 22}, words);
        canvas.sign(Sign::clock,
                    {right - canvas.width_of("0:00.00", words) - (hud.seconds >= 600 ? 34 : 18), margin + 14}, 20,
                    ringed(palette.paper));
        if (!hud.section_split || hud.section_age > 6) return;
        const double split = *hud.section_split;
        canvas.text(fmt::format("{}{:.2f} s", split > 0 ? "+" : "\u2212", std::abs(split)), {right, margin + 46},
                    {.size = 16,
                     .colour = split > 0 ? palette.danger : palette.goal,
                     .face = Face::bold,
                     .align = Align::right,
                     .edge_width = 1.6});
    }

    static constexpr double section_shown = 3.5;  // [s]
    [[nodiscard]] bool shows_section() const {
        return !hud.section.empty() && hud.section_age < section_shown && hero.low.y > 100;
    }

    void section() const {
        if (!shows_section()) return;
        const double fade =
            look.reduced_motion ? 1 : std::min({hud.section_age / 0.3, (section_shown - hud.section_age) / 0.6, 1.0});
        canvas.fade(std::clamp(fade, 0.0, 1.0));
        canvas.text(
            hud.section, {canvas.size().x / 2, 88},
            {.size = 26, .colour = palette.paper, .face = Face::bold, .align = Align::middle, .edge_width = 2.2});
        canvas.fade(1);
    }

    /// In the middle of the upper edge.
    void pill(std::string_view words, Sign sign) const {
        const double x = canvas.size().x / 2;
        const double width = canvas.width_of(words, {.size = 14}) + 44;
        canvas.box({{x - width / 2, margin - 2}, {x + width / 2, margin + 24}}, 13, with_opacity(palette.ink, 0.75));
        canvas.sign(sign, {x - width / 2 + 16, margin + 11}, 13, palette.accent);
        canvas.text(words, {x - width / 2 + 30, margin + 16}, {.size = 14, .colour = palette.paper});
    }

    void prompt() const;
    void markers(const Rect& map) const;
    [[nodiscard]] dvec2 free_place(dvec2 at, const Rect& map) const;
    void hurts() const;
};

/// Words and keys in one line, or in two where the window is narrow.
void Painter::prompt() const {
    if (hud.prompt.empty()) return;
    constexpr double size = 17;
    constexpr double row = 32;
    // Beside the map where there is room for that, else as wide as the window.
    const double beside = std::min(canvas.size().x - 2 * margin - 300, 560.0);
    const double widest = beside > 300 ? beside : canvas.size().x - 2 * margin - 40;
    struct Piece {
        std::string_view text;
        bool is_key;
        double x;
        double y;
    };
    std::vector<Piece> pieces;
    const double space = canvas.width_of(" ", {.size = size});
    dvec2 pen(0, 0);
    double width = 0;
    const auto put = [&](std::string_view text, bool is_key) {
        const double wide = is_key ? key_cap_width(canvas, text, size) : canvas.width_of(text, {.size = size});
        if (pen.x > 0 && pen.x + wide > widest) pen = {0, pen.y + row};
        // A full stop belongs to the key before it.
        if (!is_key && pen.x > 0 && pieces.back().is_key && std::ispunct(static_cast<unsigned char>(text.front())) != 0)
            pen.x -= space * 0.4;
        pieces.push_back({text, is_key, pen.x, pen.y});
        width = std::max(width, pen.x + wide);
        pen.x += wide + (is_key ? space * 0.6 : space);
    };
    for (const PromptPart& part : hud.prompt) {
        if (part.is_key) {
            put(part.text, true);
            continue;
        }
        std::string_view rest = part.text;
        while (!rest.empty()) {
            const std::size_t end = std::min(rest.find(' '), rest.size());
            if (end > 0) put(rest.substr(0, end), false);
            rest.remove_prefix(std::min(end + 1, rest.size()));
        }
    }
    const double height = pen.y + row;
    dvec2 low((canvas.size().x - width) / 2, canvas.size().y - margin - 8 - height);
    const auto plate = [&] { return Rect{low - dvec2(18, 6), low + dvec2(width + 18, height + 6)}; };
    if (plate().meets(hero)) low.y = 104;  // a camera close behind has him at the lower edge
    canvas.box(plate(), 12, with_opacity(palette.ink, 0.78));
    for (const Piece& piece : pieces) {
        const dvec2 at = low + dvec2(piece.x, piece.y + row / 2);
        if (piece.is_key)
            draw_key_cap(canvas, piece.text, at, size);
        else
            canvas.text(piece.text, at + dvec2(0, size * 0.36), {.size = size, .colour = palette.paper});
    }
}

/// Not over the figures in the corners, nor over the map, nor over the hero: inwards along the edge.
dvec2 Painter::free_place(dvec2 at, const Rect& map) const {
    const dvec2 size = canvas.size();
    if (at.y < 130 && at.x < 250) at.y = 130;
    if (at.y < 100 && at.x > size.x - 190) at.y = 100;
    if (at.y < 130 && shows_section() && std::abs(at.x - size.x / 2) < 260) at.y = 130;
    if (map.grown(26).has(at)) at.y = map.low.y - 27;
    if (!hud.prompt.empty() && at.y > size.y - 110 && !map.grown(26).has(at)) at.y = size.y - 110;
    if (const Rect aside = hero.grown(52); aside.has(at)) at.x = at.x < hero.middle().x ? aside.low.x : aside.high.x;
    return at;
}

void Painter::markers(const Rect& map) const {
    const dvec2 size = canvas.size();
    constexpr double from_edge = 52;
    const dvec2 apart(48, 62);  // a marker with its arrow and its metres
    std::vector<dvec2> taken;
    const auto is_free = [&](const dvec2& at) {
        return std::ranges::none_of(taken, [&](const dvec2& other) {
            return std::abs(at.x - other.x) < apart.x && std::abs(at.y - other.y) < apart.y;
        });
    };
    // Where another one stands, along the edge to the next place that is free, to either side.
    const auto settle = [&](const dvec2& wanted) {
        const dvec2 room = size / 2.0 - from_edge;
        const dvec2 out = glm::abs(wanted - size / 2.0) / room;
        const dvec2 along = out.x > out.y ? dvec2(0, apart.y) : dvec2(apart.x, 0);
        for (int step = 0; step < 24; ++step) {
            const double by = (step % 2 == 0 ? -0.5 : 0.5) * ((step + 1) / 2);
            const dvec2 at = free_place(glm::clamp(wanted + along * by, dvec2(from_edge), size - from_edge), map);
            if (is_free(at)) return at;
        }
        return free_place(wanted, map);
    };
    for (const HudMarker& marker : hud.markers) {
        const auto edge = edge_place(hud.camera, marker.place, size, from_edge);
        if (!edge) continue;
        Sign sign = Sign::beam;
        Colour colour = palette.goal;
        switch (marker.kind) {
            case HudMarker::Kind::goal:
                break;
            case HudMarker::Kind::checkpoint:
                sign = Sign::flag, colour = palette.checkpoint;
                break;
            case HudMarker::Kind::key:
                sign = Sign::key, colour = key_colour(marker.door, look.colours);
                break;
            case HudMarker::Kind::door:
                sign = Sign::door, colour = key_colour(marker.door, look.colours);
                break;
            case HudMarker::Kind::star:
                sign = Sign::star, colour = palette.star;
                break;
            case HudMarker::Kind::ghost:
                sign = Sign::ghost, colour = palette.quiet;
                break;
        }
        const dvec2 at = settle(edge->at);
        taken.push_back(at);
        const dvec2 way(std::sin(edge->turn), -std::cos(edge->turn));
        canvas.disc(at, 19, Fill(with_opacity(palette.ink, 0.75)).edged(colour, 2));
        canvas.sign(sign, at, 21, colour);
        // Which key, and which door, is told by a letter too.
        if (!marker.door.empty())
            canvas.text(
                key_sign(marker.door), at + dvec2(17, 19),
                {.size = 17, .colour = palette.paper, .face = Face::bold, .align = Align::middle, .edge_width = 2.2});
        const dvec2 side(-way.y, way.x);
        canvas.triangle(at + way * 33.0, at + way * 23.0 + side * 8.0, at + way * 23.0 - side * 8.0, ringed(colour), 1);
        const double metres = glm::length(marker.place - hud.hero);
        canvas.text(
            fmt::format("{:.0f} m", metres), at + dvec2(0, way.y > 0.5 ? -25.0 : 34.0),
            {.size = 13, .colour = palette.paper, .face = Face::bold, .align = Align::middle, .edge_width = 1.6});
    }
}

/// An arc about the picture's middle, towards what hurt: up is ahead, down is behind.
void Painter::hurts() const {
    constexpr double shown = 1.2;
    const dvec2 size = canvas.size();
    const dvec2 middle = size / 2.0;
    // About the hero, but never wider than the window.
    const double corner = glm::length(glm::max(glm::abs(hero.low - middle), glm::abs(hero.high - middle)));
    const double least = std::min(size.x, size.y);
    const double radius = std::clamp(corner + 12, least * 0.32, least * 0.455);
    for (const HudHurt& hurt : hud.hurts) {
        if (!(hurt.age >= 0 && hurt.age < shown)) continue;
        const dvec3 to = hurt.from - hud.hero;
        const dvec3 up = hud.camera.up;
        const dvec3 level = to - up * glm::dot(to, up);
        if (!(glm::length(level) > 1e-6)) continue;
        const dvec3 ahead = hud.camera.forward - up * glm::dot(hud.camera.forward, up);
        const double angle = std::atan2(glm::dot(level, hud.camera.right()), glm::dot(level, glm::normalize(ahead)));
        canvas.fade(1 - hurt.age / shown);
        canvas.arc(middle, radius, 12, angle, 0.7, Fill(palette.danger).edged(with_opacity(palette.ink, 0.8), 2));
        const dvec2 way(std::sin(angle), -std::cos(angle));
        const dvec2 side(-way.y, way.x);
        const dvec2 tip = middle + way * (radius + 20);
        canvas.triangle(tip, tip - way * 12.0 + side * 11.0, tip - way * 12.0 - side * 11.0, ringed(palette.danger), 1);
        canvas.fade(1);
    }
}

}  // namespace

Rect hero_box(const HudView& hud, const dvec2& size) {
    const double unit = size.y / std::max(hud.window.y, 1);
    Rect box{{1e9, 1e9}, {-1e9, -1e9}};
    const double half = hud.hero_height / 2;
    for (const double up : {-half, half}) {
        for (const double aside : {-half * 0.5, half * 0.5}) {
            const auto at = hud.camera.project(hud.hero + hud.camera.up * up + hud.camera.right() * aside, hud.window);
            if (!at) continue;
            box.low = glm::min(box.low, at->at * unit);
            box.high = glm::max(box.high, at->at * unit);
        }
    }
    if (!(box.low.x <= box.high.x)) return {size / 2.0, size / 2.0};
    return box.grown(6);
}

std::optional<EdgePlace> edge_place(const view::Camera& camera, const dvec3& place, const dvec2& size, double by) {
    const dvec3 to = place - camera.eye;
    const double depth = glm::dot(to, camera.forward);
    const double tall = std::tan(camera.field_of_view / 2);
    // Right and down, in halves of the picture's height at the depth of 1.
    dvec2 out(glm::dot(to, camera.right()), -glm::dot(to, camera.above()));
    if (!(glm::length(to) > 1e-9) || !std::isfinite(out.x + out.y)) return std::nullopt;
    const dvec2 half = size / 2.0;
    if (depth > 0) {
        const dvec2 at = out / (depth * tall) * half.y;
        if (std::abs(at.x) <= half.x && std::abs(at.y) <= half.y) return std::nullopt;
    } else {
        // The farther behind, the farther below: one turns round for it, it is not in the sky.
        out.y -= 2 * depth;
        if (!(glm::length(out) > 1e-9)) out = {0, 1};
    }
    const dvec2 room = half - by;
    const double shrink =
        std::min(room.x / std::max(std::abs(out.x), 1e-12), room.y / std::max(std::abs(out.y), 1e-12));
    return EdgePlace{half + out * shrink, std::atan2(out.x, -out.y)};
}

void draw_hud(Canvas& canvas, const HudView& hud, const Plan* plan, const HudLook& look) {
    const Palette& palette = palette_for(look.colours);
    const dvec2 size = canvas.size();
    const Painter paint{canvas, hud, palette, look, hero_box(hud, size)};
    const double side = 132;
    Rect map{size, size};
    if (plan != nullptr && look.minimap) map = view::anchored(size, {1, 1}, dvec2(side), margin);
    paint.hurts();
    paint.markers(map);
    paint.hearts();
    paint.counts();
    if (look.timer) paint.clock();
    if (hud.watching) paint.pill("Watching a recorded run", Sign::play);
    if (!hud.mark.empty()) paint.pill(hud.mark, Sign::check);
    paint.section();
    if (map.size().x > 0) draw_minimap(canvas, *plan, hud.map, map, hud.hero, hud.facing, hud.camera.forward, palette);
    paint.prompt();
}

}  // namespace surefoot::platformer
