// surefoot replay of steps and sessions.
#include <array>

#include <surefoot/surefoot.hpp>

#include "cli_program.hpp"

namespace {

using namespace surefoot;

class CliWhy : public Cli {
protected:
    void SetUp() override {
        Cli::SetUp();
        level_ = (folder_ / "floor.surefoot").string();
        EXPECT_EQ(run("cook " + floor_ + " -o " + level_).code, 0);
        const auto mesh = Mesh::open(level_);
        ASSERT_TRUE(mesh.has_value());
        ASSERT_TRUE(world_.add(*mesh, {.body = 3}).has_value());
        state_.position = {3, 1, 0};
        session_ = begin_session(world_, {}, state_);
        session_.note = "into the wall";
        for (int i = 0; i < 60; ++i) {
            state_ = step(world_, {}, input_, dt, state_).state;
            record(session_, input_, dt, state_);
        }
    }
    std::string step_file() const {
        const std::string file = (folder_ / "step.json").string();
        StepCapture capture = capture_step(world_, {}, input_, dt, state_);
        capture.note = "at the wall";
        EXPECT_TRUE(write_capture(capture, file).has_value());
        return file;
    }
    std::string session_file() const {
        const std::string file = (folder_ / "session.json").string();
        EXPECT_TRUE(write_session(session_, file).has_value());
        return file;
    }

    static constexpr double dt = 1.0 / 60;
    std::string level_;
    World world_;
    CharacterState state_{};
    CharacterInput input_{.wish = {4, 0, 0}};
    Session session_;
};

TEST_F(CliWhy, cpp_prints_a_saved_step_as_a_test_that_is_called_as_the_file) {
    const Outcome replay = run("replay " + step_file() + " --cpp");
    EXPECT_EQ(replay.code, 0) << replay.err;
    EXPECT_TEXT(replay.out, "TEST(Moments, step) {");
    EXPECT_TEXT(replay.out, "// at the wall");
    EXPECT_TEXT(replay.out, "moment.input.wish = surefoot::dvec3{4.0, 0.0, 0.0};");
    EXPECT_TEXT(replay.out, "EXPECT_EQ(again.result.state.position.x, ");
}

TEST_F(CliWhy, a_saved_step_is_told_in_words_and_is_the_same) {
    const Outcome replay = run("replay " + step_file());
    EXPECT_EQ(replay.code, 0) << replay.err;
    EXPECT_TEXT(replay.out, "Note: at the wall");
    EXPECT_TEXT(replay.out, "it wishes for (4, 0, 0) m/s");
    EXPECT_TEXT(replay.out, " of 1 body. Its story has ");
    EXPECT_TEXT(replay.out, "events: blocked");
    EXPECT_TEXT(replay.out, "Made again: the same, to the last bit.");
    EXPECT_TEXT(replay.out, "It stopped at triangle ");
    EXPECT_TEXT(replay.out, " of body 3: that face stands upright");
    EXPECT_TEXT(replay.out, "No step there: ");
}

TEST_F(CliWhy, a_step_that_comes_out_otherwise_says_what_differs_first_and_fails) {
    std::string text = read_text(step_file());
    const std::size_t after = text.find("\"after\"");
    const std::size_t height = text.find("\"position\": [", after);
    text.insert(height + 13, "1");
    const Outcome replay = run("replay " + write("changed.json", text));
    EXPECT_EQ(replay.code, 1) << replay.err;
    EXPECT_TEXT(replay.out, "DIFFERENT, first in position, (14.");
    const Outcome json = run("replay --json " + write("changed.json", text));
    EXPECT_EQ(nlohmann::json::parse(json.out)["same"], false);
    EXPECT_EQ(nlohmann::json::parse(json.out)["why"].size(), 2U);
}

TEST_F(CliWhy, a_neighbour_in_the_way_is_named) {
    const CharacterState start{.position = {0, 0.91, 0}, .velocity = {4, 0, 0}, .footing = Footing::ground};
    const std::array<Neighbour, 2> others{neighbour_of({}, {}, {.position = {0.83, 0.91, 0}}, 12),
                                          neighbour_of({}, {}, {.position = {-0.6, 0.91, 0}}, 40)};
    const std::string file = (folder_ / "met.json").string();
    ASSERT_TRUE(write_capture(capture_step(world_, {}, input_, dt, start, others), file).has_value());
    const Outcome replay = run("replay " + file);
    EXPECT_EQ(replay.code, 0) << replay.err;
    EXPECT_TEXT(replay.out, " of 1 body, and 2 neighbours.");
    EXPECT_TEXT(replay.out, "met a neighbour");
    EXPECT_TEXT(replay.out, "too close to neighbour 40, and was moved out by");
    EXPECT_TEXT(replay.out, "neighbour 12: it is hard, and in the way like a wall.");
    EXPECT_EQ(nlohmann::json::parse(run("replay --json " + file).out)["neighbours"], 2);
}

TEST_F(CliWhy, a_session_is_played_again_on_its_level) {
    const Outcome replay = run("replay " + session_file() + " --level " + level_);
    EXPECT_EQ(replay.code, 0) << replay.err;
    EXPECT_TEXT(replay.out, "Note: into the wall");
    EXPECT_TEXT(replay.out, "Played again: the same in 60 ticks, to the last bit.");
}

TEST_F(CliWhy, a_tick_of_a_session_is_told_and_saved) {
    const std::string saved = (folder_ / "saved.json").string();
    const Outcome replay = run("replay " + session_file() + " --level " + level_ + " --tick 59 --save " + saved);
    EXPECT_EQ(replay.code, 0) << replay.err;
    EXPECT_TEXT(replay.out, "It stopped at triangle ");
    EXPECT_EQ(run("replay " + saved).code, 0);
    EXPECT_EQ(run("replay " + session_file() + " --level " + level_ + " --tick 60").code, 2);
    EXPECT_EQ(run("replay " + session_file() + " --level " + level_ + " --save " + saved).code, 2);
}

TEST_F(CliWhy, the_first_tick_that_differs_is_named_and_told) {
    session_.ticks[20].hash ^= 1;
    const Outcome replay = run("replay " + session_file() + " --level " + level_);
    EXPECT_EQ(replay.code, 1) << replay.err;
    EXPECT_TEXT(replay.out, "DIFFERENT from tick 20 on, 0.333333 s after the beginning.");
    EXPECT_TEXT(replay.out, "Tick 20, saved by surefoot");
    const Outcome json = run("replay --json " + session_file() + " --level " + level_);
    EXPECT_EQ(nlohmann::json::parse(json.out)["first_differs"], 20);
}

TEST_F(CliWhy, a_session_needs_its_own_level) {
    EXPECT_EQ(run("replay " + session_file()).code, 2);
    const std::string other = write("other.obj", "v 0 0 0\nv 1 0 0\nv 0 0 1\nf 1 2 3\n");
    const Outcome replay = run("replay " + session_file() + " --level " + other);
    EXPECT_EQ(replay.code, 1);
    EXPECT_TEXT(replay.out, "is another level than that of the session: nothing was played.");
    session_.bodies.push_back({.body = 9});
    const Outcome two = run("replay " + session_file() + " --level " + level_);
    EXPECT_EQ(two.code, 2);
    EXPECT_TEXT(two.err, "the session is of a world of 2 bodies");
}

TEST_F(CliWhy, what_is_cut_is_named_with_the_byte) {
    const std::string text = read_text(step_file());
    const Outcome step = run("replay " + write("cut.json", text.substr(0, text.size() / 2)));
    EXPECT_EQ(step.code, 3);
    EXPECT_TEXT(step.err, "cut.json: no step: byte ");
    const std::string session = read_text(session_file());
    const Outcome cut = run("replay " + write("cut.json", session.substr(0, session.size() / 2)));
    EXPECT_EQ(cut.code, 3);
    EXPECT_TEXT(cut.err, "cut.json: no session: byte ");
    EXPECT_EQ(run("replay --cpp " + session_file()).code, 2);
}

}  // namespace
