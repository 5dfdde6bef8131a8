// The platformer as a whole, played by keys: whatever one does there is a way on, and what was won is kept.
#include "platformer/play/theatre.hpp"

#include <cstdlib>
#include <future>
#include <random>
#include <set>
#include <thread>

#include "platformer/screens/arrange.hpp"
#include "theatre_things.hpp"

namespace surefoot::platformer {
namespace {

using view::Key;

TEST_F(TheatreTest, goes_from_the_title_to_a_level_to_the_options_and_back) {
    open();
    ASSERT_TRUE(is_on(ScreenId::title));
    play_first();
    seconds(0.5);
    EXPECT_EQ(game().ticks(), 31U);
    tap(Key::escape);
    ASSERT_TRUE(is_on(ScreenId::pause));
    const auto ticks = game().ticks();
    seconds(1);
    EXPECT_EQ(game().ticks(), ticks) << "it waits";
    choose("Options");
    choose("Show the map");
    EXPECT_FALSE(screens().settings().minimap);
    tap(Key::escape);
    EXPECT_FALSE(read_game_settings(options.settings).value().minimap);
    tap(Key::escape);
    ASSERT_TRUE(screens().is_playing());
    seconds(0.5);
    EXPECT_GT(game().ticks(), ticks);
    tap(Key::escape);
    choose("Back to the levels");
    EXPECT_TRUE(is_on(ScreenId::levels));
    EXPECT_EQ(theatre->run(), nullptr);
    tap(Key::escape);
    EXPECT_TRUE(is_on(ScreenId::title));
}

TEST_F(TheatreTest, keeps_a_run_that_was_won) {
    open();
    play_first();
    win();
    ASSERT_TRUE(is_on(ScreenId::win));
    const double time = screens().won().seconds;
    EXPECT_EQ(screens().won().medal, Medal::gold);
    const auto kept = game::read_progress(options.progress);
    ASSERT_TRUE(kept) << kept.error().text;
    EXPECT_TRUE(kept->levels.at("first").won);
    EXPECT_EQ(kept->levels.at("first").best_seconds, time);
    const auto recording = game::read_recording(best_run_path(options.recordings, "first"));
    ASSERT_TRUE(recording) << recording.error().text;
    EXPECT_TRUE(recording->won);
    EXPECT_FALSE(screens().levels()[1].locked) << "the next one is open";

    // A slower one is no better: the best run stays.
    choose("Once more");
    seconds(1);
    win();
    ASSERT_TRUE(is_on(ScreenId::win));
    EXPECT_EQ(screens().won().best_before, time);
    EXPECT_EQ(game::read_progress(options.progress).value().levels.at("first").best_seconds, time);
    EXPECT_EQ(game::read_recording(best_run_path(options.recordings, "first")).value().seconds, recording->seconds);
    tap(Key::escape);
    EXPECT_TRUE(is_on(ScreenId::levels));
}

TEST_F(TheatreTest, goes_on_from_the_checkpoint_after_a_loss) {
    open();
    play_first();
    lose();
    ASSERT_TRUE(is_on(ScreenId::lose));
    EXPECT_EQ(screens().lost().section, "half way");
    choose("Try again from half way");
    ASSERT_TRUE(screens().is_playing());
    EXPECT_EQ(game().outcome(), game::Outcome::playing);
    EXPECT_EQ(game().hero().health, game::most_health);
    EXPECT_NEAR(game().feet().z, -3, 0.3);
    win();
    ASSERT_TRUE(is_on(ScreenId::win));
    EXPECT_EQ(screens().won().deaths, game::most_health);
    tap(Key::escape);
    EXPECT_TRUE(is_on(ScreenId::levels));

    // And from the other screen of that kind to the menu, and from the beginning.
    choose("First");
    choose("Play");
    lose();
    choose("From the beginning");
    EXPECT_TRUE(screens().is_playing());
    EXPECT_EQ(game().checkpoint(), 0U);
    lose();
    ASSERT_TRUE(is_on(ScreenId::lose));
    tap(Key::escape);
    EXPECT_TRUE(is_on(ScreenId::levels));
    EXPECT_EQ(theatre->run(), nullptr);
}

TEST_F(TheatreTest, races_the_ghost_and_watches_the_recording_to_its_end) {
    open();
    play_first();
    win();
    choose("Race the ghost");
    ASSERT_NE(theatre->run(), nullptr);
    ASSERT_TRUE(theatre->run()->ghost());
    seconds(2.5);
    EXPECT_EQ(theatre->run()->ghost()->game->outcome(), game::Outcome::won);
    EXPECT_EQ(game().outcome(), game::Outcome::playing) << "nobody pressed anything";
    tap(Key::escape);
    choose("From the beginning");
    EXPECT_TRUE(theatre->run()->ghost()) << "it is raced again, too";
    tap(Key::escape);
    choose("Back to the levels");
    choose("First");
    choose("Watch the best run");
    ASSERT_TRUE(theatre->run()->is_watched());
    seconds(5);
    EXPECT_EQ(game().outcome(), game::Outcome::won);
    ASSERT_TRUE(is_on(ScreenId::replay_end));
    choose("Watch it again");
    EXPECT_TRUE(theatre->run()->is_watched());
    tap(Key::escape);
    choose("Back to the levels");
    EXPECT_TRUE(is_on(ScreenId::levels));
    EXPECT_EQ(theatre->progress().levels.at("first").runs, 3U) << "what is watched is no run";
}

TEST_F(TheatreTest, watches_a_recording_from_a_second_on_as_if_it_had_been_watched_from_the_beginning) {
    open();
    play_first();
    win();
    theatre.reset();
    options.watch = best_run_path(options.recordings, "first");
    const auto recording = game::read_recording(options.watch);
    ASSERT_TRUE(recording) << recording.error().text;
    options.watch_from = 0.75;
    open();
    ASSERT_NE(theatre->run(), nullptr);
    ASSERT_TRUE(theatre->run()->is_watched());
    const auto expect_from = [&](std::uint64_t least) {
        EXPECT_GE(game().ticks(), least);
        EXPECT_LE(game().ticks(), least + 2);
        const auto whole = *game::Game::start(game().level_pointer());
        game::Player player(*recording);
        while (player.ticks() < game().ticks()) ASSERT_TRUE(player.tick(*whole));
        EXPECT_EQ(whole->hash(), game().hash());
    };
    expect_from(45);
    seconds(3.5);
    ASSERT_TRUE(is_on(ScreenId::replay_end));
    EXPECT_EQ(game().outcome(), game::Outcome::won);
    choose("Watch it again");
    expect_from(45);
}

// The defect: it began again whenever one left it, so that there was no way to the menu.
TEST_F(TheatreTest, begins_a_named_level_at_once_and_only_once) {
    options.level = "second";
    open();
    ASSERT_TRUE(screens().is_playing());
    EXPECT_EQ(game().level().id, "second");
    tap(Key::escape);
    choose("Back to the levels");
    seconds(1);
    EXPECT_TRUE(is_on(ScreenId::levels));
    EXPECT_EQ(theatre->run(), nullptr);
}

TEST_F(TheatreTest, says_that_a_named_level_is_not_there) {
    options.level = "third";
    open();
    ASSERT_TRUE(is_on(ScreenId::trouble));
    EXPECT_NE(screens().menu().title.find("'third'"), std::string::npos);
    EXPECT_NE(theatre->failure().find("first, second"), std::string::npos) << "and which there are";
    seconds(60);
    EXPECT_TRUE(is_on(ScreenId::trouble)) << "it stays until it was read";
    tap(Key::escape);
    EXPECT_TRUE(is_on(ScreenId::title));
}

/// All that the screen on top says in its lines of text.
std::string words_of(const Screens& screens) {
    std::string words;
    for (const Entry& entry : screens.menu().entries)
        if (entry.kind == Entry::Kind::text) words += entry.label + " ";
    return words;
}

// The defect: messages about other files of the folder pushed it out.
TEST_F(TheatreTest, shows_why_the_file_that_was_named_is_no_level_and_nothing_of_its_neighbours) {
    std::filesystem::create_directories(root + "/lev");
    for (const char* const name : {"/lev/bad.glb", "/lev/worse.glb"}) std::ofstream(root + name) << "this is no level";
    options.level = "bad";
    options.level_file = root + "/lev/bad.glb";
    open();
    ASSERT_TRUE(is_on(ScreenId::trouble));
    EXPECT_NE(screens().menu().title.find("cannot be played"), std::string::npos);
    EXPECT_NE(words_of(screens()).find("bad.glb"), std::string::npos);
    EXPECT_NE(theatre->failure().find("bad.glb"), std::string::npos);
    EXPECT_EQ(notices.find("worse.glb"), std::string::npos);
    EXPECT_EQ(theatre->run(), nullptr);
}

TEST_F(TheatreTest, plays_a_level_that_is_named_by_its_file_alone) {
    write_level(root + "/mine/castle.glb", R"("title":"Castle")");
    options.level = "castle";
    options.level_file = root + "/mine/castle.glb";
    open();
    ASSERT_TRUE(screens().is_playing());
    EXPECT_EQ(game().level().title, "Castle");
    EXPECT_EQ(theatre->failure(), "");
}

TEST_F(TheatreTest, says_why_a_recording_cannot_be_watched) {
    std::filesystem::create_directories(root);
    std::ofstream(root + "/empty.run") << "";
    options.watch = root + "/empty.run";
    open();
    ASSERT_TRUE(is_on(ScreenId::trouble));
    EXPECT_NE(theatre->failure().find("empty.run"), std::string::npos);
}

TEST_F(TheatreTest, says_that_a_level_has_no_such_beat) {
    options.level = "first";
    options.beat = 50;
    open();
    ASSERT_TRUE(is_on(ScreenId::trouble));
    EXPECT_NE(theatre->failure().find("no beat 50"), std::string::npos);
}

// The defect: who won a level of their own from the command line found it locked all the same.
TEST_F(TheatreTest, has_the_players_own_levels_open_at_the_end_of_the_level_select) {
    write_level(root + "/levels/castle.glb", R"("title":"Castle","order":50)");
    std::ofstream(root + "/levels/broken.glb") << "this is no level";
    open();
    choose("Levels");
    const std::vector<LevelCard>& levels = screens().levels();
    ASSERT_EQ(levels.size(), 3U);
    EXPECT_TRUE(levels[1].locked) << "of the campaign";
    EXPECT_EQ(levels[2].title, "Castle");
    EXPECT_TRUE(levels[2].own);
    EXPECT_FALSE(levels[2].locked);
    choose("Castle");
    ASSERT_TRUE(is_on(ScreenId::level));
    tap(Key::escape);
    choose("broken.glb");
    ASSERT_TRUE(is_on(ScreenId::trouble));
    EXPECT_NE(words_of(screens()).find("broken.glb"), std::string::npos);
    EXPECT_EQ(theatre->failure(), "") << "nobody asked for it";
    tap(Key::escape);
    EXPECT_TRUE(is_on(ScreenId::levels));
}

// The defect: of two programs at once the last one to end wrote what it knew over what the other had won.
TEST_F(TheatreTest, keeps_what_another_program_has_won_meanwhile) {
    open();
    play_first();
    game::Progress other;
    other.levels["second"] = {.won = true, .best_seconds = 12, .stars = {1}};
    other.levels["first"] = {.won = true, .best_seconds = 0.5};
    ASSERT_TRUE(game::write_progress(options.progress, other));
    win();
    EXPECT_EQ(screens().won().best_before, 0.5);
    const auto kept = game::read_progress(options.progress).value();
    EXPECT_TRUE(kept.levels.at("second").won);
    EXPECT_EQ(kept.levels.at("first").best_seconds, 0.5);
    EXPECT_EQ(kept.levels.at("first").medal, game::Medal::gold);
    EXPECT_FALSE(std::filesystem::exists(best_run_path(options.recordings, "first"))) << "the other one's is better";
}

// The defect: "Try again" lost again at once, without end.
TEST_F(TheatreTest, once_the_time_is_up_offers_the_beginning_and_the_levels_only) {
    write_level(root + "/levels/first.glb", R"("title":"First","order":1,"time_limit":10)");
    open();
    play_first();
    seconds(13);
    ASSERT_TRUE(is_on(ScreenId::lose));
    for (const Entry& entry : screens().menu().entries) EXPECT_FALSE(entry.label.starts_with("Try again"));
    choose("From the beginning");
    EXPECT_TRUE(screens().is_playing());
    EXPECT_LT(game().seconds(), 0.5);
}

// The defect: it stood before "Not this time" for ever.
TEST_F(TheatreTest, a_bot_tries_again_and_goes_on_to_the_next_level) {
    int into_the_fire = 1;
    options.pilot = {.study = {}, .decide = [&](const game::Game& game) -> game::HeroInput {
                         if (game.deaths() >= unsigned(game::most_health)) into_the_fire = 0;
                         return {.move_z = into_the_fire == 1 ? 1.0F : -1.0F};
                     }};
    options.pilot_goes_on = true;
    open();
    play_first();
    for (int i = 0; i < 60 * 30 && !(game().level().id == "second"); ++i) tick();
    EXPECT_EQ(game().level().id, "second");
    EXPECT_TRUE(screens().is_playing());
}

TEST_F(TheatreTest, tells_what_a_heart_is_when_the_first_is_lost_and_only_then) {
    open();
    play_first();
    EXPECT_EQ(theatre->hint(), "");
    lose();
    EXPECT_NE(theatre->hint().find("{retry}"), std::string_view::npos);
    tap(Key::escape);
    theatre.reset();
    open();
    play_first();
    lose();
    EXPECT_EQ(theatre->hint(), "") << "this player knows";
}

TEST_F(TheatreTest, gives_scripts_the_place_of_what_a_label_names) {
    open();
    const auto place = theatre->place_of("Options");
    ASSERT_TRUE(place);
    theatre->event(view::ButtonPress{.at = *place});
    EXPECT_TRUE(is_on(ScreenId::options));
    EXPECT_FALSE(theatre->place_of("Levels"));
    const auto labels = theatre->labels();
    EXPECT_NE(std::ranges::find(labels, "Keys and buttons"), labels.end());
}

TEST_F(TheatreTest, messages_wait_for_a_screen_and_never_stand_over_the_game) {
    std::filesystem::create_directories(root + "/own");
    std::ofstream(options.settings) << "no settings";
    options.level = "first";
    open();
    ASSERT_TRUE(screens().is_playing());
    seconds(1);
    EXPECT_EQ(screens().notice(), "");
    tap(Key::escape);
    tick();
    EXPECT_NE(screens().notice().find("damaged"), std::string::npos);
}

TEST_F(TheatreTest, keeps_the_size_of_its_own_window_with_its_settings) {
    options.keeps_window = true;
    open();
    display->resize({1000, 700});
    ASSERT_TRUE(theatre->keep());
    EXPECT_EQ(read_game_settings(options.settings)->width, 1000);
    EXPECT_EQ(read_game_settings(options.settings)->height, 700);
}

// The defect: all levels became one.
TEST_F(TheatreTest, has_all_levels_of_all_folders_in_the_order_of_playing) {
    write_level(root + "/levels/a-secret.glb", R"("title":"Secret","order":0,"secret":true)");
    write_level(root + "/levels/zeroth.glb", R"("title":"Zeroth","order":0)");
    std::ofstream(root + "/levels/campaign.txt") << "zeroth\nfirst\na-secret\nsecond\nthird\n";
    std::ofstream(root + "/levels/broken.glb") << "this is no level";
    write_level(root + "/more/second.glb", R"("title":"Second, mended","order":2)");
    write_level(root + "/more/third.glb", R"("title":"Third","order":3)");
    options.level_folders.push_back(root + "/more");
    options.level_folders.push_back(root + "/is not there");
    open();
    std::vector<std::string> titles;
    for (const LevelCard& card : screens().levels()) titles.push_back(card.title);
    EXPECT_EQ(titles, (std::vector<std::string>{"Zeroth", "First", "Second, mended", "Third", "Secret"}));
    choose("Play: Zeroth");
    tap(Key::escape);
    choose("Back to the levels");
    EXPECT_EQ(notices, "") << "what is no level is told on the level select only";
}

TEST_F(TheatreTest, shows_that_a_level_is_made_ready_and_can_be_left_meanwhile) {
    std::promise<void> gate;
    options.background = true;
    options.pilot = {.study = [open = gate.get_future().share()](const game::Game&) { open.wait(); },
                     .decide = [](const game::Game&) { return game::HeroInput{}; }};
    open();
    const auto wait_until = [&](const auto& is_so) {
        for (int i = 0; i < 4000 && !is_so(); ++i) {
            tick();
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
        ASSERT_TRUE(is_so());
    };
    wait_until([&] { return !screens().levels().empty(); });
    choose("Play: First");
    ASSERT_TRUE(is_on(ScreenId::getting_ready));
    EXPECT_EQ(theatre->run(), nullptr);
    tap(Key::escape);
    EXPECT_TRUE(is_on(ScreenId::levels));
    choose("First");
    choose("Play");
    ASSERT_TRUE(is_on(ScreenId::getting_ready));
    gate.set_value();
    wait_until([&] { return screens().is_playing(); });
    ASSERT_NE(theatre->run(), nullptr);
    seconds(1);
    EXPECT_GT(game().ticks(), 50U);
}

TEST_F(TheatreTest, ends_at_once_while_it_looks_for_the_ways_of_one_who_jumps) {
    const std::string usual = std::getenv("XDG_CACHE_HOME");
    setenv("XDG_CACHE_HOME", (root + "/cache").c_str(), 1);  // where nothing is kept yet
    write_level(root + "/levels/jumper.glb", R"("title":"Jumper")",
                R"(,{"name":"j","translation":[-3,0,0],"extras":{"surefoot":{"kind":"enemy","type":"jumper"}}})");
    auto level = game::read_level(root + "/levels/jumper.glb");
    ASSERT_TRUE(level) << level.error().text;
    const auto shared = std::make_shared<const game::Level>(std::move(*level));
    const std::atomic<bool> stop = true;
    EXPECT_FALSE(game::Game::start(shared, {.stop = &stop}));
    EXPECT_TRUE(game::Game::start(shared)) << "what was stopped was not kept";
    setenv("XDG_CACHE_HOME", usual.c_str(), 1);
}

TEST_F(TheatreTest, agrees_with_the_window_about_full_screen) {
    open();
    display->set_full_screen(true);  // F11
    tick();
    EXPECT_TRUE(screens().settings().full_screen);
    EXPECT_TRUE(read_game_settings(options.settings).value().full_screen);
    choose("Options");
    choose("Show the clock");
    EXPECT_TRUE(display->is_full_screen()) << "another setting does not undo it";
    choose("Full screen");
    EXPECT_FALSE(display->is_full_screen());
    EXPECT_FALSE(screens().settings().full_screen);
}

TEST_F(TheatreTest, takes_a_click_where_the_title_stands_after_the_window_has_changed) {
    open();
    for (const view::ivec2 size : {view::ivec2(1500, 640), view::ivec2(640, 900), view::ivec2(3840, 2160)}) {
        display->resize(size);
        theatre->event(view::Resize{size, display->framebuffer_size()});
        const Menu menu = screens().menu();
        const view::Layout& layout = screens().layout();
        ASSERT_EQ(layout.framebuffer, display->framebuffer_size()) << "before it is drawn";
        const Arrangement all = arrange(menu, layout.size(), 0);
        ASSERT_EQ(menu.entries[1].label, "Levels");
        theatre->event(view::ButtonPress{.at = all.places[1].middle() * layout.pixels() / layout.per_window_unit});
        ASSERT_TRUE(is_on(ScreenId::levels)) << size.x;
        tap(Key::escape);
    }
}

view::InputEvent anything(std::mt19937& random) {
    const auto number = [&](int below) { return static_cast<int>(random() % static_cast<unsigned>(below)); };
    const view::dvec2 at(number(800), number(600));
    constexpr Key common[] = {Key::up, Key::down, Key::enter, Key::w, Key::w, Key::d, Key::space, Key::escape};
    switch (number(7)) {
        case 0:
            return view::KeyPress{.key = static_cast<Key>(1 + number(static_cast<int>(Key::count) - 1)),
                                  .down = number(3) > 0};
        case 1:
        case 2:
            return view::KeyPress{.key = common[number(8)], .down = number(4) > 0};
        case 3:
            return view::GamepadButton{static_cast<view::PadButton>(number(15)), number(3) > 0};
        case 4:
            return view::GamepadAxis{static_cast<view::PadAxis>(number(6)), number(201) / 100.0 - 1};
        case 5:
            return view::ButtonPress{static_cast<view::MouseButton>(number(3)), number(2) == 0, at, {}};
        default:
            return view::PointerMove{.at = at, .by = {number(20) - 10.0, 1}};
    }
}

TEST_F(TheatreTest, minutes_of_pressing_everything_never_end_where_there_is_no_way_out) {
    options.session = root + "/afternoon";
    open();
    fill_in();
    std::mt19937 random(3);
    std::set<ScreenId> seen;
    int played = 0;
    for (int i = 0; i < 5 * 3600; ++i) {
        if (i % 4 == 0) theatre->event(anything(random));
        theatre->tick();
        (void)theatre->take_notices();
        if (screens().is_playing()) {
            ASSERT_NE(theatre->run(), nullptr) << "nothing is shown and nothing is played, after tick " << i;
            ++played;
        } else {
            seen.insert(screens().top());
        }
        if (i % 900 != 0) continue;
        for (int tries = 0; tries < 20 && !is_on(ScreenId::title); ++tries) {
            if (is_on(ScreenId::pause)) choose("Back to the levels");
            tap(Key::escape);
        }
        ASSERT_TRUE(is_on(ScreenId::title)) << "after tick " << i;
    }
    EXPECT_GT(played, 600);
    EXPECT_GE(seen.size(), 8U);
    EXPECT_TRUE(seen.contains(ScreenId::form));
}

}  // namespace
}  // namespace surefoot::platformer
