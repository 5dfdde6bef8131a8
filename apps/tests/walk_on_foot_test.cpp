// The character in the room, by the hands of a script: what is saved there is what the library says.
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>

#include <surefoot/capture_session.hpp>
#include <surefoot/capture_step.hpp>

#include "level.hpp"
#include "small_app.hpp"
#include "view/widgets.hpp"

namespace surefoot::playground {
namespace {

const std::string ground = SUREFOOT_LEVELS_DIR "/training-ground.glb";

void play(App& app, const std::string& script) {
    app.play(*view::parse_script(script, "test"));
    for (int i = 0; i < 1500 && app.frame(); ++i) {
    }
    EXPECT_EQ(app.failure(), "");
}

std::string scratch(const std::string& name) {
    const std::string path = (std::filesystem::path(testing::TempDir()) / name).string();
    std::filesystem::remove(path);
    return path;
}

/// Walks by the script, and saves what it did.
Session session_of(const std::string& script, const std::string& name) {
    const std::string file = scratch(name);
    const auto app = open("walk", ground);
    play(*app, "resize 1280 900\nwait 3\n" + script + "\nclick \"Keep\"\nwait 2\nclick \"File\"\nwait 2\ntext " + file +
                   "\nwait 2\nclick \"Save the session\"\nwait 2\nquit");
    const auto session = read_session(file);
    EXPECT_TRUE(session) << session.error().text;
    return session ? *session : Session{};
}

const Mesh& mesh() {
    static const tools::Level level =
        tools::load_level({.file = ground, .scale = {}, .up = {}, .tolerance = {}, .solids = {}});
    return level.mesh;
}

TEST(WalkOnFoot, the_character_walks_the_bits_that_step_gives_by_hand) {
    const Session session = session_of(
        "hold W\nwait 40\nhold Space\nwait 20\nunhold Space\nhold D\nwait 40\nunhold D\n"
        "unhold W\nwait 5\nkey P",
        "walk-bits.json");
    World world;
    ASSERT_TRUE(world.add(mesh()));
    ASSERT_GT(session.ticks.size(), 100U);
    const CharacterSettings settings = settings_of(session);
    CharacterState state = session.first;
    bool jumped = false;
    for (const SessionTick& tick : session.ticks) {
        const StepResult result = step(world, settings, tick.input, tick.dt, state);
        jumped = jumped || result.events.has(CharacterEvent::jumped);
        state = result.state;
        ASSERT_EQ(hash(state), tick.hash);
    }
    EXPECT_TRUE(jumped);
    EXPECT_LT(state.position.z, session.first.position.z - 4) << "it went north";
    EXPECT_GT(state.position.x, session.first.position.x + 1) << "and east";
}

TEST(WalkOnFoot, going_back_forgets_what_came_after_and_what_is_left_replays) {
    const Session session = session_of(
        "hold W\nwait 60\nkey P\nkey Comma\nkey Comma\nkey Comma\nkey P\nunhold W\nwait 1\nkey P", "walk-back.json");
    World world;
    ASSERT_TRUE(world.add(mesh()));
    const SessionReplay again = replay(session, world);
    EXPECT_TRUE(again.is_same()) << again.wrong;
    ASSERT_GT(session.ticks.size(), 50U);
    std::size_t walking = 0;
    for (const SessionTick& tick : session.ticks) walking += tick.input.wish != dvec3(0) ? 1 : 0;
    EXPECT_GT(walking, 50U);
}

TEST(WalkOnFoot, a_moment_that_is_saved_replays_and_says_why_it_stopped) {
    const std::string file = scratch("walk-moment.json");
    const auto app = open("walk", ground);
    play(*app, "resize 1280 900\nwait 3\nclick \"Keep\"\nwait 2\nclick \"File\"\nwait 2\ntext " + file +
                   "\nkey Enter\nclick \"Station\"\nclick \"Stairs of 0.5 m\"\nhold W\nwait 90\nkey M\nwait 2\nquit");
    ASSERT_FALSE(app->stage().toasts.texts().empty());
    EXPECT_NE(app->stage().toasts.texts().back().find(file), std::string::npos);
    const auto capture = read_step_capture(file);
    ASSERT_TRUE(capture) << capture.error().text;
    EXPECT_TRUE(replay(*capture).is_same()) << replay(*capture).differs;
    EXPECT_TRUE(capture->events.has(CharacterEvent::blocked));
    EXPECT_NE(explain_text(story_of(*capture)).find("stopped"), std::string::npos);
}

TEST(WalkOnFoot, a_gamepad_walks_and_jumps) {
    const Session session = session_of(
        "axis left_y -1\nwait 30\npad press A\nwait 10\npad release A\naxis left_y 0\n"
        "wait 2\nkey P",
        "walk-pad.json");
    bool jumps = false;
    bool walks = false;
    for (const SessionTick& tick : session.ticks) {
        jumps = jumps || tick.input.jump;
        walks = walks || tick.input.wish.z < -3.9;
    }
    EXPECT_TRUE(jumps);
    EXPECT_TRUE(walks);
}

TEST(WalkOnFoot, a_level_without_ground_is_seen_from_outside) {
    const std::string file = scratch("walk-wall.obj");
    std::ofstream(file) << "v 0 0 0\nv 0 4 0\nv 0 4 4\nf 1 2 3\n";
    auto app = open("walk", file);
    play(*app, "wait 3\nkey G\nwait 2\nquit");
    EXPECT_FALSE(view::ui::find_item("Past")) << "nobody stands there";
    app.reset();
    app = open("walk", ground);
    play(*app, "wait 3\nquit");
    EXPECT_TRUE(view::ui::find_item("Past"));
    play(*app, "key G\nwait 3\nquit");
    EXPECT_FALSE(view::ui::find_item("Past"));
}

TEST(WalkOnFoot, the_pointer_that_looks_around_is_given_back) {
    const auto app = open("walk", ground);
    play(*app, "wait 3\nkey Tab\nquit");
    EXPECT_TRUE(app->stage().display.is_pointer_captured());
    play(*app, "key Escape\nquit");
    EXPECT_FALSE(app->stage().display.is_pointer_captured());
    EXPECT_EQ(app->room(), "walk");
    play(*app, "key Tab\nkey G\nwait 1\nquit");
    EXPECT_FALSE(app->stage().display.is_pointer_captured());
}

}  // namespace
}  // namespace surefoot::playground
