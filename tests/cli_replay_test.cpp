// surefoot sweep --save, surefoot replay, surefoot prove --save-failures.
#include "cli_program.hpp"

namespace {

class CliReplay : public Cli {
protected:
    std::string saved(const std::string& question = "--shape sphere:0.5 --from 0,1,0 --to 9,1,0") const {
        const std::string file = (folder_ / "moment.json").string();
        const Outcome sweep = run("sweep " + floor_ + " " + question + " --save " + file + " --note 'the wall'");
        EXPECT_EQ(sweep.code, 0) << sweep.err;
        return file;
    }
    /// The moment with a piece of its text replaced.
    std::string changed(const std::string& piece, const std::string& by) const {
        std::string text = read_text(saved());
        const std::size_t at = text.find(piece);
        EXPECT_NE(at, text.npos) << text;
        return write("changed.json", text.replace(at, piece.size(), by));
    }
};

TEST_F(CliReplay, a_saved_sweep_is_told_in_words_and_is_the_same) {
    const Outcome replay = run("replay " + saved());
    EXPECT_EQ(replay.code, 0) << replay.err;
    EXPECT_TEXT(replay.out, "Note: the wall");
    EXPECT_TEXT(replay.out, "sphere of radius 0.5 m moves 9 m from (0, 1, 0) to (9, 1, 0)");
    EXPECT_TEXT(replay.out, "hit at t = 0.5\n");
    EXPECT_TEXT(replay.out, "the same, to the last bit");
    EXPECT_TEXT(replay.out, "that stops the motion");
    EXPECT_TEXT(replay.out, "The plane that decides is that of its face, with the normal (-1, 0, 0)");
}

TEST_F(CliReplay, a_moment_needs_its_level_no_more) {
    const std::string file = saved();
    std::filesystem::remove(floor_);
    EXPECT_EQ(run("replay " + file).code, 0);
}

TEST_F(CliReplay, a_free_way_is_told_by_what_keeps_apart) {
    const Outcome replay = run("replay " + saved("--shape sphere:0.5 --from 0,1,0 --to 3,1,0"));
    EXPECT_EQ(replay.code, 0) << replay.err;
    EXPECT_TEXT(replay.out, "no hit: the whole way is free");
    EXPECT_TEXT(replay.out, "Why: ");
}

TEST_F(CliReplay, a_start_in_touch_is_told) {
    const Outcome replay = run("replay " + saved("--shape sphere:0.5 --from 0,0.25,0 --to 0,-1,0"));
    EXPECT_TEXT(replay.out, "by 0.25 m; the motion would go deeper");
}

TEST_F(CliReplay, another_answer_is_named_and_fails) {
    const Outcome replay = run("replay " + changed("\"t\": 0.4", "\"t\": 0.2"));
    EXPECT_EQ(replay.code, 1);
    EXPECT_TEXT(replay.out, "DIFFERENT in t.");
    EXPECT_TEXT(replay.out, "hit at t = 0.3\n");
    EXPECT_TEXT(replay.out, "hit at t = 0.5\n");
}

TEST_F(CliReplay, json_is_a_line_for_each_file) {
    const std::string same = saved();
    const std::string other = changed("\"feature\": \"face\"", "\"feature\": \"edge\"");
    const Outcome replay = run("replay " + same + " " + other + " --json");
    EXPECT_EQ(replay.code, 1);
    const auto lines = lines_of(replay.out);
    ASSERT_EQ(lines.size(), 2U);
    const auto first = nlohmann::json::parse(lines[0]);
    EXPECT_EQ(first["same"], true);
    EXPECT_EQ(first["recorded"], first["answer"]);
    EXPECT_EQ(first["note"], "the wall");
    const auto second = nlohmann::json::parse(lines[1]);
    EXPECT_EQ(second["same"], false);
    EXPECT_EQ(second["differs"], nlohmann::json::array({"feature"}));
    EXPECT_TRUE(nlohmann::json::accept(read_text(same))) << "the file itself is JSON too";
}

TEST_F(CliReplay, a_file_that_is_no_moment_is_named_with_the_byte) {
    const Outcome replay = run("replay " + write("cut.json", "{\"surefoot_capture\": 1,") + " " + saved());
    EXPECT_EQ(replay.code, 3);
    EXPECT_TEXT(replay.err, "cut.json: no capture: byte 23");
    EXPECT_TEXT(replay.out, "the same, to the last bit");
    EXPECT_EQ(run("replay " + (folder_ / "none.json").string()).code, 3);
    EXPECT_EQ(run("replay").code, 2);
}

TEST_F(CliReplay, cpp_prints_a_test_that_is_called_as_the_file) {
    const Outcome replay = run("replay " + saved() + " --cpp");
    EXPECT_EQ(replay.code, 0) << replay.err;
    EXPECT_TEXT(replay.out, "TEST(Moments, moment) {");
    EXPECT_TEXT(replay.out, "// the wall\n");
    EXPECT_TEXT(replay.out, "surefoot::Sphere{0.5}");
}

TEST_F(CliReplay, saving_where_nothing_can_be_written_fails_as_a_file_does) {
    EXPECT_EQ(run("sweep " + floor_ + " --shape sphere:0.5 --from 0,1,0 --to 9,1,0 --save /none/moment.json").code, 3);
    EXPECT_EQ(run("sweep " + floor_ + " --batch - --save " + (folder_ / "m.json").string()).code, 2);
    EXPECT_EQ(run("sweep " + floor_ + " --shape sphere:0.5 --from 0,1,0 --to 9,1,0 --note alone").code, 2);
}

TEST_F(CliReplay, prove_saves_nothing_where_nothing_fails) {
    const std::string folder = (folder_ / "failures").string();
    const Outcome prove = run("prove --queries 200 --shape sphere --save-failures " + folder);
    EXPECT_EQ(prove.code, 0) << prove.out;
    EXPECT_TRUE(std::filesystem::is_empty(folder));
    EXPECT_EQ(run("prove --queries 200 --shape sphere --save-failures " + floor_ + "/x").code, 3);
}

}  // namespace
