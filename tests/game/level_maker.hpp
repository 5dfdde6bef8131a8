/// Small levels for tests of the platformer's rules, made of boxes.
#pragma once

#include <cstdint>
#include <gtest/gtest.h>
#include <memory>
#include <vector>

#include <surefoot/mesh.hpp>

#include "game/game.hpp"

namespace surefoot::test {

/// The outside of a box.
inline Mesh box_mesh(const dvec3& low, const dvec3& high, std::uint32_t surface = 0) {
    std::vector<vec3> corners;
    for (int i = 0; i < 8; ++i)
        corners.push_back({float((i & 1) != 0 ? high.x : low.x), float((i & 2) != 0 ? high.y : low.y),
                           float((i & 4) != 0 ? high.z : low.z)});
    const std::vector<std::uint32_t> indices{0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                                             2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
    const std::vector<std::uint32_t> surfaces(12, surface);
    return Mesh::build({.vertices = corners, .indices = indices, .surfaces = surfaces}).value();
}

/// A floor of 40 m by 40 m with its top at y = 0, the spawn in its middle, the goal in a corner.
class LevelMaker {
public:
    LevelMaker() : level(std::make_shared<game::Level>(game::Level{.ground = empty(), .decor = empty()})) {
        level->id = "made";
        level->title = "Made";
        level->kill_y = -10;
        level->checkpoints.push_back({.feet = {0, 0, 0}, .facing = {0, 0, -1}, .section = "the start", .order = 0});
        level->goal = {18, 0, 18};
        level->materials.resize(2);
        level->rules.resize(2);
        level->materials[1].deadly = true;
        box({-20, -1, -20}, {20, 0, 20});
    }

    void box(const dvec3& low, const dvec3& high, std::uint32_t surface = 0) {
        const Mesh mesh = box_mesh(low, high, surface);
        for (std::uint32_t id = 0; id < mesh.triangle_count(); ++id) {
            const Triangle triangle = mesh.triangle(id);
            for (const dvec3& corner : {triangle.a, triangle.b, triangle.c}) {
                indices_.push_back(std::uint32_t(vertices_.size()));
                vertices_.push_back(vec3(corner));
            }
            surfaces_.push_back(surface);
        }
    }

    /// Without the floor.
    void clear() {
        vertices_.clear();
        indices_.clear();
        surfaces_.clear();
    }

    game::BodyPlan& body(game::BodyKind kind, const dvec3& origin, const dvec3& half) {
        level->bodies.push_back({.kind = kind, .name = "body", .mesh = box_mesh(-half, half), .origin = origin});
        return level->bodies.back();
    }

    /// As it is played; nothing is added to it any more.
    [[nodiscard]] std::shared_ptr<const game::Level> finish() {
        level->ground = Mesh::build({.vertices = vertices_, .indices = indices_, .surfaces = surfaces_}).value();
        return level;
    }

    [[nodiscard]] std::unique_ptr<game::Game> start() {
        (void)finish();
        auto game = game::Game::start(level);
        EXPECT_TRUE(game) << game.error().text;
        return std::move(*game);
    }

    std::shared_ptr<game::Level> level;

private:
    static Mesh empty() { return Mesh::build({}).value(); }

    std::vector<vec3> vertices_;
    std::vector<std::uint32_t> indices_;
    std::vector<std::uint32_t> surfaces_;
};

/// What was seen while a game went on.
struct Seen {
    std::vector<game::GameEvent> events;

    [[nodiscard]] int count(game::Happening what) const {
        int sum = 0;
        for (const game::GameEvent& event : events) sum += event.what == what ? 1 : 0;
        return sum;
    }
};

/// `seconds` of the same input.
inline Seen play(game::Game& game, double seconds, const game::HeroInput& input = {}) {
    Seen seen;
    for (int tick = 0; tick < int(seconds * 60 + 0.5); ++tick) {
        game.tick(input);
        seen.events.insert(seen.events.end(), game.events().begin(), game.events().end());
    }
    return seen;
}

/// Runs straight to a place, seen from above, for at most so long; presses nothing else.
inline Seen run_to(game::Game& game, const dvec3& place, double most_seconds = 10, std::uint8_t buttons = 0) {
    Seen seen;
    for (int tick = 0; tick < int(most_seconds * 60); ++tick) {
        const dvec3 way = place - game.feet();
        const double length = std::sqrt(way.x * way.x + way.z * way.z);
        if (length < 0.3 || game.outcome() != game::Outcome::playing) break;
        game::HeroInput input;
        input.move_x = float(way.x / length);
        input.move_z = float(way.z / length);
        input.buttons = buttons;
        game.tick(input);
        seen.events.insert(seen.events.end(), game.events().begin(), game.events().end());
    }
    return seen;
}

}  // namespace surefoot::test
