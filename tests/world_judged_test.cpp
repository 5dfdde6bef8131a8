// A turned body rounds every question that it is asked. The judge, who does not round, is asked the same question in
// the body's own frame: with whole numbers for quaternions, and distances that are multiples of their squared lengths,
// that question is a question in doubles.
#include "judge/judge.hpp"
#include "prove/bridge.hpp"
#include "world_things.hpp"

namespace surefoot {
namespace {

using namespace tests;

// Whole numbers all the way, so every product and sum is exact.
dvec3 turned_times_square(const dquat& q, const dvec3& v) {
    const dvec3 u(q.x, q.y, q.z);
    return (q.w * q.w - glm::dot(u, u)) * v + 2.0 * glm::dot(u, v) * u + 2.0 * q.w * glm::cross(u, v);
}
dquat conjugate(const dquat& q) {
    return {q.w, -q.x, -q.y, -q.z};
}
dquat product(const dquat& a, const dquat& b) {
    return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
            a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}

class Whole {
public:
    explicit Whole(std::uint64_t seed) : random_(seed) {}
    double within(int span) {
        return static_cast<double>(static_cast<int>(random_.next() % (2 * static_cast<unsigned>(span) + 1)) - span);
    }
    dvec3 point(int span) {
        const double x = within(span);
        const double y = within(span);
        return {x, y, within(span)};
    }
    dquat quaternion() {
        const double w = within(3) + 4;  // never zero
        const dvec3 v = point(3);
        return {w, v.x, v.y, v.z};
    }
    double size() { return 1 + static_cast<double>(random_.next() % 6); }

private:
    SplitMix random_;
};

TEST(WorldJudged, a_turned_body_is_never_missed_and_never_hit_late) {
    Whole whole(111);
    int hits = 0;
    int judged = 0;
    for (int i = 0; i < 24000; ++i) {
        judge::Query query;
        query.kind = static_cast<judge::Kind>(i % judge::kind_count);
        query.size = {whole.size(), whole.size(), whole.size()};
        const dquat turn = whole.quaternion();
        const double square = turn.w * turn.w + turn.x * turn.x + turn.y * turn.y + turn.z * turn.z;
        const dquat orientation = i % 3 == 0 ? turn : whole.quaternion();  // upright as the body sees it, or any
        const dquat seen = product(conjugate(turn), orientation);
        query.qw = seen.w;
        query.qx = seen.x;
        query.qy = seen.y;
        query.qz = seen.z;
        // All near each other, and half of the time far from the body's own origin, where the pose rounds far more
        // than the sweep does. What the mesh holds is whole and below 2^24, so it is a float.
        const dvec3 far = i % 2 == 0 ? dvec3(0, 0, 0) : whole.point(100000);
        const dvec3 from = far + whole.point(2);
        const dvec3 to = far + whole.point(2);
        query.from = tools::vec_from(from * square);
        query.to = tools::vec_from(to * square);
        const dvec3 middle = far * square;
        const dvec3 corners[3] = {middle + whole.point(30), middle + whole.point(30), middle + whole.point(30)};
        query.a = tools::vec_from(corners[0]);
        query.b = tools::vec_from(corners[1]);
        query.c = tools::vec_from(corners[2]);
        const Shape shape = tools::shape_from(query);
        const Triangle triangle{corners[0], corners[1], corners[2]};
        // A start in touch is a matter of direction, which rounding may turn by as little as it likes.
        if (overlap(Volume(shape, seen), from * square, triangle)) continue;

        const std::array<vec3, 3> vertices{vec3(corners[0]), vec3(corners[1]), vec3(corners[2])};
        const std::array<std::uint32_t, 3> indices{0, 1, 2};
        const auto mesh = Mesh::build({.vertices = vertices, .indices = indices});
        ASSERT_TRUE(mesh);
        World world;
        const dvec3 place = whole.point(1000);
        ASSERT_TRUE(world.add(*mesh, {.pose = {place, turn}}));
        auto hit = world.sweep(Volume(shape, orientation),
                               {place + turned_times_square(turn, from), place + turned_times_square(turn, to)});
        if (hit && hit->status == HitStatus::ok) {
            const Pose pose{place, turn};
            hit->point = to_body(pose, hit->point);
            hit->normal = to_body({{0, 0, 0}, turn}, hit->normal);
        }
        ++judged;
        hits += hit.has_value();
        const judge::Judgement judgement = judge::judge(query, tools::answer_from(hit));
        EXPECT_EQ(judgement.verdict, judge::Verdict::right)
            << judge::name_of(judgement.verdict) << ": " << judgement.why << ", query " << i << " of a "
            << judge::name_of(query.kind);
    }
    EXPECT_GT(judged, 18000);
    EXPECT_GT(hits, 1800);
}

}  // namespace
}  // namespace surefoot
