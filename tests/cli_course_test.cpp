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

TEST_F(CliCourse, another_shape_walks_and_what_does_not_apply_to_it_is_told_with_the_reason_and_counted_apart) {
    const Outcome cone = run("course --shape cone --scene floor-stand");
    EXPECT_EQ(cone.code, 0) << cone.out << cone.err;
    EXPECT_TEXT(cone.out, "ours passes 1 of 1 scenes");
    const Outcome ball = run("course --shape sphere --scene lintel --scene floor-stand");
    EXPECT_EQ(ball.code, 0) << ball.out << ball.err;
    EXPECT_TEXT(ball.out, "does not apply to this shape: the lintel leaves 1.3 m");
    EXPECT_TEXT(ball.out, "ours passes 1 of 1 scenes; 1 does not apply to this shape");
    EXPECT_TEXT(run("course --shape sphere --scene lintel --list").out, "does not apply to this shape: the lintel");
}

TEST_F(CliCourse, all_shapes_stand_side_by_side_and_are_a_line_of_json_each) {
    const Outcome all = run("course --shape all --scene lintel --scene floor-stand");
    EXPECT_EQ(all.code, 0) << all.out << all.err;
    EXPECT_TEXT(all.out, "does not apply");
    EXPECT_TEXT(all.out, "ours passes 2 of 2 scenes with the shape cone");
    const auto lines = lines_of(run("course --shape sphere --shape box --scene lintel --json").out);
    ASSERT_EQ(lines.size(), 2U);
    const auto ball = nlohmann::json::parse(lines[0]), box = nlohmann::json::parse(lines[1]);
    EXPECT_EQ(ball["shape"], "sphere");
    EXPECT_EQ(ball["apply"], 0);
    EXPECT_EQ(ball["passed"], 0);
    EXPECT_EQ(ball["scenes"][0]["applies"], false);
    EXPECT_EQ(box["shape"], "box");
    EXPECT_EQ(box["scenes"][0]["applies"], true);
    EXPECT_EQ(box["passed"], 1);
}

TEST_F(CliCourse, a_shape_that_is_none_and_shapes_beside_several_movers_are_refused) {
    const Outcome none = run("course --shape pyramid --scene lintel");
    EXPECT_EQ(none.code, 2);
    EXPECT_TEXT(none.err, "there is no shape pyramid: capsule, ellipsoid, sphere, box, cylinder, cone, or all");
    EXPECT_EQ(run("course --shape all --mover ours --mover textbook --scene lintel").code, 2);
}

TEST_F(CliCourse, each_scene_tells_whether_it_fails_the_broken_mover_that_it_is_about) {
    const Outcome course = run("course --catches --shape box --shape sphere --scene convex-edge --scene lintel");
    EXPECT_EQ(course.code, 0) << course.out << course.err;
    const auto lines = lines_of(course.out);
    ASSERT_EQ(lines.size(), 4U) << "a heading, two of the box and one of the ball\n" << course.out;
    EXPECT_TEXT(lines[1], "convex-edge");
    EXPECT_TEXT(lines[1], "fails");
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
