#include "platformer/screens/arrange.hpp"

#include <algorithm>

namespace surefoot::platformer {
namespace {

using view::dvec2;
using view::Rect;

/// How wide the column of entries may be.
double widest(ScreenId id) {
    switch (id) {
        case ScreenId::levels:
            return 900;
        case ScreenId::options:
        case ScreenId::help:
        case ScreenId::credits:
        case ScreenId::form:
        case ScreenId::trouble:
            return 620;
        case ScreenId::bindings:
            return 740;
        default:
            return 360;
    }
}

double height_of(Entry::Kind kind) {
    switch (kind) {
        case Entry::Kind::card:
            return 122;
        case Entry::Kind::heading:
            return 30;
        case Entry::Kind::text:
            return 22;
        case Entry::Kind::binding:
            return 30;
        case Entry::Kind::button:
            return 38;
        default:
            return 32;
    }
}

/// Won and lost show figures between title and entries.
double figures_height(ScreenId id) {
    return id == ScreenId::win ? 150 : id == ScreenId::level ? 96 : 0;
}

}  // namespace

Rect rail_of(const Rect& entry) {
    const double width = entry.size().x;
    return {{entry.low.x + width * 0.52, entry.low.y}, {entry.high.x - 70, entry.high.y}};
}

Arrangement arrange(const Menu& menu, const dvec2& size, double scroll) {
    constexpr double gap = 6;
    const double width = std::min(widest(menu.id), size.x - 40);
    const double left = menu.id == ScreenId::title ? std::min(70.0, (size.x - width) / 2) : (size.x - width) / 2;
    // The title's name is larger than other screens' titles.
    const double top = head_height + figures_height(menu.id) + (menu.id == ScreenId::title ? 70 : 0);
    Arrangement all;
    all.page = {{left - 12, std::min(top, size.y * 0.6)}, {left + width + 12, size.y - foot_height}};
    double y = 0;
    double row_height = 0;
    int row = -1;
    bool is_text = false;  // of which lines follow each other as in a book
    for (const Entry& entry : menu.entries) {
        if (entry.row != row) {
            if (row >= 0) y += row_height + (is_text && entry.kind == Entry::Kind::text ? 0 : gap);
            row = entry.row;
            row_height = height_of(entry.kind);
            is_text = entry.kind == Entry::Kind::text;
        }
        Rect place{{left, y}, {left + width, y + row_height}};
        const bool is_of_table = menu.id == ScreenId::bindings && entry.kind != Entry::Kind::button;
        if (entry.kind == Entry::Kind::card || is_of_table) {
            const double label = is_of_table ? width * 0.25 : 0;
            const double cell = (width - label + gap) / menu.columns;
            place.low.x = left + label + cell * entry.column;
            place.high.x = place.low.x + cell - gap;
        }
        all.places.push_back(place);
    }
    y += row_height;
    const double room = all.page.size().y;
    all.highest_scroll = std::max(0.0, y - room);
    // What is lower than the page stands in its upper third rather than at its top.
    const double spare = menu.id == ScreenId::title ? 0 : std::max(0.0, room - y) * 0.3;
    const double by = all.page.low.y + spare - std::clamp(scroll, 0.0, all.highest_scroll);
    for (Rect& place : all.places) {
        place.low.y += by;
        place.high.y += by;
    }
    return all;
}

}  // namespace surefoot::platformer
