// The platformer as a program: what it says and what it ends with when something cannot be had, and whose settings it
// keeps.
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <string>

namespace surefoot::playground {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& path) {
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

class PlatformerProgram : public testing::Test {
protected:
    void SetUp() override {
        folder = fs::path(testing::TempDir()) /
                 (std::string("surefoot_program_") + testing::UnitTest::GetInstance()->current_test_info()->name());
        fs::remove_all(folder);
        fs::create_directories(folder / "config/surefoot");
    }
    void TearDown() override { fs::remove_all(folder); }

    /// Runs it in the folder; returns what it ends with, and keeps what it says in `said`.
    int run(const std::string& words) {
        const std::string command = "cd '" + folder.string() + "' && XDG_CONFIG_HOME='" + (folder / "config").string() +
                                    "' '" SUREFOOT_PLATFORMER "' --headless --size 320x240 " + words +
                                    " 2> said.txt > /dev/null";
        const int status = std::system(command.c_str());
        said = text_of(folder / "said.txt");
        return status / 256;
    }
    void put(const std::string& name, const std::string& bytes) {
        std::ofstream(folder / name, std::ios::binary) << bytes;
    }

    fs::path folder;
    std::string said;
};

// The defect: all of these ended with 0 and without a word.
TEST_F(PlatformerProgram, ends_with_3_and_the_reason_when_what_was_named_cannot_be_had) {
    put("bad.glb", "this is no level");
    put("empty.run", "");
    put("cut.run", "SFRUN");
    for (const auto& [words, reason] : {std::pair{"bad.glb", "bad.glb"},
                                        {"empty.run", "empty.run"},
                                        {"cut.run", "cut.run"},
                                        {"no-such-level", "no-such-level"},
                                        {"first-steps --beat 50", "no beat 50"},
                                        {"none.glb", "none.glb"}}) {
        EXPECT_EQ(run(std::string(words) + " --frames 5"), 3) << words;
        EXPECT_NE(said.find(reason), std::string::npos) << words << ": " << said;
        EXPECT_EQ(said.rfind("surefoot-platformer: ", 0), 0U) << said;
    }
    EXPECT_EQ(run("first-steps --frames 5"), 0) << said;
    EXPECT_EQ(run("--beat 3"), 2) << "of which level?";
}

// The defect: a bare name was looked for among the levels that came with the program.
TEST_F(PlatformerProgram, finds_a_level_in_the_folder_that_one_stands_in) {
    fs::copy_file(SUREFOOT_LEVELS_DIR "/platformer/first-steps.glb", folder / "t.glb");
    EXPECT_EQ(run("t.glb --frames 5"), 0) << said;
}

// The defect: it wrote the playground's settings into the file that was named, and its own into the playground's.
TEST_F(PlatformerProgram, keeps_its_own_settings_in_the_file_that_is_named_and_leaves_the_playgrounds_alone) {
    put("config/surefoot/playground.json", "{\"width\": 1111}");
    put("set.json", "{\"volume\": 0.25, \"minimap\": false}");
    put("keys.txt", "wait 3\nclick \"Options\"\nwait 2\nkey Escape\nwait 3\nquit\n");
    EXPECT_EQ(run("--settings set.json --script keys.txt"), 0) << said;
    EXPECT_NE(text_of(folder / "set.json").find("\"volume\": 0.25"), std::string::npos) << text_of(folder / "set.json");
    EXPECT_NE(text_of(folder / "set.json").find("bindings"), std::string::npos) << "written anew, by the game";
    EXPECT_EQ(text_of(folder / "config/surefoot/playground.json"), "{\"width\": 1111}");
    EXPECT_FALSE(fs::exists(folder / "config/surefoot/platformer.json"));
}

// The defect: it ended with 0, and the message came from the playground.
TEST_F(PlatformerProgram, ends_with_1_when_its_settings_could_not_be_kept) {
    put("a file", "");
    put("keys.txt", "wait 3\nclick \"Options\"\nwait 2\nkey Escape\nwait 3\nquit\n");
    EXPECT_EQ(run("--settings 'a file/set.json' --script keys.txt"), 1);
    EXPECT_NE(said.find("surefoot-platformer: "), std::string::npos) << said;
    EXPECT_EQ(said.find("playground"), std::string::npos) << said;
}

// The defect: there were no widgets, and nothing else was looked at: 'there are ' and nothing.
TEST_F(PlatformerProgram, tells_a_script_which_labels_there_are) {
    put("wrong.txt", "wait 3\nclick \"Optons\"\n");
    EXPECT_EQ(run("--script wrong.txt"), 1);
    EXPECT_NE(said.find("\"Options\""), std::string::npos) << said;
}

}  // namespace
}  // namespace surefoot::playground
