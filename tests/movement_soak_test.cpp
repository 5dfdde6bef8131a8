// Random input for a long time in a closed level: whatever is asked for, nobody gets into a wall or out of the level.
#include "movement_scene.hpp"
#include "splitmix.hpp"

namespace surefoot::tests {
namespace {

// A hall with everything in it that bodies get stuck on.
World hall() {
    Scene scene;
    scene.block({-12, -1, -12}, {12, 6, 12});  // seen from within
    scene.floor(-12, 12, -12, 12, 0.0, 23);
    scene.stairs(6, 5, 0.3, 0.35, 2);
    scene.ramp(-9, 4, 35, 1.5).ramp(-9, 3, 65, 0.4);
    scene.block({-3, 0, -8}, {-1, 1.9, -5}).block({-3, 2.4, -8}, {4, 2.6, -5});
    scene.block({1, 0, 4}, {1.02, 3, 9}).block({2.0, 0, 4}, {2.2, 3, 9});  // a thin wall, and a crevice of 0.98 m
    for (int i = 0; i < 12; ++i) {  // a dome's lower part, as a funnel upside down and needles around it
        const double a = i * 0.5235987755982988, b = a + 0.5235987755982988;
        const dvec3 low_a{-6 + 2 * std::cos(a), 0, 6 + 2 * std::sin(a)},
            low_b{-6 + 2 * std::cos(b), 0, 6 + 2 * std::sin(b)};
        const dvec3 high_a{-6 + 3 * std::cos(a), 2, 6 + 3 * std::sin(a)},
            high_b{-6 + 3 * std::cos(b), 2, 6 + 3 * std::sin(b)};
        if (i != 3) scene.quad(low_a, high_a, high_b, low_b);
    }
    return scene.world();
}

TEST(MovementSoak, NobodyGetsIntoAWallOrOutOfTheHall) {
    const World world = hall();
    const Shape shapes[] = {Ellipsoid{}, Sphere{},
                            Capsule{},   Box{.half_extents = {0.35, 0.8, 0.35}},
                            Cylinder{},  Cone{.radius = 0.4, .height = 1.8}};
    std::uint64_t seed = 1;
    for (const Shape& shape : shapes) {
        for (const double rate : {20.0, 60.0, 240.0}) {
            Actor actor;
            actor.settings.volume = shape;
            actor.dt = 1 / rate;
            actor.state.position = {0, 2, 0};
            SplitMix random(seed++);
            CharacterInput input;
            int walked = 0;
            for (int tick = 0; tick < static_cast<int>(rate) * 40; ++tick) {
                if (random.in(0, 1) < 3 / rate) {
                    input.wish = random.point(9);
                    input.jump = random.in(0, 1) < 0.4;
                }
                const CharacterEvents events = actor.tick(world, input);
                const dvec3& p = actor.state.position;
                const auto where = [&] {
                    return ::testing::Message() << "shape " << shape.index() << " at " << rate << " Hz, tick " << tick
                                                << ", (" << p.x << ", " << p.y << ", " << p.z << ")";
                };
                ASSERT_FALSE(events.has(CharacterEvent::stuck)) << where();
                ASSERT_FALSE(events.has(CharacterEvent::overflow)) << where();
                ASSERT_TRUE(fits(world, actor.settings, p)) << where();
                ASSERT_TRUE(std::abs(p.x) < 12 && std::abs(p.z) < 12 && p.y > -1 && p.y < 6) << where();
                if (actor.on_ground()) ++walked;
            }
            EXPECT_GT(walked, rate * 5) << shape.index() << " " << rate;
        }
    }
}

}  // namespace
}  // namespace surefoot::tests
