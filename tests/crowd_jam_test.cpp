// Characters with no room between them.
#include <algorithm>

#include "crowd_scene.hpp"

namespace surefoot::tests {
namespace {

TEST(CrowdJam, NobodyIsPushedThroughAWall) {
    Scene scene;
    scene.floor(-12, 12, -12, 12);
    const dvec3 low{-4, 0, -4}, high{4, 3, 4};
    scene.quad({low.x, 0, low.z}, {low.x, 3, low.z}, {high.x, 3, low.z}, {high.x, 0, low.z});
    scene.quad({low.x, 0, high.z}, {low.x, 3, high.z}, {high.x, 3, high.z}, {high.x, 0, high.z});
    scene.quad({low.x, 0, low.z}, {low.x, 3, low.z}, {low.x, 3, high.z}, {low.x, 0, high.z});
    scene.quad({high.x, 0, low.z}, {high.x, 3, low.z}, {high.x, 3, high.z}, {high.x, 0, high.z});
    const World world = scene.world();
    Many many;
    SplitMix random(8);
    // All of them want into one corner, and there is not nearly room for what they overlap by at the start.
    for (int i = 0; i < 60; ++i) many.add({random.in(-3.5, 3.5), 0.95, random.in(-3.5, 3.5)}, {5, 0, 5});
    for (int tick = 0; tick < 200; ++tick) {
        many.tick(world);
        for (const CharacterState& state : many.states) {
            ASSERT_LT(std::abs(state.position.x), high.x - 0.35) << tick;
            ASSERT_LT(std::abs(state.position.z), high.z - 0.35) << tick;
            ASSERT_GT(state.position.y, 0.8) << tick;
        }
    }
}

// What docs/movement.md says of two hard ones, for every pair in a yard full of them. The planes of a slide are not
// quite square to the shortest way out, which is what is measured: a hundredth of the skin.
TEST(CrowdJam, NoPairGetsDeeperThanItWasOrThanTheShorterOfItsWays) {
    Scene scene;
    scene.floor(-20, 20, -20, 20, 0, 8);
    const World world = scene.world();
    Many many;
    SplitMix random(9);
    for (int i = 0; i < 60; ++i) many.add({random.in(-3, 3), 0.95, random.in(-3, 3)});
    for (int tick = 0; tick < 200; ++tick) {
        if (tick % 20 == 0) {
            for (CharacterInput& input : many.inputs) input.wish = {random.in(-6, 6), 0, random.in(-6, 6)};
        }
        const std::vector<CharacterState> before = many.states;
        std::vector<double> depths;
        for (std::size_t a = 0; a < before.size(); ++a) {
            for (std::size_t b = 0; b < a; ++b) depths.push_back(many.overlap(a, b));
        }
        many.tick(world);
        std::size_t pair = 0;
        const auto way = [&](std::size_t i) { return glm::length(many.states[i].position - before[i].position); };
        for (std::size_t a = 0; a < before.size(); ++a) {
            for (std::size_t b = 0; b < a; ++b) {
                const double most = std::max(depths[pair++], std::min(way(a), way(b)));
                ASSERT_LE(many.overlap(a, b), most + 0.01 * many.settings[a].skin) << tick << ": " << a << " and " << b;
            }
        }
    }
}

// Two crowds that want through one door, each to where the other comes from. Returns how many got through.
int push_through_a_door(bool keep_right) {
    const double half = keep_right ? 2.4 : 1;  // of the door's width
    Scene scene;
    scene.floor(-20, 20, -20, 20, 0, 6).block({-0.3, 0, -20}, {0.3, 3, -half}).block({-0.3, 0, half}, {0.3, 3, 20});
    const World world = scene.world();
    Many many;
    for (int i = 0; i < 30; ++i) {
        const double x = 1.5 + 0.95 * (i % 5), z = 0.95 * (i / 5 - 3) + 0.03 * (i % 5);
        many.add({x, 0.95, keep_right ? z - 2 : z});
        many.add({-x, 0.95, keep_right ? z + 2.5 : z + 0.1});
    }
    many.run(world, 0.2);
    EXPECT_EQ(many.deepest_overlap(), 0);
    const double speed = 4;
    double deepest = 0;
    int meetings = 0;
    for (int tick = 0; tick < 500; ++tick) {
        for (std::size_t i = 0; i < many.states.size(); ++i) {
            const double side = i % 2 == 0 ? -1 : 1;
            const dvec3 at = many.states[i].position;
            const double lane = keep_right ? 1.2 * side : 0;
            const bool is_through = at.x * side > 0.5;
            const dvec3 goal = is_through ? dvec3(side * 19, at.y, at.z) : dvec3(side * 0.6, at.y, lane);
            many.inputs[i].wish = glm::normalize(goal - at) * speed;
        }
        many.tick(world);
        deepest = std::max(deepest, many.deepest_overlap());
        for (const CharacterEvents& events : many.events) meetings += events.has(CharacterEvent::met_neighbour) ? 1 : 0;
    }
    EXPECT_GT(meetings, 100);
    EXPECT_LE(deepest, 2 * speed * many.dt);
    int through = 0;
    for (std::size_t i = 0; i < many.states.size(); ++i) {
        through += many.states[i].position.x * (i % 2 == 0 ? -1 : 1) > 0 ? 1 : 0;
    }
    std::printf("deepest %.4f m of %.4f allowed; %d of %zu through\n", deepest, 2 * speed * many.dt, through,
                many.states.size());
    return through;
}

TEST(CrowdJam, TwoCrowdsPushingThroughADoorNeverOverlapMoreThanTheBound) {
    (void)push_through_a_door(false);
    EXPECT_GT(push_through_a_door(true), 45) << "who keeps to the right gets through";
}

}  // namespace
}  // namespace surefoot::tests
