// Links that are too long for the tiles, doors and links, and characters whose ground changes under them.
#include <array>
#include <gtest/gtest.h>
#include <vector>

#include <surefoot/navigation_check.hpp>
#include <surefoot/navigation_links.hpp>

#include "navigation_link_levels.hpp"
#include "navigation_things.hpp"

namespace surefoot::tests {
namespace {

using Status = NavigationFollowStatus;
using Reason = NavigationFollowReason;
using Region = NavigationRegion;

std::optional<NavigationPath> way(const NavigationMesh& mesh, const dvec3& from, const dvec3& to,
                                  NavigationDoors doors = NavigationDoors::as_they_are) {
    const NavigationQuery query(mesh, 4096, doors);
    const auto start = query.nearest(from, 0.5, 0.5);
    const auto end = query.nearest(to, 0.5, 0.5);
    return start && end ? query.path(*start, *end) : std::nullopt;
}

bool leads(const NavigationMesh& mesh, const dvec3& from, const dvec3& to,
           NavigationDoors doors = NavigationDoors::as_they_are) {
    const auto path = way(mesh, from, to, doors);
    return path && !path->partial;
}

/// Polygons of an area.
std::vector<NavigationPolygon> of_area(const NavigationMesh& mesh, std::uint32_t area) {
    std::vector<NavigationOutline> outlines(mesh.outlines({}));
    mesh.outlines(outlines);
    std::vector<NavigationPolygon> found;
    for (const NavigationOutline& outline : outlines)
        if (outline.area == area) found.push_back(outline.polygon);
    return found;
}

// Broken variant: Detour is given a link that it cannot join, and nobody is told.
TEST(NavigationChange, ALinkFartherThanTheNextTileIsLeftOutAndCounted) {
    Level level =
        level_of(Scene().block({0, -9, 0}, {4, 0, 6}).block({20, -9, 0}, {24, 0, 6}).block({5, -9, 0}, {9, 0, 6}));
    level.mesh_options = {.cell_size = 0.2, .cell_height = 0.1, .tile_cells = 32};
    NavigationMesh mesh = level.mesh();
    const std::array<NavigationLink, 2> links{NavigationLink{.from = {3, 0, 3}, .to = {21, 0, 3}, .takeoff = {3, 0, 3}},
                                              {.from = {3, 0, 3}, .to = {6, 0, 3}, .takeoff = {3, 0, 3}}};
    EXPECT_EQ(mesh.set_links(links).value_or(9), 1U);
    ASSERT_EQ(mesh.links().size(), 1U);
    EXPECT_EQ(mesh.links()[0].to.x, 6);
    const auto path = way(mesh, {1, 0, 3}, {8, 0, 3});
    ASSERT_TRUE(path && !path->partial);
    EXPECT_TRUE(std::any_of(path->corners.begin(), path->corners.end(),
                            [](const NavigationCorner& corner) { return corner.link == 0U; }));
    EXPECT_FALSE(leads(mesh, {1, 0, 3}, {22, 0, 3}));
}

// Broken variants: links are looked for that no tile can hold; tiles are chosen without a look at the jumps.
TEST(NavigationChange, TilesAreChosenSoThatTheyHoldTheLinksOfTheCharacter) {
    Level level = level_of(gap(3));
    level.settings.volume = Ellipsoid{{0.1, 0.9, 0.1}};
    level.mesh_options.cell_size = 0.05;
    level.mesh_options.tile_cells = 32;
    static_cast<void>(level.links());
    EXPECT_GT(level.report.too_long, 0U);
    level.mesh_options.tile_cells = 0;
    const auto links = level.links();
    EXPECT_EQ(level.report.too_long, 0U);
    ASSERT_FALSE(links.empty());
    NavigationMesh mesh = level.mesh();
    EXPECT_EQ(mesh.set_links(links).value_or(9), 0U);
    EXPECT_TRUE(leads(mesh, {-5, 20, 0}, {5, 20, 0}));
}

// Broken variant: a link counts as ground of area 0, until its tile is put in again.
TEST(NavigationChange, ALinkIsOpenAsLongAsBothItsEndsAre) {
    const std::array<NavigationArea, 2> areas{NavigationArea{.name = "ground"}, {.name = "yard"}};
    const std::array<std::uint32_t, 2> surface_areas{0, 1};
    Scene scene;
    Level level = level_of(scene.made_of(1).block({-6, 0, -3}, {-1, 20, 3}).block({1, 0, -3}, {6, 20, 3}));
    level.mesh_options.areas = areas;
    level.mesh_options.surface_areas = surface_areas;
    NavigationMesh mesh = level.mesh();
    ASSERT_EQ(mesh.set_links(level.links()).value_or(9), 0U);
    const auto gets_over = [&] { return leads(mesh, {-5, 20, 0}, {5, 20, 0}); };
    EXPECT_TRUE(gets_over());
    ASSERT_TRUE(mesh.set_area(0, true));
    EXPECT_TRUE(gets_over()) << "nothing here is of area 0";
    ASSERT_TRUE(mesh.set_area(1, true));
    EXPECT_FALSE(gets_over());
    const std::vector<NavigationLink> links(mesh.links().begin(), mesh.links().end());
    EXPECT_EQ(mesh.set_links(links).value_or(9), 0U) << "shut ground is ground";
    EXPECT_FALSE(gets_over());
    ASSERT_TRUE(mesh.set_area(1, false));
    EXPECT_TRUE(gets_over());
}

/// Two blocks with a gap of two metres; beyond it the first metres are a door.
struct Gate {
    std::array<NavigationArea, 2> areas{NavigationArea{.name = "ground"}, {.name = "door", .closed = true}};
    std::array<Region, 1> regions{Region{.name = "door",
                                         .pose = {.position = {2, 20, 0}},
                                         .half_extents = {1.5, 1, 4},
                                         .kind = Region::Kind::area,
                                         .area = 1}};
    Level level = level_of(gap(2));

    Gate() {
        level.mesh_options.areas = areas;
        level.mesh_options.regions = regions;
    }
    Gate(const Gate&) = delete;
    Gate& operator=(const Gate&) = delete;
};

// Broken variant: a door that is shut while links are looked for has none.
TEST(NavigationChange, LinksLeadThroughADoorThatIsShutWhileTheyAreLookedFor) {
    Gate gate;
    NavigationMesh mesh = gate.level.mesh();
    const auto links = find_links(gate.level.world, gate.level.settings, mesh);
    ASSERT_TRUE(mesh.set_area(1, false));
    EXPECT_EQ(links.size(), find_links(gate.level.world, gate.level.settings, mesh).size());
    EXPECT_GE(links.size(), 4U);
    ASSERT_TRUE(mesh.set_area(1, true));
    ASSERT_EQ(mesh.set_links(links).value_or(9), 0U);
    EXPECT_FALSE(leads(mesh, {-5, 20, 0}, {5, 20, 0}));
    EXPECT_TRUE(leads(mesh, {-5, 20, 0}, {5, 20, 0}, NavigationDoors::open)) << "would there be a way?";
    ASSERT_TRUE(mesh.set_area(1, false));
    EXPECT_TRUE(leads(mesh, {-5, 20, 0}, {5, 20, 0}));
}

// Broken variant: what is behind a shut door counts as out of reach.
TEST(NavigationChange, ACheckGoesThroughDoors) {
    Gate gate;
    NavigationCheckOptions options;
    options.mesh = gate.level.mesh_options;
    options.walks = 20;
    options.rehearsals = 20;
    const dvec3 start{-5, 20, 0};
    const auto check = check_navigation(gate.level.world, gate.level.settings, std::span(&start, 1), options);
    ASSERT_TRUE(check.has_value()) << check.error().text;
    EXPECT_TRUE(check->passes());
    EXPECT_GT(check->agreement.kept, 50) << "both blocks";
    EXPECT_GT(check->links_walked, 0U);
}

// Broken variants: lava is ground of the mesh; the flood walks over it; links lead over it on foot.
TEST(NavigationChange, NobodySetsFootOnASurfaceThatIsForbidden) {
    Scene scene;
    scene.floor(-6, -1, -4, 4).floor(1, 6, -4, 4).made_of(1).floor(-1, 1, -4, 2).made_of(0).floor(-1, 1, 2, 4);
    Level level = level_of(scene);
    const std::array<std::uint32_t, 2> surface_areas{0, forbidden_area};
    NavigationCheckOptions options;
    options.mesh.surface_areas = surface_areas;
    options.walks = 20;
    options.rehearsals = 20;
    level.settings.jump_height = 0;
    const dvec3 start{-5, 0, 0};
    const auto check = check_navigation(level.world, level.settings, std::span(&start, 1), options);
    ASSERT_TRUE(check.has_value()) << check.error().text;
    EXPECT_TRUE(check->passes()) << check->agreement.covered();
    EXPECT_EQ(check->links.kept[0] + check->links.kept[1] + check->links.kept[2], 0U);
    EXPECT_NEAR(check->agreement.flood, 84, 8) << "all but the twelve square metres of lava";
    level.mesh_options.surface_areas = surface_areas;
    EXPECT_FALSE(NavigationQuery(level.mesh()).nearest({0, 0, -2}, 0.3, 0.5).has_value());
}

// Broken variant: without a word it begins somewhere else.
TEST(NavigationChange, ACheckBeginsWhereItIsToldOrSaysThatThereIsNoGround) {
    Level level = level_of(Scene().floor(-6, 6, -6, 6).floor(20, 24, 0, 4));
    NavigationCheckOptions options;
    options.walks = 2;
    options.rehearsals = 0;
    options.start = dvec3{22, 0.5, 2};
    const auto check = check_navigation(level.world, level.settings, {}, options);
    ASSERT_TRUE(check.has_value()) << check.error().text;
    EXPECT_LT(check->agreement.kept, 20) << "the smaller floor";
    options.start = dvec3{14.5, 0.5, 2};
    const auto none = check_navigation(level.world, level.settings, {}, options);
    ASSERT_FALSE(none.has_value());
    EXPECT_NE(none.error().text.find("14.5,0.5,2"), std::string::npos) << none.error().text;
}

// Broken variants: the goal's polygon is dead for ever; links that failed are taken for others of their number.
TEST(NavigationChange, AFollowerFindsItsGoalAgainWhenLinksWereSet) {
    Level level = level_of(Scene().floor(-8, 8, -4, 4));
    NavigationMesh mesh = level.mesh();
    const NavigationQuery query(mesh);
    Walker walker{.world = level.world, .query = query};
    walker.at({-6, 0, 0}).to({6, 0, 0});
    for (int i = 0; i < 30; ++i) walker.tick();
    const NavigationLink link{.from = {5, 0, 1}, .to = {5, 0, -1}, .takeoff = {5, 0, 1}};
    const NavigationLink other{.from = {-5, 0, 1}, .to = {-5, 0, -1}, .takeoff = {-5, 0, 1}};
    const std::array<NavigationLink, 2> links{link, other};
    ASSERT_EQ(mesh.set_links(links).value_or(9), 0U);
    EXPECT_EQ(walker.run(), Status::arrived);
    EXPECT_LT(walker.from_goal({6, 0, 0}), 0.3);
    ASSERT_EQ(mesh.set_links({}).value_or(9), 0U);
    EXPECT_EQ(walker.to({-6, 0, 0}).run(), Status::arrived);
}

/// A floor of which the middle is of its own area, so that it has polygons of its own.
struct Middle {
    std::array<NavigationArea, 2> areas{NavigationArea{.name = "ground"}, {.name = "middle"}};
    std::array<Region, 1> regions{
        Region{.name = "middle", .half_extents = {4, 1, 5}, .kind = Region::Kind::area, .area = 1}};
    Level level = level_of(Scene().floor(-10, 10, -4, 4));

    Middle() {
        level.mesh_options.areas = areas;
        level.mesh_options.regions = regions;
    }
    Middle(const Middle&) = delete;
    Middle& operator=(const Middle&) = delete;
};

// Broken variants: whoever stands on ground that was taken out gives up; it walks to the farther side.
TEST(NavigationChange, WhoeverStandsOnGroundThatWasTakenOutFindsTheWayBack) {
    Middle middle;
    NavigationMesh mesh = middle.level.mesh();
    const NavigationQuery query(mesh);
    for (const bool door : {false, true}) {
        if (door) {
            mesh.take_out(of_area(mesh, 1), false);
            ASSERT_TRUE(mesh.set_area(1, true));
        } else {
            mesh.take_out(of_area(mesh, 1));
        }
        EXPECT_FALSE(query.under({-1, 0.1, 0}, 1, 1).has_value());
        EXPECT_FALSE(query.nearest({-1, 0, 0}, 1, 1).has_value());
        const std::vector<dvec3> back = query.way_back({-1, 0, 0});
        ASSERT_FALSE(back.empty());
        EXPECT_LT(back.back().x, -4);
        EXPECT_TRUE(query.under(back.back() + dvec3{0, 0.1, 0}, 1, 1).has_value());
        Walker walker{.world = middle.level.world, .query = query};
        EXPECT_EQ(walker.at({-1, 0, 0}).to({-8, 0, 2}).run(), Status::arrived);
        EXPECT_LT(walker.seconds, 5);
    }
    EXPECT_EQ(query.way_back({-8, 0, 0}).size(), 1U) << "who stands on open ground is there";
    EXPECT_TRUE(query.way_back({30, 0, 0}).empty());
}

// Broken variant: it is led for ever.
TEST(NavigationChange, WhereNoGroundLeadsBackAFollowerGivesUp) {
    Level level = level_of(Scene().floor(-10, 10, -4, 4).floor(20, 26, -3, 3));
    NavigationMesh mesh = level.mesh();
    const NavigationQuery query(mesh);
    const auto island = query.reachable(*query.nearest({23, 0, 0}, 1, 1));
    mesh.take_out(island);
    EXPECT_TRUE(query.way_back({23, 0, 0}).empty());
    Walker walker{.world = level.world, .query = query};
    EXPECT_EQ(walker.at({23, 0, 0}).to({-8, 0, 2}).run(), Status::gave_up);
    EXPECT_EQ(walker.follower.reason(), Reason::off_mesh);
}

// Broken variant: random places are drawn from the ground as it was when the first was asked for.
TEST(NavigationChange, RandomPlacesAreOnGroundThatIsOpenNow) {
    Middle middle;
    NavigationMesh mesh = middle.level.mesh();
    const NavigationQuery query(mesh);
    const auto in_middle = [&] {
        int count = 0;
        for (std::uint64_t seed = 0; seed < 200; ++seed)
            count += std::abs(query.random(seed)->position.x) < 3.5 ? 1 : 0;
        return count;
    };
    const int before = in_middle();
    EXPECT_GT(before, 30);
    ASSERT_TRUE(mesh.set_area(1, true));
    EXPECT_EQ(in_middle(), 0);
    ASSERT_TRUE(mesh.set_area(1, false));
    mesh.take_out(of_area(mesh, 1));
    EXPECT_EQ(in_middle(), 0);
    mesh.take_out(of_area(mesh, 1), false);
    EXPECT_EQ(in_middle(), before);
}

}  // namespace
}  // namespace surefoot::tests
