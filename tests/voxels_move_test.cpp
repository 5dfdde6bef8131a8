#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include <surefoot/voxels_move.hpp>

#include "block_world.hpp"
#include "exact/number.hpp"
#include "splitmix.hpp"

namespace surefoot {
namespace {

using tests::Solid;

/// The sign of a + b - c, without rounding.
int sign_of_sum(double a, double b, double c) {
    using Exact = internal::ExactNumber<72>;  // 2304 bits: any three doubles
    return (Exact(a) + Exact(b) - Exact(c)).sign();
}

bool overlaps(double centre, double half, double low, double high) {
    return sign_of_sum(centre, half, low) > 0 && sign_of_sum(-centre, half, -high) > 0;
}

bool is_inside(const std::vector<Solid>& solids, const dvec3& centre, const dvec3& half) {
    return std::any_of(solids.begin(), solids.end(), [&](const Solid& s) {
        return overlaps(centre.x, half.x, s.min.x, s.max.x) && overlaps(centre.y, half.y, s.min.y, s.max.y) &&
               overlaps(centre.z, half.z, s.min.z, s.max.z);
    });
}

/// The same question to every box of the world, decided exactly, one double at a time.
double reference_advance(const std::vector<Solid>& solids, const dvec3& centre, const dvec3& half, int axis, double way,
                         AxisStop& stop) {
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    const double target = centre[axis] + way;
    double end = target;
    for (const Solid& s : solids) {
        if (way == 0 || !overlaps(centre[u], half[u], s.min[u], s.max[u]) ||
            !overlaps(centre[v], half[v], s.min[v], s.max[v])) {
            continue;
        }
        const bool up = way > 0;
        const double sign = up ? 1 : -1;
        const double face = sign * (up ? s.min[axis] : s.max[axis]);
        if (sign_of_sum(sign * centre[axis], half[axis], face) > 0) continue;  // not ahead
        double last = face - half[axis];
        while (sign_of_sum(last, half[axis], face) > 0) last = std::nextafter(last, -1e300);
        while (sign_of_sum(std::nextafter(last, 1e300), half[axis], face) <= 0) last = std::nextafter(last, 1e300);
        if (sign_of_sum(sign * centre[axis], sign * way, last) <= 0) continue;  // does not get there
        const std::uint32_t triangle = s.first_id + static_cast<std::uint32_t>(4 * axis + (up ? 0 : 2));
        const double position = sign * last;
        if (stop.blocked && (sign * position > sign * end || (position == end && triangle > stop.triangle))) continue;
        end = position;
        stop = {.blocked = true, .triangle = triangle, .surface = s.surface};
    }
    return end;
}

constexpr std::array<std::array<int, 3>, 6> orders{{{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};

BoxMove reference_move(const std::vector<Solid>& solids, const Box& box, const dvec3& from, const dvec3& way,
                       AxisOrder order) {
    std::array<AxisStop, 3> stops;
    dvec3 at = from;
    for (const int axis : orders[static_cast<std::size_t>(order)]) {
        at[axis] =
            reference_advance(solids, at, box.half_extents, axis, way[axis], stops[static_cast<std::size_t>(axis)]);
    }
    return {.position = at,
            .x = stops[0],
            .y = stops[1],
            .z = stops[2],
            .started_inside = is_inside(solids, from, box.half_extents)};
}

void expect_same(const AxisStop& ours, const AxisStop& theirs) {
    EXPECT_EQ(ours.blocked, theirs.blocked);
    EXPECT_EQ(ours.triangle, theirs.triangle);
    EXPECT_EQ(ours.surface, theirs.surface);
}

/// A world, and moves in it. Every second move is on a grid, so that boxes touch exactly and fit exactly.
struct Trial {
    tests::BlockWorld world;
    Voxels voxels;
    std::vector<Solid> solids;
    tests::SplitMix random;

    Trial(const VoxelWindow& window, std::uint64_t seed, std::uint64_t full, std::uint64_t partial)
        : world(window, seed, full, partial),
          voxels(*Voxels::over(world, window)),
          solids(world.solids()),
          random(seed + 100) {}
    Trial(const Trial&) = delete;  // the voxels look at the world

    struct Question {
        Box box;
        dvec3 from;
        dvec3 way;
        AxisOrder order;
    };
    Question any(int i) {
        const VoxelWindow& w = world.window;
        const Bounds all = voxels.bounds();
        const auto share = [&](double least, double most) { return random.in(least, most); };
        Question q{
            .box = {dvec3(share(0.05, 0.9), share(0.05, 1.4), share(0.05, 0.9)) * w.size},
            .from = (all.min + (all.max - all.min) * dvec3(share(-0.2, 1.2), share(-0.2, 1.2), share(-0.2, 1.2))),
            .way = (random.point(i % 3 == 0 ? 1000 : (i % 3 == 1 ? 2 : 0.05)) * w.size),
            .order = static_cast<AxisOrder>(random.next() % 6)};
        if (i % 2 == 0) {
            const auto snap = [](const dvec3& v, const dvec3& step) { return floor3(v / step) * step; };
            q.box.half_extents = max3(snap(q.box.half_extents, w.size * 0.125), w.size * 0.125);
            q.from = snap(q.from - w.origin, w.size * 0.125) + w.origin;
            if (i % 4 == 0) q.way = snap(q.way, w.size * 0.25);
        }
        if (i % 7 == 0) q.way[static_cast<int>(random.next() % 3)] = 0;
        return q;
    }
    static dvec3 floor3(const dvec3& v) { return dvec3(std::floor(v.x), std::floor(v.y), std::floor(v.z)); }
    static dvec3 max3(const dvec3& a, const dvec3& b) {
        return dvec3(std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z));
    }
};

constexpr VoxelWindow small_window{.first = {-5, -3, -4}, .cells = {10, 7, 9}, .boxes_per_block = 2};
constexpr VoxelWindow rounded_window{
    .cells = {9, 8, 7}, .size = {0.3, 0.7, 1.1}, .origin = {300.1, 20.3, -90.7}, .boxes_per_block = 2};

TEST(MoveAxisByAxis, equals_brute_force_decided_exactly) {
    int blocked = 0;
    int inside = 0;
    for (const VoxelWindow& window : {small_window, rounded_window}) {
        for (const std::uint64_t full : {1U, 4U, 9U}) {
            Trial trial(window, full, full, 4);
            for (int i = 0; i < 1500 && !HasFailure(); ++i) {
                SCOPED_TRACE(i);
                const auto q = trial.any(i);
                const BoxMove ours = move_axis_by_axis(trial.voxels, q.box, q.from, q.way, q.order);
                const BoxMove theirs = reference_move(trial.solids, q.box, q.from, q.way, q.order);
                EXPECT_EQ(ours.position, theirs.position);
                EXPECT_EQ(ours.started_inside, theirs.started_inside);
                EXPECT_EQ(ours.status, HitStatus::ok);
                expect_same(ours.x, theirs.x);
                expect_same(ours.y, theirs.y);
                expect_same(ours.z, theirs.z);
                blocked += ours.x.blocked || ours.y.blocked || ours.z.blocked ? 1 : 0;
                inside += ours.started_inside ? 1 : 0;
            }
        }
    }
    EXPECT_GT(blocked, 2000);
    EXPECT_GT(inside, 1000);
}

/// How many of many moves from a free start end inside of solid.
template <typename Move>
int count_ends_inside(const Move& move) {
    int inside = 0;
    int moves = 0;
    for (const VoxelWindow& window : {small_window, rounded_window}) {
        Trial trial(window, 31, 3, 4);
        for (int i = 0; i < 4000; ++i) {
            const auto q = trial.any(i);
            if (is_inside(trial.solids, q.from, q.box.half_extents)) continue;
            ++moves;
            // Move on from where it came to, as a game does: the ends of moves are the hardest starts.
            dvec3 at = q.from;
            for (int tick = 0; tick < 3; ++tick) at = move(trial.voxels, q.box, at, q.way, q.order).position;
            inside += is_inside(trial.solids, at, q.box.half_extents) ? 1 : 0;
        }
    }
    EXPECT_GT(moves, 2000);
    return inside;
}

TEST(MoveAxisByAxis, never_ends_inside_from_a_free_start) {
    EXPECT_EQ(count_ends_inside(move_axis_by_axis), 0);
}

TEST(MoveAxisByAxis, the_incorrect_variant_does_end_inside) {
    const auto incorrect = [](const Voxels& voxels, const Box& box, const dvec3& from, const dvec3& way, AxisOrder) {
        return incorrect_move_axes_together(voxels, box, from, way);
    };
    EXPECT_GT(count_ends_inside(incorrect), 20);
}

TEST(MoveAxisByAxis, past_a_corner_block_the_incorrect_variant_walks_into_it) {
    const auto corner = [](std::int32_t x, std::int32_t y, std::int32_t z) { return x == 2 && y == 0 && z == 2; };
    const auto voxels = Voxels::over(corner, {.cells = {4, 1, 4}});
    ASSERT_TRUE(voxels.has_value());
    const Box box{{0.5, 0.5, 0.5}};
    const BoxMove wrong = incorrect_move_axes_together(*voxels, box, {1.5, 0.5, 1.5}, {1, 0, 1});
    EXPECT_EQ(wrong.position, dvec3(2.5, 0.5, 2.5)) << "in the middle of the block";
    EXPECT_FALSE(wrong.x.blocked || wrong.z.blocked);
    EXPECT_TRUE(move_axis_by_axis(*voxels, box, wrong.position, {0, 0, 0}).started_inside);

    const BoxMove right = move_axis_by_axis(*voxels, box, {1.5, 0.5, 1.5}, {1, 0, 1}, AxisOrder::xyz);
    EXPECT_EQ(right.position, dvec3(2.5, 0.5, 1.5));
    EXPECT_TRUE(right.z.blocked);
    EXPECT_EQ(voxels->cell(right.z.triangle), (Cell{2, 0, 2}));
    const BoxMove other = move_axis_by_axis(*voxels, box, {1.5, 0.5, 1.5}, {1, 0, 1}, AxisOrder::zyx);
    EXPECT_EQ(other.position, dvec3(1.5, 0.5, 2.5));
}

TEST(MoveAxisByAxis, tunnels_through_nothing_at_any_speed) {
    const auto wall = [](std::int32_t x, std::int32_t, std::int32_t) {
        static constexpr BlockBox thin[] = {{{0.5F, 0, 0}, {0.5F + 0x1p-10F, 1, 1}}};
        return x == 3 ? Block::of(thin, 9) : Block::empty();
    };
    const auto voxels = Voxels::over(wall, {.cells = {600, 2, 2}});
    ASSERT_TRUE(voxels.has_value());
    for (double speed = 1e-3; speed < 9e8; speed *= 1.7) {
        dvec3 at(0.5, 1, 1);
        for (int tick = 0; tick < 4000 && at.x < 3.25; ++tick) {
            const BoxMove moved = move_axis_by_axis(*voxels, Box{{0.25, 0.5, 0.5}}, at, {speed, 0, 0});
            at = moved.position;
            ASSERT_LE(at.x, 3.25);
            if (at.x == 3.25 && speed > 1e-2) {
                EXPECT_TRUE(moved.x.blocked);
                EXPECT_EQ(moved.x.surface, 9U);
            }
        }
        EXPECT_GE(at.x, 3.25 - 1e-3);
        EXPECT_EQ(move_axis_by_axis(*voxels, Box{{0.25, 0.5, 0.5}}, {500, 1, 1}, {-speed, 0, 0}).position.x,
                  std::max(500 - speed, 3.5 + 0x1p-10 + 0.25));
    }
}

TEST(MoveAxisByAxis, at_rest_keeps_its_bits_and_goes_on_being_blocked) {
    // Sizes that doubles cannot hold: where the box comes to rest is rounded, and must not be rounded again.
    for (const double half : {0.3, 0.9, 0.1, 1.0 / 3, 0.7}) {
        for (const double size : {1.0, 0.1, 0.7}) {
            const auto ground = [](std::int32_t, std::int32_t y, std::int32_t) { return y < 2; };
            const auto voxels =
                Voxels::over(ground, {.cells = {40, 8, 40}, .size = dvec3(size), .origin = {0, -7.3, 0}});
            ASSERT_TRUE(voxels.has_value());
            const Box box{dvec3(half)};
            const dvec3 landed = move_axis_by_axis(*voxels, box, {3, 4, 3}, {0, -100, 0}).position;
            EXPECT_NEAR(landed.y, voxels->triangle(0).a.y + 2 * size + half, 1e-6);
            dvec3 at = landed;
            for (const double fall : {-1e-300, -1e-17, -1e-9, -0.003, -1.0, -1e6}) {
                for (int tick = 0; tick < 50; ++tick) {
                    const BoxMove moved = move_axis_by_axis(*voxels, box, at, {0, fall, 0});
                    ASSERT_TRUE(moved.y.blocked) << fall;
                    ASSERT_FALSE(moved.started_inside);
                    at = moved.position;
                }
                EXPECT_EQ(std::bit_cast<std::uint64_t>(at.y), std::bit_cast<std::uint64_t>(landed.y));
            }
            const BoxMove along = move_axis_by_axis(*voxels, box, at, {0.01, -0.01, 0.01});
            EXPECT_FALSE(along.x.blocked || along.z.blocked) << "nothing to catch on between the blocks";
        }
    }
}

TEST(MoveAxisByAxis, at_rest_at_zero_keeps_the_sign_of_zero) {
    const auto ground = [](std::int32_t, std::int32_t y, std::int32_t) { return y == 0; };
    const auto voxels = Voxels::over(ground, {.cells = {3, 2, 3}, .origin = {0, -2, 0}});
    for (const double zero : {0.0, -0.0}) {
        const BoxMove moved = move_axis_by_axis(*voxels, Box{{0.5, 1, 0.5}}, {1.5, zero, 1.5}, {0, -1, 0});
        EXPECT_TRUE(moved.y.blocked);
        EXPECT_EQ(std::signbit(moved.position.y), std::signbit(zero));
    }
}

TEST(MoveAxisByAxis, leaves_a_block_that_it_started_in_and_enters_no_other) {
    const auto row = [](std::int32_t x, std::int32_t, std::int32_t) { return x == 1 || x == 2; };
    const auto voxels = Voxels::over(row, {.cells = {4, 1, 1}});
    const Box box{{0.25, 0.25, 0.25}};
    const BoxMove out = move_axis_by_axis(*voxels, box, {1.1, 0.5, 0.5}, {-1, 0, 0});
    EXPECT_TRUE(out.started_inside);
    EXPECT_EQ(out.position.x, 1.1 - 1);
    const BoxMove deeper = move_axis_by_axis(*voxels, box, {1.1, 0.5, 0.5}, {5, 0, 0});
    EXPECT_TRUE(deeper.x.blocked);
    EXPECT_EQ(deeper.position.x, 1.75);
}

TEST(MoveAxisByAxis, what_is_invalid_stays_and_is_blocked) {
    const auto nothing = [](std::int32_t, std::int32_t, std::int32_t) { return false; };
    const auto voxels = Voxels::over(nothing, {});
    const auto refused = [&](const Box& box, const dvec3& from, const dvec3& way) {
        const BoxMove moved = move_axis_by_axis(*voxels, box, from, way);
        EXPECT_EQ(moved.status, HitStatus::invalid);
        EXPECT_TRUE(moved.x.blocked && moved.y.blocked && moved.z.blocked);
        return moved.position;
    };
    EXPECT_EQ(refused(Box{}, {1, 2, 3}, {0, std::nan(""), 0}), dvec3(1, 2, 3));
    EXPECT_EQ(refused(Box{}, {1, 2, 3}, {0, 1e10, 0}), dvec3(1, 2, 3));
    EXPECT_EQ(refused(Box{{0, 1, 1}}, {1, 2, 3}, {0, 1, 0}), dvec3(1, 2, 3));
    EXPECT_EQ(refused(Box{}, {1, std::nan(""), 3}, {0, 1, 0}), dvec3(0, 0, 0));
}

}  // namespace
}  // namespace surefoot
