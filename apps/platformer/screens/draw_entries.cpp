#include "platformer/screens/draw_entries.hpp"

#include <algorithm>
#include <fmt/format.h>

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

/// The ground of what can be chosen. Focus is told by a frame, a lighter ground and darker letters, not by colour
/// alone.
void draw_plate(Canvas& canvas, const Rect& place, const EntryLook& look, bool enabled) {
    const Palette& p = look.palette;
    if (!look.focused) {
        canvas.box(place, 8, with_opacity(view::mixed(p.ink, p.paper, 0.12), enabled ? 0.85 : 0.5));
        return;
    }
    const Colour ground = enabled ? p.accent : view::mixed(p.accent, p.ink, 0.6);
    canvas.box(place, 8, Fill(view::mixed(ground, p.paper, 0.15), ground).edged(p.paper, 1.5 + look.pulse));
}

Colour letters_on(const EntryLook& look, bool enabled) {
    if (look.focused) return enabled ? look.palette.ink : look.palette.paper;
    return enabled ? look.palette.paper : with_opacity(look.palette.quiet, 0.6);
}

Rect inset(const Rect& place, double by) {
    return {{place.low.x + by, place.low.y}, {place.high.x - by, place.high.y}};
}

/// As large as it fits.
void fit_text(Canvas& canvas, std::string_view words, const Rect& place, view::TextLook look) {
    const double width = canvas.width_of(words, look);
    if (width > place.size().x) look.size *= place.size().x / width;
    canvas.text_in(words, place, look);
}

void draw_card(Canvas& canvas, const LevelCard& card, const Entry& entry, const Rect& place, const EntryLook& look) {
    const Palette& p = look.palette;
    draw_plate(canvas, place, look, entry.enabled);
    const Colour words = letters_on(look, entry.enabled);
    const Rect inner = inset(place, 12);
    const auto row = [&](double from, double to) {
        return Rect{{inner.low.x, place.low.y + from}, {inner.high.x, place.low.y + to}};
    };
    const Colour dark = with_opacity(p.ink, look.focused ? 0.85 : 0.6);
    if (card.locked) {
        canvas.sign(Sign::lock, row(26, 82).middle(), 34, Fill(p.quiet).edged(dark, 1.5));
        fit_text(canvas, card.secret ? "Secret" : entry.label, row(84, 116),
                 {.size = 16, .colour = words, .face = Face::bold, .align = Align::middle});
        return;
    }
    if (!card.own)
        canvas.text(fmt::format("{}", entry.index + 1), {inner.low.x, place.low.y + 30},
                    {.size = 20, .colour = with_opacity(words, 0.7), .face = Face::bold});
    const Colour metal = card.medal == Medal::gold     ? p.gold
                         : card.medal == Medal::silver ? p.silver
                         : card.medal == Medal::bronze ? p.bronze
                                                       : with_opacity(p.quiet, 0.25);
    canvas.sign(Sign::medal, {inner.high.x - 14, place.low.y + 24}, 30, Fill(metal).edged(dark, 1.5));
    fit_text(canvas, entry.label, row(40, 68), {.size = 18, .colour = words, .face = Face::bold});
    canvas.sign(Sign::clock, {inner.low.x + 8, place.low.y + 80}, 15, words);
    canvas.text_in(card.best ? time_text(*card.best) : std::string("not won yet"),
                   {{inner.low.x + 22, place.low.y + 70}, {inner.high.x, place.low.y + 90}},
                   {.size = 15, .colour = words});
    for (int i = 0; i < card.stars_all; ++i)
        canvas.sign(Sign::star, {inner.low.x + 9 + 22.0 * i, place.low.y + 108}, 19,
                    i < card.stars ? Fill(p.star).edged(dark, 1.5) : Fill(with_opacity(p.quiet, 0.35)));
    canvas.text_in(fmt::format("{}/{}", card.coins, card.coins_all), row(98, 118),
                   {.size = 15, .colour = words, .align = Align::right});
    const double width = canvas.width_of(fmt::format("{}/{}", card.coins, card.coins_all), {.size = 15});
    canvas.sign(Sign::coin, {inner.high.x - width - 13, place.low.y + 108}, 16, Fill(p.coin).edged(dark, 1.5));
}

void draw_setting(Canvas& canvas, const Entry& entry, const Rect& place, const EntryLook& look) {
    const Palette& p = look.palette;
    draw_plate(canvas, place, look, true);
    const Colour words = letters_on(look, true);
    const Rect rail = rail_of(place);
    fit_text(canvas, entry.label, {{place.low.x + 14, place.low.y}, {rail.low.x - 10, place.high.y}},
             {.size = 16, .colour = words});
    const double y = place.middle().y;
    const Colour dark = with_opacity(p.ink, 0.8);
    if (entry.kind == Entry::Kind::slider) {
        const double x = rail.low.x + rail.size().x * entry.share;
        canvas.line({rail.low.x, y}, {rail.high.x, y}, 6, Fill(with_opacity(p.ink, 0.55)));
        canvas.line({rail.low.x, y}, {x, y}, 6, look.focused ? p.ink : p.accent);
        canvas.disc({x, y}, 9, Fill(p.paper).edged(dark, 1.5));
        canvas.text_in(entry.value, inset(place, 14), {.size = 15, .colour = words, .align = Align::right});
    } else if (entry.kind == Entry::Kind::toggle) {
        const Rect pill{{rail.low.x, y - 10}, {rail.low.x + 42, y + 10}};
        const bool on = entry.share > 0.5;
        canvas.box(pill, 10, Fill(on ? (look.focused ? p.ink : p.accent) : with_opacity(p.ink, 0.45)).edged(dark, 1));
        canvas.disc({on ? pill.high.x - 10 : pill.low.x + 10, y}, 7.5, p.paper);
        canvas.text_in(entry.value, {{pill.high.x + 12, place.low.y}, place.high}, {.size = 15, .colour = words});
    } else if (entry.kind == Entry::Kind::line) {
        const Rect line{{rail.low.x, place.low.y + 5}, {place.high.x - 12, place.high.y - 5}};
        canvas.box(line, 5, Fill(with_opacity(p.ink, look.focused ? 0.8 : 0.45)).edged(dark, 1));
        // A line that is too long shows its end: that is where one types.
        const view::TextLook letters{.size = 15, .colour = p.paper};
        std::string shown = entry.value;
        while (!shown.empty() && canvas.width_of(shown, letters) > line.size().x - 20) {
            do shown.erase(0, 1);
            while (!shown.empty() && (static_cast<unsigned char>(shown.front()) & 0xC0U) == 0x80U);
        }
        canvas.text_in(shown, inset(line, 8), letters);
        const double end = line.low.x + 10 + canvas.width_of(shown, letters);
        if (look.focused) canvas.line({end, y - 8}, {end, y + 8}, 1.5, p.paper);
    } else {
        canvas.triangle({rail.low.x, y}, {rail.low.x + 9, y - 7}, {rail.low.x + 9, y + 7}, words, 1);
        canvas.triangle({place.high.x - 14, y}, {place.high.x - 23, y - 7}, {place.high.x - 23, y + 7}, words, 1);
        fit_text(canvas, entry.value, {{rail.low.x + 16, place.low.y}, {place.high.x - 30, place.high.y}},
                 {.size = 15, .colour = words, .align = Align::middle});
    }
}

void draw_binding(Canvas& canvas, const Screens& screens, const Entry& entry, const Rect& place,
                  const EntryLook& look) {
    draw_plate(canvas, place, look, true);
    const bool waits = look.focused && screens.is_capturing();
    const std::string words = waits ? "..." : entry.value.empty() ? "\u2013" : entry.value;
    // What is there without being bound is paler.
    const Device device = entry.place < 2 ? Device::keyboard : Device::gamepad;
    const bool is_bound = bool(screens.settings().bindings.rows[entry.index][entry.place]);
    const bool is_always = !is_bound && words == Bindings::always(static_cast<Action>(entry.index), device);
    const Colour letters = letters_on(look, true);
    fit_text(canvas, words, inset(place, 6),
             {.size = 15, .colour = is_always ? with_opacity(letters, 0.6) : letters, .align = Align::middle});
    if (entry.column != 0) return;
    const Rect page{{place.low.x - 178, place.low.y}, {place.low.x - 8, place.high.y}};
    fit_text(canvas, entry.label, page, {.size = 15, .colour = look.palette.paper, .align = Align::right});
}

}  // namespace

void draw_entry(Canvas& canvas, const Screens& screens, const Entry& entry, const Rect& place, const EntryLook& look) {
    const Palette& p = look.palette;
    switch (entry.kind) {
        case Entry::Kind::heading:
            canvas.text(entry.label, {place.low.x + 2, place.high.y - 6},
                        {.size = 16, .colour = p.accent, .face = Face::bold});
            break;
        case Entry::Kind::text:
            fit_text(canvas, entry.label,
                     {place.low, {place.low.x + place.size().x * (entry.value.empty() ? 1 : 0.55), place.high.y}},
                     {.size = 15, .colour = p.quiet});
            fit_text(canvas, entry.value, {{place.low.x + place.size().x * 0.57, place.low.y}, place.high},
                     {.size = 15, .colour = p.paper, .face = Face::bold});
            break;
        case Entry::Kind::card:
            draw_card(canvas, screens.levels()[entry.index], entry, place, look);
            break;
        case Entry::Kind::binding:
            draw_binding(canvas, screens, entry, place, look);
            break;
        case Entry::Kind::button:
            draw_plate(canvas, place, look, entry.enabled);
            fit_text(canvas, entry.label, inset(place, 14),
                     {.size = 17,
                      .colour = letters_on(look, entry.enabled),
                      .face = look.focused ? Face::bold : Face::plain});
            break;
        default:
            draw_setting(canvas, entry, place, look);
            break;
    }
}

}  // namespace surefoot::platformer
