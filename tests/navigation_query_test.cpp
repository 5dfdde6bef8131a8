// Questions to a navigation mesh: under, nearest, path, ray, random.
#include <limits>

#include "navigation_scene.hpp"
#include "splitmix.hpp"

namespace surefoot::tests {
namespace {

// Would catch a query that takes the storey above, or the nearest in height whatever the side.
TEST(NavigationQuery, OfTwoStoreysTheOneThatIsUnderThePlaceIsFound) {
    const NavigationMesh mesh = built(Scene().floor(0, 10, 0, 10).block({2, 3, 2}, {8, 3.5, 8}).world());
    const NavigationQuery query(mesh);
    const auto upper = query.under({5, 5, 5}, 10, 1);
    const auto lower = query.under({5, 2, 5}, 10, 10);
    ASSERT_TRUE(upper && lower);
    EXPECT_NEAR(upper->position.y, 3.5, 0.11);
    EXPECT_NEAR(lower->position.y, 0, 0.11);
    EXPECT_NE(upper->polygon, lower->polygon);
}

TEST(NavigationQuery, WhoBeginsBelowTheGroundFindsItAboveAndNoFartherThanAsked) {
    const NavigationMesh mesh = built(Scene().floor(0, 10, 0, 10).world());
    const NavigationQuery query(mesh);
    const auto above = query.under({5, -0.6, 5}, 0.1, 1);
    ASSERT_TRUE(above);
    EXPECT_NEAR(above->position.y, 0, 0.11);
    EXPECT_EQ(above->position.x, 5);
    EXPECT_FALSE(query.under({5, -2, 5}, 0.1, 1));
    EXPECT_FALSE(query.under({5, 3, 5}, 1, 1));
    EXPECT_FALSE(query.under({15, 0, 5}, 1, 1)) << "there is no ground";
}

// Found by a random corridor: to floats, a place on the side that two polygons share lay in neither of them.
TEST(NavigationQuery, OnTheSideBetweenTwoPolygonsThereIsGround) {
    const NavigationMesh mesh = built(yard().world());
    const NavigationQuery query(mesh);
    for (const NavigationOutline& outline : outlines_of(mesh)) {
        for (std::size_t i = 0; i < outline.corners; ++i) {
            if (!outline.beside[i]) continue;
            const dvec3 a = outline.corner[i];
            const dvec3 b = outline.corner[(i + 1) % outline.corners];
            for (int k = 0; k <= 32; ++k) EXPECT_TRUE(query.under(a + (b - a) * (k / 32.0) + dvec3{0, 0.5, 0}, 1, 0.5));
        }
    }
}

// Would catch a search box that is not cut to the tiles: it would go on for ever.
TEST(NavigationQuery, TheNearestGroundIsFoundFromAfarAndNowhereBeyondItsReach) {
    const NavigationMesh mesh = built(Scene().floor(0, 10, 0, 10).world());
    const NavigationQuery query(mesh);
    const auto far = query.nearest({1000, 0, 5}, 1e9, 1e9);
    ASSERT_TRUE(far);
    EXPECT_NEAR(far->position.x, 10, 0.5);
    EXPECT_NEAR(far->position.z, 5, 0.01);
    EXPECT_FALSE(query.nearest({12, 0, 5}, 1, 1));
    EXPECT_TRUE(query.nearest({10.6, 0, 5}, 1, 1));
}

// Would catch numbers that reach Detour, which squares them and follows what comes of it.
TEST(NavigationQuery, WhatIsNoPlaceHasNoAnswer) {
    const NavigationMesh mesh = built(Scene().floor(0, 10, 0, 10).world());
    const NavigationQuery query(mesh);
    const auto here = query.under({5, 0.5, 5}, 1, 1);
    ASSERT_TRUE(here);
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 1e30}) {
        const dvec3 place{bad, 0, 5};
        EXPECT_FALSE(query.under(place, 1, 1));
        EXPECT_FALSE(query.under({5, 0, 5}, std::numeric_limits<double>::quiet_NaN(), 1));
        EXPECT_FALSE(query.nearest(place, 1, 1));
        EXPECT_FALSE(query.ray(*here, place));
        EXPECT_FALSE(query.path({place, here->polygon}, *here));
        EXPECT_FALSE(query.path(*here, {place, here->polygon}));
    }
    EXPECT_FALSE(query.path(*here, {{5, 0, 5}, {}})) << "no polygon";
    EXPECT_FALSE(query.path(*here, {{5, 0, 5}, {0xdeadbeef}})) << "nor one that is not there";
    EXPECT_FALSE(query.ray({{5, 0, 5}, {0xdeadbeef}}, {6, 0, 5}));
}

TEST(NavigationQuery, APathThatCannotArriveEndsAsNearAsItGetsAndSaysSo) {
    const NavigationMesh mesh =
        built(Scene().floor(0, 10, 0, 10).block({10, -1, 0}, {10.2, 4, 10}).floor(10.2, 20, 0, 10).world());
    const auto path = way(mesh, {2, 0, 3}, {18, 0, 3});
    ASSERT_TRUE(path);
    EXPECT_TRUE(path->partial);
    EXPECT_GT(path->corners.back().position.x, 9);
    EXPECT_LT(path->corners.back().position.x, 10);
    EXPECT_FALSE(leads(mesh, {2, 0, 3}, {18, 0, 3}));
    EXPECT_TRUE(leads(mesh, {2, 0, 3}, {8, 0, 9}));
}

/// Random corridors: rooms in a row, each with a gap in the wall at another place.
struct Corridor {
    Scene scene;
    std::vector<std::pair<double, double>> gaps;  ///< in z, at x = 4, 8, 12, ...
};

Corridor corridor(std::uint64_t seed) {
    SplitMix random(seed);
    Corridor made;
    constexpr int walls = 5;
    made.scene.floor(0, 4 * (walls + 1), 0, 12);
    for (int i = 1; i <= walls; ++i) {
        const double low = random.in(1, 9);
        const double high = low + 2;
        made.scene.block({4.0 * i, 0, 0}, {4.0 * i + 0.2, 3, low}).block({4.0 * i, 0, high}, {4.0 * i + 0.2, 3, 12});
        made.gaps.emplace_back(low, high);
    }
    return made;
}

/// The shortest line through segments, by brute force: all ways over their ends that are not cut off.
double shortest(const dvec3& from, const std::vector<NavigationPortal>& portals, const dvec3& to) {
    std::vector<dvec3> places{from};
    std::vector<std::size_t> before{0};  // how many portals are crossed when one is there
    for (std::size_t i = 0; i < portals.size(); ++i) {
        for (const dvec3& end : {portals[i].left, portals[i].right}) {
            places.push_back(end);
            before.push_back(i + 1);
        }
    }
    places.push_back(to);
    before.push_back(portals.size() + 1);
    const auto level = [](const dvec3& v) { return dvec3{v.x, 0, v.z}; };
    const auto sees = [&](std::size_t a, std::size_t b) {
        for (std::size_t i = before[a]; i + 1 < before[b]; ++i) {
            // The line from a to b crosses portal i between its ends.
            const dvec3 way = level(places[b] - places[a]);
            const dvec3 l = level(portals[i].left - places[a]);
            const dvec3 r = level(portals[i].right - places[a]);
            const double on_left = way.x * l.z - way.z * l.x;
            const double on_right = way.x * r.z - way.z * r.x;
            if (on_left * on_right > 1e-9) return false;
        }
        return true;
    };
    std::vector<double> best(places.size(), 1e300);
    best[0] = 0;
    for (std::size_t b = 1; b < places.size(); ++b)
        for (std::size_t a = 0; a < b; ++a)
            if (before[a] < before[b] && sees(a, b))
                best[b] = std::min(best[b], best[a] + length_of(level(places[b] - places[a])));
    return best.back();
}

// Would catch a funnel that turns at the wrong corner, or keeps a corner too many. One tile, so that portals are whole
// sides and the row of them is a simple corridor.
TEST(NavigationQuery, ThePulledPathIsTheShortestThroughItsPortals) {
    NavigationOptions options = quick();
    options.tile_cells = 160;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const NavigationMesh mesh = built(corridor(seed).scene.world(), options);
        const auto path = way(mesh, {1, 0, 6}, {23, 0, 6});
        ASSERT_TRUE(path && !path->partial) << seed;
        double length = 0;
        for (std::size_t i = 0; i + 1 < path->corners.size(); ++i) {
            dvec3 leg = path->corners[i + 1].position - path->corners[i].position;
            leg.y = 0;
            length += length_of(leg);
        }
        EXPECT_NEAR(length, shortest(path->corners.front().position, path->portals, path->corners.back().position),
                    1e-4)
            << seed;
    }
}

TEST(NavigationQuery, PortalsHaveTheirLeftOnTheLeftAndTheRawPathGoesThroughTheirMiddles) {
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
        const NavigationMesh mesh = built(corridor(seed).scene.world());
        const auto path = way(mesh, {1, 0, 6}, {23, 0, 6});
        ASSERT_TRUE(path);
        ASSERT_EQ(path->portals.size() + 1, path->polygons.size());
        ASSERT_EQ(path->midpoints.size(), path->portals.size() + 2);
        for (std::size_t i = 0; i < path->portals.size(); ++i) {
            const NavigationPortal& portal = path->portals[i];
            const dvec3 middle = (portal.left + portal.right) * 0.5;
            EXPECT_LT(length_of(path->midpoints[i + 1] - middle), 1e-9);
            const NavigationOutline outline = mesh.outline(path->polygons[i]);
            dvec3 centre{0, 0, 0};
            for (std::size_t k = 0; k < outline.corners; ++k)
                centre += outline.corner[k] / static_cast<double>(outline.corners);
            // +Y up, seen from above: left of the way towards the portal.
            const dvec3 ahead = middle - centre;
            const dvec3 left = portal.left - middle;
            EXPECT_GT(ahead.z * left.x - ahead.x * left.z, 0) << seed << " " << i;
        }
    }
}

// Would catch a ray that stops at tile borders, or goes through walls, or a normal that points away.
TEST(NavigationQuery, ARayRunsAlongTheGroundUntilTheMeshEnds) {
    const NavigationMesh mesh = built(Scene().floor(0, 20, 0, 20).block({14, 0, 0}, {15, 3, 20}).world());
    const NavigationQuery query(mesh);
    const auto from = query.under({2, 0.5, 3}, 1, 1);
    ASSERT_TRUE(from);
    const auto free = query.ray(*from, {12, 0, 17});
    ASSERT_TRUE(free);
    EXPECT_FALSE(free->hit);
    EXPECT_EQ(free->t, 1);
    EXPECT_EQ(free->position, dvec3(12, 0, 17));
    const auto stopped = query.ray(*from, {18, from->position.y, 11});
    ASSERT_TRUE(stopped);
    EXPECT_TRUE(stopped->hit);
    EXPECT_LT(stopped->position.x, 14 - 0.41);
    EXPECT_GT(stopped->position.x, 14 - 0.41 - 2 * 0.2 - 0.01) << "two cells at most are lost";
    EXPECT_NEAR(stopped->normal.x, -1, 0.05);
    EXPECT_NEAR(length_of(stopped->position -
                          (from->position + (dvec3{18, from->position.y, 11} - from->position) * stopped->t)),
                0, 1e-9);
    const auto nowhere = query.ray(*from, from->position);
    ASSERT_TRUE(nowhere);
    EXPECT_FALSE(nowhere->hit);
}

// Would catch places drawn by polygon, where small ones are as likely as large ones.
TEST(NavigationQuery, EachSquareMetreIsAsLikelyToBeDrawn) {
    const NavigationMesh mesh =
        built(Scene().floor(0, 20, 0, 20).block({5, 0, 5}, {6, 2, 6}).block({14, 0, 3}, {15, 2, 9}).world());
    const NavigationQuery query(mesh);
    std::array<int, 4> quarters{};
    constexpr int draws = 4000;
    double area = 0;
    std::array<double, 4> share{};
    for (const NavigationOutline& outline : outlines_of(mesh)) {
        // Polygons are cut into thin slices of triangles, each counted where its middle lies.
        for (std::size_t i = 2; i < outline.corners; ++i) {
            const dvec3 a = outline.corner[0], b = outline.corner[i - 1], c = outline.corner[i];
            constexpr int cuts = 40;
            for (int u = 0; u < cuts; ++u) {
                for (int v = 0; u + v < cuts; ++v) {
                    const dvec3 at = a + (b - a) * ((u + 1.0 / 3) / cuts) + (c - a) * ((v + 1.0 / 3) / cuts);
                    const double size = std::abs((b.x - a.x) * (c.z - a.z) - (c.x - a.x) * (b.z - a.z)) *
                                        (u + v + 1 < cuts ? 1 : 0.5) / (cuts * cuts);
                    share[(at.x > 10 ? 1U : 0U) + (at.z > 10 ? 2U : 0U)] += size;
                    area += size;
                }
            }
        }
    }
    for (std::uint64_t seed = 0; seed < draws; ++seed) {
        const auto place = query.random(seed);
        ASSERT_TRUE(place);
        ++quarters[(place->position.x > 10 ? 1U : 0U) + (place->position.z > 10 ? 2U : 0U)];
        EXPECT_EQ(place->position, query.random(seed)->position) << "the same seed, the same place";
    }
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(quarters[i] / double{draws}, share[i] / area, 0.03) << i;
}

TEST(NavigationQuery, WhatIsDrawnAsReachableCanBeReached) {
    const NavigationMesh mesh = built(Scene().floor(0, 10, 0, 10).floor(20, 30, 0, 10).world());
    const NavigationQuery query(mesh);
    const auto from = query.under({2, 0.5, 2}, 1, 1);
    ASSERT_TRUE(from);
    bool beyond = false;
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
        const auto place = query.random_reachable(*from, seed);
        ASSERT_TRUE(place);
        EXPECT_LT(place->position.x, 10);
        EXPECT_FALSE(query.path(*from, *place)->partial);
        beyond = beyond || query.random(seed)->position.x > 15;
    }
    EXPECT_TRUE(beyond) << "of all ground, some lies beyond";
    for (const NavigationPolygon polygon : query.reachable(*from)) EXPECT_LT(mesh.outline(polygon).corner[0].x, 10);
}

// Would catch a search that keeps something from one round to the next which the whole search does not.
TEST(NavigationQuery, ASearchThatIsWatchedStepByStepEndsAsTheSearchAtOnce) {
    const NavigationMesh mesh = built(corridor(4).scene.world());
    NavigationQuery query(mesh);
    const auto from = query.under({1, 0.5, 6}, 1, 1);
    const auto to = query.under({23, 0.5, 6}, 1, 1);
    ASSERT_TRUE(from && to);
    const auto whole = query.path(*from, *to);
    ASSERT_TRUE(whole);
    ASSERT_TRUE(query.begin_search(*from, *to));
    std::size_t last = 0;
    std::vector<NavigationSearchNode> nodes(1000);
    bool more = true;
    while (more) {
        more = query.advance_search(1);
        const std::size_t count = query.search_nodes(nodes);
        EXPECT_GE(count, last);
        last = count;
    }
    EXPECT_GT(last, whole->polygons.size() - 1);
    const auto watched = query.finish_search();
    ASSERT_TRUE(watched);
    EXPECT_EQ(watched->polygons, whole->polygons);
    EXPECT_EQ(watched->length, whole->length);
}

}  // namespace
}  // namespace surefoot::tests
