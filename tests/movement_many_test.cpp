// Where more triangles are near than a step has room for, it walks as anywhere else; and where there are more than it
// looks at, it stays and says so.
#include <gtest/gtest.h>

#include "character/surroundings.hpp"
#include "movement_scene.hpp"
#include "splitmix.hpp"

namespace surefoot::tests {
namespace {

constexpr double skin = CharacterSettings{}.skin;

// Splinters of a millimetre that no walker along x touches, though they are in the box around it: beside its head.
void add_splinters(Scene& scene, SplitMix& random, int count, double from_x, double to_x) {
    const auto near = [&](const dvec3& at) { return at + 0.001 * random.point(1); };
    for (int i = 0; i < count; ++i) {
        const dvec3 at{random.in(from_x, to_x), random.in(1.7, 1.78), random.in(0.36, 0.38)};
        scene.triangle(near(at), near(at), near(at));
    }
}

std::size_t near_body(const World& world, const dvec3& at) {
    const dvec3 half = dvec3{0.4, 0.9, 0.4} + 3 * skin;
    return world.gather({at - half, at + half}, {});
}

TEST(MovementMany, FiveThousandTrianglesAroundAWalkerAreWalkedOnAsTwoAre) {
    Scene fine;
    fine.floor(-1, 1, -1, 1, 0, 66).quad({0.9, 0, -1}, {0.9, 0, 1}, {0.9, 3, 1}, {0.9, 3, -1});
    const World many = fine.world();
    const World two = Scene().floor(-1, 1, -1, 1).quad({0.9, 0, -1}, {0.9, 0, 1}, {0.9, 3, 1}, {0.9, 3, -1}).world();
    ASSERT_GT(near_body(many, {0, 0.91, 0}), 1500U);
    const Shape shapes[] = {Ellipsoid{}, Sphere{},
                            Capsule{},   Box{.half_extents = {0.4, 0.9, 0.4}},
                            Cylinder{},  Cone{.radius = 0.4, .height = 1.8}};
    for (const Shape& shape : shapes) {
        Actor on_many;
        on_many.settings.volume = shape;
        on_many.state.position = {-0.4, 1.9, 0.01};
        Actor on_two = on_many;
        for (int i = 0; i < 45; ++i) {
            const CharacterInput input{.wish = i < 20 ? dvec3{} : dvec3{3, 0, 0.3}};
            on_many.tick(many, input);
            on_two.tick(two, input);
            const dvec3 apart = on_many.state.position - on_two.state.position;
            ASSERT_LT(std::abs(apart.x) + std::abs(apart.y) + std::abs(apart.z), 1e-6) << shape.index() << " " << i;
        }
        EXPECT_TRUE(on_many.on_ground()) << shape.index();
        EXPECT_TRUE(on_many.did(CharacterEvent::blocked)) << shape.index();
        EXPECT_FALSE(on_many.did(CharacterEvent::overflow)) << shape.index();
        EXPECT_TRUE(fits(many, on_many.settings, on_many.state.position)) << shape.index();
    }
}

// A course with a step, a slope and a wall, with or without splinters beside it.
World course(int splinters) {
    Scene scene;
    scene.floor(-3, 3, -2, 2, 0, 4)
        .block({0.5, -1, -1}, {1.2, 0.2, 1})
        .ramp(1.5, 1, 25)
        .block({-2.6, 0, -1}, {-2.5, 2, 1});
    SplitMix random(11);
    add_splinters(scene, random, splinters, -3, 3);
    return scene.world();
}

TEST(MovementMany, AStepAmongThousandsIsTheSameBitForBit) {
    const World few = course(0);
    const World many = course(12000);
    ASSERT_GT(near_body(many, {0, 0.91, 0}), internal::Surroundings::most);
    ASSERT_LT(near_body(many, {0, 0.91, 0}), internal::Surroundings::most_in_reach);
    for (const double towards : {3.0, -3.0}) {
        Actor among_few;
        among_few.settings.step_up = 0.3;
        among_few.state.position = {-0.5, 1.0, -0.05};
        Actor among_many = among_few;
        for (int i = 0; i < 60; ++i) {
            const CharacterInput input{.wish = {towards, 0, 0}};
            // The step lifts it, and its head, above the splinters.
            const CharacterEvents events = among_few.tick(few, input);
            EXPECT_EQ(events.set, among_many.tick(many, input).set) << towards << " " << i;
            ASSERT_EQ(among_few.state, among_many.state) << towards << " " << i;
            if (among_few.state.position.y > 1.0) break;
        }
    }
}

TEST(MovementMany, AFanOfAThousandAboutOneCornerIsStoodOn) {
    Scene scene;
    constexpr int sides = 1200;
    for (int i = 0; i < sides; ++i) {
        const double one = 6.283185307179586 * i / sides, next = 6.283185307179586 * (i + 1) / sides;
        scene.triangle({0, 0, 0}, {3 * std::sin(one), 0, 3 * std::cos(one)},
                       {3 * std::sin(next), 0, 3 * std::cos(next)});
    }
    const World world = scene.world();
    Actor actor;
    actor.state.position = {0.05, 1.1, 0};
    actor.run(world, 0.3);
    EXPECT_TRUE(actor.on_ground());
    actor.run(world, 0.3, {.wish = {3, 0, 0}});
    EXPECT_TRUE(actor.on_ground());
    EXPECT_GT(actor.state.position.x, 0.7);
    EXPECT_FALSE(actor.did(CharacterEvent::overflow));
}

TEST(MovementMany, WhereMoreAreNearThanAStepLooksAtItStaysAndSaysSo) {
    Scene scene;
    scene.floor(-3, 3, -3, 3);
    SplitMix random(3);
    add_splinters(scene, random, 40000, 0.8, 1.2);
    const World world = scene.world();
    ASSERT_GT(near_body(world, {1, 0.91, 0}), internal::Surroundings::most_in_reach);
    Actor actor;
    actor.state.position = {1, 0.9108, 0};
    const dvec3 before = actor.state.position;
    for (int i = 0; i < 10; ++i) {
        EXPECT_TRUE(actor.tick(world, {.wish = {3, 0, 0}, .jump = i == 5}).has(CharacterEvent::overflow)) << i;
        EXPECT_EQ(actor.state.position, before) << i;
        EXPECT_EQ(actor.state.velocity, dvec3(0, 0, 0)) << i;
    }
    EXPECT_FALSE(actor.did(CharacterEvent::stuck));
    EXPECT_FALSE(actor.did(CharacterEvent::invalid));
}

}  // namespace
}  // namespace surefoot::tests
