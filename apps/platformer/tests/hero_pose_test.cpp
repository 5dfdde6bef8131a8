// The drawn hero follows from what its volume does.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "hero_ground.hpp"
#include "platformer/hero/figure.hpp"
#include "platformer/hero/pose.hpp"

namespace surefoot::platformer::tests {
namespace {

struct Actor {
    explicit Actor(const World& world_, const dvec3& at = {0, 0.82, 0}) : world(world_) {
        state.position = at;
        for (int i = 0; i < 10; ++i) state = step(world, settings, {}, tick, state).state;
        pose = hero_at(state, settings);
    }

    void go(const CharacterInput& input) {
        const StepResult result = step(world, settings, input, tick, state);
        last = pose;
        before = state;
        events = result.events;
        state = result.state;
        pose = advance(pose, before, state, events, settings, flags, tick);
    }
    void go_on(int ticks, const CharacterInput& input) {
        for (int i = 0; i < ticks; ++i) go(input);
    }

    const World& world;
    CharacterSettings settings = hero_settings();
    HeroFlags flags;
    CharacterState before;
    CharacterState state;
    CharacterEvents events;
    HeroPose last;
    HeroPose pose;
};

Mesh plain() {
    return Blocks().add({-60, -1, -60}, {60, 0, 60}).mesh();
}

TEST(HeroPose, puts_feet_down_that_do_not_slide_at_any_speed) {
    const Mesh mesh = plain();
    const World world = world_of(mesh);
    for (const double speed : {1.0, 2.5, 4.0, 6.5}) {
        Actor hero(world, {0, 0.82, -40});
        hero.go_on(60, {.wish = {0, 0, speed}});
        int stood[2] = {0, 0};
        int swung[2] = {0, 0};
        for (int i = 0; i < 240; ++i) {
            hero.go({.wish = {0, 0, speed}});
            for (std::size_t k = 0; k < 2; ++k) {
                const bool stands = hero.pose.feet[k].swing == 0 && hero.last.feet[k].swing == 0;
                (stands ? stood[k] : swung[k])++;
                if (!stands) continue;
                const dvec3 slid = hero.pose.feet[k].at - hero.last.feet[k].at;
                ASSERT_LT(std::hypot(slid.x, slid.z), 1e-9) << "speed " << speed << ", tick " << i;
                ASSERT_NEAR(hero.pose.feet[k].at.y, 0, 0.02);
            }
        }
        for (const int k : {on_left, on_right}) {
            EXPECT_GT(stood[k], 40) << speed;
            EXPECT_GT(swung[k], 40) << speed;
        }
    }
}

TEST(HeroPose, moves_no_foot_by_a_leap_while_it_walks_turns_and_stops) {
    const Mesh mesh = plain();
    const World world = world_of(mesh);
    Actor hero(world);
    Random random(4);
    CharacterInput input;
    for (int i = 0; i < 1200; ++i) {
        if (i % 50 == 0) input.wish = dvec3(random.in(-6, 6), 0, random.in(-6, 6)) * (i % 150 == 0 ? 0.0 : 1.0);
        hero.go(input);
        for (std::size_t k = 0; k < 2; ++k)
            ASSERT_LT(glm::length(hero.pose.feet[k].at - hero.last.feet[k].at), 0.75) << i;
    }
}

TEST(HeroPose, stands_with_both_feet_under_it_after_a_stop) {
    const Mesh mesh = plain();
    const World world = world_of(mesh);
    Actor hero(world);
    hero.go_on(77, {.wish = {5, 0, 3}});
    hero.go_on(90, {});
    for (const Foot& foot : hero.pose.feet) {
        EXPECT_EQ(foot.swing, 0);
        EXPECT_LT(glm::length(foot.at - hero.pose.soles), 0.26);
    }
    EXPECT_EQ(hero.pose.act, HeroAct::idle);
}

TEST(HeroPose, is_squashed_the_more_the_harder_it_lands_and_not_at_all_with_reduced_motion) {
    const Mesh mesh = plain();
    const World world = world_of(mesh);
    const auto flattest = [&](double height, bool reduced) {
        Actor hero(world, {0, 0.82 + height, 0});
        hero.flags.reduced_motion = reduced;
        double least = 0;
        for (int i = 0; i < 120; ++i) {
            hero.go({});
            least = std::min(least, hero.pose.squash);
        }
        EXPECT_NEAR(hero.pose.squash, 0, 0.01);
        return least;
    };
    EXPECT_LT(flattest(1, false), -0.05);
    EXPECT_LT(flattest(4, false), flattest(1, false) - 0.05);
    EXPECT_EQ(flattest(4, true), 0);
}

TEST(HeroPose, leans_into_a_start_and_into_a_turn) {
    const Mesh mesh = plain();
    const World world = world_of(mesh);
    Actor hero(world);
    hero.go_on(6, {.wish = {0, 0, 6.5}});
    EXPECT_GT(hero.pose.lean_forward, 0.03);
    hero.go_on(60, {.wish = {0, 0, 6.5}});
    EXPECT_NEAR(hero.pose.lean_left, 0, 0.01);
    double most = 0;
    for (int i = 0; i < 60; ++i) {
        const double angle = i * 0.05;
        hero.go({.wish = dvec3(std::sin(angle), 0, std::cos(angle)) * 6.5});  // to the left
        most = std::max(most, hero.pose.lean_left);
    }
    EXPECT_GT(most, 0.1);
}

TEST(HeroPose, looks_where_it_runs) {
    const Mesh mesh = plain();
    const World world = world_of(mesh);
    Actor hero(world);
    hero.go_on(60, {.wish = {5, 0, 0}});
    EXPECT_NEAR(hero.pose.facing, 1.5708, 0.01);
}

TEST(HeroPose, hangs_with_both_hands_at_the_edge) {
    const Mesh mesh = Blocks().add({-60, -1, -60}, {60, 0, 60}).add({-5, 0, 2}, {5, 2.6, 8}).mesh();
    const World world = world_of(mesh);
    Actor hero(world, {0, 0.82, 1});
    for (int i = 0; i < 90 && hero.state.hold == Hold::none; ++i) hero.go({.wish = {0, 0, 4}, .jump = i < 25});
    ASSERT_EQ(hero.state.hold, Hold::hanging);
    hero.go_on(20, {});
    ASSERT_EQ(hero.state.hold, Hold::hanging);
    EXPECT_EQ(hero.pose.act, HeroAct::hang);
    const Frame frame = standing_frame(hero.pose);
    for (const int side : {on_left, on_right}) {
        const dvec3 hand = frame.at(hero.pose.stance.hands[side]);
        EXPECT_NEAR(hand.y, 2.6, 0.06);
        EXPECT_NEAR(hand.z, hero.state.ledge_point.z, 0.05);
        EXPECT_LT(std::abs(hand.x - hero.state.ledge_point.x), 0.4);
    }
    for (int i = 0; i < 60; ++i) {
        hero.go({.wish = {1.2, 0, 0}});
        if (hero.state.hold != Hold::hanging) break;
        for (const int side : {on_left, on_right})
            EXPECT_NEAR(standing_frame(hero.pose).at(hero.pose.stance.hands[side]).y, 2.6, 0.08) << i;
    }
}

TEST(HeroPose, slides_down_a_wall_with_the_hand_that_is_nearer_to_it) {
    CharacterSettings settings = hero_settings();
    CharacterState state;
    state.position = {0, 5, 0};
    state.velocity = {0, -2.4, 0};
    state.wall_normal = {1, 0, 0};  // the wall is on the side of -X
    state.since_wall = 0;
    HeroPose pose = hero_at(state, settings);  // looks along Z: -X is to its right
    for (int i = 0; i < 30; ++i) pose = advance(pose, state, state, {}, settings, {}, tick);
    EXPECT_EQ(pose.act, HeroAct::wall_slide);
    EXPECT_LT(pose.wall_side, 0);
    const Frame frame = standing_frame(pose);
    EXPECT_NEAR(frame.at(pose.stance.hands[on_right]).x, -0.33, 0.04);
    EXPECT_GT(frame.at(pose.stance.hands[on_left]).x, 0.3);
}

TEST(HeroPose, turns_over_once_in_a_jump_in_the_air) {
    const Mesh mesh = plain();
    const World world = world_of(mesh);
    Actor hero(world);
    hero.go_on(15, {.jump = true});
    EXPECT_EQ(hero.pose.flip, 0);
    hero.go({});
    hero.go({.jump = true});
    EXPECT_GT(hero.pose.flip, 5);
    hero.go_on(40, {});
    EXPECT_EQ(hero.pose.flip, 0);
}

TEST(HeroPose, leaves_images_behind_in_a_dash_unless_motion_is_reduced) {
    const Mesh mesh = plain();
    const World world = world_of(mesh);
    for (const bool reduced : {false, true}) {
        Actor hero(world);
        hero.flags.reduced_motion = reduced;
        hero.go_on(5, {.wish = {0, 0, 6}});
        hero.go_on(8, {.wish = {0, 0, 6}, .dash = true});
        EXPECT_EQ(hero.pose.act, HeroAct::dash);
        EXPECT_EQ(hero.pose.images[0].age < after_image_time, !reduced);
    }
}

TEST(HeroPose, says_what_it_does_by_what_is_told_in_the_order_of_what_matters) {
    const Mesh mesh = plain();
    const World world = world_of(mesh);
    Actor hero(world);
    const auto act_after = [&](const HeroFlags& flags) {
        return advance(hero.pose, hero.state, hero.state, {}, hero.settings, flags, tick).act;
    };
    EXPECT_EQ(act_after({}), HeroAct::idle);
    EXPECT_EQ(act_after({.under_water = true}), HeroAct::swim);
    EXPECT_EQ(act_after({.under_water = true, .hurt = true}), HeroAct::hurt);
    EXPECT_EQ(act_after({.won = true}), HeroAct::win);
    EXPECT_EQ(act_after({.dead = true, .won = true}), HeroAct::dead);
    hero.go_on(20, {.crouch = true});
    EXPECT_EQ(hero.pose.act, HeroAct::crouch);
}

TEST(HeroPose, has_a_scarf_of_one_length_that_stays_out_of_the_body) {
    const Mesh mesh = plain();
    const World world = world_of(mesh);
    Actor hero(world);
    Random random(9);
    CharacterInput input;
    for (int i = 0; i < 900; ++i) {
        if (i % 30 == 0) input.wish = {random.in(-6, 6), 0, random.in(-6, 6)};
        input.jump = i % 90 < 20;
        input.dash = i % 200 == 0;
        hero.go(input);
        const auto& points = hero.pose.scarf.now;
        for (std::size_t k = 1; k < scarf_points; ++k) {
            ASSERT_NEAR(glm::length(points[k] - points[k - 1]), 0.105, 1e-6);
            ASSERT_GT(points[k].y, -0.15);
        }
    }
}

TEST(HeroPose, is_all_of_numbers_whatever_happens) {
    const Mesh mesh = training_ground();
    const World world = world_of(mesh);
    Actor hero(world, {0, 2, 12});
    Random random(5);
    CharacterInput input;
    std::vector<view::Piece> pieces;
    for (int i = 0; i < 3000; ++i) {
        if (i % 25 == 0) input.wish = {random.in(-7, 7), 0, random.in(-7, 7)};
        input.jump = random.in(0, 1) < 0.3;
        input.crouch = random.in(0, 1) < 0.1;
        input.dash = random.in(0, 1) < 0.02;
        hero.flags = {.under_water = random.in(0, 1) < 0.05, .hurt = random.in(0, 1) < 0.01};
        hero.flags.won = i > 2500 && i < 2700;
        hero.flags.dead = i > 2800;
        hero.go(input);
        pieces.clear();
        add_pieces(pieces, between(hero.last, hero.pose, random.in(0, 1)));
        for (const view::Piece& p : pieces)
            for (int c = 0; c < 4; ++c) ASSERT_TRUE(std::isfinite(p.place[c].x + p.place[c].y + p.place[c].z)) << i;
    }
    EXPECT_TRUE(pieces.empty() || hero.pose.act != HeroAct::dead || hero.pose.act_time < 0.6);
}

TEST(HeroPose, stands_there_at_once_when_it_was_put_elsewhere) {
    const Mesh mesh = plain();
    const World world = world_of(mesh);
    Actor hero(world);
    hero.go_on(30, {.wish = {0, 0, 6}});
    const CharacterState was = hero.state;
    hero.state.position += dvec3(20, 0, 0);
    const HeroPose there = advance(hero.pose, was, hero.state, {}, hero.settings, {}, tick);
    for (const Foot& foot : there.feet) EXPECT_LT(glm::length(foot.at - there.soles), 0.3);
    EXPECT_LT(glm::length(there.scarf.now.back() - there.soles), 1.5);
    EXPECT_EQ(between(hero.pose, there, 0.3).soles, there.soles);
}

TEST(HeroFigure, is_as_tall_as_its_volume_and_stands_on_its_soles) {
    const Mesh mesh = plain();
    const World world = world_of(mesh);
    Actor hero(world);
    hero.go_on(60, {});
    std::vector<view::Piece> pieces;
    add_pieces(pieces, hero.pose);
    double low = 1e9;
    double high = -1e9;
    for (const view::Piece& p : pieces) {
        const double up = std::hypot(p.place[0].y, p.place[1].y, p.place[2].y);
        low = std::min(low, p.place[3].y - (p.solid == view::Solid::cone ? 0 : up));
        high = std::max(high, p.place[3].y + up);
    }
    EXPECT_NEAR(low, 0, 0.03);
    EXPECT_NEAR(high, 1.6, 0.12);
    EXPECT_LT(pieces.size(), 70U);
}

}  // namespace
}  // namespace surefoot::platformer::tests
