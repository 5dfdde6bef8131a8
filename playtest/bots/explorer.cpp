#include "playtest/bots/explorer.hpp"

#include <cmath>

#include "playtest/vectors.hpp"

namespace surefoot::playtest {
namespace {

constexpr double cell = 2;  // m
constexpr double full_turn = 6.283185307179586;

std::array<int, 3> cell_of(const dvec3& place) {
    return {int(std::floor(place.x / cell)), int(std::floor(place.y / cell)), int(std::floor(place.z / cell))};
}

}  // namespace

void Explorer::look_for_new(const game::Game& game) {
    // Of some directions the one in which it has been the least, where there is ground or something to climb.
    double best = 1e300;
    for (int i = 0; i < 12; ++i) {
        const double turn = dice_.in(0, full_turn);
        const dvec3 ahead{std::sin(turn), 0, std::cos(turn)};
        double score = dice_.in(0, 30);
        for (const double far : {2.0, 4.0, 7.0}) {
            const dvec3 place = game.feet() + ahead * far;
            for (int up = -1; up <= 1; ++up) {
                const auto found = been_.find(cell_of(place + dvec3{0, up * cell, 0}));
                if (found != been_.end()) score += found->second;
            }
            const bool ground =
                game.world().ray_any({place + dvec3{0, 2, 0}, place - dvec3{0, 5, 0}}, {.begin = 1, .end = 1});
            if (!ground) score += far < 3 ? 60 : 200 / far;
        }
        if (score < best) {
            best = score;
            heading_ = turn;
        }
    }
}

void Explorer::choose_mood(const game::Game& game) {
    mood_ = Mood(dice_.whole(0, 5));
    if (dice_.chance(0.35)) mood_ = Mood::looks_for_new;
    left_ = dice_.whole(30, 180);
    heading_ = dice_.in(0, full_turn);
    turning_ = mood_ == Mood::spins ? dice_.in(-0.2, 0.2) : dice_.in(-0.01, 0.01);
    constexpr double chances[] = {0.01, 0.03, 0.15, 0.06, 0.03, 0.004};
    jumps_ = chances[int(mood_)];
    if (mood_ == Mood::looks_for_new) look_for_new(game);
    if (mood_ == Mood::hugs_walls) {
        const auto near = game.world().nearest(game.hero().body.position, 6, {.begin = 1, .end = 1});
        if (near) {
            const dvec3 way = flat(near->point - game.hero().body.position);
            if (length(way) > 0.1) heading_ = std::atan2(way.x, way.z) + dice_.in(-0.7, 0.7);
        }
    }
}

game::HeroInput Explorer::decide(const game::Game& game) {
    ++been_[cell_of(game.feet())];
    if (left_-- <= 0) choose_mood(game);
    heading_ += turning_;
    Intent intent;
    if (mood_ != Mood::stands) intent.move = dvec3{std::sin(heading_), 0, std::cos(heading_)};
    if (mood_ == Mood::mashes && dice_.chance(0.1)) heading_ = dice_.in(0, full_turn);
    const auto hold = [&](int& left, double chance) {
        if (left > 0)
            --left;
        else if (dice_.chance(chance))
            left = dice_.whole(2, 30);
        return left > 0;
    };
    intent.jump = hold(jump_for_, jumps_);
    intent.dash = hold(dash_for_, jumps_ / 3);
    intent.crouch = hold(crouch_for_, jumps_ / 5);
    return hands_.act(intent);
}

}  // namespace surefoot::playtest
