// What the panels Mathematics, Strategies and Search reckon for themselves.
#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "debugger/strategies.hpp"
#include "debugger/worlds.hpp"
#include "playground/debugger_room/answer_rows.hpp"
#include "playground/debugger_room/drawn_world.hpp"
#include "playground/debugger_room/graph_frame.hpp"
#include "playground/debugger_room/order_cursor.hpp"
#include "playground/debugger_room/sample_path.hpp"
#include "playground/debugger_room/subjects.hpp"

namespace surefoot::playground {
namespace {

using debugger::GapSample;
using debugger::WorldKind;

TEST(GraphFrame, a_place_is_taken_back_to_its_moment_and_what_is_outside_to_the_nearest_end) {
    const std::vector<GapSample> samples{{0, 3}, {0.5, -0.2}, {1, 2}};
    const GraphFrame frame = frame_of(samples, {100, 50}, {300, 150});
    for (const double t : {0.0, 0.3, 1.0}) EXPECT_NEAR(frame.t_at(frame.at(t, 1).x), t, 1e-12);
    EXPECT_EQ(frame.t_at(20), 0);
    EXPECT_EQ(frame.t_at(900), 1);
}

TEST(GraphFrame, shows_all_samples_and_the_line_of_zero) {
    for (const std::vector<GapSample>& samples :
         {std::vector<GapSample>{{0, 3}, {1, 1}}, {{0, -3}, {1, -1}}, {{0, 0}, {1, 0}}}) {
        const GraphFrame frame = frame_of(samples, {0, 0}, {200, 100});
        EXPECT_LT(frame.least, frame.most);
        for (const double g : {samples[0].g, samples[1].g, 0.0}) {
            EXPECT_GT(frame.at(0, g).y, 0);
            EXPECT_LT(frame.at(0, g).y, 100);
        }
        EXPECT_LT(frame.at(0, frame.most).y, frame.at(0, frame.least).y) << "up is more";
    }
}

TEST(GraphFrame, marks_are_few_round_and_inside) {
    for (const auto& [low, high] : {std::pair(-0.4, 3.1), std::pair(-1e-4, 2e-5), std::pair(-7000.0, 12.0)}) {
        const std::vector<double> marks = round_marks(low, high, 6);
        ASSERT_GE(marks.size(), 2U);
        EXPECT_LE(marks.size(), 6U);
        for (const double mark : marks) {
            EXPECT_GE(mark, low);
            EXPECT_LE(mark, high);
        }
    }
    EXPECT_EQ(round_marks(-0.4, 3.1, 6), (std::vector<double>{0, 1, 2, 3}));
}

TEST(GraphFrame, between_samples_the_curve_is_straight) {
    const std::vector<GapSample> samples{{0, 4}, {0.5, 2}, {1, 6}};
    EXPECT_EQ(curve_at(samples, 0), 4);
    EXPECT_EQ(curve_at(samples, 0.25), 3);
    EXPECT_EQ(curve_at(samples, 0.5), 2);
    EXPECT_EQ(curve_at(samples, 0.75), 4);
    EXPECT_EQ(curve_at(samples, 1), 6);
}

TEST(OrderCursor, plays_everything_once_from_the_beginning_and_rests) {
    OrderCursor cursor;
    cursor.restart(30);
    EXPECT_EQ(cursor.shown(), 30U) << "all is shown at first";
    cursor.play();
    EXPECT_EQ(cursor.shown(), 0U);
    int ticks = 0;
    for (std::size_t before = 0; cursor.advance(1.0 / 60); before = cursor.shown(), ++ticks)
        EXPECT_LE(cursor.shown() - before, 1U) << "none is skipped";
    EXPECT_EQ(cursor.shown(), 30U);
    EXPECT_NEAR(ticks, 300, 2);
}

TEST(OrderCursor, takes_ten_seconds_for_a_long_list_and_stops_when_it_is_moved) {
    OrderCursor cursor;
    cursor.restart(100000);
    cursor.play();
    for (int i = 0; i < 300; ++i) cursor.advance(1.0 / 60);
    EXPECT_NEAR(double(cursor.shown()), 50000, 300);
    cursor.show(7);
    EXPECT_FALSE(cursor.advance(1));
    EXPECT_EQ(cursor.shown(), 7U);
    cursor.show(200000);
    EXPECT_EQ(cursor.shown(), 100000U);
}

TEST(OrderCursor, of_nothing_never_plays) {
    OrderCursor cursor;
    cursor.restart(0);
    cursor.play();
    EXPECT_FALSE(cursor.is_playing());
    EXPECT_FALSE(cursor.advance(1));
}

TEST(Pace, a_step_follows_from_speed_and_rate_and_the_other_way_round) {
    Pace pace{.speed = 12, .rate = 6};
    EXPECT_EQ(pace.step(), 2);
    pace.set_step(0.5);
    EXPECT_EQ(pace.rate, 24);
    EXPECT_EQ(pace.speed, 12);
}

TEST(SamplePath, finds_what_the_strategy_finds_and_ends_at_END) {
    const debugger::Question q = debugger::default_question(WorldKind::triangle);
    const debugger::Arena arena(q.triangles);
    const double length = glm::length(q.motion.to - q.motion.from);
    for (const double step : {0.2, 0.8, 2.0, 2.4, 6.0, 100.0}) {
        const auto samples = samples_along(arena, q.volume(), q.motion, step);
        const auto finding = debugger::look_at_samples(arena, q.volume(), q.motion, step);
        ASSERT_FALSE(samples.empty());
        EXPECT_EQ(samples.back().position, q.motion.to);
        EXPECT_EQ(samples.back().along, length);
        std::uint64_t looked = 0;
        bool touched = false;
        for (const Sample& sample : samples) {
            looked += sample.looked;
            touched = touched || (sample.looked && sample.touches);
        }
        EXPECT_EQ(looked, finding.looks);
        EXPECT_EQ(touched, finding.hit);
    }
    EXPECT_EQ(samples_along(arena, q.volume(), q.motion, 1e-6, false, 50).size(), 50U);
    EXPECT_EQ(samples_along(arena, q.volume(), {q.motion.to, q.motion.to}, 1).size(), 1U);
}

bool apart(const Bounds& a, const Bounds& b) {
    for (int i = 0; i < 3; ++i)
        if (a.max[i] < b.min[i] || b.max[i] < a.min[i]) return true;
    return false;
}

TEST(WorldBeside, never_meets_the_real_one_however_far_it_is_squashed) {
    for (const WorldKind kind : {WorldKind::triangle, WorldKind::fold, WorldKind::wedge}) {
        debugger::Question q = debugger::default_question(kind);
        q.shape = debugger::ShapeName::ellipsoid;
        for (const dvec3 radii : {dvec3(0.8, 1.4, 0.8), dvec3(0.05, 0.4, 0.1), dvec3(3, 8, 2)}) {
            q.sizes.ellipsoid.radii = radii;
            for (const dquat turned : {dquat(1, 0, 0, 0), dquat(0.5, 0.7, -0.1, 0.4)}) {
                q.orientation = turned;
                const dvec3 offset = offset_beside(q.volume(), q.motion, q.triangles);
                const Bounds real = bounds_in(real_world(q.volume()), q.motion, q.triangles);
                for (int i = 0; i <= 100; ++i) {
                    const auto world = world_beside(q.volume(), q.motion, i / 100.0, offset);
                    EXPECT_TRUE(apart(real, bounds_in(world, q.motion, q.triangles))) << i;
                }
            }
        }
    }
}

TEST(WorldBeside, of_a_level_stands_above_all_of_it) {
    const debugger::Question q = debugger::default_question(WorldKind::triangle);
    const Bounds level{{-300, -20, -300}, {300, 90, 300}};
    const dvec3 offset = offset_beside(q.volume(), q.motion, q.triangles, level);
    EXPECT_GT(bounds_in(world_beside(q.volume(), q.motion, 1, offset), q.motion, q.triangles).min.y, 90);
}

TEST(Subjects, of_a_few_triangles_are_all_and_the_one_that_was_hit_comes_first) {
    const debugger::Question q = debugger::default_question(WorldKind::wedge);
    const debugger::Arena arena(q.triangles);
    const auto hit = arena.sweep(q.volume(), q.motion);
    ASSERT_TRUE(hit);
    const auto subjects = subjects_of({q, arena, hit});
    EXPECT_EQ(subjects.size(), q.triangles.size());
    EXPECT_EQ(subjects[foremost(subjects, {q, arena, hit})].id, hit->triangle);
}

TEST(Subjects, without_a_hit_the_one_that_was_nearest_comes_first) {
    debugger::Question q;
    q.triangles = {{{0, 0, 0}, {0, 0, 1}, {1, 0, 1}}, {{9, 0, 0}, {9, 0, 1}, {10, 0, 1}}};
    q.motion = {{9, 5, 0}, {9, 3, 0}};
    const debugger::Arena arena(q.triangles);
    const std::optional<Hit> none;
    EXPECT_EQ(foremost(subjects_of({q, arena, none}), {q, arena, none}), 1U);
}

TEST(Subjects, of_a_level_are_the_triangles_that_were_asked) {
    std::vector<vec3> vertices;
    std::vector<std::uint32_t> indices;
    for (std::uint32_t i = 0; i < 200; ++i) {
        const auto x = static_cast<float>(i);
        for (const vec3 corner : {vec3(x, 0, 0), vec3(x, 0, 1), vec3(x + 1, 0, 1)}) {
            indices.push_back(static_cast<std::uint32_t>(vertices.size()));
            vertices.push_back(corner);
        }
    }
    const debugger::Arena arena(*Mesh::build({.vertices = vertices, .indices = indices}));
    debugger::Question q;
    q.world = WorldKind::level;
    q.motion = {{120, 5, 0.5}, {121, -5, 0.5}};
    const auto hit = arena.sweep(q.volume(), q.motion);
    ASSERT_TRUE(hit);
    const auto subjects = subjects_of({q, arena, hit});
    ASSERT_FALSE(subjects.empty());
    EXPECT_LE(subjects.size(), most_subjects);
    EXPECT_EQ(subjects[foremost(subjects, {q, arena, hit})].id, hit->triangle);
    for (const Subject& subject : subjects) EXPECT_NEAR(subject.triangle.a.x, 120, 30);
}

TEST(Subjects, of_a_refused_question_are_explained_instead) {
    debugger::Question q = debugger::default_question(WorldKind::triangle);
    const debugger::Arena arena(q.triangles);
    const std::optional<Hit> none;
    EXPECT_FALSE(why_no_answer({q, arena, none}));
    q.sizes.ellipsoid.radii.x = 0;
    EXPECT_TRUE(why_no_answer({q, arena, none}));
}

TEST(AnswerRows, say_what_became_of_every_candidate_and_mark_the_answer) {
    const debugger::Question q = debugger::default_question(WorldKind::triangle);
    const auto rows = rows_of(debugger::method_table(q.volume(), q.motion, q.triangles[0]));
    ASSERT_EQ(rows.size(), 7U);
    EXPECT_EQ(rows[3].name, "edge ca");
    EXPECT_EQ(rows[3].asked, "45.15 t\u00B2 - 51.4 t + 14.19 = 0");
    EXPECT_EQ(rows[3].became, "t = 0.4711, 0.6674. The first touch");
    for (std::size_t i = 0; i < rows.size(); ++i) EXPECT_EQ(rows[i].answer, i == 3);
}

TEST(AnswerRows, of_a_box_are_planes_and_one_of_them_is_the_answer) {
    const debugger::Question q = debugger::default_question(WorldKind::triangle);
    const auto rows = rows_of(debugger::plane_table(Box{{0.8, 1.4, 0.8}}, q.motion, q.triangles[0]));
    EXPECT_EQ(std::count_if(rows.begin(), rows.end(), [](const AnswerRow& row) { return row.answer; }), 1);
}

}  // namespace
}  // namespace surefoot::playground
