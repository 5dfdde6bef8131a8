#include "platformer/hud/minimap.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

namespace surefoot::platformer {
namespace {

using view::Colour;
using view::dvec2;
using view::Fill;
using view::Rect;
using view::Sign;
using view::with_opacity;

constexpr double reach = 22;  // from the hero to the map's edge [m]
constexpr double nothing = -std::numeric_limits<double>::infinity();

struct Heights {
    int side;
    std::vector<double> at;
    [[nodiscard]] double get(int x, int y) const {
        if (x < 0 || y < 0 || x >= side || y >= side) return nothing;
        return at[static_cast<std::size_t>(y) * static_cast<std::size_t>(side) + static_cast<std::size_t>(x)];
    }
};

/// Fills the pixels whose middle is in a triangle, keeping the highest.
void raise(Heights& heights, const dvec3& a, const dvec3& b, const dvec3& c) {
    const double area = (b.x - a.x) * (c.z - a.z) - (b.z - a.z) * (c.x - a.x);
    if (!(std::abs(area) > 1e-12)) return;
    const double last = heights.side - 1;
    const auto from = [&](double least) { return static_cast<int>(std::clamp(std::ceil(least - 0.5), 0.0, last)); };
    const auto to = [&](double most) { return static_cast<int>(std::clamp(std::floor(most - 0.5), -1.0, last)); };
    for (int y = from(std::min({a.z, b.z, c.z})); y <= to(std::max({a.z, b.z, c.z})); ++y) {
        for (int x = from(std::min({a.x, b.x, c.x})); x <= to(std::max({a.x, b.x, c.x})); ++x) {
            const dvec2 p(x + 0.5, y + 0.5);
            const double u = ((b.x - p.x) * (c.z - p.y) - (b.z - p.y) * (c.x - p.x)) / area;
            const double v = ((c.x - p.x) * (a.z - p.y) - (c.z - p.y) * (a.x - p.x)) / area;
            const double w = 1 - u - v;
            if (u < -1e-9 || v < -1e-9 || w < -1e-9) continue;
            double& height = heights.at[static_cast<std::size_t>(y) * static_cast<std::size_t>(heights.side) +
                                        static_cast<std::size_t>(x)];
            height = std::max(height, a.y * u + b.y * v + c.y * w);
        }
    }
}

Sign sign_of(MapItem::Kind kind) {
    switch (kind) {
        case MapItem::Kind::coin:
            return Sign::coin;
        case MapItem::Kind::star:
            return Sign::star;
        case MapItem::Kind::heart:
            return Sign::heart;
        case MapItem::Kind::key:
            return Sign::key;
        case MapItem::Kind::enemy:
            return Sign::enemy;
        case MapItem::Kind::checkpoint:
            return Sign::flag;
        case MapItem::Kind::goal:
            return Sign::beam;
        case MapItem::Kind::ghost:
            return Sign::ghost;
    }
    return Sign::coin;
}

Colour colour_of(MapItem::Kind kind, const Palette& palette) {
    switch (kind) {
        case MapItem::Kind::coin:
            return palette.coin;
        case MapItem::Kind::star:
            return palette.star;
        case MapItem::Kind::heart:
            return palette.health;
        case MapItem::Kind::key:
            return palette.key;
        case MapItem::Kind::enemy:
            return palette.danger;
        case MapItem::Kind::checkpoint:
            return palette.checkpoint;
        case MapItem::Kind::goal:
            return palette.goal;
        case MapItem::Kind::ghost:
            return palette.quiet;
    }
    return palette.paper;
}

}  // namespace

dvec2 Plan::share(const dvec3& place) const {
    return dvec2(place.x - low.x, place.z - low.z) / metres;
}

Plan make_plan(std::span<const dvec3> corners, int side) {
    Plan plan{.picture = {{1, 1}, {Colour{0, 0, 0, 0}}}};
    dvec3 low(1e300);
    dvec3 high(-1e300);
    const auto is_floor = [](const dvec3& a, const dvec3& b, const dvec3& c) {
        const dvec3 normal = glm::cross(b - a, c - a);
        return normal.y > 0.3 * glm::length(normal);  // false for what is not finite
    };
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
        if (!is_floor(corners[i], corners[i + 1], corners[i + 2])) continue;
        for (std::size_t k = i; k < i + 3; ++k) {
            low = glm::min(low, corners[k]);
            high = glm::max(high, corners[k]);
        }
    }
    if (!(low.x <= high.x)) return plan;
    // A border of two pixels, so that edges are seen on all sides.
    plan.metres = std::max({high.x - low.x, high.z - low.z, 1.0}) * side / (side - 4.0);
    const double pixel = plan.metres / side;
    const dvec2 middle((low.x + high.x) / 2, (low.z + high.z) / 2);
    plan.low = {middle.x - plan.metres / 2, low.y, middle.y - plan.metres / 2};
    Heights heights{side,
                    std::vector<double>(static_cast<std::size_t>(side) * static_cast<std::size_t>(side), nothing)};
    const auto on_map = [&](const dvec3& p) {
        return dvec3((p.x - plan.low.x) / pixel, p.y, (p.z - plan.low.z) / pixel);
    };
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3)
        if (is_floor(corners[i], corners[i + 1], corners[i + 2]))
            raise(heights, on_map(corners[i]), on_map(corners[i + 1]), on_map(corners[i + 2]));
    plan.picture.size = {side, side};
    plan.picture.pixels.assign(heights.at.size(), Colour{0, 0, 0, 0});
    constexpr double drop = 0.6;  // what one does not step over is an edge [m]
    const Colour deep = view::rgb(0x46586A);
    const Colour tall = view::rgb(0xB9C8D6);
    const Colour edge = view::rgb(0xF4F6F8);
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const double height = heights.get(x, y);
            if (height == nothing) continue;
            const double share = (height - low.y) / std::max(high.y - low.y, 1.0);
            bool is_edge = false;
            for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}})
                is_edge = is_edge || heights.get(x + dx, y + dy) < height - drop;
            plan.picture
                .pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(side) + static_cast<std::size_t>(x)] =
                is_edge ? edge : view::mixed(deep, tall, share);
        }
    }
    return plan;
}

void draw_minimap(view::Canvas& canvas, const Plan& plan, std::span<const MapItem> items, const Rect& place,
                  const dvec3& hero, const dvec3& facing, const dvec3& looking, const Palette& palette) {
    const dvec2 middle = place.middle();
    const double radius = place.size().x / 2;
    canvas.disc(middle, radius, Fill(with_opacity(palette.ink, 0.72)).edged(with_opacity(palette.paper, 0.7), 2));
    // The way the camera looks is up: the map turns, not the player's head.
    const double turn = std::atan2(looking.x, -looking.z);
    const double half = reach / plan.metres;
    canvas.picture(place, radius, plan.share(hero), dvec2(half), turn, 0.9);
    const dvec2 across(std::cos(turn), std::sin(turn));
    const double scale = radius / reach;
    for (const MapItem& item : items) {
        const dvec3 to = item.place - hero;
        dvec2 at = dvec2(to.x * across.x + to.z * across.y, to.z * across.x - to.x * across.y) * scale;
        const double far = glm::length(at);
        const bool is_goal = item.kind == MapItem::Kind::goal;
        if (far > radius - 7) {
            if (!is_goal) continue;
            at *= (radius - 7) / far;  // one always knows where to go
        }
        const bool is_coin = item.kind == MapItem::Kind::coin;
        const double size = is_coin ? 5 : 13;
        const Fill fill =
            Fill(item.colour.value_or(colour_of(item.kind, palette))).edged(with_opacity(palette.ink, 0.9), 1.2);
        if (is_coin)
            canvas.disc(middle + at, size / 2, fill);
        else
            canvas.sign(sign_of(item.kind), middle + at, size, fill);
        // Above or below by more than a storey.
        if (std::abs(to.y) > 3 && !is_coin) {
            const dvec2 tip = middle + at + dvec2(9, to.y > 0 ? -4.0 : 4.0);
            const double back = to.y > 0 ? 6 : -6;
            canvas.triangle(tip, tip + dvec2(-3.5, back), tip + dvec2(3.5, back), palette.paper);
        }
    }
    canvas.sign(Sign::arrow, middle, 15, Fill(palette.paper).edged(palette.ink, 1.5),
                std::atan2(facing.x, -facing.z) - turn);
}

}  // namespace surefoot::platformer
