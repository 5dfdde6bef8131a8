// The display over the game points where things are, shows what there is, and leaves the hero to be seen.
#include "platformer/hud/hud.hpp"

#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>
#include <random>

namespace surefoot::platformer {
namespace {

using view::Canvas;
using view::CanvasItem;
using view::dvec2;
using view::Layout;

view::Letters& letters() {
    static view::Letters all;
    return all;
}

/// The hero some metres before the camera, which looks a little down on him.
HudView on_the_way(const view::ivec2& window = {800, 600}) {
    HudView hud;
    hud.coins_all = 40;
    hud.coins = 12;
    hud.hero = {0, 0.8, 0};
    hud.camera.eye = {0, 2.8, 5};
    hud.camera.forward = glm::normalize(dvec3(0, -0.3, -1));
    hud.camera.field_of_view = 1.05;
    hud.window = window;
    return hud;
}

TEST(EdgeMarkers, are_not_shown_for_what_is_in_sight) {
    const HudView hud = on_the_way();
    EXPECT_FALSE(edge_place(hud.camera, {0, 1, -10}, {800, 600}, 50));
    EXPECT_FALSE(edge_place(hud.camera, hud.hero, {800, 600}, 50));
}

TEST(EdgeMarkers, stand_at_the_side_where_one_has_to_turn) {
    const HudView hud = on_the_way();
    const auto right = edge_place(hud.camera, {50, 0, 0}, {800, 600}, 50);
    ASSERT_TRUE(right);
    EXPECT_NEAR(right->at.x, 750, 1e-9);
    EXPECT_NEAR(right->turn, std::numbers::pi / 2, 0.3);
    const auto left = edge_place(hud.camera, {-50, 0, 0}, {800, 600}, 50);
    EXPECT_NEAR(left.value().at.x, 50, 1e-9);
    const auto behind = edge_place(hud.camera, {0, 2, 90}, {800, 600}, 50);
    EXPECT_NEAR(behind.value().at.y, 550, 1e-9);
    const auto behind_and_higher = edge_place(hud.camera, {0, 20, 40}, {800, 600}, 50);
    EXPECT_NEAR(behind_and_higher.value().at.y, 550, 1e-9) << "one turns round for it, it is not in the sky";
    const auto above = edge_place(hud.camera, {0, 60, -9}, {800, 600}, 50);
    EXPECT_NEAR(above.value().at.y, 50, 1e-9);
    EXPECT_FALSE(edge_place(hud.camera, {std::nan(""), 0, 0}, {800, 600}, 50));
}

TEST(EdgeMarkers, stand_on_the_frame_for_every_place_out_of_sight) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> metres(-80, 80);
    const HudView hud = on_the_way();
    int out = 0;
    for (int i = 0; i < 20'000; ++i) {
        const auto edge = edge_place(hud.camera, {metres(random), metres(random), metres(random)}, {1067, 600}, 52);
        if (!edge) continue;
        ++out;
        const dvec2 from_frame = glm::abs(edge->at - dvec2(533.5, 300)) - dvec2(481.5, 248);
        ASSERT_NEAR(std::max(from_frame.x, from_frame.y), 0, 1e-6);
    }
    EXPECT_GT(out, 10'000);
}

/// Does this shape touch the box? Of a ring only the ring.
bool covers(const Canvas& canvas, const CanvasItem& item, const view::Rect& box) {
    if (item.b.w != static_cast<float>(CanvasItem::Kind::arc)) return canvas.bounds_of(item).meets(box);
    const double unit = canvas.layout().pixels();
    const dvec2 back = dvec2(-item.turn_and_widths.y, item.turn_and_widths.x) * double(item.b.y);
    const dvec2 middle = (dvec2(item.middle) + back) / unit;
    const double inner = (item.a.x - item.a.y - item.turn_and_widths.z) / unit;
    double farthest = 0;
    for (const dvec2 corner : {box.low, box.high, dvec2(box.low.x, box.high.y), dvec2(box.high.x, box.low.y)})
        farthest = std::max(farthest, glm::length(corner - middle));
    return farthest > inner;
}

TEST(Hud, never_covers_the_hero_whatever_it_shows) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> number(0, 1);
    Plan plan;
    plan.picture = {{1, 1}, {view::rgb(0)}};
    Canvas canvas(letters());
    for (int i = 0; i < 3000; ++i) {
        const view::ivec2 window = i % 3 == 0   ? view::ivec2(800, 600)
                                   : i % 3 == 1 ? view::ivec2(1920, 1080)
                                                : view::ivec2(3840, 2160);
        HudView hud = on_the_way(window);
        hud.camera.eye = hud.hero + dvec3(0, number(random) * 2, 4 + number(random) * 4);
        hud.camera.forward =
            glm::normalize(hud.hero + dvec3(number(random) - 0.5, 0.2 + number(random) * 0.6, 0) - hud.camera.eye);
        hud.most_health = 5;
        hud.health = static_cast<int>(random() % 6);
        hud.coins_all = 100;
        hud.keys = {"red", "blue"};
        hud.section = "Over the long bridge";
        hud.section_age = number(random) * 4;
        hud.section_split = number(random) - 0.5;
        hud.watching = random() % 2 == 0;
        hud.prompt = prompt_parts("Hold {jump} for a high jump, then {dash} over the gap before it closes.",
                                  Bindings::defaults(), random() % 2 == 0 ? Device::keyboard : Device::gamepad);
        for (int k = 0; k < 6; ++k) {
            const dvec3 place = dvec3(number(random) - 0.5, number(random) - 0.5, number(random) - 0.5) * 120.0;
            hud.markers.push_back({static_cast<HudMarker::Kind>(k), place});
            hud.hurts.push_back({place, number(random)});
            hud.map.push_back({static_cast<MapItem::Kind>(k), place});
        }
        canvas.begin({window, i % 2 == 0 ? 1.0 : 1.25});
        draw_hud(canvas, hud, &plan, {});
        const view::Rect hero = hero_box(hud, canvas.size());
        ASSERT_GT(hero.size().y, 40);
        for (const CanvasItem& item : canvas.items())
            ASSERT_FALSE(covers(canvas, item, hero))
                << "round " << i << ", kind " << item.b.w << " at " << canvas.bounds_of(item).middle().x << ", "
                << canvas.bounds_of(item).middle().y << "; the hero is from " << hero.low.x << ", " << hero.low.y
                << " to " << hero.high.x << ", " << hero.high.y;
    }
}

// The defect: the goal and the checkpoint before it, both behind the same edge, lay on each other.
TEST(EdgeMarkers, that_would_cover_each_other_step_aside) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> number(0, 1);
    Canvas canvas(letters());
    for (int i = 0; i < 2000; ++i) {
        HudView hud = on_the_way();
        const dvec3 place = dvec3(number(random) - 0.5, number(random) * 0.1, number(random) - 0.5) * 300.0;
        for (int k = 0; k < 4; ++k)
            hud.markers.push_back({static_cast<HudMarker::Kind>(k), place + dvec3(number(random), 0, number(random))});
        canvas.begin({{800, 600}, 1});
        draw_hud(canvas, hud, nullptr, {});
        std::vector<dvec2> grounds;  // of the markers: discs of 38
        for (const CanvasItem& item : canvas.items()) {
            const view::Rect bounds = canvas.bounds_of(item);
            if (item.b.w != static_cast<float>(CanvasItem::Kind::box) || std::abs(item.half.x - 19) > 1 ||
                std::abs(item.half.y - 19) > 1)
                continue;
            for (const dvec2& other : grounds) ASSERT_GT(glm::length(other - bounds.middle()), 40) << "round " << i;
            grounds.push_back(bounds.middle());
        }
        std::size_t outside = 0;
        for (const HudMarker& marker : hud.markers)
            outside += edge_place(hud.camera, marker.place, canvas.size(), 52) ? 1 : 0;
        ASSERT_EQ(grounds.size(), outside);
    }
}

TEST(Hud, keeps_within_the_window) {
    Canvas canvas(letters());
    for (const Layout layout : {Layout{{800, 600}, 1}, {{800, 600}, 1.5}, {{3840, 2160}, 1}, {{600, 900}, 1}}) {
        HudView hud = on_the_way(layout.framebuffer);
        hud.prompt = prompt_parts("Run with {move}, look around with {camera}, jump with {jump}, dash with {dash}.",
                                  Bindings::defaults(), Device::keyboard);
        hud.seconds = 1234.5;
        for (const dvec3 place : {dvec3(90, 0, 0), {-90, 0, 0}, {0, 90, 0}, {0, -90, 0}, {0, 0, 90}, {60, 60, 60}})
            hud.markers.push_back({HudMarker::Kind::goal, place});
        canvas.begin(layout);
        draw_hud(canvas, hud, nullptr, {});
        for (const CanvasItem& item : canvas.items()) {
            if (item.b.w == static_cast<float>(CanvasItem::Kind::glyph)) continue;  // their fields are wider than they
            const view::Rect bounds = canvas.bounds_of(item);
            EXPECT_GE(bounds.low.x, 0);
            EXPECT_GE(bounds.low.y, 0);
            EXPECT_LE(bounds.high.x, canvas.size().x);
            EXPECT_LE(bounds.high.y, canvas.size().y);
        }
    }
}

TEST(Hud, points_at_what_hurt) {
    Canvas canvas(letters());
    const auto angle_of = [&](const dvec3& from) {
        HudView hud = on_the_way();
        hud.hurts = {{from, 0}};
        canvas.begin({{800, 600}, 1});
        draw_hud(canvas, hud, nullptr, {});
        const CanvasItem& arc = canvas.items().front();
        EXPECT_EQ(arc.b.w, static_cast<float>(CanvasItem::Kind::arc));
        return std::atan2(double(arc.turn_and_widths.y), double(arc.turn_and_widths.x));
    };
    EXPECT_NEAR(angle_of({0, 1, -5}), 0, 1e-6);
    EXPECT_NEAR(angle_of({5, 9, 0}), std::numbers::pi / 2, 1e-6);
    EXPECT_NEAR(angle_of({-5, 0, 0}), -std::numbers::pi / 2, 1e-6);
    EXPECT_NEAR(std::abs(angle_of({0, 0, 7})), std::numbers::pi, 1e-6);
}

TEST(Hud, with_less_motion_nothing_moves_by_itself) {
    const auto drawn = [](double seconds, double since, bool reduced) {
        Canvas canvas(letters());
        HudView hud = on_the_way();
        hud.health = 1;
        hud.seconds = seconds;
        hud.since_coin = since;
        hud.since_health = since;
        hud.section = "The bridge";
        hud.section_age = 1 + since;
        canvas.begin({{800, 600}, 1});
        draw_hud(canvas, hud, nullptr, {.reduced_motion = reduced, .timer = false});
        std::vector<float> places;
        for (const CanvasItem& item : canvas.items())
            places.insert(places.end(), {item.middle.x, item.middle.y, item.half.x, item.half.y, float(item.top.a)});
        return places;
    };
    EXPECT_EQ(drawn(1, 0.1, true), drawn(1.3, 0.2, true));
    EXPECT_NE(drawn(1, 0.1, false), drawn(1.3, 0.2, false));
}

TEST(Plan, shows_floors_from_above_and_no_walls) {
    const auto square = [](double x, double z, double size, double y) {
        return std::vector<dvec3>{{x, y, z}, {x, y, z + size},        {x + size, y, z + size},
                                  {x, y, z}, {x + size, y, z + size}, {x + size, y, z}};
    };
    std::vector<dvec3> corners = square(0, 0, 10, 0);
    const auto upper = square(6, 6, 4, 5);
    corners.insert(corners.end(), upper.begin(), upper.end());
    for (const dvec3 wall : {dvec3(30, 0, 0), dvec3(30, 5, 0), dvec3(30, 0, 5)}) corners.push_back(wall);
    for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity(), 0.0})
        corners.push_back({bad, bad, 0});
    const Plan plan = make_plan(corners, 128);
    const auto at = [&](double x, double z) {
        const dvec2 share = plan.share({x, 0, z});
        return plan.picture.at(static_cast<int>(share.x * 128), static_cast<int>(share.y * 128));
    };
    EXPECT_NEAR(plan.metres, 10.3, 0.1) << "the wall does not count";
    EXPECT_EQ(at(3, 3).a, 255);
    EXPECT_GT(at(8, 8).r, at(3, 3).r + 40) << "the higher, the lighter";
    EXPECT_GT(std::max(at(6.04, 8).r, at(6.11, 8).r), 220) << "an edge";
    EXPECT_EQ(plan.picture.at(0, 0).a, 0);
    EXPECT_EQ(make_plan({}).picture.pixels.size(), 1U);
}

/// What an eye without one kind of cone sees: Vienot, Brettel and Mollon 1999, for eyes without red or green cones.
dvec3 seen_without(const view::Colour& colour, bool red) {
    const auto linear = [](std::uint8_t part) { return std::pow(part / 255.0, 2.2); };
    const dvec3 rgb(linear(colour.r), linear(colour.g), linear(colour.b));
    const double first = red ? 0.11238 * rgb.x + 0.88762 * rgb.y : 0.29275 * rgb.x + 0.70725 * rgb.y;
    const double blue = red ? 0.00401 * rgb.x - 0.00401 * rgb.y + rgb.z : -0.02234 * rgb.x + 0.02234 * rgb.y + rgb.z;
    const auto shown = [](double part) { return std::pow(std::max(part, 0.0), 1 / 2.2); };
    return {shown(first), shown(first), shown(blue)};
}

TEST(Palettes, for_eyes_that_see_red_and_green_alike_tell_friend_from_danger) {
    const auto apart = [](const Palette& p, bool red) {
        double least = 9;
        for (const auto& [a, b] :
             {std::pair{p.goal, p.danger}, {p.checkpoint, p.danger}, {p.goal, p.health}, {p.goal, p.coin}})
            least = std::min(least, glm::length(seen_without(a, red) - seen_without(b, red)));
        return least;
    };
    for (const bool red : {true, false}) {
        EXPECT_GT(apart(palette_for(ColourVision::red_green), red), 0.5);
        EXPECT_LT(apart(palette_for(ColourVision::usual), red), 0.5) << "else nobody would need the other";
    }
}

// The defect: red and blue keys were one pink, and only a colour said which door is whose.
TEST(Palettes, keys_are_told_apart_by_every_eye_and_by_their_letter) {
    const auto apart = [](const view::Colour& a, const view::Colour& b) {
        return std::abs(a.r - b.r) + std::abs(a.g - b.g) + std::abs(a.b - b.b);
    };
    for (int i = 0; i < static_cast<int>(ColourVision::count); ++i) {
        const auto vision = static_cast<ColourVision>(i);
        for (const auto& [a, b] :
             {std::pair{"red", "blue"}, {"red", "green"}, {"blue", "yellow"}, {"green", "violet"}}) {
            const view::Colour one = key_colour(a, vision);
            const view::Colour other = key_colour(b, vision);
            EXPECT_GT(apart(one, other), 150) << a << " " << b << " " << i;
            if (vision != ColourVision::red_green) continue;
            for (const bool red : {true, false})
                EXPECT_GT(glm::length(seen_without(one, red) - seen_without(other, red)), 0.3) << a << " " << b;
        }
        EXPECT_GT(apart(key_colour("vault", vision), palette_for(vision).ink), 150)
            << "a name of one's own has one too";
    }
    EXPECT_EQ(key_sign("red"), "R");
    EXPECT_EQ(key_sign("Blue"), "B");
    EXPECT_EQ(key_sign(""), "");
}

TEST(Palettes, are_legible) {
    const auto light = [](const view::Colour& c) {
        const auto linear = [](std::uint8_t part) { return std::pow(part / 255.0, 2.2); };
        return 0.2126 * linear(c.r) + 0.7152 * linear(c.g) + 0.0722 * linear(c.b);
    };
    const auto contrast = [&](const view::Colour& a, const view::Colour& b) {
        return (std::max(light(a), light(b)) + 0.05) / (std::min(light(a), light(b)) + 0.05);
    };
    for (int i = 0; i < static_cast<int>(ColourVision::count); ++i) {
        const Palette& p = palette_for(static_cast<ColourVision>(i));
        EXPECT_GT(contrast(p.paper, p.ink), 7) << i;
        EXPECT_GT(contrast(p.quiet, p.ink), 4.5) << i;
        EXPECT_GT(contrast(p.accent, p.ink), 4.5) << i;
        EXPECT_GT(contrast(p.danger, p.ink), 4.5) << i;
    }
}

}  // namespace
}  // namespace surefoot::platformer
