#include "playtest/report.hpp"

#include <algorithm>
#include <filesystem>
#include <gtest/gtest.h>

#include "game/whole_file.hpp"
#include "made_levels.hpp"

namespace surefoot::playtest {
namespace {

TEST(Report, is_one_page_that_refers_to_nothing_on_a_network) {
    std::vector<Findings> levels;
    levels.push_back(*run_campaign(test::pit(), {.bots = 2, .hours = 0, .explorer_run = 30}));
    const std::string folder = testing::TempDir() + "surefoot_report_test";
    const std::string path = folder + "/report.html";
    ASSERT_TRUE(write_report(path, levels));
    const std::string page = *game::read_whole(path);
    EXPECT_EQ(page.find("http"), std::string::npos);
    EXPECT_EQ(page.find("<script"), std::string::npos);
    EXPECT_NE(page.find("data:image/png;base64,iVBOR"), std::string::npos);
    EXPECT_NE(page.find("goal unreachable"), std::string::npos);
    EXPECT_NE(page.find("Where they stood"), std::string::npos);
    // Every file that it links to lies beside it, and can be read.
    std::size_t links = 0;
    for (std::size_t at = page.find("href=\"report_files/"); at != std::string::npos;
         at = page.find("href=\"report_files/", at + 1)) {
        const std::size_t begin = at + 6;
        const std::string file = folder + "/" + page.substr(begin, page.find('"', begin) - begin);
        EXPECT_TRUE(std::filesystem::exists(file)) << file;
        const bool reads =
            file.ends_with(".run") ? game::read_recording(file).has_value() : read_step_capture(file).has_value();
        EXPECT_TRUE(reads) << file;
        ++links;
    }
    EXPECT_GT(links, 0U);
    std::filesystem::remove_all(folder);
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
