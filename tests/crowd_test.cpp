// Characters among characters.
#include <algorithm>
#include <array>
#include <numeric>

#include "crowd_scene.hpp"

namespace surefoot::tests {
namespace {

World yard(double half_width = 20) {
    Scene scene;
    scene.floor(-half_width, half_width, -half_width, half_width, 0, 8);
    return scene.world();
}

TEST(Crowd, StepAllIsTheVeryStepOfEachHoweverItIsSplit) {
    const World world = yard();
    Many many = jostling(60, 8, 1);
    std::vector<CharacterState> expected;
    for (std::size_t i = 0; i < many.states.size(); ++i) {
        expected.push_back(step(world, many.settings[i], many.inputs[i], many.dt, many.states[i]).state);
    }
    for (const std::size_t parts : {std::size_t{1}, std::size_t{2}, std::size_t{7}}) {
        std::vector<CharacterState> after(many.states.size());
        const Characters characters = many.all(after);
        for (std::size_t k = 0; k < parts; ++k) step_all(world, characters, many.dt, many.part(k, parts));
        EXPECT_EQ(after, expected) << parts;
    }
}

TEST(Crowd, StepAllTakesOneSettingAndOneInputForAllAndAnswersInPlace) {
    const World world = yard();
    std::vector<CharacterState> states(9);
    for (std::size_t i = 0; i < states.size(); ++i) states[i].position = {static_cast<double>(i), 1, 0};
    const CharacterSettings settings;
    const CharacterInput input{.wish = {0, 0, 3}};
    std::vector<CharacterState> expected;
    for (const CharacterState& state : states) {
        expected.push_back(step(world, settings, input, 0.02, state).state);
    }
    step_all(world, {.settings = {&settings, 1}, .inputs = {&input, 1}, .before = states, .after = states}, 0.02);
    EXPECT_EQ(states, expected);
}

TEST(Crowd, SplitsAndThreadsChangeNoBit) {
    const World world = yard();
    Many alone = jostling(100, 5, 2);
    Many by_two = jostling(100, 5, 2);
    Many by_seven = jostling(100, 5, 2);
    for (int tick = 0; tick < 40; ++tick) {
        alone.tick(world, 1);
        by_two.tick(world, 2);
        by_seven.tick(world, 7);
        ASSERT_EQ(alone.states, by_two.states) << tick;
        ASSERT_EQ(alone.states, by_seven.states) << tick;
    }
}

TEST(Crowd, StepAllTellsWhatEachPressedAgainstHoweverItIsSplit) {
    Scene scene;
    scene.floor(-20, 20, -20, 20, 0, 8).block({1, 0, -20}, {2, 3, 20});
    const World world = scene.world();
    Many many = jostling(40, 5, 3);
    for (int tick = 0; tick < 30; ++tick) many.tick(world);
    std::vector<StepResult> expected;
    std::size_t pressed = 0;
    std::vector<CharacterState> after(many.states.size());
    std::vector<CharacterContacts> contacts(many.states.size());
    Characters characters = many.all(after);
    characters.contacts = contacts;
    ASSERT_TRUE(many.crowd.gather(characters, many.dt));
    for (std::size_t i = 0; i < many.states.size(); ++i) {
        std::array<Neighbour, most_met_in_crowd> near;
        const std::size_t count = std::min(many.crowd.neighbours(i, near), near.size());
        expected.push_back(
            step(world, many.settings[i], many.inputs[i], many.dt, many.states[i], std::span(near).first(count)));
        pressed += expected[i].contacts.count;
    }
    EXPECT_GT(pressed, many.states.size() / 2) << "most of them stand on the floor";
    for (const std::size_t parts : {std::size_t{1}, std::size_t{3}}) {
        std::fill(contacts.begin(), contacts.end(), CharacterContacts{.count = 4});
        for (std::size_t k = parts; k-- > 0;) step_all(world, many.crowd, characters, many.dt, many.part(k, parts));
        for (std::size_t i = 0; i < contacts.size(); ++i) {
            ASSERT_EQ(contacts[i].count, expected[i].contacts.count) << i;
            for (std::size_t k = 0; k < contacts[i].count; ++k) {
                EXPECT_EQ(contacts[i].all[k].impulse, expected[i].contacts.all[k].impulse);
                EXPECT_EQ(contacts[i].all[k].point, expected[i].contacts.all[k].point);
                EXPECT_EQ(contacts[i].all[k].triangle, expected[i].contacts.all[k].triangle);
            }
        }
    }
}

TEST(Crowd, TheOrderInWhichCharactersAreHeldChangesNoBit) {
    const World world = yard();
    Many many = jostling(100, 5, 3);
    std::vector<std::size_t> order(many.states.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    SplitMix random(4);
    for (std::size_t i = order.size() - 1; i > 0; --i) std::swap(order[i], order[random.next() % (i + 1)]);
    Many shuffled;
    for (const std::size_t i : order) {
        shuffled.add(many.states[i].position, many.inputs[i].wish, many.settings[i]);
        shuffled.ids.back() = many.ids[i];
    }
    for (int tick = 0; tick < 40; ++tick) {
        many.tick(world);
        shuffled.tick(world);
        for (std::size_t k = 0; k < order.size(); ++k) {
            ASSERT_EQ(shuffled.states[k], many.states[order[k]]) << tick << " " << k;
            ASSERT_EQ(shuffled.events[k].set, many.events[order[k]].set) << tick << " " << k;
        }
    }
}

TEST(Crowd, NeighboursAreThoseThatADenseSearchFinds) {
    Many many = jostling(300, 12, 5);
    CharacterSettings giant;
    giant.volume = Sphere{6};
    many.add({3, 5, 3}, {0, 0, 0}, giant);
    std::vector<CharacterState> after(many.states.size());
    ASSERT_TRUE(many.crowd.gather(many.all(after), many.dt));
    std::vector<Neighbour> room(many.states.size());
    for (std::size_t i = 0; i < many.states.size(); ++i) {
        const std::size_t count = many.crowd.neighbours(i, room);
        std::vector<bool> found(many.states.size());
        for (std::size_t k = 0; k < count; ++k) found[room[k].id] = true;
        EXPECT_FALSE(found[i]);
        for (std::size_t k = 0; k < many.states.size(); ++k) {
            if (k == i) continue;
            // All that could touch before both have moved for a tick at 7 m/s.
            const bool meets = pair_overlap(many.settings[i].volume, many.states[i].position, many.settings[k].volume,
                                            many.states[k].position)
                                   .has_value();
            if (meets) {
                EXPECT_TRUE(found[k]) << i << " " << k;
            }
        }
    }
}

TEST(Crowd, TheNearestAreHeededWhenThereAreMoreThanRoom) {
    Many many;
    for (int i = 0; i < 40; ++i) many.add({0.02 * i, 1, 0});
    std::vector<CharacterState> after(many.states.size());
    ASSERT_TRUE(many.crowd.gather(many.all(after), many.dt));
    std::array<Neighbour, 3> room;
    EXPECT_EQ(many.crowd.neighbours(10, room), 39U);
    EXPECT_EQ(room[0].id + room[1].id, 9U + 11U);
    EXPECT_TRUE(room[2].id == 8 || room[2].id == 12);
}

TEST(Crowd, GatheringNoMoreThanThereIsRoomForGivesTheSameAsANewCrowd) {
    const World world = yard();
    Many big = jostling(200, 6, 6);
    Many small = jostling(50, 3, 7);
    Many reused = jostling(50, 3, 7);
    ASSERT_TRUE(reused.crowd.reserve(200));
    std::vector<CharacterState> after(200);
    ASSERT_TRUE(reused.crowd.gather(big.all(after), big.dt));
    EXPECT_EQ(reused.crowd.size(), 200U);
    for (int tick = 0; tick < 20; ++tick) {
        small.tick(world);
        reused.tick(world);
    }
    EXPECT_EQ(small.states, reused.states);
}

TEST(Crowd, TwoThatWalkIntoEachOtherStopAtASkinAndStayForEver) {
    const World world = yard();
    for (const double speed : {0.5, 6.0, 30.0}) {
        Many many;
        many.add({-2, 0.95, 0}, {speed, 0, 0});
        many.add({2, 0.95, 0}, {-speed, 0, 0});
        double deepest = 0;
        for (int tick = 0; tick < 240; ++tick) {
            many.tick(world);
            deepest = std::max(deepest, many.overlap(0, 1));
            ASSERT_LT(many.states[0].position.x, many.states[1].position.x);
        }
        EXPECT_LE(deepest, 2 * speed * many.dt) << speed;
        EXPECT_TRUE(many.events[0].has(CharacterEvent::met_neighbour));
        EXPECT_EQ(many.events[0].blocked_body, 1U);
        EXPECT_EQ(many.overlap(0, 1), 0);
        const std::vector<CharacterState> before = many.states;
        many.run(world, 1);
        EXPECT_EQ(many.states[0].position, before[0].position) << speed;
        EXPECT_EQ(many.states[1].position, before[1].position) << speed;
        const double gap = many.states[1].position.x - many.states[0].position.x - 0.8;
        EXPECT_GE(gap, 0.4 * many.settings[0].skin);
        EXPECT_LE(gap, 2.5 * many.settings[0].skin);
    }
}

TEST(Crowd, TheFastDoNotChangePlacesThroughEachOther) {
    const World world = yard(200);
    for (const double speed : {60.0, 100.0, 400.0}) {
        Many many;
        many.add({-0.4 * speed, 0.95, 0}, {speed, 0, 0});
        many.add({0.4 * speed, 0.95, 0}, {-speed, 0, 0});
        for (CharacterState& state : many.states) state.velocity = {state.position.x < 0 ? speed : -speed, 0, 0};
        for (int tick = 0; tick < 60; ++tick) {
            many.tick(world);
            ASSERT_LT(many.states[0].position.x, many.states[1].position.x) << speed << " " << tick;
        }
    }
}

TEST(Crowd, AnOverlapOfHardOnesIsGoneInTheNextTick) {
    const World world = yard();
    Many many;
    many.add({0, 0.95, 0});
    many.add({0.7, 0.95, 0});
    many.run(world, 0.1);
    many.states[0].position = {0, many.states[0].position.y, 0};
    many.states[1].position = {0.7, many.states[1].position.y, 0};
    ASSERT_NEAR(many.overlap(0, 1), 0.1, 1e-6);
    many.tick(world);
    EXPECT_EQ(many.overlap(0, 1), 0);
    EXPECT_NEAR(many.states[0].position.x + many.states[1].position.x, 0.7, 1e-6) << "each does half";
    EXPECT_TRUE(many.states[0].footing == Footing::ground);
}

TEST(Crowd, AgainstAWallTheOtherOneGivesWay) {
    Scene scene;
    scene.floor(-5, 5, -5, 5).block({-2, 0, -5}, {-1, 3, 5});
    const World world = scene.world();
    Many many;
    many.add({-0.58, 0.95, 0});
    many.add({0.1, 0.95, 0});
    many.run(world, 0.5);
    EXPECT_EQ(many.overlap(0, 1), 0);
    EXPECT_GE(many.states[0].position.x, -0.6 + 0.4 * many.settings[0].skin);
}

TEST(Crowd, SoftOnesCanBeWalkedIntoAndPartSlowly) {
    const World world = yard();
    CharacterSettings soft;
    soft.firmness = Firmness::soft;
    Many many;
    many.add({-1.2, 0.95, 0}, {6, 0, 0}, soft);
    many.add({0, 0.95, 0.05}, {0, 0, 0}, soft);
    double deepest = 0;
    for (int tick = 0; tick < 60; ++tick) {
        many.tick(world);
        deepest = std::max(deepest, many.overlap(0, 1));
    }
    EXPECT_GT(deepest, 0.2);
    EXPECT_GT(many.states[0].position.x, many.states[1].position.x) << "it got through";
    many.inputs[0].wish = {0, 0, 0};
    many.states[0].position = many.states[1].position + dvec3(0.1, 0, 0);
    const dvec3 before = many.states[1].position;
    many.tick(world);
    EXPECT_LE(glm::length(many.states[1].position - before), soft_parting_speed * many.dt * 1.000001);
    many.run(world, 1);
    EXPECT_EQ(many.overlap(0, 1), 0);
}

TEST(Crowd, ThoseInTheVerySamePlacePart) {
    const World world = yard();
    Many many;
    for (int i = 0; i < 5; ++i) many.add({1, 0.95, 1});
    many.run(world, 3);
    EXPECT_LE(many.deepest_overlap(), 1e-9);
}

TEST(Crowd, NeighboursThatRideTheSameTrainAreMetWhereItTakesThem) {
    World world;
    const auto train = world.add(Scene().floor(-6, 6, -3, 3).mesh());
    Many many;
    for (int i = 0; i < 5; ++i) many.add({0.83 * i - 2, 0.95, 0.1});
    many.run(world, 0.3);
    std::vector<double> starts;
    for (const CharacterState& state : many.states) starts.push_back(state.position.x);
    double x = 0;
    for (int tick = 0; tick < 120; ++tick) {
        x += 25 * many.dt;
        world.begin_tick();
        ASSERT_TRUE(world.move(*train, {.position = {x, 0, 0}}));
        many.tick(world);
        for (std::size_t i = 0; i < starts.size(); ++i) {
            ASSERT_NEAR(many.states[i].position.x - x, starts[i], 1e-9) << tick << " " << i;
        }
    }
}

TEST(Crowd, NobodyWalksUpAnother) {
    const World world = yard();
    CharacterSettings rat;
    rat.volume = Sphere{0.15};
    rat.step_up = 0.05;
    Many many;
    many.add({-2, 0.95, 0}, {5, 0, 0});
    many.add({0, 0.2, 0}, {0, 0, 0}, rat);
    many.run(world, 0.1);
    const double height = many.states[0].position.y;
    for (int tick = 0; tick < 120; ++tick) {
        many.tick(world);
        ASSERT_NEAR(many.states[0].position.y, height, 0.01) << tick;
    }
    EXPECT_LT(many.states[0].position.x, many.states[1].position.x);
}

TEST(Crowd, ANeighbourThatIsNotANumberLeavesTheStateAsItWas) {
    const World world = yard();
    CharacterState state{.position = {0, 0.95, 0}};
    Neighbour bad{.volume = Sphere{0.5}, .position = {0, std::nan(""), 0}};
    const StepResult result = step(world, {}, {.wish = {1, 0, 0}}, 0.02, state, {&bad, 1});
    EXPECT_TRUE(result.events.has(CharacterEvent::invalid));
    EXPECT_EQ(result.state, state);
}

TEST(Crowd, ACharacterThatIsNotANumberIsMetByNobody) {
    const World world = yard();
    Many many;
    many.add({0, 0.95, 0}, {1, 0, 0});
    many.add({std::nan(""), 0.95, 0});
    many.add({0.5, 0.95, 0});
    many.settings[2].skin = -1;
    many.tick(world);
    EXPECT_FALSE(many.events[0].has(CharacterEvent::invalid));
    EXPECT_TRUE(many.events[1].has(CharacterEvent::invalid));
    EXPECT_TRUE(many.events[2].has(CharacterEvent::invalid));
}

TEST(Crowd, MoreNeighboursThanAreHeededSayOverflow) {
    const World world = yard();
    std::vector<Neighbour> others(most_neighbours + 1, Neighbour{.volume = Sphere{0.2}, .position = {9, 9, 9}});
    const CharacterState state{.position = {0, 0.95, 0}};
    EXPECT_TRUE(step(world, {}, {}, 0.02, state, others).events.has(CharacterEvent::overflow));
    others.pop_back();
    EXPECT_FALSE(step(world, {}, {}, 0.02, state, others).events.has(CharacterEvent::overflow));
}

TEST(Crowd, TheTraceNamesWhoWasMetAndWhoGaveWay) {
    const World world = yard();
    std::array<StepRecord, 64> room;
    StepTrace trace(room);
    const Neighbour other{.volume = Ellipsoid{}, .position = {0.85, 0.92, 0}, .id = 77};
    CharacterState state{.position = {0, 0.92, 0}, .velocity = {6, 0, 0}, .footing = Footing::ground};
    (void)step(world, {}, {.wish = {6, 0, 0}}, 0.02, state, {&other, 1}, &trace);
    const auto met = std::find_if(trace.records().begin(), trace.records().end(),
                                  [](const StepRecord& record) { return record.act == StepAct::met_neighbour; });
    ASSERT_NE(met, trace.records().end());
    EXPECT_EQ(met->body, 77U);
    EXPECT_NEAR(met->normal.x, -1, 1e-6);
    trace.clear();
    state.position.x = 0.2;
    (void)step(world, {}, {}, 0.02, state, {&other, 1}, &trace);
    EXPECT_TRUE(std::any_of(trace.records().begin(), trace.records().end(),
                            [](const StepRecord& record) { return record.act == StepAct::parted; }));
}

}  // namespace
}  // namespace surefoot::tests
