// How a navigation mesh is made: what is ground, and what the settings of `step` have to do with it.
#include "navigation_scene.hpp"

namespace surefoot::tests {
namespace {

double area_of(const NavigationMesh& mesh) {
    return mesh.report().area;
}

TEST(NavigationBuild, AFloorIsGroundUpToItsEdges) {
    const NavigationMesh mesh = built(Scene().floor(0, 10, 0, 10).world());
    const NavigationReport report = mesh.report();
    EXPECT_GT(report.area, 90) << "a body stands on an edge; a cell at each side is lost";
    EXPECT_LT(report.area, 100);
    EXPECT_EQ(report.tiles, 4U);
    EXPECT_TRUE(leads(mesh, {1, 0, 1}, {9, 0, 9}));
    EXPECT_EQ(outlines_of(mesh).size(), report.polygons);
}

// Would catch an agent of another width than the body that `step` moves.
TEST(NavigationBuild, AWallKeepsThePathAsFarAwayAsTheBodyIsWide) {
    const World world = Scene().floor(0, 12, 0, 8).block({5, 0, 0}, {6, 3, 4}).block({5, 0, 6}, {6, 3, 8}).world();
    const NavigationMesh mesh = built(world);
    ASSERT_TRUE(leads(mesh, {2, 0, 2}, {9, 0, 2}));
    const auto path = way(mesh, {2, 0, 2}, {9, 0, 2});
    EXPECT_GT(path->length, 8) << "around it";
    for (const NavigationOutline& outline : outlines_of(mesh)) {
        for (std::size_t i = 0; i < outline.corners; ++i) {
            const dvec3 at = outline.corner[i];
            const bool near = at.x > 5 - 0.40 && at.x < 6 + 0.40 && (at.z < 4 + 0.40 || at.z > 6 - 0.40);
            EXPECT_FALSE(near && at.y < 2) << at.x << " " << at.z;
        }
    }
    CharacterSettings wide;
    wide.volume = Ellipsoid{{1.2, 1.3, 1.2}};
    EXPECT_FALSE(leads(built(world, quick(), wide), {2, 0, 2}, {9, 0, 2})) << "2 m are too narrow for 2.4 m";
}

TEST(NavigationBuild, StairsOfJustTheStepHeightAreWalkedAndOfMoreAreNot) {
    const CharacterSettings settings;
    const auto stairs = [&](double rise) { return Scene().floor(-10, 0, -3, 3).stairs(0, 5, rise, 0.6).world(); };
    EXPECT_TRUE(leads(built(stairs(settings.step_up)), {-5, 0, 0}, {5, 5 * settings.step_up, 0}));
    EXPECT_FALSE(leads(built(stairs(settings.step_up + 0.11)), {-5, 0, 0}, {5, 5 * (settings.step_up + 0.11), 0}));
    CharacterSettings none = settings;
    none.step_up = 0.15;
    EXPECT_FALSE(leads(built(stairs(settings.step_up), quick(), none), {-5, 0, 0}, {5, 5 * settings.step_up, 0}));
}

TEST(NavigationBuild, ASlopeJustUnderTheLimitIsGroundAndOneJustOverItIsNot) {
    const CharacterSettings settings;
    for (const double off : {-0.5, 0.5}) {
        const double degrees = settings.slope_limit_deg + off;
        const double rise = 4 * std::tan(degrees * 0.017453292519943295);
        const NavigationMesh mesh = built(Scene().floor(-6, 0, -10, 10).ramp(0, 4, degrees).world());
        const NavigationQuery query(mesh);
        EXPECT_EQ(query.under({2, rise / 2 + 0.3, 0}, 1, 0.3).has_value(), off < 0) << degrees;
        EXPECT_TRUE(query.under({-3, 0.3, 0}, 1, 0.3));
    }
}

TEST(NavigationBuild, SlipperyGroundIsNone) {
    const World world = Scene().floor(0, 10, 0, 10).made_of(3).floor(10, 20, 0, 10).world();
    CharacterSettings settings;
    const NavigationMesh dry = built(world, quick(), settings);
    std::array<SurfaceRule, 4> surfaces{};
    surfaces[3].slippery = true;
    settings.surfaces = std::span<const SurfaceRule>(surfaces);
    const NavigationMesh wet = built(world, quick(), settings);
    EXPECT_TRUE(NavigationQuery(dry).under({15, 0.5, 5}, 1, 1));
    EXPECT_FALSE(NavigationQuery(wet).under({15, 0.5, 5}, 1, 1));
    EXPECT_TRUE(NavigationQuery(wet).under({5, 0.5, 5}, 1, 1));
}

// Would catch a door that is shut in one tile only, or a query that keeps what was true when it was made.
TEST(NavigationBuild, ADoorIsShutAndOpenedWithoutBuilding) {
    const World world = Scene().floor(0, 12, 0, 8).block({5, 0, 0}, {6, 3, 3}).block({5, 0, 5}, {6, 3, 8}).world();
    const std::array<NavigationArea, 2> areas{NavigationArea{.name = "ground"}, {.name = "door"}};
    const std::array<NavigationRegion, 1> regions{NavigationRegion{.name = "door",
                                                                   .pose = {.position = {5.5, 0, 4}},
                                                                   .half_extents = {0.5, 1, 1},
                                                                   .kind = NavigationRegion::Kind::area,
                                                                   .area = 1}};
    NavigationOptions options = quick();
    options.areas = areas;
    options.regions = regions;
    NavigationMesh mesh = built(world, options);
    const NavigationQuery query(mesh);
    const auto from = query.under({2, 0.5, 4}, 1, 1);
    const auto to = query.under({9, 0.5, 4}, 1, 1);
    ASSERT_TRUE(from && to);
    EXPECT_FALSE(query.path(*from, *to)->partial);
    ASSERT_TRUE(mesh.set_area(1, true));
    EXPECT_TRUE(query.path(*from, *to)->partial);
    EXPECT_TRUE(query.ray(*from, {9, 0, 4})->hit);
    ASSERT_TRUE(mesh.set_area(1, false));
    EXPECT_FALSE(query.path(*from, *to)->partial);
    EXPECT_FALSE(query.ray(*from, {9, 0, 4})->hit);
}

TEST(NavigationBuild, ARegionForbidsGroundAndOneThatRequiresItSaysWhenThereIsNone) {
    const World world = Scene().floor(0, 12, 0, 6).world();
    std::array<NavigationRegion, 1> regions{NavigationRegion{.name = "flowers",
                                                             .pose = {.position = {6, 0, 3}},
                                                             .half_extents = {1, 1, 4},
                                                             .kind = NavigationRegion::Kind::forbid}};
    NavigationOptions options = quick();
    options.regions = regions;
    EXPECT_FALSE(leads(built(world, options), {2, 0, 3}, {10, 0, 3}));
    regions[0].kind = NavigationRegion::Kind::require;
    EXPECT_TRUE(leads(built(world, options), {2, 0, 3}, {10, 0, 3}));
    regions[0].pose.position.y = 5;
    const auto none = NavigationMesh::build(world, {}, options);
    ASSERT_FALSE(none.has_value());
    EXPECT_EQ(none.error().code, ErrorCode::invalid);
    EXPECT_NE(none.error().text.find("'flowers'"), std::string::npos) << none.error().text;
}

TEST(NavigationBuild, MarkersOfALevelForbidAndRequireGround) {
    const std::array<Marker, 3> markers{
        Marker{.name = "pit", .kind = "navigation_forbid", .extras = {}, .position = {6, 0, 3}, .scale = {-1, 1, 4}},
        {.name = "spawn", .kind = "spawn", .extras = {}},
        {.name = "exit", .kind = "navigation_require", .extras = {}, .position = {10, 0, 3}}};
    const std::vector<NavigationRegion> regions = navigation_regions(markers);
    ASSERT_EQ(regions.size(), 2U);
    NavigationOptions options = quick();
    options.regions = regions;
    EXPECT_FALSE(leads(built(Scene().floor(0, 12, 0, 6).world(), options), {2, 0, 3}, {10, 0, 3}));
    const auto without = NavigationMesh::build(Scene().floor(0, 8, 0, 6).world(), {}, options);
    ASSERT_FALSE(without.has_value());
    EXPECT_NE(without.error().text.find("'exit'"), std::string::npos) << without.error().text;
}

// Would catch costs that are not handed to the search, or areas that are off by one.
TEST(NavigationBuild, DearGroundIsGoneAroundWhenThatIsCheaper) {
    const World world = Scene()
                            .floor(0, 4, 0, 20)
                            .made_of(1)
                            .floor(4, 8, 0, 14)
                            .made_of(0)
                            .floor(4, 8, 14, 20)
                            .floor(8, 12, 0, 20)
                            .world();
    const std::array<NavigationArea, 2> areas{NavigationArea{.name = "ground"}, {.name = "mud", .cost = 10}};
    const std::array<std::uint32_t, 2> surfaces{0, 1};
    NavigationOptions options = quick();
    options.areas = areas;
    options.surface_areas = surfaces;
    NavigationMesh mesh = built(world, options);
    EXPECT_GT(way(mesh, {1, 0, 8}, {11, 0, 8})->length, 14) << "around the mud";
    ASSERT_TRUE(mesh.set_area(1, false, 1));
    EXPECT_LT(way(mesh, {1, 0, 8}, {11, 0, 8})->length, 11) << "through it";
}

/// The scene with y turned to `up`; `turn` is the matrix's columns.
Scene turned_yard(const std::array<dvec3, 3>& turn, const dvec3& shift) {
    const auto at = [&](double x, double y, double z) { return shift + x * turn[0] + y * turn[1] + z * turn[2]; };
    Scene scene;
    scene.quad(at(0, 0, 0), at(0, 0, 12), at(12, 0, 12), at(12, 0, 0));
    scene.quad(at(4, 2, 0), at(4, 0, 0), at(4, 0, 7), at(4, 2, 7));
    return scene;
}

// Would catch any place that takes +Y for up, or mirrors.
TEST(NavigationBuild, WhicheverWayIsUpTheMeshIsTheSameTurned) {
    const std::array<dvec3, 3> plain{dvec3{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const std::array<dvec3, 3> to_x{dvec3{0, 1, 0}, {1, 0, 0}, {0, 0, -1}};
    const std::array<dvec3, 3> to_z{dvec3{0, -1, 0}, {0, 0, 1}, {-1, 0, 0}};
    const std::array<dvec3, 3> down{dvec3{-1, 0, 0}, {0, -1, 0}, {0, 0, 1}};
    const double s = std::sqrt(0.5);
    const std::array<dvec3, 3> askew{dvec3{s, -s, 0}, {s, s, 0}, {0, 0, 1}};
    const auto measured = [&](const std::array<dvec3, 3>& turn) {
        NavigationOptions options = quick();
        options.up = 3.0 * turn[1];
        const NavigationMesh mesh = built(turned_yard(turn, {0, 0, 0}).world(), options);
        const auto at = [&](double x, double y, double z) { return x * turn[0] + y * turn[1] + z * turn[2]; };
        const NavigationQuery query(mesh);
        const auto from = query.under(at(2, 0.5, 2), 1, 1);
        const auto to = query.under(at(9, 0.5, 2), 1, 1);
        EXPECT_TRUE(from && to);
        EXPECT_NEAR(length_of(mesh.up() - turn[1]), 0, 1e-12);
        const auto path = query.path(from.value_or(NavigationPoint{}), to.value_or(NavigationPoint{}));
        EXPECT_TRUE(path && !path->partial);
        return std::pair(area_of(mesh), path ? path->length : 0);
    };
    const auto [area, length] = measured(plain);
    EXPECT_GT(length, 12) << "around the wall";
    for (const auto& turn : {to_x, to_z, down, askew}) {
        const auto [turned_area, turned_length] = measured(turn);
        // Cells begin at the corner of the box around the turned level, so that borders differ by cells.
        EXPECT_NEAR(turned_area, area, 0.06 * area);
        EXPECT_NEAR(turned_length, length, 0.5);
    }
}

// Would catch places that are narrowed to float before the frame's origin is taken off.
TEST(NavigationBuild, AMillionMetresFromTheOriginTheMeshIsTheSame) {
    const auto at = [](const dvec3& shift) {
        World world;
        EXPECT_TRUE(world.add(yard().mesh(), {.pose = {.position = shift}}).has_value());
        return built(world);
    };
    const dvec3 far{1e6, -3e5, 1e6};
    const NavigationMesh near = at({0, 0, 0});
    const NavigationMesh away = at(far);
    auto shapes = shapes_of(away);
    auto expected = shapes_of(near);
    ASSERT_EQ(shapes.size(), expected.size());
    for (auto& shape : shapes)
        for (std::size_t i = 2; i < shape.size(); ++i) shape[i] -= far[static_cast<int>((i - 2) % 3)];
    std::sort(shapes.begin(), shapes.end());
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        ASSERT_EQ(shapes[i].size(), expected[i].size());
        for (std::size_t k = 0; k < shapes[i].size(); ++k) EXPECT_NEAR(shapes[i][k], expected[i][k], 1e-5);
    }
}

// Would catch tiles that do not look beyond their border, and a tile too few.
TEST(NavigationBuild, WhatIsBuiltAnewAfterABodyCameOrWentIsWhatIsBuiltAfresh) {
    World world = yard().world();
    NavigationMesh mesh = built(world);
    const auto before = shapes_of(mesh);
    // Beside the border of a tile, at 12.8: the next one has to keep its distance, too.
    const Bounds box{{12.0, 0, 5}, {12.75, 2, 9}};
    const auto handle = world.add(Scene().block(box.min, box.max).mesh());
    ASSERT_TRUE(handle.has_value());
    const auto tiles = mesh.rebuild(world, {}, quick(), box);
    ASSERT_TRUE(tiles.has_value()) << tiles.error().text;
    EXPECT_GE(*tiles, 2U);
    EXPECT_LT(*tiles, 9U) << "not all of them";
    EXPECT_NE(shapes_of(mesh), before);
    EXPECT_EQ(shapes_of(mesh), shapes_of(built(world)));
    ASSERT_TRUE(world.remove(*handle));
    ASSERT_TRUE(mesh.rebuild(world, {}, quick(), box).has_value());
    EXPECT_EQ(shapes_of(mesh), before);
}

TEST(NavigationBuild, ABodyThatMovesIsNoGroundAndInNobodysWay) {
    World world = Scene().floor(0, 12, 0, 6).world();
    const NavigationMesh alone = built(world);
    const auto handle = world.add(Scene().block({-1, 0, -3}, {1, 1, 3}).mesh(), {.pose = {.position = {6, 0, 3}}});
    ASSERT_TRUE(handle.has_value());
    EXPECT_FALSE(leads(built(world), {2, 0, 3}, {10, 0, 3})) << "it stands";
    ASSERT_TRUE(world.move(*handle, {.position = {6, 0, 3}}, {.position = {6, 0.1, 3}}));
    EXPECT_EQ(shapes_of(built(world)), shapes_of(alone));
}

TEST(NavigationBuild, WhatCannotBeBuiltIsSaidInWords) {
    const World world = Scene().floor(0, 10, 0, 10).world();
    const auto error = [&](const NavigationOptions& options, const World& of, const CharacterSettings& settings = {}) {
        const auto mesh = NavigationMesh::build(of, settings, options);
        EXPECT_FALSE(mesh.has_value());
        return mesh ? Error{} : mesh.error();
    };
    const auto says = [](const Error& found, ErrorCode code, const char* words) {
        EXPECT_EQ(found.code, code) << found.text;
        EXPECT_NE(found.text.find(words), std::string::npos) << found.text;
    };
    NavigationOptions options = quick();
    options.cell_size = options.cell_height = 0.001;
    options.tile_cells = 1024;
    says(error(options, world), ErrorCode::invalid, "256 cells wide");
    options = quick();
    options.cell_height = 1;
    says(error(options, world), ErrorCode::invalid, "smaller `cell_height`");
    options = quick();
    options.tile_cells = 8;
    says(error(options, world), ErrorCode::invalid, "16 to 1024");
    options = quick();
    options.up = {0, 0, 0};
    says(error(options, world), ErrorCode::invalid, "`up`");
    says(error(quick(), World{}), ErrorCode::invalid, "nothing in the world");
    CharacterSettings broken;
    broken.slope_limit_deg = 95;
    says(error(quick(), world, broken), ErrorCode::invalid, "settings");
    says(error(quick(), Scene().floor(0, 1000, 0, 1000).world()), ErrorCode::limit, "16384 tiles");
    const std::vector<NavigationArea> areas(61);
    options = quick();
    options.areas = areas;
    says(error(options, world), ErrorCode::limit, "room for 60 areas");
    const std::array<NavigationArea, 1> cheap{NavigationArea{.name = "air", .cost = 0.5}};
    options.areas = cheap;
    says(error(options, world), ErrorCode::invalid, "1 is the least");
    options = quick();
    options.cell_height = 0.01;
    says(error(options, Scene().floor(0, 10, 0, 10).floor(0, 10, 0, 10, 200).world()), ErrorCode::limit, "8191 cells");
}

TEST(NavigationBuild, TheProgressCountsAllTilesOnce) {
    for (const int threads : {1, 2}) {
        std::vector<std::size_t> told;
        std::size_t all = 0;
        const auto tell = [&](std::size_t done, std::size_t of) {
            told.push_back(done);
            all = of;
        };
        NavigationOptions options = quick();
        options.threads = threads;
        options.progress = NavigationProgress(tell);
        const NavigationMesh mesh = built(yard().world(), options);
        ASSERT_EQ(told.size(), all);
        for (std::size_t i = 0; i < told.size(); ++i) EXPECT_EQ(told[i], i + 1);
    }
}

// Broken variant: cells alone decide, and each of them is but a step higher than the one before.
TEST(NavigationBuild, NarrowTreadsAndShortSteepBanksAreNoWayUp) {
    Scene narrow;
    narrow.floor(-6, 0, -3, 3);
    for (int i = 0; i < 4; ++i) narrow.block({i * 0.1, -1, -3}, {6, 0.25 * (i + 1), 3});
    const NavigationMesh stairs = built(narrow.world(), {});
    EXPECT_FALSE(leads(stairs, {-3, 0, 0}, {3, 1, 0})) << "treads of ten centimetres";
    Scene wide;
    wide.floor(-6, 0, -3, 3);
    for (int i = 0; i < 4; ++i) wide.block({i * 0.25, -1, -3}, {6, 0.25 * (i + 1), 3});
    EXPECT_TRUE(leads(built(wide.world(), {}), {-3, 0, 0}, {3, 1, 0})) << "treads of twenty-five centimetres";
    // 74 degrees, and no longer than two cells.
    Scene bank;
    bank.floor(-6, 0, -3, 3).floor(0.25, 6, -3, 3, 0.875);
    bank.quad({0, 0, -3}, {0, 0, 3}, {0.25, 0.875, 3}, {0.25, 0.875, -3});
    EXPECT_FALSE(leads(built(bank.world(), {}), {-3, 0, 0}, {3, 0.875, 0}));
}

}  // namespace
}  // namespace surefoot::tests
