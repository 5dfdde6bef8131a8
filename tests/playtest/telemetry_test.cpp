#include <algorithm>
#include <gtest/gtest.h>

#include "made_levels.hpp"
#include "playtest/bots/explorer.hpp"
#include "playtest/campaign.hpp"
#include "playtest/report/report.hpp"

namespace surefoot::playtest {
namespace {

// Does in each tick what a list says, and the last of it for ever.
class Script final : public Bot {
public:
    explicit Script(std::vector<game::HeroInput> inputs) : inputs_(std::move(inputs)) {}
    game::HeroInput decide(const game::Game& game) override {
        return inputs_[std::min<std::size_t>(game.ticks(), inputs_.size() - 1)];
    }
    const std::string& gave_up() const override { return never_; }
    std::string name() const override { return "script"; }

private:
    std::vector<game::HeroInput> inputs_;
    std::string never_;
};

TEST(Telemetry, notices_whoever_is_stuck_in_a_pit) {
    const auto level = test::pit();
    Explorer bot(1);
    const auto run = play(level, bot, {.most_seconds = 120});
    ASSERT_TRUE(run);
    ASSERT_GT(run->telemetry.count(Incident::Kind::stuck), 0U);
    const auto first = std::ranges::find(run->telemetry.incidents, Incident::Kind::stuck, &Incident::kind);
    EXPECT_NEAR(first->place.y, -8, 0.1);
    ASSERT_TRUE(first->capture.has_value());
    EXPECT_TRUE(surefoot::replay(*first->capture).is_same()) << "the step can be made again";
}

TEST(Telemetry, says_of_nobody_who_leans_against_a_wall_for_a_while_that_they_are_stuck) {
    test::LevelMaker maker;
    maker.box({-5, 0, -3}, {5, 3, -2});
    std::vector<game::HeroInput> inputs(200, game::HeroInput{.move_z = -1});
    inputs.insert(inputs.end(), 200, game::HeroInput{.move_z = 1});
    Script bot(inputs);
    const auto run = play(maker.finish(), bot, {.most_seconds = 6});
    ASSERT_TRUE(run);
    EXPECT_EQ(run->telemetry.count(Incident::Kind::stuck), 0U);
}

// Jumps at an edge that is too low to climb over, and presses on.
class Hanger final : public Bot {
public:
    game::HeroInput decide(const game::Game& game) override {
        game::HeroInput input{.move_z = -1};
        hangs_ = hangs_ || game.hero().body.footing == Footing::ledge;
        if (!hangs_ && game.feet().z < -2.5) press(input, game::Button::jump);
        return input;
    }
    const std::string& gave_up() const override { return never_; }
    std::string name() const override { return "hanger"; }

private:
    bool hangs_ = false;
    std::string never_;
};

TEST(Telemetry, says_of_nobody_who_hangs_on_an_edge_and_has_not_let_go_that_they_are_stuck) {
    test::LevelMaker maker;
    maker.box({-3, 0, -8}, {3, 2.4, -4});
    maker.box({-3, 2.8, -8}, {3, 4, -4.0});
    const auto level = maker.finish();
    Hanger bot;
    const auto run = play(level, bot, {.most_seconds = 10});
    ASSERT_TRUE(run);
    const auto game = *game::start_of(level, run->recording);
    game::Player player(run->recording);
    while (player.tick(*game)) continue;
    ASSERT_EQ(game->hero().body.footing, Footing::ledge) << "it still hangs there";
    EXPECT_EQ(run->telemetry.count(Incident::Kind::stuck), 0U);
}

// From wall to wall up a shaft for four seconds, down again at the one where it began, and off to the other.
class Climber final : public Bot {
public:
    game::HeroInput decide(const game::Game& game) override {
        const int i = int(game.ticks());
        const bool is_down = i > 250 && game.hero().body.footing == Footing::ground;
        leaves_ = leaves_ || is_down;
        const bool right = !leaves_ && (i >= 240 || i / 30 % 2 == 0);
        game::HeroInput input{.move_x = right ? 1.0F : -1.0F};
        if (i > 16 && i < 240 && i % 30 > 4 && i % 30 < 22) press(input, game::Button::jump);
        highest = std::max(highest, game.feet().y);
        return input;
    }
    const std::string& gave_up() const override { return never_; }
    std::string name() const override { return "climber"; }

    double highest = 0;

private:
    bool leaves_ = false;
    std::string never_;
};

TEST(Telemetry, says_of_nobody_who_climbs_a_shaft_off_its_walls_and_slides_down_again_that_they_are_stuck) {
    test::LevelMaker maker;
    maker.box({-3, 0, -3}, {-1.2, 12, 3});
    maker.box({1.2, 0, -3}, {3, 12, 3});
    maker.box({-3, 0, -4}, {3, 12, -3});
    maker.box({-3, 0, 3}, {3, 12, 4});
    Climber bot;
    const auto run = play(maker.finish(), bot, {.most_seconds = 10});
    ASSERT_TRUE(run);
    EXPECT_GT(bot.highest, 3.5);
    EXPECT_EQ(run->telemetry.count(Incident::Kind::stuck), 0U);
}

TEST(Telemetry, counts_deaths_by_section_and_failed_jumps) {
    test::LevelMaker maker;
    maker.clear();
    maker.box({-3, -1, -12}, {3, 0, 4});
    maker.level->checkpoints.push_back({.feet = {0, 0, -6}, .section = "the edge", .order = 1});
    maker.level->goal = {0, 0, -60};
    const auto level = maker.finish();
    // Runs past the checkpoint, jumps off the edge, and does so again.
    std::vector<game::HeroInput> inputs;
    for (int i = 0; i < 1200; ++i) {
        game::HeroInput input{.move_z = -1};
        if (i % 40 < 20) press(input, game::Button::jump);
        inputs.push_back(input);
    }
    Script bot(inputs);
    const auto run = play(level, bot, {.most_seconds = 20});
    ASSERT_TRUE(run);
    EXPECT_EQ(run->telemetry.section_deaths[0], 0U);
    EXPECT_GT(run->telemetry.section_deaths[1], 3U);
    EXPECT_EQ(run->telemetry.count(Incident::Kind::death), run->telemetry.section_deaths[1]);
    EXPECT_GT(run->telemetry.count(Incident::Kind::failed_jump), 0U);
    const auto death = std::ranges::find(run->telemetry.incidents, Incident::Kind::death, &Incident::kind);
    EXPECT_EQ(death->cause, game::Cause::fall);
    EXPECT_GT(death->trail.size(), 10U);
    EXPECT_GT(run->telemetry.section_seconds[1], run->telemetry.section_seconds[0]);
    double sum = 0;
    for (const double seconds : run->telemetry.section_seconds) sum += seconds;
    EXPECT_NEAR(sum, run->telemetry.seconds, 1e-6);
}

TEST(Telemetry, is_the_same_after_it_was_written_and_read) {
    const auto level = test::pit();
    Explorer bot(1);
    const auto run = play(level, bot, {.most_seconds = 40});
    ASSERT_TRUE(run);
    const std::string text = to_json(run->telemetry);
    const auto read = telemetry_of(text, "a file");
    ASSERT_TRUE(read) << read.error().text;
    EXPECT_EQ(to_json(*read), text);
    EXPECT_FALSE(telemetry_of(text.substr(0, text.size() / 2), "a file"));
    EXPECT_FALSE(telemetry_of("{}", "a file"));
}

TEST(Telemetry, of_who_began_at_a_checkpoint_knows_no_section_before_it_and_is_made_again_from_the_recording) {
    const auto level = test::gaps_lift_key_and_door();
    Explorer bot(2);
    const auto run = play(level, bot, {.most_seconds = 20, .checkpoint = 1, .one_section = true});
    ASSERT_TRUE(run);
    EXPECT_EQ(run->telemetry.begun_in, 1U);
    EXPECT_FALSE(run->telemetry.section_reached[0]);
    EXPECT_EQ(run->telemetry.section_seconds[0], 0);
    std::uint64_t diverged = 1;
    const auto again = replay(level, run->recording, &diverged);
    ASSERT_TRUE(again) << again.error().text;
    EXPECT_EQ(diverged, 0U);
    EXPECT_EQ(to_json(*again), to_json(run->telemetry));
}

TEST(Campaign, has_explorers_in_every_section_for_the_same_time) {
    const auto level = test::gaps_lift_key_and_door();
    const auto found = run_campaign(level, {.bots = 2, .hours = 0.05});
    ASSERT_TRUE(found);
    std::vector<double> seconds(level->checkpoints.size(), 0);
    for (const PlayedRun& run : found->runs)
        if (run.telemetry.player == "explorer") seconds[run.telemetry.begun_in] += run.telemetry.seconds;
    for (const double stayed : seconds) EXPECT_NEAR(stayed, 30, 1);
}

// A run of an explorer in each of these sections, with so many deaths in it.
Findings explored(const std::vector<std::uint32_t>& deaths) {
    test::LevelMaker maker;
    for (std::size_t i = 1; i < deaths.size(); ++i)
        maker.level->checkpoints.push_back({.section = "part " + std::to_string(i), .order = int(i)});
    Findings findings{.level = maker.finish()};
    for (std::uint32_t i = 0; i < deaths.size(); ++i) {
        findings.runs.push_back({.telemetry = {.player = "explorer", .seconds = 200, .begun_in = i}, .recording = {}});
        findings.runs.back().telemetry.section_deaths.resize(deaths.size());
        findings.runs.back().telemetry.section_deaths[i] = deaths[i];
    }
    return findings;
}

TEST(Campaign, finds_fault_with_deaths_nowhere_or_most_of_them_in_one_section) {
    EXPECT_TRUE(explored({4, 5, 3}).is_fine());
    EXPECT_EQ(explored({4, 15, 3}).death_fault(), "part 1: more than half of all deaths are here");
    EXPECT_FALSE(explored({4, 15, 3}).is_fine());
    EXPECT_FALSE(explored({0, 0, 0}).is_fine());
    Findings some = explored({4, 15, 3});
    some.runs.pop_back();
    EXPECT_TRUE(some.death_fault().empty()) << "where nobody was there is nothing to say";
}

TEST(Campaign, plays_the_same_on_one_thread_and_on_two) {
    const auto level = test::gaps_lift_key_and_door();
    const auto json = [&](int threads) {
        const auto found = run_campaign(level, {.bots = 3, .hours = 0.01, .threads = threads, .explorer_run = 20});
        EXPECT_TRUE(found);
        std::string all;
        for (const PlayedRun& run : found->runs) all += to_json(run.telemetry);
        return all;
    };
    EXPECT_EQ(json(1), json(2));
}

TEST(Campaign, finds_a_made_level_fine_and_a_pit_not) {
    const auto fine = run_campaign(test::gaps_lift_key_and_door(), {.bots = 3, .hours = 0, .explorer_run = 20});
    ASSERT_TRUE(fine);
    EXPECT_TRUE(fine->unreachable.empty()) << fine->unreachable;
    EXPECT_EQ(fine->navigators_won(), fine->navigators());
    EXPECT_TRUE(fine->is_fine());
    const auto broken = run_campaign(test::pit(), {.bots = 2, .hours = 0, .explorer_run = 60});
    ASSERT_TRUE(broken);
    EXPECT_FALSE(broken->unreachable.empty());
    EXPECT_FALSE(broken->is_fine());
}

}  // namespace
}  // namespace surefoot::playtest
