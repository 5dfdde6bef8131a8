#include "playtest/report/report.hpp"

#include <algorithm>
#include <filesystem>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "game/whole_file.hpp"
#include "made_levels.hpp"
#include "page_parts.hpp"

namespace surefoot::playtest {
namespace {

// Of runs into a pit that nobody gets out of, and a page of it.
const std::vector<Findings>& pits() {
    static const std::vector<Findings> levels{*run_campaign(test::pit(), {.bots = 2, .hours = 0, .explorer_run = 30})};
    return levels;
}
const Report& report_of_pits() {
    static const Report report = make_report(pits(), {}, "report_files");
    return report;
}

TEST(Report, is_one_page_that_refers_to_nothing_outside_of_itself) {
    const std::string& page = report_of_pits().html;
    EXPECT_TRUE(report_of_pits().files.empty());
    EXPECT_NE(page.find("goal unreachable"), std::string::npos);
    EXPECT_NE(page.find("Where they stood"), std::string::npos);
    std::size_t within = 0;
    for (const char* const attribute : {" href=\"", " src=\"", "url("})
        for (const std::string& to : test::all_between(page, attribute, "\"")) {
            EXPECT_TRUE(to.starts_with('#') || to.starts_with("data:")) << attribute << to.substr(0, 80);
            ++within;
        }
    EXPECT_GT(within, 5U);
    const auto scripts = test::all_between(page, "<script>", "</script>");
    ASSERT_EQ(scripts.size(), 1U);
    EXPECT_EQ(test::all_between(page, "<script", ">").size(), 1U) << "and none of elsewhere";
    for (const char* const word : {"import", "fetch", "XMLHttp", "WebSocket", "location"})
        EXPECT_EQ(scripts.front().find(word), std::string::npos) << word;
    EXPECT_EQ(page.find("http"), std::string::npos);
    EXPECT_EQ(page.find("@import"), std::string::npos);
}

TEST(Report, shows_frames_that_are_pictures_of_something) {
    const auto cards = test::all_between(report_of_pits().html, "<div class=\"incident\">", "<div class=\"incident");
    ASSERT_FALSE(cards.empty());
    const auto pictures = test::all_between(cards.front(), "src=\"data:image/png;base64,", "\"");
    const auto widths = test::all_between(cards.front(), "<img width=\"", "\"");
    ASSERT_EQ(pictures.size(), 3U);
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        const test::Decoded picture = test::decoded(test::bytes_of_base64(pictures[i]));
        EXPECT_EQ(std::to_string(picture.width), widths[i]);
        EXPECT_GT(picture.colours, 50U);
    }
}

TEST(Report, holds_the_replay_of_each_incident_that_plays_to_the_same_end) {
    const Findings& of = pits().front();
    const std::string& page = report_of_pits().html;
    std::size_t replays = 0;
    for (std::size_t run = 0; run < of.runs.size(); ++run) {
        const std::string link = "<a id=\"run-0-" + std::to_string(run) + "\"";
        const auto links = test::all_between(page, link, "</a>");
        if (links.empty()) continue;
        ASSERT_EQ(links.size(), 1U) << "each once";
        const auto data = test::all_between(links.front(), "data:application/octet-stream;base64,", "\"");
        const auto names = test::all_between(links.front(), "download=\"", "\"");
        ASSERT_EQ(data.size(), 1U);
        ASSERT_EQ(names.size(), 1U);
        const auto read = game::recording_of(test::bytes_of_base64(data.front()), names.front());
        ASSERT_TRUE(read) << read.error().text;
        const auto end_of = [&](const game::Recording& recording) {
            auto game = *game::start_of(of.level, recording);
            game::Player player(recording);
            while (player.tick(*game)) continue;
            EXPECT_EQ(player.diverged(), 0U);
            return game->hash();
        };
        EXPECT_EQ(end_of(*read), end_of(of.runs[run].recording));
        EXPECT_EQ(read->inputs, of.runs[run].recording.inputs);
        // Its incidents name the file, and the second from which it is watched.
        EXPECT_NE(page.find("<code>surefoot-platformer " + names.front() + " --from "), std::string::npos);
        ++replays;
    }
    EXPECT_GT(replays, 0U);
    // Whatever a card refers to is there.
    for (const std::string& id : test::all_between(page, "data-run=\"", "\""))
        EXPECT_NE(page.find("<a id=\"" + id + "\""), std::string::npos) << id;
}

TEST(Report, says_of_a_level_that_nobody_played_just_that) {
    const Findings nobody{.level = pits().front().level};
    const std::string page = make_report({&nobody, 1}, {}, "files").html;
    EXPECT_NE(page.find("Nobody has played it."), std::string::npos);
    EXPECT_EQ(page.find("nobody dies anywhere"), std::string::npos);
    EXPECT_EQ(page.find("Never taken"), std::string::npos);
    EXPECT_NE(report_of_pits().html.find("Never taken"), std::string::npos);
}

TEST(Report, holds_the_step_of_a_stuck_moment) {
    const auto steps = test::all_between(report_of_pits().html, "<a id=\"step-", "</a>");
    ASSERT_FALSE(steps.empty());
    const auto data = test::all_between(steps.front(), "base64,", "\"");
    const auto capture = parse_step_capture(test::bytes_of_base64(data.at(0)));
    ASSERT_TRUE(capture) << capture.error().text;
    EXPECT_TRUE(replay(*capture).is_same());
}

TEST(Report, plays_the_last_seconds_on_the_plan) {
    const auto clips = test::all_between(report_of_pits().html, "data-clip='", "'");
    ASSERT_FALSE(clips.empty());
    for (const std::string& clip : clips) {
        const auto json = nlohmann::json::parse(clip, nullptr, false);
        ASSERT_TRUE(json.is_object());
        EXPECT_EQ(json.at("p").size() % 4, 0U);
        EXPECT_GT(json.at("p").size(), 4U * 20);
        EXPECT_NEAR(json.at("dt").get<double>(), 4.0 / 60, 1e-4);
    }
}

TEST(Report, that_would_be_too_long_says_what_lies_beside_it) {
    const std::string folder = testing::TempDir() + "surefoot_report_test";
    ASSERT_TRUE(write_report(folder + "/report.html", pits(), {}, {.most_bytes = 1000}));
    const std::string page = *game::read_whole(folder + "/report.html");
    EXPECT_EQ(page.find("<div class=\"incident\">"), std::string::npos) << "no frames found room";
    EXPECT_NE(page.find("lie beside it"), std::string::npos);
    std::size_t beside = 0;
    for (const std::string& name : test::all_between(page, "href=\"report_files/", "\"")) {
        const std::string file = folder + "/report_files/" + name;
        EXPECT_TRUE(file.ends_with(".run") ? game::read_recording(file).has_value()
                                           : read_step_capture(file).has_value())
            << file;
        ++beside;
    }
    EXPECT_GT(beside, 0U);
    std::filesystem::remove_all(folder);
}

TEST(Report, has_as_many_frames_as_are_asked_for_and_says_so) {
    const Report report = make_report(pits(), {}, "files", {.framed = 0});
    EXPECT_EQ(report.html.find("<div class=\"incident\">"), std::string::npos);
    EXPECT_NE(report.html.find(" 0 with frames"), std::string::npos);
    EXPECT_EQ(report_of_pits().html.find(" 0 with frames"), std::string::npos);
}

TEST(Report, finds_fault_with_a_section_of_more_than_half_of_all_deaths_and_with_none_anywhere) {
    const std::vector<std::uint32_t> uneven{1, 9, 2};
    EXPECT_EQ(death_verdict(uneven, 0), "");
    EXPECT_EQ(death_verdict(uneven, 1), "more than half of all deaths are here");
    const std::vector<std::uint32_t> even{3, 4, 3};
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(death_verdict(even, i), "");
    const std::vector<std::uint32_t> none{0, 0};
    EXPECT_EQ(death_verdict(none, 0), "nobody dies anywhere: is it too easy?");
}

TEST(Report, shows_what_people_wrote_as_text_and_not_as_tags) {
    Session session;
    session.start.player = "A<b>";
    session.notes.push_back({.run = "made", .seconds = 61.5, .text = "looks for the key & sighs"});
    const Report report = make_report({}, {&session, 1}, "files");
    EXPECT_NE(report.html.find("A&lt;b&gt;"), std::string::npos);
    EXPECT_NE(report.html.find("made at 1:01.5: looks for the key &amp; sighs"), std::string::npos);
}

}  // namespace
}  // namespace surefoot::playtest
