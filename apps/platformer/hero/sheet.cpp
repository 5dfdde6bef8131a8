// Writes a contact sheet: every pose of the hero, the enemies, what is collected. A picture to look at after a change.
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <surefoot/mesh.hpp>

#include "platformer/hero/enemy.hpp"
#include "platformer/hero/figure.hpp"
#include "platformer/hero/particles.hpp"
#include "platformer/hero/props.hpp"
#include "view/contact_sheet.hpp"
#include "view/display.hpp"
#include "view/gl.hpp"
#include "view/imgui_adapter.hpp"

namespace surefoot::platformer {
namespace {

constexpr view::ivec2 cell(300, 260);

struct Cell {
    std::string caption;
    std::vector<view::Piece> pieces;
    double wide = 1.5;  // how much of the world is to be seen, upwards [m]
    dvec3 middle{0, 0.8, 0};
    double yaw = 0.55;  // from where; 0 sees its face
    std::function<void(view::Renderer&)> draw{};
};

HeroPose posed(HeroAct act, const StanceMoment& moment) {
    HeroPose pose = hero_at({}, {});
    pose.soles = {0, 0, 0};
    pose.act = act;
    pose.clock = moment.clock;
    pose.stance = stance_of(act, moment);
    if (act == HeroAct::run || act == HeroAct::idle || act == HeroAct::crouch) {
        // Some strides, so that the feet are where they would be.
        Feet feet{};
        const double speed = moment.speed;
        for (int i = 0; i < 240; ++i) {
            const double left_to_go = (239 - i) / 60.0;
            feet = advance(feet,
                           {{0, 0, -left_to_go * speed},
                            {0, 0, 0},
                            {0, 1, 0},
                            0,
                            {0, 0, speed},
                            moment.stride - left_to_go * speed / stride_length(speed),
                            0.13},
                           1.0 / 60);
        }
        pose.feet = feet;
        pose.lean_forward = 0.05 * std::min(speed, 6.5) / 6.5;
    } else {
        for (std::size_t i = 0; i < 2; ++i) pose.feet[i] = {pose.stance.feet[i], {}, 0, pose.stance.toes[i]};
    }
    // The scarf, as it trails after some way at this speed.
    const dvec3 velocity(0, moment.rise, act == HeroAct::wall_slide ? 0 : moment.speed);
    Scarf scarf = hanging_scarf({0, 0.9, -0.16}, {0, 0, -1});
    const Frame frame = standing_frame(pose);
    const dvec3 knot =
        frame.at(pose.stance.body + pose.stance.head * 0.7 + pitched(pose.stance.pitch) * dvec3(0, 0.27, -0.17));
    for (int i = 0; i < 120; ++i) {
        const dvec3 off = velocity * ((i - 119) / 60.0);
        scarf = advance(scarf, knot + off, pose.stance.body + off, 0.27, -10, act == HeroAct::swim ? 7 : 2.6, i / 60.0,
                        1.0 / 60);
    }
    pose.scarf = scarf;
    return pose;
}

Cell hero(const char* caption, HeroAct act, const StanceMoment& moment, double yaw = 0.55) {
    Cell made{caption, {}, 2.0, {0, 0.8, 0}, yaw};
    add_pieces(made.pieces, posed(act, moment));
    return made;
}

std::vector<Cell> hero_cells() {
    std::vector<Cell> cells;
    cells.push_back(hero("idle", HeroAct::idle, {.clock = 1.0}));
    cells.push_back(hero("idle, from behind", HeroAct::idle, {.clock = 1.0}, 3.5));
    cells.push_back(hero("run", HeroAct::run, {.clock = 1, .stride = 0.22, .speed = 6.5}, 1.1));
    cells.push_back(hero("run, the other foot", HeroAct::run, {.clock = 1, .stride = 0.62, .speed = 6.5}, 3.6));
    cells.push_back(hero("jump", HeroAct::jump, {.time = 0.1, .clock = 1, .speed = 4, .rise = 5}, 0.9));
    cells.push_back(hero("fall", HeroAct::fall, {.time = 1, .clock = 1.1, .speed = 3, .rise = -8}));
    HeroPose landed = posed(HeroAct::idle, {.clock = 1});
    landed.squash = -0.28;
    cells.push_back({"land", {}, 2.0, {0, 0.8, 0}, 0.55});
    add_pieces(cells.back().pieces, landed);
    HeroPose leaning = posed(HeroAct::run, {.clock = 1, .stride = 0.4, .speed = 6});
    leaning.lean_left = 0.28;
    leaning.look_left = 0.5;
    cells.push_back({"lean into a turn", {}, 2.0, {0, 0.8, 0}, 0.2});
    add_pieces(cells.back().pieces, leaning);
    HeroPose flipping = posed(HeroAct::jump, {.clock = 1, .rise = 4});
    flipping.flip = 4;
    cells.push_back({"somersault", {}, 2.0, {0, 0.8, 0}, 1.2});
    add_pieces(cells.back().pieces, flipping);
    cells.push_back(hero("crouch", HeroAct::crouch, {.clock = 1}));
    cells.push_back(hero("slide", HeroAct::slide, {.clock = 1, .speed = 6}, 1.1));
    cells.push_back(hero("hang", HeroAct::hang, {.clock = 1}, 2.6));
    cells.push_back(hero("climb", HeroAct::climb, {.clock = 1}, 2.2));
    cells.push_back(hero("wall slide", HeroAct::wall_slide, {.clock = 1, .rise = -2.5, .wall_side = 1}, 0.2));
    cells.push_back(hero("ladder", HeroAct::ladder, {.clock = 1, .stride = 0.2, .rise = 2}, 2.5));
    cells.push_back(hero("swim", HeroAct::swim, {.clock = 1, .speed = 4}, 1.1));
    cells.push_back(hero("tread water", HeroAct::swim, {.clock = 1, .speed = 0.2}));
    HeroPose dashing = posed(HeroAct::dash, {.clock = 1, .speed = 14});
    for (std::size_t i = 0; i < after_image_count; ++i)
        dashing.images[i] = {{dmat3(1), {0, 0, -0.45 - 0.5 * double(i)}}, dashing.stance, 0.02 + 0.06 * double(i)};
    cells.push_back({"dash", {}, 2.4, {0, 0.8, -0.5}, 1.1});
    add_pieces(cells.back().pieces, dashing);
    cells.push_back(hero("hurt", HeroAct::hurt, {.time = 0.1, .clock = 1}, 0.8));
    cells.push_back(hero("win", HeroAct::win, {.time = 0.32, .clock = 1}));
    cells.push_back(hero("win, the other beat", HeroAct::win, {.time = 0.80, .clock = 1}, -0.3));
    return cells;
}

Cell enemy(const char* caption, EnemyKind kind, EnemyMood mood, double mood_time, double stride, double yaw) {
    EnemyPose pose = enemy_at(kind, {0, 0, 0}, 0, 1.0);
    pose.mood = mood;
    pose.mood_time = mood_time;
    pose.stride = stride;
    pose.alarm = mood == EnemyMood::attack ? 1 : 0;
    if (kind == EnemyKind::jumper && mood == EnemyMood::attack) {
        pose.on_ground = false;
        pose.soles.y = 0.5;
        pose.squash = 0.15;
    }
    Cell made{caption, {}, 2.2, {0, 0.85, 0}, yaw};
    add_pieces(made.pieces, pose);
    return made;
}

std::vector<Cell> enemy_cells() {
    return {enemy("chaser, idle", EnemyKind::chaser, EnemyMood::idle, 1, 0.2, 0.6),
            enemy("chaser, attacks", EnemyKind::chaser, EnemyMood::attack, 1, 0.5, 0.9),
            enemy("chaser, stomped", EnemyKind::chaser, EnemyMood::stomped, 0.2, 0, 0.6),
            enemy("patroller, idle", EnemyKind::patroller, EnemyMood::idle, 1, 0.2, 0.6),
            enemy("patroller, notices", EnemyKind::patroller, EnemyMood::notice, 0.3, 0, 0.6),
            enemy("patroller, attacks", EnemyKind::patroller, EnemyMood::attack, 1, 0.5, 0.9),
            enemy("jumper, idle", EnemyKind::jumper, EnemyMood::idle, 1, 0, 0.6),
            enemy("jumper, attacks", EnemyKind::jumper, EnemyMood::attack, 1, 0, 0.9),
            enemy("jumper, notices", EnemyKind::jumper, EnemyMood::notice, 0.3, 0, 0.3),
            enemy("shooter, idle", EnemyKind::shooter, EnemyMood::idle, 1, 0, 0.6),
            enemy("shooter, attacks", EnemyKind::shooter, EnemyMood::attack, 1, 0, 0.9),
            enemy("shooter, notices", EnemyKind::shooter, EnemyMood::notice, 0.3, 0, 0.3)};
}

std::vector<Cell> prop_cells() {
    const PropMoment now{.clock = 0.25};
    const auto prop = [](const char* caption, double wide, double middle, std::function<void(view::Renderer&)> draw) {
        return Cell{caption, {}, wide, {0, middle, 0}, 0.5, std::move(draw)};
    };
    std::vector<Cell> cells;
    cells.push_back(prop("coins", 1.9, 0.6, [now](view::Renderer& r) {
        for (const double x : {-0.8, 0.0, 0.8}) draw_coin(r, {x, 0.6, 0}, now);
    }));
    cells.push_back(prop("star; found before", 1.6, 0.7, [now](view::Renderer& r) {
        draw_star(r, {-0.6, 0.7, 0}, now);
        draw_star(r, {0.7, 0.7, 0}, now, true);
    }));
    cells.push_back(prop("heart and key", 1.4, 0.6, [now](view::Renderer& r) {
        draw_heart(r, {-0.5, 0.6, 0}, now);
        draw_key(r, {0.5, 0.6, 0}, now, view::rgb(0xE0483E));
    }));
    cells.push_back(prop("checkpoint", 2.8, 1.2, [now](view::Renderer& r) {
        draw_checkpoint(r, {-0.9, 0, 0}, now, 0);
        draw_checkpoint(r, {0.7, 0, 0}, now, 1);
    }));
    cells.push_back(prop("goal", 3.4, 1.5, [now](view::Renderer& r) { draw_goal(r, {0, 0, 0}, now, 1.0); }));
    cells.push_back(prop("bullets, dust, sparkles, splash", 2.4, 0.7, [](view::Renderer& r) {
        draw_bullet(r, {-1.2, 1.3, 0}, {5, 0, 3}, 0.14);
        Particles puffs(3);
        puffs.land({-0.8, 0, 0.4}, 9);
        puffs.sparkle({0.4, 1.0, 0}, view::rgb(0xFFD84A));
        puffs.splash({1.2, 0.1, -0.4}, 6);
        for (int i = 0; i < 10; ++i) puffs.advance(1.0 / 60);
        puffs.draw(r, 1);
    }));
    return cells;
}

std::shared_ptr<view::Model> floor_model(int half) {
    std::vector<vec3> vertices;
    std::vector<std::uint32_t> indices;
    for (int x = -half; x < half; ++x)
        for (int z = -half; z < half; ++z) {
            const auto first = std::uint32_t(vertices.size());
            for (const auto& [dx, dz] : {std::pair{0, 0}, {0, 1}, {1, 1}, {1, 0}})
                vertices.emplace_back(x + dx, 0, z + dz);
            for (const std::uint32_t k : {0U, 1U, 2U, 0U, 2U, 3U}) indices.push_back(first + k);
        }
    const auto mesh = Mesh::build({.vertices = vertices, .indices = indices});
    return view::Model::make(*mesh, [](const SourceTriangle& t) {
        const dvec3 middle = (t.triangle.a + t.triangle.b + t.triangle.c) / 3.0;
        const bool even = (int(std::floor(middle.x)) + int(std::floor(middle.z))) % 2 == 0;
        return even ? view::rgb(0x8FA37C) : view::rgb(0x98AB85);
    });
}

/// How long a frame takes with everything in it that a game has, at 800x600 and with what the software renderer does.
int measure() {
    constexpr view::ivec2 size(800, 600);
    auto display = view::Display::open({.size = size, .headless = true});
    if (!display) {
        std::fprintf(stderr, "%s\n", display.error().text.c_str());
        return 1;
    }
    view::Renderer renderer;
    renderer.effects = view::Effects::software();
    const auto floor = floor_model(39);  // 12,168 triangles
    const HeroPose hero_pose = posed(HeroAct::run, {.clock = 1, .stride = 0.3, .speed = 6.5});
    for (const bool full : {false, true}) {
        double best = 1e9;
        double sum = 0;
        constexpr int frames = 60;
        for (int i = 0; i < frames; ++i) {
            const auto start = std::chrono::steady_clock::now();
            view::FrameView frame;
            frame.size = frame.framebuffer = size;
            frame.camera.eye = {0, 3, -6};
            frame.camera.forward = glm::normalize(dvec3(0, -0.3, 1));
            renderer.begin(frame);
            renderer.model(floor);
            if (full) {
                draw(renderer, hero_pose, hero_pose, 0.5);
                for (int k = 0; k < 10; ++k) {
                    const auto kind = static_cast<EnemyKind>(k % 4);
                    const EnemyPose pose = enemy_at(kind, {k - 4.5, 0, 3.0 + k % 3}, 3.0);
                    draw(renderer, pose, pose, 0.5);
                }
                for (int k = 0; k < 60; ++k)
                    draw_coin(renderer, {(k % 10) * 1.2 - 5.4, 0.6, 5.0 + k / 10}, {.clock = i / 60.0});
            }
            renderer.end((*display)->framebuffer());
            glFinish();
            const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - start;
            best = std::min(best, took.count());
            sum += took.count();
        }
        std::printf("%s: %zu triangles, %zu pieces: %.1f ms a frame, %.1f at best\n",
                    full ? "with a hero, 10 enemies, 60 coins" : "the level alone", renderer.counts().triangles,
                    renderer.counts().pieces, sum / frames, best);
    }
    return 0;
}

int run(const std::string& path) {
    auto display = view::Display::open({.size = cell, .headless = true});
    if (!display) {
        std::fprintf(stderr, "%s\n", display.error().text.c_str());
        return 1;
    }
    view::ImGuiAdapter letters(**display);
    letters.begin_frame(1.0 / 60);  // this loads the letters of the captions
    letters.end_frame();
    view::Renderer renderer;
    const auto floor = floor_model(6);
    std::vector<view::CaptionedPicture> pictures;
    std::vector<Cell> cells = hero_cells();
    for (const auto& more : {enemy_cells(), prop_cells()}) cells.insert(cells.end(), more.begin(), more.end());
    for (const Cell& c : cells) {
        view::FrameView frame;
        frame.size = frame.framebuffer = cell;
        const double distance = c.wide * 2.1;
        const dvec3 from(std::sin(c.yaw) * distance, distance * 0.22, std::cos(c.yaw) * distance);
        frame.camera.eye = c.middle + from;
        frame.camera.forward = glm::normalize(-from);
        frame.camera.field_of_view = 0.5;
        renderer.begin(frame);
        renderer.model(floor);
        for (const view::Piece& p : c.pieces) renderer.piece(p);
        if (c.draw) c.draw(renderer);
        renderer.end((*display)->framebuffer());
        pictures.push_back({view::read_picture((*display)->framebuffer(), cell), c.caption});
    }
    const auto written = view::write_png(view::contact_sheet(pictures), path);
    if (!written) std::fprintf(stderr, "%s\n", written.error().text.c_str());
    return written ? 0 : 1;
}

}  // namespace
}  // namespace surefoot::platformer

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fputs("surefoot_hero_sheet PICTURE.png | --time\n", stderr);
        return 2;
    }
    const std::string what = argv[1];
    return what == "--time" ? surefoot::platformer::measure() : surefoot::platformer::run(what);
}
