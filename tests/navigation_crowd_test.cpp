// Many are sent at once and have to get there without running into each other.
#include <numbers>

#include <surefoot/navigation_crowd.hpp>

#include "movement_scene.hpp"
#include "navigation_things.hpp"

namespace surefoot::tests {
namespace {

using Status = NavigationFollowStatus;

struct Many {
    const World& world;
    const NavigationMesh& mesh;
    std::size_t count;
    NavigationCrowdOptions options{};
    CharacterSettings settings{};
    NavigationCrowdWorker worker{mesh};
    NavigationCrowd crowd{mesh, count, options};
    Crowd feet{};
    std::vector<CharacterState> states = std::vector<CharacterState>(count);
    std::vector<CharacterInput> inputs = std::vector<CharacterInput>(count);
    double dt = 1.0 / 60;
    double nearest = 1e30;  ///< that two ever were, seen from above [m]
    double lowest = 1e30;   ///< feet [m]

    void put(std::size_t index, const dvec3& place, const dvec3& goal) {
        states[index] = {};
        states[index].position = place + dvec3{0, mesh.agent().feet + settings.skin, 0};
        crowd.go(worker.query(), index, goal);
    }
    void tick() {
        ASSERT_TRUE(crowd.gather(states));
        crowd.steer(worker, settings, dt, inputs);
        const Characters all{.settings = {&settings, 1}, .inputs = inputs, .before = states, .after = states};
        ASSERT_TRUE(feet.gather(all, dt));
        step_all(world, feet, all, dt);
        for (std::size_t i = 0; i < count; ++i) {
            lowest = std::min(lowest, states[i].position.y - mesh.agent().feet);
            for (std::size_t k = 0; k < i; ++k)
                nearest = std::min(nearest, std::hypot(states[i].position.x - states[k].position.x,
                                                       states[i].position.z - states[k].position.z));
        }
    }
    [[nodiscard]] std::size_t arrived() const {
        std::size_t found = 0;
        for (std::size_t i = 0; i < count; ++i) found += crowd.follower(i).status() == Status::arrived ? 1 : 0;
        return found;
    }
    /// How long it took until all had arrived [s]; or the whole time.
    double run(double most_seconds) {
        double time = 0;
        for (; time < most_seconds && arrived() < count; time += dt) tick();
        return time;
    }
};

Scene open_floor(double half = 15) {
    Scene scene;
    return scene.floor(-half, half, -half, half);
}

// Broken variant: avoidance off, as below.
TEST(NavigationCrowd, TwoWhoMeetPassWithoutTouching) {
    const World world = open_floor().world();
    const NavigationMesh mesh = built(world);
    const auto meet = [&](NavigationAvoidance avoidance) {
        Many two{.world = world, .mesh = mesh, .count = 2, .options = {.avoidance = avoidance}};
        two.put(0, {-10, 0, 0}, {10, 0, 0});
        two.put(1, {10, 0, 0}, {-10, 0, 0});
        const double time = two.run(20);
        return std::pair{time, two.nearest};
    };
    for (const auto avoidance : {NavigationAvoidance::few, NavigationAvoidance::medium, NavigationAvoidance::many}) {
        const auto [time, nearest] = meet(avoidance);
        EXPECT_LT(time, 20.0 / 6 + 1.5);
        EXPECT_GT(nearest, 0.8) << "they touched";
    }
    EXPECT_LT(meet(NavigationAvoidance::none).second, 0.83) << "without avoidance they run into each other";
}

TEST(NavigationCrowd, ACircleOfManyChangesSides) {
    const World world = open_floor().world();
    const NavigationMesh mesh = built(world);
    constexpr std::size_t count = 24;
    Many many{.world = world, .mesh = mesh, .count = count};
    for (std::size_t i = 0; i < count; ++i) {
        const double angle = 2 * std::numbers::pi * static_cast<double>(i) / count;
        const dvec3 place{10 * std::cos(angle), 0, 10 * std::sin(angle)};
        many.put(i, place, -place);
    }
    EXPECT_LT(many.run(30), 15);
    EXPECT_EQ(many.arrived(), count);
}

// Broken variant: only who stands on the goal itself has arrived.
TEST(NavigationCrowd, ManyArriveAtOneGoal) {
    const World world = open_floor().world();
    const NavigationMesh mesh = built(world);
    constexpr std::size_t count = 30;
    Many many{.world = world, .mesh = mesh, .count = count};
    for (std::size_t i = 0; i < count; ++i)
        many.put(i, {-12 + 1.2 * static_cast<double>(i % 6), 0, -12 + 1.2 * static_cast<double>(i / 6)}, {5, 0, 5});
    EXPECT_LT(many.run(30), 15);
    EXPECT_EQ(many.arrived(), count);
    for (const CharacterState& state : many.states)
        EXPECT_LT(std::hypot(state.position.x - 5, state.position.z - 5), 1 + 1.25 * std::sqrt(30.0));
}

TEST(NavigationCrowd, ManyGetThroughADoor) {
    Scene scene = open_floor();
    scene.block({-0.25, 0, -15}, {0.25, 3, -1}).block({-0.25, 0, 1}, {0.25, 3, 15});
    const World world = scene.world();
    const NavigationMesh mesh = built(world);
    constexpr std::size_t count = 20;
    Many many{.world = world, .mesh = mesh, .count = count};
    for (std::size_t i = 0; i < count; ++i) {
        const dvec3 place{-10 + 1.2 * static_cast<double>(i % 5), 0, -6 + 3 * static_cast<double>(i / 5)};
        many.put(i, place, place + dvec3{14, 0, 0});
    }
    EXPECT_LT(many.run(60), 30);
    EXPECT_EQ(many.arrived(), count);
}

// Broken variant: what avoidance bends is not kept on the mesh.
TEST(NavigationCrowd, NobodyIsPushedOffABridge) {
    Scene scene;
    scene.floor(-20, -10, -8, 8).floor(10, 20, -8, 8).floor(-10, 10, -2, 2);
    const World world = scene.world();
    const NavigationMesh mesh = built(world);
    constexpr std::size_t count = 16;
    Many many{.world = world, .mesh = mesh, .count = count};
    for (std::size_t i = 0; i < count; ++i) {
        const double side = i % 2 == 0 ? 1 : -1;
        const dvec3 place{side * 17, 0, -5 + 1.3 * static_cast<double>(i / 2)};
        many.put(i, place, {-place.x, 0, place.z});
    }
    EXPECT_LT(many.run(60), 40);
    EXPECT_EQ(many.arrived(), count);
    EXPECT_GT(many.lowest, -0.1) << "somebody fell";
}

TEST(NavigationCrowd, EverybodyTakesTheLink) {
    Scene scene;
    scene.block({-12, 0, -5}, {0, 2, 5}).floor(0, 12, -5, 5);
    const World world = scene.world();
    NavigationMesh mesh = built(world);
    const NavigationLink drop{.from = {-1, 2, 0}, .to = {1.5, 0, 0}, .takeoff = {-0.45, 2, 0}, .inputs = {}};
    ASSERT_TRUE(mesh.set_links({&drop, 1}).has_value());
    constexpr std::size_t count = 8;
    Many many{.world = world, .mesh = mesh, .count = count};
    for (std::size_t i = 0; i < count; ++i)
        many.put(i, {-10 + 1.5 * static_cast<double>(i / 4), 2, -3 + 2.0 * static_cast<double>(i % 4)},
                 {9, 0, -4 + 1.1 * static_cast<double>(i)});
    EXPECT_LT(many.run(60), 30);
    EXPECT_EQ(many.arrived(), count);
}

// Broken variant: reading what others were told in this very tick.
TEST(NavigationCrowd, IsTheSameHoweverTheWorkIsCut) {
    const World world = open_floor().world();
    const NavigationMesh mesh = built(world);
    constexpr std::size_t count = 40;
    const auto filled = [&] {
        Many many{.world = world, .mesh = mesh, .count = count};
        for (std::size_t i = 0; i < count; ++i) {
            const dvec3 place{-9 + 2 * static_cast<double>(i % 8), 0, -9 + 2 * static_cast<double>(i / 8)};
            many.put(i, place, {-place.z, 0, place.x});
        }
        return many;
    };
    Many whole = filled();
    Many cut = filled();
    NavigationCrowdWorker other(mesh);
    for (int tick = 0; tick < 120; ++tick) {
        whole.tick();
        ASSERT_TRUE(cut.crowd.gather(cut.states));
        cut.crowd.steer(cut.worker, cut.settings, cut.dt, cut.inputs, {.begin = 17, .end = count});
        cut.crowd.steer(other, cut.settings, cut.dt, cut.inputs, {.begin = 0, .end = 17});
        const Characters all{
            .settings = {&cut.settings, 1}, .inputs = cut.inputs, .before = cut.states, .after = cut.states};
        ASSERT_TRUE(cut.feet.gather(all, cut.dt));
        step_all(world, cut.feet, all, cut.dt);
        ASSERT_EQ(whole.states, cut.states) << "tick " << tick;
    }
}

TEST(NavigationCrowd, TakesNoWrongNumberOfStates) {
    const World world = open_floor().world();
    const NavigationMesh mesh = built(world);
    Many many{.world = world, .mesh = mesh, .count = 3};
    EXPECT_FALSE(many.crowd.gather(std::span(many.states).first(2)));
    many.crowd.resize(2);
    EXPECT_TRUE(many.crowd.gather(std::span(many.states).first(2)));
    EXPECT_EQ(many.crowd.size(), 2U);
}

}  // namespace
}  // namespace surefoot::tests
