// surefoot bench, as a person runs it. Nothing here looks at a time.
#include "cli_program.hpp"

namespace {

using json = nlohmann::json;

TEST_F(Cli, bench_times_every_question_in_small_scenes) {
    const Outcome outcome = run("bench --small --json");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const json report = json::parse(outcome.out);
    ASSERT_EQ(report["scenes"].size(), 3U);
    EXPECT_EQ(report["rollback"]["first_differs"], nullptr);
    for (const json& scene : report["scenes"]) {
        EXPECT_GT(scene["triangles"], 1000);
        EXPECT_GE(scene["rows"].size(), 30U) << scene["scene"];
        for (const json& row : scene["rows"]) EXPECT_EQ(row["wrong"], 0) << row["question"];
    }
}

TEST_F(Cli, bench_takes_a_level_and_only_some_questions) {
    const Outcome outcome = run("bench '" + floor_ + "' --small --only \"short sphere sweep\"");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("short sphere sweep"), std::string::npos);
    EXPECT_EQ(outcome.out.find("box sweep"), std::string::npos);
}

TEST_F(Cli, bench_goes_back_and_comes_to_the_same_hashes) {
    const Outcome outcome = run("bench --rollback --small");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("rollback: 64 characters on 8 moving lifts"), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find("24 hashes compared, all equal"), std::string::npos) << outcome.out;
    EXPECT_EQ(outcome.out.find("triangles, built in"), std::string::npos) << "no scene was asked for";
}

TEST_F(Cli, bench_of_a_level_that_is_not_there_says_so) {
    const Outcome outcome = run("bench nowhere.obj");
    EXPECT_EQ(outcome.code, 3);
    EXPECT_NE(outcome.err.find("nowhere.obj"), std::string::npos);
}

}  // namespace
