// surefoot cook, cooked levels as LEVEL, and the cache.
#include "cli_program.hpp"

namespace {

class CliCook : public Cli {
protected:
    std::size_t cached() const {
        std::size_t count = 0;
        std::error_code none;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_ / "cache", none))
            count += entry.is_regular_file() ? 1 : 0;
        return count;
    }
    std::string path(const std::string& name) const { return (folder_ / name).string(); }
};

TEST_F(CliCook, a_cooked_level_answers_as_the_one_it_was_made_from) {
    const Outcome cooked = run("cook " + floor_ + " -o " + path("floor.surefoot"));
    ASSERT_EQ(cooked.code, 0) << cooked.err;
    EXPECT_TEXT(cooked.out, "4 triangles");
    EXPECT_TEXT(cooked.out, "open edges");
    const std::string question = " --shape sphere:0.5 --from 0,1,0 --to 9,1,0 --json";
    const Outcome from_file = run("sweep " + path("floor.surefoot") + question);
    EXPECT_EQ(from_file.code, 0) << from_file.err;
    EXPECT_EQ(from_file.out, run("sweep " + floor_ + question).out);
    EXPECT_TEXT(from_file.out, "\"hit\":true");
}

TEST_F(CliCook, findings_are_printed_as_json_with_their_places) {
    const Outcome cooked = run("cook " + floor_ + " -o " + path("f.surefoot") + " --json");
    ASSERT_EQ(cooked.code, 0) << cooked.err;
    const auto json = nlohmann::json::parse(cooked.out);
    EXPECT_EQ(json["report"]["triangles"], 4);
    EXPECT_EQ(json["report"]["open_edges"]["count"], 8);
    EXPECT_EQ(json["report"]["open_edges"]["places"].size(), 8U);
    EXPECT_EQ(json["report"]["degenerate"]["count"], 0);
    EXPECT_EQ(json["bytes"], std::filesystem::file_size(path("f.surefoot")));
}

TEST_F(CliCook, several_files_become_one_level_with_surfaces_by_name) {
    const std::string more =
        write("more.obj", "v 0 1 0\nv 0 1 1\nv 1 1 0\nusemtl brick\nf 1 2 3\nusemtl ice\nf 1 2 3\n");
    ASSERT_EQ(run("cook " + floor_ + " " + more + " -o " + path("both.surefoot")).code, 0);
    const auto json = nlohmann::json::parse(run("info " + path("both.surefoot") + " --json").out);
    EXPECT_EQ(json["triangles"], 6);
    std::map<std::string, int> triangles;
    for (const auto& surface : json["surfaces"]) triangles[surface["name"]] = surface["triangles"];
    EXPECT_EQ(triangles, (std::map<std::string, int>{{"stone", 2}, {"brick", 3}, {"ice", 1}}));
}

TEST_F(CliCook, info_shows_sections_and_findings) {
    ASSERT_EQ(run("cook " + floor_ + " -o " + path("f.surefoot")).code, 0);
    const Outcome info = run("info " + path("f.surefoot"));
    EXPECT_EQ(info.code, 0);
    EXPECT_TEXT(info.out, "surefoot/leaves");
    EXPECT_TEXT(info.out, "a triangle");
    EXPECT_TEXT(info.out, "8 open edges");
    EXPECT_TEXT(info.out, "stone (1)");
}

TEST_F(CliCook, a_level_is_cooked_once_and_again_when_its_content_changes) {
    EXPECT_EQ(cached(), 0U);
    EXPECT_TEXT(run("info " + floor_).out, "read in");
    EXPECT_EQ(cached(), 1U);
    const Outcome again = run("info " + floor_);
    EXPECT_TEXT(again.out, "cooked before");
    EXPECT_TEXT(again.out, "stone (1)");
    EXPECT_EQ(cached(), 1U);
    EXPECT_TEXT(run("info " + floor_ + " --scale 2").out, "read in");
    EXPECT_EQ(cached(), 2U);
    std::ofstream(floor_, std::ios::app) << "f 1 2 5\n";
    EXPECT_TEXT(run("info " + floor_).out, "triangles   5");
    EXPECT_EQ(cached(), 3U);
    EXPECT_TEXT(run("info " + floor_ + " --no-cache").out, "read in");
}

TEST_F(CliCook, a_damaged_file_in_the_cache_is_cooked_again) {
    ASSERT_EQ(run("info " + floor_).code, 0);
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_ / "cache"))
        if (entry.is_regular_file()) std::filesystem::resize_file(entry.path(), 100);
    const Outcome again = run("info " + floor_);
    EXPECT_EQ(again.code, 0) << again.err;
    EXPECT_TEXT(again.out, "read in");
    EXPECT_TEXT(run("info " + floor_).out, "cooked before");
}

TEST_F(CliCook, mistakes_are_told_with_their_cure) {
    ASSERT_EQ(run("cook " + floor_ + " -o " + path("f.surefoot")).code, 0);
    const Outcome twice = run("cook " + path("f.surefoot") + " -o " + path("g.surefoot"));
    EXPECT_EQ(twice.code, 2);
    EXPECT_TEXT(twice.err, "cooked already");
    EXPECT_EQ(run("info " + path("f.surefoot") + " --scale 2").code, 2);
    const Outcome near = run("info " + path("ff.surefoot"));
    EXPECT_EQ(near.code, 3);
    EXPECT_TEXT(near.err, "did you mean");
    const Outcome nowhere = run("cook " + floor_ + " -o " + path("no/where.surefoot"));
    EXPECT_EQ(nowhere.code, 3);
    EXPECT_TEXT(nowhere.err, "folder");
    write("f.surefoot", "not a level");
    const Outcome other = run("info " + path("f.surefoot"));
    EXPECT_EQ(other.code, 3);
    EXPECT_TEXT(other.err, "surefoot cook");
}

}  // namespace
