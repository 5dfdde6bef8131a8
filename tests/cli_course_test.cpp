// surefoot course.
#include "cli_program.hpp"

namespace {

class CliCourse : public Cli {};

TEST_F(CliCourse, a_scene_that_is_passed_ends_well) {
    const Outcome course = run("course --scene floor-seams");
    EXPECT_EQ(course.code, 0) << course.out << course.err;
    EXPECT_TEXT(course.out, "floor-seams  passes");
    EXPECT_TEXT(course.out, "ours passes 1 of 1 scenes");
}

TEST_F(CliCourse, a_missed_bar_is_told_with_its_measure_and_its_run) {
    const Outcome course = run("course --scene convex-edge --mover broken-stop");
    EXPECT_EQ(course.code, 1);
    EXPECT_TEXT(course.out, "FAILS");
    EXPECT_TEXT(course.out, "short of the way round");
    EXPECT_TEXT(course.out, "broken-stop passes 0 of 1 scenes");
}

TEST_F(CliCourse, several_movers_stand_side_by_side_and_only_ours_decides) {
    const Outcome course = run("course --scene convex-edge --mover ours --mover broken-stop");
    EXPECT_EQ(course.code, 0) << course.out;
    EXPECT_TEXT(course.out, "ours passes 1 of 1");
    EXPECT_TEXT(course.out, "broken-stop passes 0 of 1");
}

TEST_F(CliCourse, json_is_a_line_for_each_mover) {
    const Outcome course = run("course --scene convex-edge --mover ours --mover broken-stop --json");
    const auto lines = lines_of(course.out);
    ASSERT_EQ(lines.size(), 2U);
    const auto broken = nlohmann::json::parse(lines[1]);
    EXPECT_EQ(broken["mover"], "broken-stop");
    EXPECT_EQ(broken["passed"], 0);
    EXPECT_EQ(broken["scenes"][0]["scene"], "convex-edge");
    EXPECT_EQ(nlohmann::json::parse(lines[0])["scenes"][0]["passes"], true);
}

TEST_F(CliCourse, the_list_tells_scenes_bars_reasons_and_movers) {
    const Outcome course = run("course --list --scene corners");
    EXPECT_EQ(course.code, 0);
    EXPECT_TEXT(course.out, "corners: corners of 10 to 170 degrees");
    EXPECT_TEXT(course.out, "zero from the second tick on");
    EXPECT_TEXT(course.out, "fails broken-");
    EXPECT_TEXT(course.out, "broken-seams: believes the normals of inner edges");
}

TEST_F(CliCourse, a_track_is_every_tick_of_a_run) {
    const Outcome course = run("course --scene floor-stand --run 'a seam' --track");
    EXPECT_EQ(course.code, 0);
    const auto lines = lines_of(course.out);
    ASSERT_EQ(lines.size(), 1U + 1 + 30 + 180) << "a heading, the start, half a second and three";
    EXPECT_TEXT(lines[1], "ours,floor-stand,\"a seam\",-0.5,0.5,");
}

TEST_F(CliCourse, a_program_of_yours_is_scored) {
    const Outcome course = run("course --scene corners --exec '" SUREFOOT_COURSE_MOVER "'");
    EXPECT_EQ(course.code, 0) << course.out << course.err;
    const Outcome gone = run("course --scene corners --exec /none/such");
    EXPECT_EQ(gone.code, 3);
    EXPECT_TEXT(gone.err, "/none/such: the program has ended");
}

TEST_F(CliCourse, names_that_are_none_are_refused_in_words) {
    EXPECT_EQ(run("course --scene nowhere").code, 2);
    const Outcome nobody = run("course --mover nobody");
    EXPECT_EQ(nobody.code, 2);
    EXPECT_TEXT(nobody.err, "there is no mover nobody");
    EXPECT_EQ(run("course --scene corners --run nothing").code, 2);
}

}  // namespace
