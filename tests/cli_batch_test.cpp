// Batches of sweeps: a line in, a line out, whatever the line.
#include "cli_program.hpp"

using nlohmann::json;

namespace {

const std::string good = R"({"shape":{"ellipsoid":[0.4,0.9,0.4]},"from":[0,3,0],"to":[0,-3,0]})";

class Batch : public Cli {
protected:
    /// The one answer to one line.
    json answer(const std::string& line, const std::string& options = "") const {
        const std::vector<std::string> lines =
            lines_of(run("sweep " + floor_ + " --batch - " + options, line + "\n").out);
        EXPECT_EQ(lines.size(), 1U) << line;
        return lines.empty() ? json() : json::parse(lines[0]);
    }
};

}  // namespace

TEST_F(Batch, answers_come_in_the_order_of_the_lines_and_bad_lines_do_not_stop_it) {
    const std::string miss = R"({"shape":{"sphere":[0.5]},"from":[0,3,0],"to":[0,2,0]})";
    const Outcome batch = run("sweep " + floor_ + " --batch -", good + "\nnonsense\n" + miss + "\n\n" + good);
    EXPECT_EQ(batch.code, 1);
    EXPECT_TEXT(batch.err, "2 of 5 lines");
    const std::vector<std::string> lines = lines_of(batch.out);
    ASSERT_EQ(lines.size(), 5U);
    EXPECT_NEAR(json::parse(lines[0])["t"].get<double>(), 0.35, 1e-9);
    EXPECT_TEXT(lines[1], R"({"error":"line 2: not JSON)");
    EXPECT_EQ(lines[2], R"({"hit":false})");
    EXPECT_TEXT(lines[3], R"({"error":"line 4: empty)");
    EXPECT_EQ(lines[4], lines[0]);
}

TEST_F(Batch, a_file_is_as_good_as_standard_input_and_a_clean_batch_exits_with_0) {
    const std::string text = good + "\r\n" + good + "\n";
    const Outcome piped = run("sweep " + floor_ + " --batch -", text);
    const Outcome filed = run("sweep " + floor_ + " --batch " + write("batch.jsonl", text));
    EXPECT_EQ(piped.code, 0) << piped.err;
    EXPECT_EQ(filed.code, 0) << filed.err;
    EXPECT_EQ(piped.out, filed.out);
    EXPECT_EQ(run("sweep " + floor_ + " --batch -", "").out, "");
}

TEST_F(Batch, a_line_answers_as_a_single_sweep_does) {
    const Outcome single = run("sweep " + floor_ + " --shape ellipsoid:0.4,0.9,0.4 --from 0,3,0 --to 0,-3,0 --json");
    EXPECT_EQ(run("sweep " + floor_ + " --batch -", good).out, single.out);
}

TEST_F(Batch, every_shape_is_understood) {
    for (const std::string shape :
         {R"({"ellipsoid":[0.4,0.9,0.4]})", R"({"sphere":[0.9]})", R"({"sphere":0.9})", R"({"capsule":[0.4,0.5]})",
          R"({"box":[0.4,0.9,0.4]})", R"({"cylinder":[0.4,0.9]})"})
        EXPECT_NEAR(answer(R"({"shape":)" + shape + R"(,"from":[0,3,0],"to":[0,-3,0]})")["t"].get<double>(), 0.35, 1e-9)
            << shape;
    // A cone stands on its apex, which is its reference point.
    const json cone = answer(R"({"shape":{"cone":[0.4,1.8]},"from":[0,3,0],"to":[0,-3,0]})");
    EXPECT_NEAR(cone["t"].get<double>(), 0.5, 1e-9);
}

TEST_F(Batch, rotate_and_one_sided_are_optional_per_line) {
    const std::string box = R"({"shape":{"box":[0.5,2,0.5]},"from":[0,2.5,0],"to":[4,2.5,0])";
    EXPECT_FALSE(answer(box + "}")["hit"].get<bool>());
    EXPECT_TRUE(answer(box + R"(,"rotate":[1,0,0,1]})")["hit"].get<bool>());
    const std::string behind = R"({"shape":{"sphere":[0.5]},"from":[8,2,0],"to":[1,2,0])";
    EXPECT_TRUE(answer(behind + "}")["hit"].get<bool>());
    EXPECT_FALSE(answer(behind + R"(,"one_sided":true})")["hit"].get<bool>());
    EXPECT_FALSE(answer(behind + "}", "--one-sided")["hit"].get<bool>());
    EXPECT_TRUE(answer(behind + R"(,"one_sided":false})", "--one-sided")["hit"].get<bool>());
}

TEST_F(Batch, the_command_line_speaks_for_lines_that_say_nothing) {
    const json by_option = answer(R"({"from":[0,3,0],"to":[0,-3,0]})", "--shape sphere:0.9");
    EXPECT_NEAR(by_option["t"].get<double>(), 0.35, 1e-9);
    EXPECT_TEXT(answer(R"({"from":[0,3,0],"to":[0,-3,0]})")["error"].get<std::string>(), "\"shape\" is missing");
}

TEST_F(Batch, numbers_are_the_doubles_nearest_to_their_decimals) {
    // The same numbers written in other ways, one with more digits than any double has.
    const json up = answer(
        R"({"shape":{"sphere":[0.5]},"from":[0,9.007199254740993,0],"to":[0,-9.00719925474099200000000000001,0]})");
    const json down =
        answer(R"({"shape":{"sphere":[0.5]},"from":[0,9007199254740993E-15,0],"to":[0,-9.007199254740992,0]})");
    EXPECT_EQ(up, down);
    const json hit = answer(R"({"shape":{"sphere":[0.1]},"from":[0.1,0.7,0.3],"to":[0.1,-0.7,0.3]})");
    EXPECT_EQ(hit["point"][0].get<double>(), 0.1);
    EXPECT_EQ(hit["point"][2].get<double>(), 0.3);
}

TEST_F(Batch, every_bad_line_says_what_is_wrong) {
    const std::vector<std::pair<std::string, std::string>> bad{
        {"[1,2]", "not an object"},
        {"{", "not JSON"},
        {good + good, "not JSON"},
        {R"({"shape":{"sphere":[0.5]},"from":[0,3,0],"to":[0,NaN,0]})", "not JSON"},
        {R"({"shape":{"sphere":[0.5]},"from":[0,3,0],"to":[0,1e999,0]})", "1e999"},
        {R"({"shape":{"sphere":[0.5]},"from":[0,3,0],"to":[0,2e9,0]})", "1e9"},
        {R"({"shape":{"sphere":[0]},"from":[0,3,0],"to":[0,2,0]})", "1e-6"},
        {R"({"shape":{"sphere":[-1]},"from":[0,3,0],"to":[0,2,0]})", "1e-6"},
        {R"({"shape":{"box":[1,1,1e-5]},"from":[0,3,0],"to":[0,2,0]})", "1e4"},
        {R"({"shape":{"cube":[1]},"from":[0,3,0],"to":[0,2,0]})", "no shape 'cube'"},
        {R"({"shape":{"box":[1,1]},"from":[0,3,0],"to":[0,2,0]})", "[hx,hy,hz]"},
        {R"({"shape":"sphere","from":[0,3,0],"to":[0,2,0]})", "\"shape\" must be"},
        {R"({"shape":{"sphere":[1],"box":[1,1,1]},"from":[0,3,0],"to":[0,2,0]})", "\"shape\" must be"},
        {R"({"shape":{"sphere":[1]},"from":[0,3],"to":[0,2,0]})", "\"from\" must be [x,y,z]"},
        {R"({"shape":{"sphere":[1]},"from":[0,3,"0"],"to":[0,2,0]})", "\"from\" must be [x,y,z]"},
        {R"({"shape":{"sphere":[1]},"from":[0,3,0]})", "\"to\" is missing"},
        {R"({"shape":{"sphere":[1]},"from":[0,3,0],"to":[0,2,0],"rotate":[0,0,0,0]})", "rotate"},
        {R"({"shape":{"sphere":[1]},"from":[0,3,0],"to":[0,2,0],"rotate":[1,0,0]})", "[w,x,y,z]"},
        {R"({"shape":{"sphere":[1]},"from":[0,3,0],"to":[0,2,0],"one_sided":1})", "true or false"},
        {R"({"shape":{"sphere":[1]},"from":[0,3,0],"to":[0,2,0],"onesided":true})", "\"onesided\" means nothing"},
        {R"({"shape":{"sphere":[1]},"from":[0,3,0],"from":[0,4,0],"to":[0,2,0]})", "twice"},
        {"\xff\xfe", "not JSON"},
        {std::string(2U << 20U, ' '), "longer than"},
        {std::string(100000, '['), "not JSON"},
    };
    std::string input;
    for (const auto& [line, words] : bad) input += line + "\n";
    const Outcome batch = run("sweep " + floor_ + " --batch -", input);
    EXPECT_EQ(batch.code, 1);
    const std::vector<std::string> lines = lines_of(batch.out);
    ASSERT_EQ(lines.size(), bad.size());
    for (std::size_t i = 0; i < bad.size(); ++i) {
        const json answer = json::parse(lines[i]);
        ASSERT_TRUE(answer.contains("error")) << bad[i].first.substr(0, 200) << lines[i];
        const auto text = answer["error"].get<std::string>();
        EXPECT_EQ(text.rfind("line " + std::to_string(i + 1) + ": ", 0), 0U) << text;
        EXPECT_TEXT(text, bad[i].second);
    }
}

TEST_F(Batch, a_program_at_the_other_end_of_a_pipe_can_wait_for_each_answer) {
    // A shell that writes a line, waits for its answer, and only then writes the next.
    const std::string file = write("talk.sh", "coproc sweeps { '" SUREFOOT_PROGRAM "' sweep '" + floor_ +
                                                  "' --batch -; }\nfor i in 1 2 3; do\n  echo '" + good +
                                                  "' >&\"${sweeps[1]}\"\n"
                                                  "  read -r -t 20 answer <&\"${sweeps[0]}\" || exit 9\ndone\n");
    EXPECT_EQ(WEXITSTATUS(std::system(("bash '" + file + "'").c_str())), 0);
}
