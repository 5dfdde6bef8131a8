// What must not change an answer: the unit of length, the order of the corners, where the origin is, a rotation of
// everything, a cut through the triangle or the motion, and which way time runs.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <string>

#include <surefoot/overlap.hpp>

#include "judge/judge.hpp"
#include "judge/runner.hpp"
#include "prove/bridge.hpp"
#include "prove/lines.hpp"

namespace surefoot::tools {
namespace {

using judge::Answer;
using judge::Draw;
using judge::Kind;
using judge::Query;
using judge::Vec;

constexpr int rounds = 2000;

class EveryShape : public testing::TestWithParam<Kind> {
protected:
    /// Queries of many families, so that tangencies and touching starts are among them.
    template <class Check>
    void for_many(std::initializer_list<const char*> families, const Check& check) {
        Draw draw(71 + static_cast<std::uint64_t>(GetParam()));
        const judge::Sweep sweep_it(ask);
        std::vector<Query> queries;
        for (const judge::Family& family : judge::families()) {
            if (std::find(families.begin(), families.end(), std::string(family.name)) == families.end()) continue;
            for (int done = 0; done < rounds;) {
                queries.clear();
                family.make({draw, GetParam(), sweep_it}, queries);
                for (const Query& query : queries) check(query, draw);
                done += static_cast<int>(queries.size());
            }
        }
    }
};

INSTANTIATE_TEST_SUITE_P(Metamorphic, EveryShape,
                         testing::Values(Kind::sphere, Kind::ellipsoid, Kind::capsule, Kind::box, Kind::cylinder,
                                         Kind::cone),
                         [](const auto& shape) { return std::string(judge::name_of(shape.param)); });

Query scaled(Query query, double by) {
    for (Vec* v : {&query.from, &query.to, &query.a, &query.b, &query.c, &query.size}) *v = *v * by;
    return query;
}

std::string described(const Query& query) {
    std::string out;
    static const judge::Family family{"", "", nullptr};
    append_record(out, {query, ask(query), {}, family});
    return out;
}

/// Is a number so small, but not zero, that its products underflow?
bool is_nearly_zero(const Query& query) {
    for (const Vec* v : {&query.from, &query.to, &query.a, &query.b, &query.c})
        for (const double part : {v->x, v->y, v->z})
            if (part != 0 && std::fabs(part) < 1e-100) return true;
    return false;
}

/// How far apart two answers to the same question may stop: each is within the hair of the truth.
double hair(const Query& query) {
    return 2 * judge::allowed_gap * judge::largest(query);
}

/// The gap between shape and triangle at the stop of `from` is what may differ, not the time; along a grazing motion
/// the time is ill-conditioned. So: both stop within the hair as far as it shows along the normal.
void expect_same_stop(const Query& query, const Answer& one, double t_of_other) {
    const Vec d = query.to - query.from;
    EXPECT_LE(std::fabs(one.t - t_of_other) * std::fabs(dot(d, one.normal)), 8 * hair(query))
        << "t " << one.t << " and " << t_of_other;
}

/// The shape a little larger on all sides, by about this part of its size, or smaller. (The reference point of a cone
/// is its apex: it sinks, and the disc rises.)
Query grown(Query query, double by) {
    if (query.kind == Kind::cone) {
        const Vec down = judge::turned(query, {0, -by * query.size.y, 0});
        query.from = query.from + down;
        query.to = query.to + down;
        by *= 2;
    }
    query.size = query.size * (1 + by);
    return query;
}

/// Does the shape, a little grown, keep clear of the triangle where it starts?
bool starts_free(const Query& asked) {
    const Query query = grown(asked, 1e-6);
    const Volume volume(shape_from(query), dquat(query.qw, query.qx, query.qy, query.qz));
    const Triangle triangle{position_from(query.a), position_from(query.b), position_from(query.c)};
    return !overlap(volume, position_from(query.from), triangle);
}

/// Starts free and stays away from the hair: shape grown and shrunk a little answer alike, so that rounding cannot
/// decide between hit and no hit.
bool is_clear(const Query& query) {
    if (!starts_free(query)) return false;
    const Answer small = ask(grown(query, -1e-6)), large = ask(grown(query, 1e-6));
    return small.hit == large.hit && std::fabs(small.t - large.t) < 1e-3;
}

TEST_P(EveryShape, a_power_of_two_of_the_unit_of_length_changes_no_bit) {
    for_many({"random", "tangent", "touching", "inside", "slivers", "shared"}, [](const Query& query, Draw& draw) {
        const double by = std::ldexp(1.0, draw.integer(-6, 6));
        const Query other = scaled(query, by);
        // What would leave the limits, or underflow, is another question.
        if (!judge::is_valid(other) || !judge::is_valid(query) || is_nearly_zero(query)) return;
        const Answer one = ask(query), two = ask(other);
        ASSERT_EQ(one.hit, two.hit);
        EXPECT_EQ(one.t, two.t);
        EXPECT_EQ(one.started_inside, two.started_inside);
        EXPECT_EQ(one.feature, two.feature);
        for (double Vec::*part : {&Vec::x, &Vec::y, &Vec::z}) {
            EXPECT_EQ(one.normal.*part, two.normal.*part);
            EXPECT_EQ(one.point.*part * by, two.point.*part);
        }
    });
}

TEST_P(EveryShape, the_order_of_the_corners_changes_no_bit) {
    for_many({"random", "tangent", "touching", "inside", "slivers", "shared", "far"}, [](const Query& query, Draw&) {
        const Answer one = ask(query);
        const Vec corners[3] = {query.a, query.b, query.c};
        constexpr int orders[5][3] = {{0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
        for (const auto& order : orders) {
            Query other = query;
            other.a = corners[order[0]], other.b = corners[order[1]], other.c = corners[order[2]];
            const Answer two = ask(other);
            ASSERT_EQ(one.hit, two.hit);
            EXPECT_EQ(one.t, two.t);
            EXPECT_EQ(one.feature, two.feature);
            for (double Vec::*part : {&Vec::x, &Vec::y, &Vec::z}) {
                EXPECT_EQ(one.normal.*part, two.normal.*part);
                EXPECT_EQ(one.point.*part, two.point.*part);
            }
        }
    });
}

TEST_P(EveryShape, a_translation_moves_the_answer_along) {
    int compared = 0;
    for_many({"random", "ratios", "wedges"}, [&](const Query& query, Draw& draw) {
        if (!is_clear(query)) return;
        const Vec by = draw.box(1000);
        Query other = query;
        for (Vec* v : {&other.from, &other.to, &other.a, &other.b, &other.c}) *v = *v + by;
        const Answer one = ask(query), two = ask(other);
        ASSERT_EQ(one.hit, two.hit);
        if (one.hit) expect_same_stop(other, one, two.t), ++compared;
    });
    EXPECT_GT(compared, rounds / 4);
}

TEST_P(EveryShape, a_rotation_of_everything_turns_the_answer_along) {
    int compared = 0;
    for_many({"random", "ratios", "wedges"}, [&](const Query& query, Draw& draw) {
        if (!is_clear(query)) return;
        Query turn;
        judge::draw_orientation(draw, turn);
        Query other = query;
        for (Vec* v : {&other.from, &other.to, &other.a, &other.b, &other.c}) *v = judge::turned(turn, *v);
        const double w = turn.qw, x = turn.qx, y = turn.qy, z = turn.qz;
        other.qw = w * query.qw - x * query.qx - y * query.qy - z * query.qz;
        other.qx = w * query.qx + x * query.qw + y * query.qz - z * query.qy;
        other.qy = w * query.qy - x * query.qz + y * query.qw + z * query.qx;
        other.qz = w * query.qz + x * query.qy - y * query.qx + z * query.qw;
        const Answer one = ask(query), two = ask(other);
        ASSERT_EQ(one.hit, two.hit);
        if (one.hit) expect_same_stop(query, one, two.t), ++compared;
    });
    EXPECT_GT(compared, rounds / 4);
}

TEST_P(EveryShape, a_triangle_cut_in_two_stops_the_shape_where_the_whole_one_does) {
    int compared = 0;
    for_many({"random", "ratios", "wedges"}, [&](const Query& query, Draw&) {
        if (!is_clear(query)) return;
        const Vec middle = (query.a + query.b) * 0.5;
        Query halves[2] = {query, query};
        halves[0].b = middle;
        halves[1].a = middle;
        const Answer one = ask(query);
        double first = 2;
        for (const Query& half : halves)
            if (const Answer answer = ask(half); answer.hit) first = std::min(first, answer.t);
        ASSERT_EQ(one.hit, first <= 1);
        if (one.hit) expect_same_stop(query, one, first), ++compared;
    });
    EXPECT_GT(compared, rounds / 4);
}

TEST_P(EveryShape, a_motion_cut_in_two_stops_where_the_whole_one_does) {
    int compared = 0;
    for_many({"random", "ratios", "wedges"}, [&](const Query& query, Draw&) {
        if (!is_clear(query)) return;
        const Answer one = ask(query);
        if (one.hit && std::fabs(one.t - 0.5) < 1e-3) return;  // the cut is where it touches
        const Vec middle = (query.from + query.to) * 0.5;
        Query halves[2] = {query, query};
        halves[0].to = middle;
        halves[1].from = middle;
        const Answer early = ask(halves[0]);
        const Answer late = early.hit ? early : ask(halves[1]);
        ASSERT_EQ(one.hit, early.hit || late.hit);
        if (one.hit) expect_same_stop(query, one, early.hit ? 0.5 * early.t : 0.5 + 0.5 * late.t), ++compared;
    });
    EXPECT_GT(compared, rounds / 4);
}

TEST_P(EveryShape, with_clear_ends_the_way_back_hits_if_and_only_if_the_way_there_does) {
    int compared = 0;
    for_many({"random", "ratios", "edge-on"}, [&](const Query& query, Draw&) {
        Query back = query;
        std::swap(back.from, back.to);
        if (!is_clear(query) || !is_clear(back)) return;
        EXPECT_EQ(ask(query).hit, ask(back).hit) << described(query);
        ++compared;
    });
    EXPECT_GT(compared, rounds / 4);
}

}  // namespace
}  // namespace surefoot::tools
