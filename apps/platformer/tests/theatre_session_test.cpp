// Somebody is tested: forms, the observer's keys, and a folder that the report reads.
#include "game/whole_file.hpp"
#include "playtest/report/report.hpp"
#include "playtest/run.hpp"
#include "theatre_things.hpp"

namespace surefoot::platformer {
namespace {

namespace fs = std::filesystem;
using view::Key;
using view::PadButton;

class TheatreSession : public TheatreTest {
protected:
    void SetUp() override {
        TheatreTest::SetUp();
        options.session = root + "/afternoon";
    }
};

TEST_F(TheatreSession, leaves_a_folder_that_the_report_reads) {
    open();
    ASSERT_TRUE(is_on(ScreenId::form));
    fill_in();
    ASSERT_TRUE(is_on(ScreenId::title));
    play_first();
    seconds(0.5);
    key(Key::w, true);
    tap(Key::f9);
    ASSERT_TRUE(is_on(ScreenId::form));
    const auto ticks = game().ticks();
    type("wonders <where> to go");
    seconds(1);
    EXPECT_EQ(game().ticks(), ticks) << "the game waits for the note";
    tap(Key::enter);
    ASSERT_TRUE(screens().is_playing());
    seconds(0.5);
    EXPECT_EQ(game().feet().z, 0) << "a key that was held when the form came is let go";
    tap(Key::f10);
    EXPECT_TRUE(screens().is_playing());
    lose();
    choose("From the beginning");
    win();
    tap(Key::escape);
    tap(Key::f10);
    tap(Key::escape);
    tap(Key::escape);
    choose("Leave");
    ASSERT_TRUE(is_on(ScreenId::form)) << "not without the questions";
    EXPECT_FALSE(theatre->wants_quit());
    tap(Key::left);
    tap(Key::down);
    tap(Key::right);
    choose("Anything else?", false);
    type("The fire is hot.");
    choose("Done");
    EXPECT_TRUE(theatre->wants_quit());
    theatre.reset();

    const auto sessions = playtest::read_sessions(root + "/afternoon");
    ASSERT_TRUE(sessions) << sessions.error().text;
    ASSERT_EQ(sessions->size(), 1U);
    const playtest::Session& session = sessions->front();
    EXPECT_TRUE(fs::path(session.folder).filename().string().ends_with("-Anna-W"));
    EXPECT_EQ(session.start.player, "Anna W.") << "keys that bring letters do nothing else";
    EXPECT_EQ(session.start.plays_games, "never");
    EXPECT_EQ(session.start.device, "gamepad");
    EXPECT_TRUE(session.start.consent);
    ASSERT_EQ(session.runs, (std::vector<std::string>{"first", "first-2"}));
    ASSERT_EQ(session.notes.size(), 3U);
    EXPECT_EQ(session.notes[0].text, "wonders <where> to go");
    EXPECT_EQ(session.notes[0].run, "first");
    EXPECT_NEAR(session.notes[0].seconds, 0.5, 0.1);
    EXPECT_EQ(session.notes[1].text, "");
    EXPECT_EQ(session.notes[2].run, "") << "between runs";
    EXPECT_EQ(session.answers.fun, 5);
    EXPECT_EQ(session.answers.difficulty, 1);
    EXPECT_EQ(session.answers.control, 0) << "left open";
    EXPECT_EQ(session.answers.remark, "The fire is hot.");

    const auto level = std::make_shared<const game::Level>(*game::read_level(root + "/levels/first.glb"));
    playtest::Findings of{.level = level};
    for (const std::string& run : session.runs) {
        const auto recording = game::read_recording(session.folder + "/" + run + ".run");
        ASSERT_TRUE(recording) << recording.error().text;
        std::uint64_t diverged = 0;
        const auto again = playtest::replay(level, *recording, &diverged);
        ASSERT_TRUE(again) << again.error().text;
        EXPECT_EQ(diverged, 0U);
        auto noted = *again;
        noted.player = session.start.player;
        EXPECT_EQ(playtest::to_json(noted) + "\n", *game::read_whole(session.folder + "/" + run + ".json"))
            << "what was noted down while it was played is what the recording says";
        of.runs.push_back({.telemetry = *again, .recording = *recording, .by_human = true});
    }
    EXPECT_EQ(of.runs[0].telemetry.count(playtest::Incident::Kind::death), std::size_t(game::most_health));
    EXPECT_TRUE(of.runs[1].telemetry.won);
    ASSERT_TRUE(playtest::write_report(root + "/report.html", {{of}}, *sessions));
    const std::string page = *game::read_whole(root + "/report.html");
    EXPECT_NE(page.find("wonders &lt;where&gt; to go"), std::string::npos);
    EXPECT_NE(page.find("The fire is hot."), std::string::npos);
    EXPECT_NE(page.find("marked"), std::string::npos);

    // The machine's owner has won nothing by it.
    EXPECT_TRUE(game::read_progress(options.progress).value().levels.empty());
    EXPECT_FALSE(fs::exists(options.recordings));
    EXPECT_TRUE(game::read_progress(session.folder + "/progress.json").value().levels.at("first").won);
}

TEST_F(TheatreSession, is_begun_and_ended_with_a_gamepad_alone) {
    open();
    const auto to = [&](const std::string& label) {
        for (int i = 0; i < 20; ++i) {
            const Menu menu = screens().menu();
            if (menu.entries[screens().focus()].label.starts_with(label)) return;
            tap(PadButton::down);
        }
        FAIL() << label;
    };
    tap(PadButton::right);
    tap(PadButton::right);
    to("How often");
    tap(PadButton::a);
    to("With what");
    tap(PadButton::left);
    to("Begin");
    tap(PadButton::a);
    ASSERT_TRUE(is_on(ScreenId::form)) << "not before it is agreed to";
    EXPECT_NE(screens().notice().find("I agree"), std::string::npos);
    to("I agree");
    tap(PadButton::a);
    to("Begin");
    tap(PadButton::a);
    ASSERT_TRUE(is_on(ScreenId::title));
    EXPECT_EQ(theatre->session()->session().start.player, "B");
    tap(PadButton::b);
    to("Leave");
    tap(PadButton::a);
    ASSERT_TRUE(is_on(ScreenId::form));
    tap(PadButton::right);
    to("Done");
    tap(PadButton::a);
    EXPECT_TRUE(theatre->wants_quit());
    EXPECT_EQ(playtest::read_sessions(root + "/afternoon").value().front().answers.fun, 1);
}

TEST_F(TheatreSession, keeps_nothing_of_whom_it_was_not_agreed_with) {
    open();
    type("Anna");
    tap(Key::escape);
    EXPECT_TRUE(theatre->wants_quit());
    EXPECT_FALSE(theatre->session()->has_begun());
    // The program ends here; even if it went on, nothing would be kept. The defect: runs lay about where it was
    // started.
    play_first();
    seconds(0.2);
    tap(Key::f9);
    EXPECT_TRUE(screens().is_playing());
    theatre.reset();
    EXPECT_FALSE(fs::exists(root + "/afternoon"));
    EXPECT_FALSE(fs::exists("first.run"));
}

TEST_F(TheatreSession, gives_two_players_of_one_name_a_folder_each_and_begins_the_level_that_was_named) {
    options.level = "second";
    for (int i = 0; i < 2; ++i) {
        open();
        ASSERT_TRUE(is_on(ScreenId::form)) << "the form comes before the level";
        fill_in();
        ASSERT_TRUE(screens().is_playing());
        EXPECT_EQ(game().level().id, "second");
        seconds(1);
        theatre.reset();  // the window is closed in the middle of it
    }
    const auto sessions = playtest::read_sessions(root + "/afternoon");
    ASSERT_TRUE(sessions) << sessions.error().text;
    ASSERT_EQ(sessions->size(), 2U);
    for (const playtest::Session& session : *sessions) {
        ASSERT_EQ(session.runs, std::vector<std::string>{"second"});
        EXPECT_EQ(game::read_recording(session.folder + "/second.run").value().inputs.size(), 61U);
    }
}

TEST_F(TheatreSession, asks_again_where_the_folder_cannot_be_made) {
    std::ofstream(root + "/afternoon") << "a file";
    open();
    fill_in();
    EXPECT_TRUE(is_on(ScreenId::form));
    EXPECT_EQ(screens().form()["player"].text, "Anna W.") << "what was filled in is still there";
    EXPECT_NE(notices, "");
}

}  // namespace
}  // namespace surefoot::platformer
