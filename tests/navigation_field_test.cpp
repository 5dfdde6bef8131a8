// One goal, a potential over the mesh, and many who descend it.
#include <cmath>

#include <surefoot/navigation_field.hpp>

#include "movement_scene.hpp"
#include "navigation_things.hpp"

namespace surefoot::tests {
namespace {

using Status = NavigationFollowStatus;
using Reason = NavigationFollowReason;

/// A floor with a U of walls that is open to -x, and whose bottom lies between the places at -x and the goal.
Scene u_shape() {
    Scene scene;
    scene.floor(-15, 15, -15, 15).block({2, 0, -6}, {2.5, 3, 6});
    return scene.block({-6, 0, -6}, {2, 3, -5.5}).block({-6, 0, 5.5}, {2, 3, 6});
}

const dvec3 u_goal{10, 0, 0.5};

NavigationField field_of(const NavigationQuery& query, const dvec3& goal, NavigationPotential potential) {
    const auto place = query.nearest(goal, 1, 1);
    EXPECT_TRUE(place);
    auto field = NavigationField::make(query, *place, {.potential = potential});
    EXPECT_TRUE(field);
    return std::move(*field);
}

// Broken variant: only the middles of portals, which are up to a fifth too long.
TEST(NavigationField, IsAsFarAsTheShortestPath) {
    const World world = u_shape().world();
    const NavigationMesh mesh = built(world);
    const NavigationQuery query(mesh);
    const NavigationField field = field_of(query, u_goal, NavigationPotential::walked);
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        const auto place = query.random(seed);
        ASSERT_TRUE(place);
        const auto path = query.path(*place, field.goal());
        ASSERT_TRUE(path);
        if (path->partial) {
            EXPECT_TRUE(std::isinf(field.at(*place)));
            continue;
        }
        EXPECT_GE(field.at(*place), glm::distance(place->position, field.goal().position) - 1e-3);
        EXPECT_LT(field.at(*place), 1.05 * path->length + 0.1);
        const NavigationDescent way = field.descend(query, *place);
        EXPECT_TRUE(way.arrived);
        EXPECT_TRUE(way.minima.empty());
        EXPECT_NEAR(way.line.length(), field.at(*place), 1e-3 + 1e-3 * way.line.length());
    }
    EXPECT_TRUE(field.minima(query).empty());
}

// Broken variant: without an escape, as below.
TEST(NavigationField, HillClimbingEndsInAUOfWallsAndEveryEscapeLeadsOut) {
    const World world = u_shape().world();
    const NavigationMesh mesh = built(world);
    const NavigationQuery query(mesh);
    const NavigationField field = field_of(query, u_goal, NavigationPotential::straight);

    const auto minima = field.minima(query);
    const auto in_u = std::count_if(minima.begin(), minima.end(), [](const NavigationMinimum& minimum) {
        return std::abs(minimum.place.position.x - 1.5) < 0.3 && std::abs(minimum.place.position.z) < 5;
    });
    EXPECT_GE(in_u, 1) << "the minimum is not shown";

    const auto from = query.nearest({-3, 0, 1}, 1, 1);
    ASSERT_TRUE(from);
    const NavigationDescent stays = field.descend(query, *from, {.escape = NavigationEscape::none});
    EXPECT_FALSE(stays.arrived);
    ASSERT_EQ(stays.minima.size(), 1U);
    EXPECT_NEAR(stays.minima[0].place.position.x, 1.6, 0.3);
    EXPECT_NEAR(stays.minima[0].value, field.at(stays.minima[0].place), 1e-9);

    const auto shortest = query.path(*from, field.goal());
    ASSERT_TRUE(shortest);
    for (const auto escape : {NavigationEscape::random, NavigationEscape::wall, NavigationEscape::virtual_goal}) {
        const NavigationDescent way = field.descend(query, *from, {.escape = escape});
        EXPECT_TRUE(way.arrived) << static_cast<int>(escape);
        EXPECT_GE(way.minima.size(), 1U) << "it never was in the minimum";
        EXPECT_GT(way.line.length(), shortest->length - 0.1);
        // Chance has to walk out of nine metres of dead end; the others know where to.
        if (escape != NavigationEscape::random) {
            EXPECT_LT(way.line.length(), 2.5 * shortest->length) << static_cast<int>(escape);
        }
        EXPECT_LT(glm::distance(way.line.points.back().position, field.goal().position), 1e-3);
        // Each piece lies on the mesh.
        for (std::size_t i = 0; i + 1 < way.line.points.size(); ++i) {
            const dvec3 middle = (way.line.points[i].position + way.line.points[i + 1].position) * 0.5;
            ASSERT_TRUE(query.nearest(middle, 0.05, 0.5)) << i;
        }
    }
}

// Broken variants: `straight` without an escape; a field that is computed for one start.
TEST(NavigationField, OneGoalServesManyByTheirOwnFeet) {
    const World world = u_shape().world();
    const NavigationMesh mesh = built(world);
    const NavigationQuery query(mesh);
    const NavigationField walked = field_of(query, u_goal, NavigationPotential::walked);
    const NavigationField straight = field_of(query, u_goal, NavigationPotential::straight);
    const auto send = [&](const NavigationField& field, NavigationEscape escape, std::size_t& fell_in) {
        std::size_t arrived = 0;
        for (int i = 0; i < 30; ++i) {
            Walker walker{.world = world, .query = query};
            walker.at({-12 + 2.3 * (i % 6), 0, -5.0 + 2.4 * (i / 6)});
            walker.follower.go(query, field, {.escape = escape, .seed = static_cast<std::uint64_t>(i)});
            if (walker.run(400) == Status::arrived) ++arrived;
            if (walker.follower.reason() == Reason::local_minimum) ++fell_in;
            EXPECT_LT(walker.farthest_off_mesh, 0.1);
        }
        return arrived;
    };
    std::size_t fell_in = 0;
    EXPECT_EQ(send(walked, NavigationEscape::none, fell_in), 30U);
    EXPECT_EQ(fell_in, 0U);
    EXPECT_EQ(send(straight, NavigationEscape::wall, fell_in), 30U);
    EXPECT_EQ(send(straight, NavigationEscape::virtual_goal, fell_in), 30U);
    EXPECT_EQ(send(straight, NavigationEscape::random, fell_in), 30U);
    EXPECT_EQ(fell_in, 0U);
    const std::size_t without = send(straight, NavigationEscape::none, fell_in);
    EXPECT_LT(without, 25U) << "the U holds nobody, so the escapes were not needed";
    EXPECT_EQ(without + fell_in, 30U);
}

// Broken variant: following a wall for a few steps only.
TEST(NavigationField, DeadEndsInDeadEndsAreLeft) {
    // A U in a U, and a wall that makes one way round a long one.
    Scene scene = u_shape();
    scene.block({-2, 0, -3}, {-1.5, 3, 3}).block({-5, 0, -3}, {-2, 3, -2.5}).block({-5, 0, 2.5}, {-2, 3, 3});
    scene.block({2, 0, 6}, {2.5, 3, 15});
    const World world = scene.world();
    const NavigationMesh mesh = built(world);
    const NavigationQuery query(mesh);
    const NavigationField field = field_of(query, u_goal, NavigationPotential::straight);
    const auto from = query.nearest({-3.5, 0, 0}, 1, 1);
    ASSERT_TRUE(from);
    for (const auto escape : {NavigationEscape::random, NavigationEscape::wall, NavigationEscape::virtual_goal}) {
        const NavigationDescent way = field.descend(query, *from, {.escape = escape});
        EXPECT_TRUE(way.arrived) << static_cast<int>(escape);
        EXPECT_GE(way.minima.size(), 2U) << static_cast<int>(escape);
    }
}

TEST(NavigationField, SaysThatThereIsNoWay) {
    Scene scene = u_shape();
    scene.floor(20, 30, -5, 5);
    const World world = scene.world();
    const NavigationMesh mesh = built(world);
    const NavigationQuery query(mesh);
    const auto from = query.nearest({-3, 0, 0}, 1, 1);
    ASSERT_TRUE(from);
    const NavigationField walked = field_of(query, {25, 0, 0}, NavigationPotential::walked);
    EXPECT_TRUE(std::isinf(walked.at(*from)));
    EXPECT_FALSE(walked.descend(query, *from).arrived);
    Walker walker{.world = world, .query = query};
    walker.at({-3, 0, 0}).follower.go(query, walked);
    EXPECT_EQ(walker.run(), Status::gave_up);
    EXPECT_EQ(walker.follower.reason(), Reason::no_path);
    const NavigationField straight = field_of(query, {25, 0, 0}, NavigationPotential::straight);
    for (const auto escape : {NavigationEscape::random, NavigationEscape::wall, NavigationEscape::virtual_goal})
        EXPECT_FALSE(straight.descend(query, *from, {.escape = escape, .most_escapes = 8}).arrived);
    EXPECT_FALSE(NavigationField::make(query, {.position = {0, 0, 0}, .polygon = {}}));
}

// Broken variant: links taken in both directions.
TEST(NavigationField, KnowsLinksAndTheirDirection) {
    Scene scene;
    scene.block({-10, 0, -5}, {0, 2, 5}).floor(0, 12, -5, 5);
    const World world = scene.world();
    NavigationMesh mesh = built(world);
    const NavigationLink drop{.from = {-1, 2, 0}, .to = {1.5, 0, 0}, .takeoff = {-0.45, 2, 0}, .inputs = {}};
    ASSERT_TRUE(mesh.set_links({&drop, 1}).has_value());
    const NavigationQuery query(mesh);
    const NavigationField down = field_of(query, {10, 0, -3}, NavigationPotential::walked);
    Walker walker{.world = world, .query = query};
    walker.at({-8, 2, 3}).follower.go(query, down);
    EXPECT_EQ(walker.run(), Status::arrived);
    EXPECT_EQ(walker.follower.links(), 1U);
    const NavigationField up = field_of(query, {-8, 2, 3}, NavigationPotential::walked);
    const auto below = query.nearest({10, 0, -3}, 1, 1);
    ASSERT_TRUE(below);
    EXPECT_TRUE(std::isinf(up.at(*below)));
}

// Broken variant: a metre is a metre whatever the ground.
TEST(NavigationField, CountsCostsOfAreas) {
    Scene scene;
    const World world = scene.floor(-10, 10, -10, 10).world();
    const std::array<NavigationArea, 2> areas{NavigationArea{}, NavigationArea{.name = "mud", .cost = 4}};
    const std::array<NavigationRegion, 1> regions{NavigationRegion{
        .name = "mud", .pose = {}, .half_extents = {1, 1, 5}, .kind = NavigationRegion::Kind::area, .area = 1}};
    const NavigationMesh mesh = built(world, {}, {.areas = areas, .regions = regions});
    const NavigationQuery query(mesh);
    const NavigationField field = field_of(query, {5, 0, 0}, NavigationPotential::walked);
    const auto from = query.nearest({-5, 0, 0}, 1, 1);
    ASSERT_TRUE(from);
    EXPECT_GT(field.at(*from), 13) << "straight through the mud is 8 + 2 * 4, round it 13.6 or so";
    EXPECT_LT(field.at(*from), 16.3);
}

TEST(NavigationField, WorksInAnyUp) {
    const dquat turn = glm::normalize(dquat(0.5, 0.7, -0.3, 0.4));
    World world;
    ASSERT_TRUE(world.add(u_shape().mesh(), {.pose = {.position = {100, -50, 30}, .orientation = turn}}));
    const NavigationMesh mesh = built(world, {}, {.up = turn * dvec3{0, 1, 0}});
    const NavigationQuery query(mesh);
    const auto placed = [&](const dvec3& place) { return dvec3{100, -50, 30} + turn * place; };
    for (const auto potential : {NavigationPotential::walked, NavigationPotential::straight}) {
        const auto goal = query.nearest(placed(u_goal), 1, 1);
        ASSERT_TRUE(goal);
        const auto field = NavigationField::make(query, *goal, {.potential = potential});
        ASSERT_TRUE(field);
        Walker walker{.world = world, .query = query};
        walker.at(placed({-3, 0, 1})).follower.go(query, *field, {.escape = NavigationEscape::wall});
        EXPECT_EQ(walker.run(), Status::arrived);
    }
}

}  // namespace
}  // namespace surefoot::tests
