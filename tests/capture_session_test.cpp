// Sessions: what was played is played again, and the first tick that differs is named. And the ring that can always be
// on.
#include <array>

#include "movement_scene.hpp"
#include "splitmix.hpp"

namespace surefoot::tests {
namespace {

/// A floor with a block on it, and a lift that goes up and down.
struct Hall {
    Mesh ground = Scene().floor(-10, 10, -10, 10, 0, 4).block({-8, 0, -3}, {-7, 2, 3}).mesh();
    Mesh deck = Scene().block({-2, -0.2, -2}, {2, 0, 2}).mesh();
    World world;
    BodyHandle lift;

    Hall() {
        EXPECT_TRUE(world.add(ground, {.body = 1}).has_value());
        lift = *world.add(deck, {.pose = {{4, 0.1, 0}, dquat(1, 0, 0, 0)}, .body = 8});
    }
    /// Begins a tick in which the lift moves.
    BodyPose move(int tick) {
        world.begin_tick();
        const double height = 0.1 + 0.02 * (tick % 100 < 50 ? tick % 50 : 50 - tick % 50);
        EXPECT_TRUE(world.move(lift, {{4, height, 0}, dquat(1, 0, 0, 0)}));
        return world.poses(lift);
    }
};

struct Player {
    CharacterSettings settings{};
    CharacterState state{};
    SplitMix random{12};
    CharacterInput input{};

    Player() { state.position = {4, 2, 0.5}; }
    const CharacterInput& decide(int tick) {
        if (tick % 15 == 0) {
            input = {.wish = {random.in(-5, 5), 0, random.in(-5, 5)}, .jump = random.next() % 3 == 0};
        }
        return input;
    }
};

constexpr double dt = 1.0 / 60;

Session played(Hall& hall, int ticks) {
    Player player;
    Session session = begin_session(hall.world, player.settings, player.state);
    for (int i = 0; i < ticks; ++i) {
        const BodyPose moved = hall.move(i);
        const CharacterInput& input = player.decide(i);
        player.state = step(hall.world, player.settings, input, dt, player.state).state;
        record(session, input, dt, player.state, {&moved, 1});
    }
    return session;
}

TEST(Session, IsPlayedAgainToTheSameHashesThroughTheTextOfItsFile) {
    Hall hall;
    const Session session = played(hall, 600);
    const std::string text = session_text(session);
    EXPECT_EQ(saved_kind(text), SavedKind::session);
    const auto read = parse_session(text);
    ASSERT_TRUE(read.has_value()) << read.error().text;
    EXPECT_EQ(session_text(*read), text);
    Hall other;
    const SessionReplay again = replay(*read, other.world);
    EXPECT_TRUE(again.is_same()) << again.wrong << again.first_differs.value_or(0);
    EXPECT_EQ(again.ticks, 600U);
}

/// Somebody who walks up and down on the lift, and stands in the way.
Neighbour in_the_way(int tick) {
    Neighbour other;
    other.volume = Ellipsoid{{0.4, 0.9, 0.4}};
    other.position = {4 + 0.02 * (tick % 100 < 50 ? tick % 50 : 50 - tick % 50), 1.1, 0};
    other.velocity = {tick % 100 < 50 ? 1.2 : -1.2, 0, 0};
    other.id = 5;
    return other;
}

TEST(Session, ACharacterAmongOthersIsPlayedAgainWithThem) {
    Hall hall;
    Player player;
    Session session = begin_session(hall.world, player.settings, player.state);
    int met = 0;
    for (int i = 0; i < 300; ++i) {
        const BodyPose moved = hall.move(i);
        const Neighbour other = in_the_way(i);
        const CharacterInput input{.wish = (dvec3{4, 1, 0} - player.state.position) * 3.0};
        const StepResult result = step(hall.world, player.settings, input, dt, player.state, {&other, 1});
        player.state = result.state;
        if (result.events.has(CharacterEvent::met_neighbour)) ++met;
        record(session, input, dt, player.state, {&moved, 1}, {&other, 1});
    }
    EXPECT_GT(met, 100);
    const auto read = parse_session(session_text(session));
    ASSERT_TRUE(read.has_value()) << read.error().text;
    EXPECT_EQ(session_text(*read), session_text(session));
    Hall other;
    const SessionReplay again = replay(*read, other.world);
    EXPECT_TRUE(again.is_same()) << again.wrong << again.first_differs.value_or(0);
    for (SessionTick& tick : session.ticks) tick.neighbours.clear();
    EXPECT_TRUE(replay(session, other.world).first_differs.has_value());
}

TEST(Session, AFileOfTheFirstFormHasNoNeighboursAndOneOfTheSecondHasThemInEachTick) {
    Hall hall;
    const Session session = played(hall, 5);
    std::string text = session_text(session);
    const std::string newest = text;
    const auto without = [&](const std::string& part) {
        const std::size_t place = text.find(part);
        ASSERT_NE(place, std::string::npos) << part;
        text.erase(place, part.size());
    };
    without(", \"neighbours\": []");
    EXPECT_FALSE(parse_session(text).has_value()) << "one tick lacks them";
    for (int i = 0; i < 4; ++i) without(", \"neighbours\": []");
    EXPECT_FALSE(parse_session(text).has_value());
    text.replace(text.find("\"surefoot_session\": 2"), 21, "\"surefoot_session\": 1");
    EXPECT_FALSE(parse_session(text).has_value()) << "firmness is new as well";
    without(",\n    \"firmness\": \"hard\",\n    \"flat_foot\": false,\n    \"on_ledge\": null");
    const auto read = parse_session(text);
    ASSERT_TRUE(read.has_value()) << read.error().text;
    EXPECT_EQ(session_text(*read), newest) << "it is written in the newest form";
    Hall other;
    EXPECT_TRUE(replay(*read, other.world).is_same());
}

TEST(Session, TheFirstTickThatDiffersIsNamedAndCanBeCaptured) {
    Hall hall;
    Session session = played(hall, 300);
    session.ticks[200].hash ^= 1;
    Hall other;
    const SessionReplay again = replay(session, other.world);
    EXPECT_FALSE(again.is_same());
    ASSERT_TRUE(again.first_differs.has_value());
    EXPECT_EQ(*again.first_differs, 200U);
    const StepCapture capture =
        capture_step(other.world, settings_of(session), session.ticks[200].input, dt, again.before);
    EXPECT_EQ(capture.after, again.after);
}

TEST(Session, ADifferentInputIsADifferenceInItsTick) {
    Hall hall;
    Session session = played(hall, 100);
    session.ticks[40].input.impulse = {1, 0, 0};
    Hall other;
    EXPECT_EQ(replay(session, other.world).first_differs.value_or(0), 40U);
}

TEST(Session, AnotherLevelIsNotPlayedOn) {
    Hall hall;
    const Session session = played(hall, 10);
    World other;
    ASSERT_TRUE(other.add(hall.ground, {.body = 1}).has_value());
    const SessionReplay again = replay(session, other);
    EXPECT_FALSE(again.is_same_level);
    EXPECT_FALSE(again.is_same());
    EXPECT_EQ(again.ticks, 0U);
}

TEST(Session, TheHashOfALevelCountsEachCornerNumberAndSurfaceButNoPose) {
    const auto hash_of = [](const Mesh& mesh, const Placement& placement) {
        World world;
        EXPECT_TRUE(world.add(mesh, placement).has_value());
        return level_hash(world);
    };
    const Mesh mesh = Scene().floor(-1, 1, -1, 1).mesh();
    const std::uint64_t hash = hash_of(mesh, {.body = 1});
    EXPECT_EQ(hash, hash_of(mesh, {.pose = {{1, 2, 3}, dquat(1, 0, 0, 0)}, .body = 1}));
    EXPECT_NE(hash, hash_of(mesh, {.body = 2}));
    EXPECT_NE(hash, hash_of(Scene().floor(-1, 1, -1, 1, 0x1p-20).mesh(), {.body = 1}));
    EXPECT_EQ(hash, hash_of(Scene().floor(-1, 1, -1, 1, -0.0).mesh(), {.body = 1}));
}

TEST(Session, ABodyThatIsMissingOrAPoseThatCannotBeIsNamed) {
    Hall hall;
    Session session = played(hall, 10);
    session.ticks[3].moved[0].body = 77;
    Hall other;
    SessionReplay again = replay(session, other.world);
    EXPECT_EQ(again.wrong, "there is no body 77 in this world");
    EXPECT_EQ(again.ticks, 3U);
    session.ticks[3].moved[0] = {.body = 8, .start = {}, .end = {{0, 0, 0}, dquat(0, 0, 0, 0)}};
    again = replay(session, other.world);
    EXPECT_EQ(again.wrong, "body 8 has a pose that cannot be");
}

TEST(Session, WhatIsCutOrChangedIsAnErrorOrASessionLikeAnyOther) {
    Hall hall;
    const std::string text = session_text(played(hall, 20));
    for (std::size_t size = 0; size + 2 < text.size(); size += 13) {
        const auto cut = parse_session(text.substr(0, size), "s.json");
        ASSERT_FALSE(cut.has_value()) << size;
        ASSERT_LE(cut.error().byte, size);
    }
    SplitMix random(4);
    int read_anyway = 0;
    for (int i = 0; i < 2000; ++i) {
        std::string changed = text;
        changed[random.next() % changed.size()] = static_cast<char>(random.next());
        const auto read = parse_session(changed);
        if (!read || read->settings.longest_tick < 0.01) continue;
        ++read_anyway;
        Hall other;
        if (read->ticks[0].dt < 1) static_cast<void>(replay(*read, other.world));
    }
    EXPECT_GT(read_anyway, 20);
}

TEST(StepRing, KeepsTheLastTicksAndTheirPosesAndBecomesASession) {
    Hall hall;
    Player player;
    std::array<RingTick, 90> ticks;
    std::array<BodyPose, 90> poses;
    StepRing ring(ticks, poses);
    for (int i = 0; i < 500; ++i) {
        const BodyPose moved = hall.move(i);
        const CharacterInput& input = player.decide(i);
        ring.push(input, dt, player.state, {&moved, 1});
        player.state = step(hall.world, player.settings, input, dt, player.state).state;
        ASSERT_EQ(ring.size(), std::min(i + 1, 90));
    }
    const Session session = session_of(ring, hall.world, player.settings, player.state);
    ASSERT_EQ(session.ticks.size(), 90U);
    Hall other;
    const SessionReplay again = replay(session, other.world);
    EXPECT_TRUE(again.is_same()) << again.wrong << again.first_differs.value_or(0);
    EXPECT_EQ(again.after, player.state);
}

TEST(StepRing, KeepsNeighboursAndATickWhoseNeighboursAreGoneIsGoneItself) {
    Hall hall;
    Player player;
    std::array<RingTick, 90> ticks;
    std::array<BodyPose, 90> poses;
    std::array<Neighbour, 140> neighbours;
    StepRing ring(ticks, poses, neighbours);
    for (int i = 0; i < 200; ++i) {
        const BodyPose moved = hall.move(i);
        const std::array<Neighbour, 2> others{in_the_way(i), in_the_way(i + 20)};
        const CharacterInput input{.wish = (dvec3{4, 1, 0} - player.state.position) * 3.0};
        ring.push(input, dt, player.state, {&moved, 1}, others);
        player.state = step(hall.world, player.settings, input, dt, player.state, others).state;
    }
    EXPECT_EQ(ring.size(), 70U);
    EXPECT_EQ(ring.neighbour(ring[69], 1).position, in_the_way(219).position);
    const Session session = session_of(ring, hall.world, player.settings, player.state);
    Hall other;
    const SessionReplay again = replay(session, other.world);
    EXPECT_TRUE(again.is_same()) << again.wrong << again.first_differs.value_or(0);
    EXPECT_EQ(again.after, player.state);
    ring.push({}, dt, player.state, {}, std::vector<Neighbour>(141));
    EXPECT_EQ(ring.size(), 0U);
}

TEST(StepRing, ATickWhosePosesAreGoneIsGoneItself) {
    std::array<RingTick, 10> ticks;
    std::array<BodyPose, 6> poses;
    StepRing ring(ticks, poses);
    const std::array<BodyPose, 2> moved{BodyPose{.body = 1}, BodyPose{.body = 2}};
    for (int i = 0; i < 8; ++i) ring.push({}, dt, {}, moved);
    EXPECT_EQ(ring.size(), 3U);
    EXPECT_EQ(ring.pose(ring[0], 1).body, 2U);
    const std::array<BodyPose, 7> too_many{};
    ring.push({}, dt, {}, too_many);
    EXPECT_EQ(ring.size(), 0U);
    ring.push({}, dt, {}, moved);
    EXPECT_EQ(ring.size(), 1U);
    ring.clear();
    EXPECT_EQ(ring.size(), 0U);
    StepRing none({});
    none.push({}, dt, {});
    EXPECT_EQ(none.size(), 0U);
}

}  // namespace
}  // namespace surefoot::tests
