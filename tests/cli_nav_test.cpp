// surefoot nav: ground kept in a file, and paths over it.
#include "cli_program.hpp"

namespace {

class CliNav : public Cli {
protected:
    std::string path(const std::string& name) const { return (folder_ / name).string(); }

    /// The floor with its wall, cooked.
    std::string cooked() const {
        const Outcome outcome = run("cook " + floor_ + " -o " + path("floor.surefoot"));
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        return path("floor.surefoot");
    }
};

TEST_F(CliNav, a_cooked_level_gets_its_ground_and_keeps_everything_else) {
    const std::string level = cooked();
    const auto before = nlohmann::json::parse(run("info " + level + " --json").out);
    const Outcome built = run("nav build " + level + " --cell 0.2");
    ASSERT_EQ(built.code, 0) << built.err;
    EXPECT_TEXT(built.out, "m2 of ground");
    EXPECT_TEXT(built.out, "radius 0.41 m");
    EXPECT_TEXT(run("info " + level).out, "surefoot/navigation");
    const auto after = nlohmann::json::parse(run("info " + level + " --json").out);
    EXPECT_EQ(after["triangles"], before["triangles"]);
    EXPECT_EQ(after["surfaces"], before["surfaces"]);
    const Outcome again = run("nav build " + level + " --cell 0.4 --json");
    ASSERT_EQ(again.code, 0) << again.err;
    const auto json = nlohmann::json::parse(again.out);
    EXPECT_EQ(json["file"], level);
    EXPECT_GT(json["area"], 300);
    EXPECT_LT(json["area"], 400);
    EXPECT_GT(json["polygons"], 0);
    EXPECT_EQ(json["agent"]["climb"], 0.4);
    const std::string text = read_text(level);
    EXPECT_EQ(text.find("navigation"), text.rfind("navigation")) << "there is one of it, not two";
}

TEST_F(CliNav, a_level_that_is_not_cooked_needs_a_name_for_what_is_written) {
    const Outcome nameless = run("nav build " + floor_);
    EXPECT_EQ(nameless.code, 2);
    EXPECT_TEXT(nameless.err, "-o LEVEL.surefoot");
    const Outcome named = run("nav build " + floor_ + " --cell 0.2 -o " + path("out.surefoot"));
    ASSERT_EQ(named.code, 0) << named.err;
    EXPECT_EQ(run("nav path " + path("out.surefoot") + " --from 0,0,0 --to 3,0,3").code, 0);
}

TEST_F(CliNav, a_path_goes_around_the_wall_and_says_so_when_there_is_none) {
    const std::string level = cooked();
    // With what no feet reach from the larger side of the wall: the other side.
    ASSERT_EQ(run("nav build " + level + " --cell 0.2 --unproved").code, 0);
    const Outcome straight = run("nav path " + level + " --from 0,0,0 --to 3,0,4 --json");
    ASSERT_EQ(straight.code, 0) << straight.err;
    const auto json = nlohmann::json::parse(straight.out);
    EXPECT_TRUE(json["found"]);
    EXPECT_FALSE(json["partial"]);
    EXPECT_NEAR(json["length"], 5, 0.1);
    EXPECT_EQ(json["corners"].size(), 2U);
    EXPECT_TRUE(json["links"].empty());
    // The wall cuts the floor from edge to edge.
    const Outcome half = run("nav path " + level + " --from 0,0,0 --to 8,0,0");
    EXPECT_EQ(half.code, 0);
    EXPECT_TEXT(half.out, "It does not get there");
    const Outcome none = run("nav path " + level + " --from 0,0,0 --to 80,0,0");
    EXPECT_EQ(none.code, 0);
    EXPECT_TEXT(none.out, "no ground to stand on at --to");
    const auto none_json = nlohmann::json::parse(run("nav path " + level + " --from 0,50,0 --to 3,0,0 --json").out);
    EXPECT_FALSE(none_json["found"]);
    EXPECT_EQ(none_json["no_ground_at"], "from");
}

TEST_F(CliNav, without_ground_in_the_file_or_for_another_body_it_is_found_anew) {
    const std::string question = " --from 0,0,0 --to 3,0,4 --cell 0.2 --json";
    const Outcome anew = run("nav path " + floor_ + question);
    ASSERT_EQ(anew.code, 0) << anew.err;
    EXPECT_TRUE(nlohmann::json::parse(anew.out)["found"]);
    const std::string level = cooked();
    ASSERT_EQ(run("nav build " + level + " --cell 0.2").code, 0);
    // 4.5 m from the wall is near enough for a slim body, and too near for one of 1.5 m.
    EXPECT_TEXT(run("nav path " + level + " --from 0,0,0 --to 4.4,0,0").out, "Path of 4.");
    EXPECT_TEXT(run("nav path " + level + " --from 0,0,0 --to 4.4,0,0 --radius 1.5 --cell 0.4").out, "Path of 3.");
    EXPECT_TEXT(run("nav path " + level + " --from 0,0,0 --to 3,0,4 --shape capsule:0.4,0.5 --cell 0.2").out,
                "Path of 5");
}

TEST_F(CliNav, what_makes_no_sense_is_said_in_words) {
    EXPECT_EQ(run("nav").code, 2);
    EXPECT_EQ(run("nav build").code, 2);
    const Outcome slope = run("nav build " + floor_ + " -o " + path("x.surefoot") + " --slope 95");
    EXPECT_EQ(slope.code, 2);
    EXPECT_TEXT(slope.err, "slopes 0 to 89 degrees");
    const Outcome cells = run("nav build " + floor_ + " -o " + path("x.surefoot") + " --cell 0.0001");
    EXPECT_EQ(cells.code, 2);
    EXPECT_TEXT(cells.err, "larger");
    EXPECT_FALSE(std::filesystem::exists(path("x.surefoot")));
    EXPECT_EQ(run("nav path " + path("none.surefoot") + " --from 0,0,0 --to 1,0,0").code, 3);
    EXPECT_EQ(run("nav path " + floor_ + " --from 0,0 --to 1,0,0").code, 2);
}

TEST_F(CliNav, ground_that_is_damaged_is_an_error_that_names_the_cure) {
    const std::string level = cooked();
    ASSERT_EQ(run("nav build " + level + " --cell 0.2").code, 0);
    std::string bytes = read_text(level);
    const std::size_t at = bytes.find(std::string("SFTNAV\r\n", 8));
    ASSERT_NE(at, std::string::npos);
    bytes[at + 100] ^= 4;
    write("floor.surefoot", bytes);
    const Outcome damaged = run("nav path " + level + " --from 0,0,0 --to 3,0,4");
    EXPECT_EQ(damaged.code, 3);
    EXPECT_TEXT(damaged.err, "damaged");
    EXPECT_EQ(run("nav build " + level + " --cell 0.2").code, 0) << "and building it again mends it";
    EXPECT_EQ(run("nav path " + level + " --from 0,0,0 --to 3,0,4").code, 0);
}

TEST_F(CliNav, a_level_without_spawn_markers_is_begun_where_one_says) {
    const Outcome begun = run("navcheck " + floor_ + " --cell 0.2 --walks 5 --start 8,0.5,0 --json");
    ASSERT_EQ(begun.code, 0) << begun.err;
    EXPECT_LT(nlohmann::json::parse(begun.out)["kept"], 120) << "of the floor what is behind the wall";
    const std::string out = " -o " + path("begun.surefoot");
    const auto built = nlohmann::json::parse(run("nav build " + floor_ + out + " --cell 0.2 --start 8,0,0 --json").out);
    EXPECT_GT(built["unreached"], 200);
    for (const std::string& command : {"navcheck " + floor_, "nav build " + floor_ + out}) {
        const Outcome beside = run(command + " --cell 0.2 --start 80,0.5,0");
        EXPECT_EQ(beside.code, 2);
        EXPECT_TEXT(beside.err, "there is no ground to begin on at 80,0.5,0");
        EXPECT_EQ(run(command + " --start 80,0").code, 2);
    }
}

// The defect: what is only drawn was walked on, and lifts were ground at their first stop.
TEST_F(CliNav, of_a_level_of_the_platformer_it_is_the_still_ground) {
    const std::string level = std::string(SUREFOOT_LEVELS) + "/platformer/clockwork.glb";
    const std::string built = path("clockwork.surefoot");
    const std::string options = " --unproved --radius 0.35 --height 1.6 -o " + built;
    const Outcome text = run("nav build " + level + options);
    ASSERT_EQ(text.code, 0) << text.err;
    EXPECT_TEXT(text.out, "a level of the platformer: of it the still ground; 18 moving bodies and ");
    const auto json = nlohmann::json::parse(run("nav build " + level + options + " --json").out);
    EXPECT_EQ(json["moving_left_out"], 18);
    EXPECT_EQ(json["decor_left_out"], 9);
    // The file keeps all of its triangles.
    EXPECT_EQ(nlohmann::json::parse(run("info " + built + " --json").out)["triangles"],
              nlohmann::json::parse(run("info " + level + " --json").out)["triangles"]);
    // A level of anybody else's is taken whole, and nothing is said of it.
    const auto other = nlohmann::json::parse(run("nav build " + floor_ + " --unproved --json -o " + built).out);
    EXPECT_EQ(other["moving_left_out"], 0);
    EXPECT_EQ(run("nav build " + floor_ + " --unproved -o " + built).out.find("still ground"), std::string::npos);
}

TEST_F(CliNav, surfaces_are_what_they_are_called) {
    // Two floors, the one four metres above the other, and a ladder between them.
    const auto storeys = [&](const std::string& ladder, const std::string& floor) {
        return write(ladder + floor + ".obj",
                     "v -6 0 -3\nv 0 0 -3\nv 0 0 3\nv -6 0 3\nv 0 4 -3\nv 6 4 -3\nv 6 4 3\nv 0 4 3\n"
                     "v 0 0 -0.6\nv 0 0 0.6\nv 0 4 0.6\nv 0 4 -0.6\nusemtl stone\nf 1 4 3 2\n"
                     "usemtl " +
                         floor + "\nf 5 8 7 6\nusemtl " + ladder + "\nf 9 10 11 12\n");
    };
    const auto ladders = [&](const std::string& level, const std::string& options = "") {
        const Outcome outcome = run("navcheck " + level + " --cell 0.2 --walks 5 --start -3,0,0 --json" + options);
        EXPECT_EQ(outcome.code, 0) << outcome.err << outcome.out;
        return nlohmann::json::parse(outcome.out)["links"]["ladders"]["kept"].get<int>();
    };
    EXPECT_EQ(ladders(storeys("Iron_ladder.2", "wood")), 2);
    EXPECT_EQ(ladders(storeys("Iron_ladder.2", "wood"), " --plain"), 0);
    EXPECT_EQ(ladders(storeys("ladderless", "wood")), 0);
    EXPECT_EQ(ladders(storeys("ladder", "lava")), 0) << "there is nowhere to climb to";
    // A pool in a floor, with dry ground on three sides.
    const std::string wet = write("wet.obj",
                                  "v 0 0 0\nv 3 0 0\nv 6 0 0\nv 9 0 0\nv 0 0 6\nv 3 0 6\nv 6 0 6\nv 9 0 6\n"
                                  "v 3 0 4\nv 6 0 4\nusemtl deep water\nf 2 9 10 3\n"
                                  "usemtl stone\nf 1 5 6 2\nf 9 6 7 10\nf 3 7 8 4\n");
    const std::string question = " --from 1,0,1 --to 8,0,1 --cell 0.2 --json";
    const auto dry = nlohmann::json::parse(run("nav path " + wet + question).out);
    const auto plain = nlohmann::json::parse(run("nav path " + wet + question + " --plain").out);
    EXPECT_GT(dry["length"], plain["length"].get<double>() + 0.1) << "round the water";
}

TEST_F(CliNav, the_help_teaches) {
    for (const char* const command : {"nav build", "nav path"}) {
        const Outcome help = run(std::string(command) + " --help");
        EXPECT_EQ(help.code, 0);
        EXPECT_TEXT(help.out, "Examples:");
        EXPECT_TEXT(help.out, "Exit codes:");
        EXPECT_TEXT(help.out, "--radius");
    }
    EXPECT_TEXT(run("nav --help").out, "build");
}

}  // namespace
