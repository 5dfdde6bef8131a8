// Whatever finds the triangles, the answer is that of every triangle asked: for every query, every shape, and every
// SIMD target that this machine runs.
#include <algorithm>
#include <array>
#include <bit>
#include <gtest/gtest.h>
#include <hwy/targets.h>
#include <limits>
#include <vector>

#include <surefoot/cook.hpp>
#include <surefoot/mesh.hpp>

#include "splitmix.hpp"

namespace surefoot {
namespace {

struct Triangles {
    std::vector<vec3> vertices;
    std::vector<std::uint32_t> indices;
    [[nodiscard]] MeshInput input() const { return {.vertices = vertices, .indices = indices}; }
};

// Large and small ones, slivers, some without area, some over each other, around a place far from the origin.
Triangles make_triangles(std::uint64_t seed, int count, const dvec3& middle) {
    tests::SplitMix random(seed);
    Triangles made;
    for (int i = 0; i < count; ++i) {
        const dvec3 at = middle + random.point(10);
        const double size = i % 11 == 0 ? 6.0 : 0.6;
        for (int corner = 0; corner < 3; ++corner) {
            const bool again = corner > 0 && i % 13 == 0;
            if (!again) made.vertices.push_back(vec3(at + random.point(size)));
            made.indices.push_back(static_cast<std::uint32_t>(made.vertices.size() - 1));
        }
        if (i % 17 == 0 && i > 0) {
            std::copy_n(made.indices.end() - 6, 3, made.indices.end() - 3);
        }
    }
    return made;
}

// A floor of 40 x 40 squares, a wall across it, in a regular order: edges and corners that many triangles share.
Triangles make_floor() {
    Triangles made;
    constexpr std::uint32_t side = 41;
    for (std::uint32_t z = 0; z < side; ++z) {
        for (std::uint32_t x = 0; x < side; ++x) {
            made.vertices.push_back(
                {static_cast<float>(x) * 0.5F - 10, x == 20 ? 2.0F : 0.0F, static_cast<float>(z) * 0.5F - 10});
        }
    }
    for (std::uint32_t z = 0; z + 1 < side; ++z) {
        for (std::uint32_t x = 0; x + 1 < side; ++x) {
            const std::uint32_t a = z * side + x;
            for (const std::uint32_t i : {a, a + side, a + 1, a + 1, a + side, a + side + 1}) made.indices.push_back(i);
        }
    }
    return made;
}

Mesh built(const Triangles& triangles) {
    auto mesh = Mesh::build(triangles.input());
    EXPECT_TRUE(mesh.has_value());
    return *mesh;
}

constexpr std::array<Search, 2> searches{Search::tree, Search::scalar_tree};

template <typename T>
bool same_bits(const T& a, const T& b) {
    return std::bit_cast<std::array<std::byte, sizeof(T)>>(a) == std::bit_cast<std::array<std::byte, sizeof(T)>>(b);
}

bool same(const std::optional<Hit>& a, const std::optional<Hit>& b) {
    if (a.has_value() != b.has_value()) return false;
    if (!a) return true;
    return same_bits(a->t, b->t) && same_bits(a->point, b->point) && same_bits(a->normal, b->normal) &&
           a->triangle == b->triangle && a->feature == b->feature && a->started_inside == b->started_inside;
}

std::array<Volume, 12> volumes(tests::SplitMix& random) {
    const std::array<Shape, 6> shapes{Sphere{0.4}, Ellipsoid{}, Capsule{}, Box{}, Cylinder{}, Cone{}};
    std::array<Volume, 12> all;
    for (std::size_t i = 0; i < all.size(); ++i) {
        all[i] = Volume(shapes[i / 2], i % 2 == 0 ? dquat(1, 0, 0, 0) : random.turn());
    }
    return all;
}

struct Tally {
    int asked = 0;
    int met = 0;
};

// Every query at `rounds` places about `middle`, in each way, against brute force.
Tally expect_all_searches_agree(const Mesh& mesh, const dvec3& middle, int rounds, std::uint64_t seed) {
    tests::SplitMix random(seed);
    Tally tally;
    const auto odd = [](std::uint32_t triangle, std::uint32_t) { return triangle % 2 == 1; };
    for (int round = 0; round < rounds; ++round) {
        for (const Volume& volume : volumes(random)) {
            const dvec3 from = middle + random.point(10);
            // Short beside the shape, long, and hardly at all.
            const double far = round % 3 == 0 ? 0.3 : (round % 3 == 1 ? 15 : 1e-9);
            const Motion motion{from, from + random.point(far)};
            QueryOptions force{.one_sided = round % 4 == 3, .search = Search::brute_force};
            if (round % 5 == 4) force.filter = odd;
            const auto first = mesh.sweep(volume, motion, force);
            const auto seen = mesh.ray(motion, force);
            std::array<Overlap, 64> by_force;
            std::array<Overlap, 64> by_tree;
            const std::size_t touching = mesh.overlap(volume, from, by_force, force);
            const auto nearest = mesh.nearest(from, 3, force);
            const Bounds near{from - dvec3(1, 2, 1), from + dvec3(1, 0, 1)};
            std::array<SourceTriangle, 256> gathered_by_force;
            std::array<SourceTriangle, 256> gathered;
            const std::size_t there = mesh.gather(near, gathered_by_force, force);
            EXPECT_LE(there, gathered.size());
            for (const Search search : searches) {
                QueryOptions options = force;
                options.search = search;
                EXPECT_TRUE(same(mesh.sweep(volume, motion, options), first));
                EXPECT_EQ(mesh.sweep_any(volume, motion, options), first.has_value());
                EXPECT_TRUE(same(mesh.ray(motion, options), seen));
                EXPECT_EQ(mesh.ray_any(motion, options), seen.has_value());
                EXPECT_EQ(mesh.overlap(volume, from, by_tree, options), touching);
                for (std::size_t i = 0; i < std::min(touching, by_tree.size()); ++i) {
                    EXPECT_EQ(by_tree[i].triangle, by_force[i].triangle);
                    EXPECT_TRUE(same_bits(by_tree[i].depth, by_force[i].depth));
                }
                const auto found = mesh.nearest(from, 3, options);
                EXPECT_EQ(found.has_value(), nearest.has_value());
                if (found && nearest) {
                    EXPECT_EQ(found->triangle, nearest->triangle);
                    EXPECT_TRUE(same_bits(found->distance, nearest->distance));
                }
                EXPECT_EQ(mesh.gather(near, gathered, options), there);
                for (std::size_t i = 0; i < std::min(there, gathered.size()); ++i) {
                    EXPECT_EQ(gathered[i].id, gathered_by_force[i].id);
                }
            }
            ++tally.asked;
            tally.met += first.has_value() ? 1 : 0;
        }
    }
    return tally;
}

// Runs `test` once for every SIMD target that Highway may choose here.
template <typename Test>
void on_every_target(const Test& test) {
    int targets = 0;
    for (std::int64_t left = hwy::SupportedTargets(); left != 0; left &= left - 1) {
        const std::int64_t target = left & -left;
        SCOPED_TRACE(hwy::TargetName(target));
        hwy::SetSupportedTargetsForTest(target);
        hwy::GetChosenTarget().Update(hwy::SupportedTargets());
        test();
        ++targets;
        hwy::SetSupportedTargetsForTest(0);
    }
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    EXPECT_GE(targets, 1);
}

TEST(Tree, answers_like_brute_force_on_every_simd_target) {
    const Mesh mesh = built(make_triangles(1, 300, {0, 0, 0}));
    on_every_target([&] {
        const Tally tally = expect_all_searches_agree(mesh, {0, 0, 0}, 48, 2);
        EXPECT_GT(tally.met, tally.asked / 10);
        EXPECT_LT(tally.met, tally.asked);
    });
}

TEST(Tree, many_sweeps_at_once_answer_like_each_alone_on_every_simd_target) {
    const Mesh mesh = built(make_triangles(11, 2000, {0, 0, 0}));
    tests::SplitMix random(12);
    const auto odd = [](std::uint32_t triangle, std::uint32_t) { return triangle % 2 == 1; };
    on_every_target([&] {
        int met = 0;
        for (const Volume& volume : volumes(random)) {
            for (const std::size_t count : {0U, 1U, 7U, 8U, 9U, 100U}) {
                std::vector<Motion> motions;
                for (std::size_t i = 0; i < count; ++i) {
                    const dvec3 from = random.point(10);
                    // Short ones, some that are long, that stand still, or that are no motion at all.
                    const double far = i % 5 == 4 ? 20 : 0.4;
                    motions.push_back({from, i % 11 == 10 ? from : from + random.point(far)});
                    if (i % 17 == 16) motions.back().to.x = std::numeric_limits<double>::quiet_NaN();
                }
                QueryOptions options{.one_sided = count == 9};
                if (count == 7) options.filter = odd;
                std::vector<std::optional<Hit>> hits(count + 1, Hit{});
                mesh.sweep_many(volume, motions, hits, options);
                for (std::size_t i = 0; i < count; ++i) {
                    const auto alone = mesh.sweep(volume, motions[i], options);
                    EXPECT_TRUE(same(hits[i], alone));
                    EXPECT_EQ(hits[i] && hits[i]->status == HitStatus::invalid, i % 17 == 16);
                    met += alone.has_value() ? 1 : 0;
                }
                EXPECT_TRUE(same(hits[count], Hit{})) << "what lies behind is not touched";
            }
        }
        EXPECT_GT(met, 200);
    });
}

TEST(Tree, many_sweeps_through_a_crowd_of_leaves_answer_like_each_alone) {
    // Hundreds of leaves in every region: more than the lists of one walk hold.
    const Mesh mesh = built(make_triangles(13, 20000, {0, 0, 0}));
    tests::SplitMix random(14);
    std::vector<Motion> motions;
    for (int i = 0; i < 24; ++i) {
        const dvec3 from = random.point(8);
        motions.push_back({from, from + random.point(3)});
    }
    std::vector<std::optional<Hit>> hits(motions.size());
    QueryWork work;
    mesh.sweep_many(Sphere{9}, motions, hits, {.work = &work});
    EXPECT_GT(work.nodes, 64U * motions.size());
    for (std::size_t i = 0; i < motions.size(); ++i) EXPECT_TRUE(same(hits[i], mesh.sweep(Sphere{9}, motions[i])));
}

TEST(Tree, answers_like_brute_force_where_many_triangles_share_an_edge) {
    const Mesh mesh = built(make_floor());
    on_every_target([&] { EXPECT_GT(expect_all_searches_agree(mesh, {0, 1, 0}, 8, 3).met, 5); });
}

TEST(Tree, answers_like_brute_force_far_from_the_origin) {
    // Floats are a sixteenth of a metre apart there.
    const dvec3 middle(1e6, -3e5, 7e5);
    const Mesh mesh = built(make_triangles(4, 200, middle));
    on_every_target([&] { EXPECT_GT(expect_all_searches_agree(mesh, middle, 6, 5).met, 5); });
}

TEST(Tree, answers_like_brute_force_for_very_large_and_very_small_shapes) {
    const Mesh mesh = built(make_triangles(6, 150, {0, 0, 0}));
    tests::SplitMix random(7);
    on_every_target([&] {
        for (const double radius : {1e-6, 1e-3, 50.0, 1e6}) {
            for (int i = 0; i < 20; ++i) {
                const dvec3 away = random.point(1);
                const dvec3 from = random.point(12) + away * (radius * 1.7);
                const Motion motion{from, from - away * (radius + 5)};
                for (const Search search : searches) {
                    EXPECT_TRUE(same(mesh.sweep(Sphere{radius}, motion, {.search = search}),
                                     mesh.sweep(Sphere{radius}, motion, {.search = Search::brute_force})));
                }
            }
        }
    });
}

TEST(Tree, is_the_same_for_the_same_triangles) {
    // However the two threads share the work: the counts of an ask would differ.
    const Triangles triangles = make_triangles(8, 30000, {0, 0, 0});
    const Mesh one = built(triangles);
    const Mesh other = built(triangles);
    tests::SplitMix random(9);
    for (int i = 0; i < 50; ++i) {
        const Motion motion{random.point(10), random.point(10)};
        QueryWork of_one;
        QueryWork of_other;
        EXPECT_TRUE(
            same(one.sweep(Sphere{}, motion, {.work = &of_one}), other.sweep(Sphere{}, motion, {.work = &of_other})));
        EXPECT_EQ(of_one.nodes, of_other.nodes);
        EXPECT_EQ(of_one.triangles, of_other.triangles);
    }
}

TEST(Tree, is_built_of_the_same_bytes_by_every_simd_target) {
    // Some in a plane through the origin, so that there are minima of 0 and -0 to choose from.
    Triangles triangles = make_triangles(11, 20000, {0, 0, 0});
    for (std::size_t i = 0; i < triangles.vertices.size(); i += 5) triangles.vertices[i].y = i % 2 == 0 ? 0.0F : -0.0F;
    const std::vector<dvec3> vertices(triangles.vertices.begin(), triangles.vertices.end());
    std::vector<std::byte> first;
    on_every_target([&] {
        const auto cooked = cook({.vertices = vertices, .indices = triangles.indices});
        ASSERT_TRUE(cooked.has_value());
        std::vector<std::byte> bytes;
        for (const Section& section : cooked->mesh.sections())
            bytes.insert(bytes.end(), section.bytes.begin(), section.bytes.end());
        if (first.empty()) first = bytes;
        EXPECT_EQ(bytes, first);
    });
    EXPECT_GT(first.size(), 20000U);
}

TEST(Tree, spares_a_query_nearly_all_triangles) {
    const Mesh mesh = built(make_triangles(10, 20000, {0, 0, 0}));
    QueryWork work;
    for (int i = 0; i < 100; ++i) {
        const dvec3 from(0.1 * i - 5, 20, 0);
        static_cast<void>(mesh.sweep(Sphere{0.1}, {from, from - dvec3(0, 40, 0)}, {.work = &work}));
    }
    EXPECT_GT(work.nodes, 100U);
    EXPECT_LT(work.triangles, 100U * 40);
}

TEST(Tree, tells_which_boxes_it_opened_and_which_triangles_it_asked) {
    const Triangles triangles = make_triangles(11, 3000, {0, 0, 0});
    const Mesh mesh = built(triangles);
    tests::SplitMix random(12);
    std::vector<SearchStep> room(20000);
    for (int i = 0; i < 40; ++i) {
        const Motion motion{random.point(12), random.point(12)};
        for (const Search search : {Search::tree, Search::scalar_tree, Search::brute_force}) {
            SearchLog log(room);
            QueryWork work{.log = &log};
            const auto told = mesh.sweep(Sphere{0.3}, motion, {.search = search, .work = &work});
            EXPECT_TRUE(same(told, mesh.sweep(Sphere{0.3}, motion, {.search = search})));
            std::size_t boxes = 0;
            std::vector<std::uint32_t> asked;
            const Bounds all = mesh.bounds();
            for (const SearchStep& step : log.steps()) {
                if (step.kind == SearchStep::Kind::triangle) {
                    asked.push_back(step.triangle);
                    continue;
                }
                ++boxes;
                for (int axis = 0; axis < 3; ++axis) EXPECT_LT(step.box.min[axis], step.box.max[axis]);
                EXPECT_LE(step.enters, 1);
                if (boxes == 1) {  // the root holds everything
                    for (int axis = 0; axis < 3; ++axis) {
                        EXPECT_LE(step.box.min[axis], all.min[axis]);
                        EXPECT_GE(step.box.max[axis], all.max[axis]);
                    }
                }
            }
            EXPECT_EQ(log.dropped(), 0U);
            EXPECT_EQ(asked.size(), work.triangles);
            EXPECT_EQ(boxes, search == Search::scalar_tree ? work.nodes : 0);
            std::sort(asked.begin(), asked.end());
            EXPECT_EQ(std::adjacent_find(asked.begin(), asked.end()), asked.end()) << "one was asked twice";
            EXPECT_TRUE(!told || std::binary_search(asked.begin(), asked.end(), told->triangle));
        }
    }
}

TEST(Tree, counts_the_steps_that_found_no_room_in_its_log) {
    const Mesh mesh = built(make_triangles(11, 100, {0, 0, 0}));
    SearchStep room[7];
    SearchLog log(room);
    QueryWork work{.log = &log};
    static_cast<void>(
        mesh.sweep(Sphere{0.3}, {{0, 30, 0}, {0, 31, 0}}, {.search = Search::brute_force, .work = &work}));
    EXPECT_EQ(log.steps().size(), 7U);
    EXPECT_EQ(log.dropped(), 93U);
    log.clear();
    EXPECT_TRUE(log.steps().empty());
}

TEST(Tree, of_triangles_that_all_lie_in_one_place_still_answers) {
    Triangles pile;
    pile.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}};
    for (int i = 0; i < 1000; ++i) {
        for (const std::uint32_t corner : {0U, 2U, 1U}) pile.indices.push_back(corner);
    }
    const auto hit = built(pile).sweep(Sphere{0.1}, {{0.2, 1, 0.2}, {0.2, -1, 0.2}});
    ASSERT_TRUE(hit.has_value());
    EXPECT_EQ(hit->triangle, 0U);
}

TEST(Mesh, whose_vertices_moved_answers_like_a_new_one) {
    Triangles triangles = make_triangles(11, 500, {0, 0, 0});
    const Mesh before = built(triangles);
    tests::SplitMix random(12);
    for (vec3& vertex : triangles.vertices) vertex += vec3(random.point(2));
    const auto refitted = before.refit(triangles.input());
    ASSERT_TRUE(refitted.has_value());
    const Mesh anew = built(triangles);
    EXPECT_EQ(refitted->bounds().min, anew.bounds().min);
    int met = 0;
    for (int i = 0; i < 300; ++i) {
        const dvec3 from = random.point(10);
        const Motion motion{from, from + random.point(3)};
        const auto hit = refitted->sweep(Ellipsoid{}, motion);
        EXPECT_TRUE(same(hit, anew.sweep(Ellipsoid{}, motion)));
        met += hit.has_value() ? 1 : 0;
    }
    EXPECT_GT(met, 100);
    EXPECT_EQ(before.triangle(7).a, dvec3(built(make_triangles(11, 500, {0, 0, 0})).triangle(7).a));

    triangles.indices.resize(30);
    const auto too_few = before.refit(triangles.input());
    ASSERT_FALSE(too_few.has_value());
    EXPECT_NE(too_few.error().text.find("build a new mesh instead"), std::string::npos);
}

TEST(Mesh, hides_triangles_from_every_query_and_shows_them_again) {
    const Mesh mesh = built(make_floor());
    const Motion down{{0.1, 3, 3.1}, {0.1, -3, 3.1}};
    const auto hit = mesh.sweep(Sphere{0.1}, down);
    ASSERT_TRUE(hit.has_value());
    std::vector<std::uint32_t> hidden;
    for (std::uint32_t id = 0; id < mesh.triangle_count(); ++id) hidden.push_back(id);
    std::erase(hidden, 1600U);
    const auto almost_all = mesh.with_hidden(hidden);
    ASSERT_TRUE(almost_all.has_value());
    EXPECT_TRUE(almost_all->is_hidden(hit->triangle));
    EXPECT_FALSE(mesh.is_hidden(hit->triangle));
    EXPECT_TRUE(mesh.sweep(Sphere{0.1}, down).has_value());
    for (const Search search : {Search::tree, Search::scalar_tree, Search::brute_force}) {
        EXPECT_FALSE(almost_all->sweep(Sphere{0.1}, down, {.search = search}).has_value());
        EXPECT_FALSE(almost_all->ray(down, {.search = search}).has_value());
        std::array<SourceTriangle, 4> left;
        EXPECT_EQ(almost_all->gather({{-20, -20, -20}, {20, 20, 20}}, left, {.search = search}), 1U);
        EXPECT_EQ(left[0].id, 1600U);
    }
    const auto shown = almost_all->with_hidden(hidden, false);
    ASSERT_TRUE(shown.has_value());
    EXPECT_TRUE(same(shown->sweep(Sphere{0.1}, down), hit));
    const std::array<std::uint32_t, 1> beyond{999999};
    EXPECT_FALSE(mesh.with_hidden(beyond).has_value());
}

}  // namespace
}  // namespace surefoot
