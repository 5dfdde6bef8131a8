// The judge cannot be fooled: wrong answers of every kind, made up here for all six shapes, are refused, and right ones
// are accepted. No kernel takes part: the contacts are exact by construction.
#include "judge/judge.hpp"

#include <bit>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <sstream>

#include "judge/families/exact_contact.hpp"
#include "judge/runner.hpp"

namespace judge {
namespace {

constexpr int rounds = 300;

/// A shape that runs squarely into the triangle and reaches it at exactly t = 1/2.
struct HeadOn {
    ExactContact contact;
    Query query;
    Answer right;
};

/// How much of t the bound is worth, head on.
double bound_in_time(const HeadOn& h) {
    return allowed_gap * largest(h.query) / (2 * length(h.contact.out));
}

HeadOn draw_head_on(Draw& draw, Kind kind) {
    HeadOn result{draw_contact(draw, kind), {}, {}};
    while (result.contact.sharp) result.contact = draw_contact(draw, kind);
    const ExactContact& contact = result.contact;
    result.query = contact.query;
    result.query.from = contact.here - contact.out;
    result.query.to = contact.here + contact.out;
    result.right.hit = true;
    result.right.point = contact.at;
    result.right.normal = contact.out * (-1 / length(contact.out));
    result.right.feature = contact.part;
    // A small part of the bound early, as no sum of doubles can be trusted to the last bit.
    result.right.t = 0.5 - std::min(0.01 * bound_in_time(result), 0.25);
    return result;
}

std::string described(const Query& q, const Answer& a) {
    std::ostringstream out;
    out.precision(17);
    const auto vec = [&](const char* name, const Vec& v) {
        out << name << '{' << v.x << ", " << v.y << ", " << v.z << '}';
    };
    vec("\nsize ", q.size);
    out << " rotate {" << q.qw << ", " << q.qx << ", " << q.qy << ", " << q.qz << '}';
    vec(" from ", q.from);
    vec(" to ", q.to);
    vec(" triangle ", q.a);
    vec(" ", q.b);
    vec(" ", q.c);
    out << " hit " << a.hit << " t " << a.t;
    vec(" normal ", a.normal);
    vec(" point ", a.point);
    return out.str();
}

class EveryShape : public testing::TestWithParam<Kind> {
protected:
    template <class Check>
    void for_many(const Check& check) {
        Draw draw(20240 + static_cast<std::uint64_t>(GetParam()));
        for (int i = 0; i < rounds; ++i) check(draw_head_on(draw, GetParam()), draw);
    }
    static void expect(Verdict verdict, const Query& query, const Answer& answer) {
        const Judgement judgement = judge::judge(query, answer);
        EXPECT_STREQ(name_of(judgement.verdict), name_of(verdict))
            << judgement.why << ", gap " << judgement.gap << described(query, answer);
    }
};

INSTANTIATE_TEST_SUITE_P(Judge, EveryShape,
                         testing::Values(Kind::sphere, Kind::ellipsoid, Kind::capsule, Kind::box, Kind::cylinder,
                                         Kind::cone),
                         [](const auto& shape) { return std::string(name_of(shape.param)); });

TEST_P(EveryShape, a_right_answer_is_accepted) {
    for_many([](const HeadOn& h, Draw&) {
        expect(Verdict::right, h.query, h.right);
        Answer a_hair_early = h.right;
        a_hair_early.t = 0.5 - 0.5 * std::min(bound_in_time(h), 1.0);
        expect(Verdict::right, h.query, a_hair_early);
    });
}

TEST_P(EveryShape, one_ulp_late_is_late) {
    for_many([](const HeadOn& h, Draw&) {
        Answer late = h.right;
        late.t = std::nextafter(0.5, 1.0);
        expect(Verdict::late, h.query, late);
        late.t = 0.75;
        expect(Verdict::late, h.query, late);
    });
}

TEST_P(EveryShape, more_than_the_bound_early_is_refused) {
    for_many([](const HeadOn& h, Draw&) {
        if (bound_in_time(h) > 0.2) return;
        Answer early = h.right;
        early.t = 0.5 - 1.01 * bound_in_time(h);
        expect(Verdict::early, h.query, early);
        early.t = 0;
        expect(Verdict::early, h.query, early);
    });
}

TEST_P(EveryShape, a_miss_is_a_miss_even_by_one_touch) {
    for_many([](const HeadOn& h, Draw&) {
        expect(Verdict::miss, h.query, {});
        Query just_touching = h.query;
        just_touching.to = h.contact.here;
        expect(Verdict::miss, just_touching, {});
    });
}

TEST_P(EveryShape, a_hit_without_contact_is_false) {
    for_many([](const HeadOn& h, Draw&) {
        if (bound_in_time(h) > 0.01) return;
        Query stops_before = h.query;
        stops_before.to = h.contact.here - h.contact.out * 0.125;
        Answer hit = h.right;
        for (const double t : {0.0, 0.25, 1.0}) {
            hit.t = t;
            expect(Verdict::false_hit, stops_before, hit);
        }
        expect(Verdict::right, stops_before, {});
    });
}

TEST_P(EveryShape, starts_in_touch_are_hits_if_and_only_if_they_go_deeper) {
    for_many([](const HeadOn& h, Draw& draw) {
        Answer at_once = h.right;
        at_once.t = 0;
        Query query = h.query;
        query.from = h.contact.here;
        expect(Verdict::right, query, at_once);
        expect(Verdict::miss, query, {});

        const Vec slides = h.contact.tangent[0] * draw.integer(1, 3) + h.contact.tangent[1] * draw.integer(-3, 3);
        for (const Vec& way : {slides, -h.contact.out, slides - h.contact.out}) {
            query.to = query.from + way;
            // At a corner of the shape, what slides along one plane may still go deeper or leave: only leaving is sure.
            expect(Verdict::false_hit, query, at_once);
            expect(Verdict::right, query, {});
        }
        query.to = query.from;
        expect(Verdict::false_hit, query, at_once);
        expect(Verdict::right, query, {});
    });
}

TEST_P(EveryShape, wrong_normals_are_refused) {
    for_many([](const HeadOn& h, Draw&) {
        Answer answer = h.right;
        answer.normal = -h.right.normal;
        expect(Verdict::bad_normal, h.query, answer);
        answer.normal = h.right.normal * 1.001;
        expect(Verdict::bad_normal, h.query, answer);
        answer.normal = {0, 0, 0};
        expect(Verdict::bad_normal, h.query, answer);
        // Corners and edges have many true normals, and far from the origin the bound allows for more.
        if (h.contact.part != Feature::face || largest(h.query) > 100 * largest_dimension(h.query)) return;
        const Vec aside = h.contact.tangent[0] * (1e-3 / length(h.contact.tangent[0]));
        answer.normal = (h.right.normal + aside) * (1 / length(h.right.normal + aside));
        EXPECT_NE(judge::judge(h.query, answer).verdict, Verdict::right);
    });
}

TEST_P(EveryShape, wrong_points_and_features_are_refused) {
    for_many([](const HeadOn& h, Draw&) {
        const double bound = allowed_gap * largest(h.query);
        Answer answer = h.right;
        answer.point = h.right.point + h.right.normal * (2.5 * bound);
        expect(Verdict::bad_point, h.query, answer);
        if (h.contact.part != Feature::face) return;
        for (const Feature wrong : {Feature::edge, Feature::vertex}) {
            answer = h.right;
            answer.feature = wrong;
            EXPECT_EQ(judge::judge(h.query, answer).verdict, Verdict::bad_feature);
        }
    });
}

TEST_P(EveryShape, what_is_not_finite_or_not_answered_is_refused) {
    for_many([](const HeadOn& h, Draw&) {
        const double nan = std::numeric_limits<double>::quiet_NaN();
        Answer answer = h.right;
        answer.t = nan;
        expect(Verdict::bad_status, h.query, answer);
        answer = h.right;
        answer.point.y = std::numeric_limits<double>::infinity();
        expect(Verdict::bad_status, h.query, answer);
        answer = h.right;
        answer.normal.z = nan;
        expect(Verdict::bad_status, h.query, answer);
        answer = h.right;
        answer.t = 1.5;
        expect(Verdict::bad_status, h.query, answer);
        answer = h.right;
        answer.status = Status::overflow;
        expect(Verdict::bad_status, h.query, answer);
        answer.status = Status::invalid;
        expect(Verdict::bad_status, h.query, answer);
    });
}

TEST_P(EveryShape, data_outside_the_limits_must_be_blocked_as_invalid) {
    for_many([](const HeadOn& h, Draw& draw) {
        Answer blocked;
        blocked.hit = true;
        blocked.status = Status::invalid;
        Query query = h.query;
        const int which = draw.pick(4);
        if (which == 0) query.size.x = 0;
        if (which == 1) query.from.y = std::numeric_limits<double>::quiet_NaN();
        if (which == 2) query.b.z = 1.1e9;
        if (which == 3) query.qw = query.qx = query.qy = query.qz = 0;
        expect(Verdict::right, query, blocked);
        expect(Verdict::bad_status, query, {});
        expect(Verdict::bad_status, query, h.right);
    });
}

TEST_P(EveryShape, a_one_sided_triangle_does_not_exist_from_behind) {
    for_many([](const HeadOn& h, Draw&) {
        Query query = h.query;
        query.one_sided = true;
        const Vec d = query.to - query.from;
        const double against = dot(d, cross(query.b - query.a, query.c - query.a));
        Query turned = query;
        std::swap(turned.b, turned.c);
        if (against == 0) {
            expect(Verdict::false_hit, query, h.right);
            expect(Verdict::right, query, {});
            expect(Verdict::right, turned, {});
            return;
        }
        const Query& front = against < 0 ? query : turned;
        const Query& back = against < 0 ? turned : query;
        expect(Verdict::right, front, h.right);
        expect(Verdict::miss, front, {});
        expect(Verdict::right, back, {});
        expect(Verdict::false_hit, back, h.right);
    });
}

TEST(JudgePoints, one_in_the_middle_of_a_sliver_is_accepted_and_one_off_it_is_not) {
    // A sliver 2e-7 m wide: in doubles, where on it the point lies is lost. Found by `surefoot prove`.
    Query query;
    query.kind = Kind::box;
    query.size = {0.13429256046970395, 0.74074829719578, 2};
    query.qw = 1, query.qx = 0, query.qy = 3, query.qz = -2;
    query.from = {0.34369692487890957, 0.16494894149427397, 1.9863847319999939};
    query.to = {-1.0142920617875273, 4.356822154442833, 1.5793575318842406};
    query.a = {-0.6548335975777375, 2.9009175613063913, -0.41403909899525004};
    query.b = {-0.2938052054680706, 1.9132898208842288, 0.571749875197713};
    query.c = {1.5570808704879626, -3.149990525025858, 5.625602455443947};
    Answer answer;
    answer.hit = true;
    answer.t = 0;
    answer.normal = {-0.9025248020514293, -0.42088405080774915, -0.09113505065389643};
    answer.point = {0.23051466261377815, 0.4789611628175098, 2.0034077756480997};
    answer.feature = Feature::edge;
    EXPECT_EQ(judge::judge(query, answer).verdict, Verdict::right);
    answer.point = answer.point + answer.normal * 1e-6;
    EXPECT_EQ(judge::judge(query, answer).verdict, Verdict::bad_point);
}

TEST(JudgeFamilies, are_the_same_queries_from_every_compiler) {
    const Sweep never = [](const Query&) { return Answer{}; };
    std::uint64_t digest = 14695981039346656037U;  // FNV-1a, by words
    std::vector<Query> queries;
    for (const Family& family : families()) {
        for (int kind = 0; kind < kind_count; ++kind) {
            Draw draw(5 + static_cast<std::uint64_t>(kind));
            for (int i = 0; i < 300; ++i) {
                queries.clear();
                family.make({draw, static_cast<Kind>(kind), never}, queries);
                for (const Query& q : queries)
                    for (const Vec& v : {q.size, q.from, q.to, q.a, q.b, q.c, Vec{q.qx, q.qy, q.qz}})
                        for (const double part : {v.x, v.y, v.z})
                            digest = (digest ^ std::bit_cast<std::uint64_t>(part == part ? part : 0)) * 1099511628211U;
            }
        }
    }
    EXPECT_EQ(digest, 6733345590865824962U) << "changed on purpose? Then docs/proof.md needs its counts anew";
}

TEST(JudgeRunner, asks_the_same_queries_however_many_threads) {
    const auto digest = [](int threads) {
        Plan plan;
        plan.queries_per_shape = 10000;
        plan.families = {"random", "edge-on"};
        plan.threads = threads;
        plan.kinds = {Kind::box};
        std::uint64_t sum = 0;  // does not depend on the order
        plan.record_all = true;
        plan.record = [&](const Record& record) {
            sum += std::bit_cast<std::uint64_t>(record.query.from.x) ^ std::bit_cast<std::uint64_t>(record.query.c.z);
        };
        (void)run(plan, [] { return Sweep([](const Query&) { return Answer{}; }); });
        return sum;
    };
    EXPECT_EQ(digest(1), digest(3));
}

TEST(JudgeRunner, an_answer_that_is_always_no_hit_fails_in_every_family_that_has_hits) {
    Plan plan;
    plan.queries_per_shape = 2000;
    for (const Row& row : run(plan, [] { return Sweep([](const Query&) { return Answer{}; }); })) {
        if (std::string(row.family->name) == "still") continue;  // hardly anything that stands still hits
        EXPECT_GT(row.tally.failures(), 0U) << name_of(row.kind) << ' ' << row.family->name;
    }
}

}  // namespace
}  // namespace judge
