#include "platformer/screens/draw_screens.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "platformer/screens/draw_entries.hpp"
#include "platformer/screens/palette.hpp"

namespace surefoot::platformer {
namespace {

using view::Align;
using view::Canvas;
using view::Colour;
using view::dvec2;
using view::Face;
using view::Rect;
using view::Sign;
using view::with_opacity;

/// Darker where words stand, so that they are legible over any picture.
void draw_ground(Canvas& canvas, ScreenId id, const Palette& palette) {
    const dvec2 size = canvas.size();
    if (id == ScreenId::title) {
        canvas.box({{0, 0}, size}, 0, {with_opacity(palette.ink, 0.15), with_opacity(palette.ink, 0.75)});
        canvas.box({{-60, -60}, {std::min(size.x * 0.75, 500.0), size.y + 60}}, 0,
                   view::Fill(with_opacity(palette.ink, 0.72)).soft(90));
        return;
    }
    const double dark = id == ScreenId::win ? 0.62 : 0.78;
    canvas.box({{0, 0}, size}, 0, {with_opacity(palette.ink, dark), with_opacity(palette.ink, 0.9)});
}

Colour colour_of(Medal medal, const Palette& palette) {
    switch (medal) {
        case Medal::gold:
            return palette.gold;
        case Medal::silver:
            return palette.silver;
        case Medal::bronze:
            return palette.bronze;
        case Medal::none:
            break;
    }
    return with_opacity(palette.quiet, 0.5);
}

void draw_title(Canvas& canvas, const Menu& menu, const Rect& page, const Palette& palette) {
    const double middle = canvas.size().x / 2;
    if (menu.id == ScreenId::title) {
        const double x = page.low.x + 12;
        canvas.text(menu.title, {x, 110}, {.size = 68, .colour = palette.paper, .face = Face::bold, .edge_width = 2.5});
        canvas.box({{x + 3, 126}, {x + 120, 131}}, 2.5, palette.accent);
        canvas.text(menu.subtitle, {x + 3, 154}, {.size = 17, .colour = palette.quiet, .edge_width = 1.5});
        return;
    }
    view::TextLook head{
        .size = 36, .colour = palette.paper, .face = Face::bold, .align = Align::middle, .edge_width = 1.5};
    head.size *= std::min(1.0, (canvas.size().x - 40) / std::max(canvas.width_of(menu.title, head), 1.0));
    canvas.text(menu.title, {middle, 58}, head);
    double y = 70;
    const view::TextLook quiet{.size = 15, .colour = palette.quiet, .align = Align::middle};
    for (const std::string_view line : canvas.lines_of(menu.subtitle, canvas.size().x - 60, quiet)) {
        canvas.text(line, {middle, y + 14}, quiet);
        y += 20;
        if (y > head_height - 14) break;  // no more than there is room for
    }
}

/// A figure of the win screen: a sign above a number.
void draw_figure(Canvas& canvas, Sign sign, Colour colour, const std::string& text, const dvec2& at,
                 const Palette& palette) {
    canvas.sign(sign, at, 30, view::Fill(colour).edged(with_opacity(palette.ink, 0.9), 1.5));
    canvas.text(text, at + dvec2(0, 38), {.size = 17, .colour = palette.paper, .align = Align::middle});
}

void draw_win(Canvas& canvas, const WinResult& won, const Palette& palette) {
    const double middle = canvas.size().x / 2;
    const bool is_best = !won.best_before || won.seconds < *won.best_before;
    canvas.text(time_text(won.seconds), {middle, 148},
                {.size = 46,
                 .colour = is_best ? palette.accent : palette.paper,
                 .face = Face::bold,
                 .align = Align::middle,
                 .edge_width = 2});
    const std::string best = !won.best_before ? std::string("your first time here")
                             : is_best        ? "a new best: " + time_text(*won.best_before - won.seconds) + " faster"
                                              : "your best is " + time_text(*won.best_before);
    canvas.text(best, {middle, 170}, {.size = 15, .colour = palette.quiet, .align = Align::middle});
    const double y = 204;
    draw_figure(canvas, Sign::medal, colour_of(won.medal, palette), std::string(label_of(won.medal)), {middle - 165, y},
                palette);
    draw_figure(canvas, Sign::coin, palette.coin, fmt::format("{} of {}", won.coins, won.coins_all), {middle - 55, y},
                palette);
    draw_figure(canvas, Sign::star, palette.star, fmt::format("{} of {}", won.stars, won.stars_all), {middle + 55, y},
                palette);
    draw_figure(canvas, Sign::skull, palette.quiet, won.deaths == 1 ? "1 fall" : fmt::format("{} falls", won.deaths),
                {middle + 165, y}, palette);
}

/// What the level asks for, and what was reached.
void draw_level(Canvas& canvas, const LevelCard& card, const Palette& palette) {
    const double middle = canvas.size().x / 2;
    canvas.text(card.best ? "Best " + time_text(*card.best) : std::string("Not won yet"), {middle, 130},
                {.size = 20, .colour = card.best ? palette.accent : palette.quiet, .align = Align::middle});
    double x = middle - 190;
    for (const auto& [medal, seconds] :
         {std::pair{Medal::gold, card.gold}, {Medal::silver, card.silver}, {Medal::bronze, card.bronze}}) {
        const bool reached = card.medal >= medal;
        canvas.sign(Sign::medal, {x, 162}, 26, with_opacity(colour_of(medal, palette), reached ? 1 : 0.4));
        canvas.text(time_text(seconds), {x + 20, 167}, {.size = 15, .colour = reached ? palette.paper : palette.quiet});
        x += 112;
    }
    for (int i = 0; i < card.stars_all; ++i)
        canvas.sign(Sign::star, {x + 6 + 24.0 * i, 162}, 22,
                    with_opacity(i < card.stars ? palette.star : palette.quiet, i < card.stars ? 1 : 0.35));
}

/// What keys do here, by the device in hand, and the sentence about what is in focus.
void draw_foot(Canvas& canvas, const Screens& screens, const Menu& menu, const Palette& palette) {
    const dvec2 size = canvas.size();
    const Entry& entry = menu.entries[screens.focus()];
    const bool pad = screens.device() == Device::gamepad;
    std::string hint = !screens.notice().empty() ? screens.notice() : entry.hint;
    if (screens.is_capturing())
        hint = entry.place < 2 ? "Press the key or mouse button for it. Escape leaves it as it is."
                               : "Press the button for it. Start or Escape leaves it as it is.";
    // In one line, or in smaller ones between the page and the keys: never over what is chosen.
    view::TextLook look{.size = 15,
                        .colour = screens.notice().empty() ? palette.paper : palette.accent,
                        .align = Align::middle,
                        .edge_width = 1};
    const double width = size.x - 40;
    if (canvas.width_of(hint, look) > width) look.size = 12;
    std::vector<std::string_view> lines = canvas.lines_of(hint, width, look);
    if (lines.size() > 2) {
        look.size = 9;
        lines = canvas.lines_of(hint, width, look);
        lines.resize(std::min<std::size_t>(lines.size(), 3));
    }
    double line_y = size.y - 42 - (double(lines.size()) - 1) * look.size * 0.55;
    for (const std::string_view line : lines) {
        canvas.text(line, {size.x / 2, line_y}, look);
        line_y += look.size * 1.1;
    }
    double x = size.x / 2 - 92;
    x += draw_key_cap(canvas, pad ? "A" : "Enter", {x, size.y - 18}, 13) + 6;
    x += canvas.text("choose", {x, size.y - 13}, {.size = 13, .colour = palette.quiet}) + 18;
    x += draw_key_cap(canvas, pad ? "B" : "Escape", {x, size.y - 18}, 13) + 6;
    canvas.text(menu.id == ScreenId::pause   ? "go on"
                : menu.id == ScreenId::title ? "quit"
                                             : "back",
                {x, size.y - 13}, {.size = 13, .colour = palette.quiet});
}

void draw_scroll_bar(Canvas& canvas, const Arrangement& all, double scroll, const Palette& palette) {
    if (all.highest_scroll <= 0) return;
    const double room = all.page.size().y;
    const double length = room * room / (room + all.highest_scroll);
    const double y = all.page.low.y + (room - length) * scroll / all.highest_scroll;
    const double x = std::min(all.page.high.x + 4, canvas.size().x - 7);
    canvas.box({{x, all.page.low.y}, {x + 5, all.page.high.y}}, 2.5, with_opacity(palette.paper, 0.12));
    canvas.box({{x, y}, {x + 5, y + length}}, 2.5, with_opacity(palette.paper, 0.6));
}

}  // namespace

void draw_screens(Canvas& canvas, const Screens& screens, double seconds) {
    if (screens.is_playing()) return;
    const Palette& palette = palette_for(screens.settings().colours);
    const Menu menu = screens.menu();
    const Arrangement all = arrange(menu, canvas.size(), screens.scroll());
    draw_ground(canvas, menu.id, palette);
    draw_title(canvas, menu, all.page, palette);
    if (menu.id == ScreenId::win) draw_win(canvas, screens.won(), palette);
    if (menu.id == ScreenId::level && screens.level() < screens.levels().size())
        draw_level(canvas, screens.levels()[screens.level()], palette);
    canvas.clip(all.page.grown(4));  // of what is in focus there is a frame
    const double pulse = screens.settings().reduced_motion ? 0 : std::sin(seconds * 4) * 0.5 + 0.5;
    for (std::size_t i = 0; i < menu.entries.size(); ++i) {
        if (!all.places[i].meets(all.page)) continue;
        draw_entry(canvas, screens, menu.entries[i], all.places[i], {palette, i == screens.focus(), pulse});
    }
    canvas.clip(std::nullopt);
    draw_scroll_bar(canvas, all, screens.scroll(), palette);
    draw_foot(canvas, screens, menu, palette);
}

double key_cap_width(const Canvas& canvas, std::string_view name, double size) {
    return std::max(canvas.width_of(name, {.size = size * 0.85, .face = Face::bold}) + size * 0.8, size * 1.5);
}

double draw_key_cap(Canvas& canvas, std::string_view name, const dvec2& left, double size, double opacity) {
    const double width = key_cap_width(canvas, name, size);
    const double half = size * 0.75;
    const Rect cap{left - dvec2(0, half), left + dvec2(width, half)};
    canvas.box({cap.low + dvec2(0, 2), cap.high + dvec2(0, 2)}, size * 0.35, view::rgb(0x000000, 0.55 * opacity));
    canvas.box(cap, size * 0.35, {view::rgb(0xFFFFFF, opacity), view::rgb(0xC9D3DC, opacity)});
    canvas.text_in(
        name, cap,
        {.size = size * 0.85, .colour = view::rgb(0x141B22, opacity), .face = Face::bold, .align = Align::middle});
    return width;
}

}  // namespace surefoot::platformer
