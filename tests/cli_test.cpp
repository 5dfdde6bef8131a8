// The program as a whole: what people type, what they read, and what a script gets back.
#include "cli_program.hpp"

using nlohmann::json;

TEST_F(Cli, every_subcommand_has_help_with_an_example_and_exit_codes) {
    for (const std::string name : {"sweep", "overlap", "ray", "march", "info", "export", "prove", "tour"}) {
        const Outcome help = run(name + " --help");
        EXPECT_EQ(help.code, 0) << name;
        EXPECT_TEXT(help.out, "Examples:\n  surefoot " + name);
        EXPECT_TEXT(help.out, "Exit codes: 0");
    }
    EXPECT_EQ(run("--help").code, 0);
    EXPECT_EQ(run("--version").out.rfind("surefoot ", 0), 0U);
}

TEST_F(Cli, a_sphere_falls_onto_the_floor_where_arithmetic_says) {
    // From 3 m down to -2 m; it touches with its centre at 0.5 m, after 2.5 m of 5.
    const Outcome fall = run("sweep " + floor_ + " --shape sphere:0.5 --from 1,3,-2.5 --to 1,-2,-2.5 --json");
    ASSERT_EQ(fall.code, 0) << fall.err;
    const json answer = json::parse(fall.out);
    EXPECT_TRUE(answer["hit"].get<bool>());
    EXPECT_NEAR(answer["t"].get<double>(), 0.5, 1e-9);
    EXPECT_NEAR(answer["point"][0].get<double>(), 1, 1e-9);
    EXPECT_NEAR(answer["point"][1].get<double>(), 0, 1e-9);
    EXPECT_NEAR(answer["point"][2].get<double>(), -2.5, 1e-9);
    EXPECT_EQ(answer["normal"][1].get<double>(), 1);
    EXPECT_EQ(answer["feature"], "face");
    EXPECT_EQ(answer["triangle"], 1);
    EXPECT_FALSE(answer["started_inside"].get<bool>());
}

TEST_F(Cli, an_answer_has_its_names_in_the_order_of_the_format) {
    const Outcome fall = run("sweep " + floor_ + " --shape sphere:0.5 --from 1,3,2 --to 1,-2,2 --json");
    std::size_t last = 0;
    for (const std::string name : {"hit", "t", "point", "normal", "feature", "triangle", "started_inside"}) {
        const std::size_t place = fall.out.find("\"" + name + "\":");
        ASSERT_NE(place, std::string::npos) << name;
        EXPECT_GE(place, last) << name;
        last = place;
    }
    EXPECT_EQ(run("sweep " + floor_ + " --shape sphere:0.5 --from 1,3,2 --to 2,3,2 --json").out, "{\"hit\":false}\n");
}

TEST_F(Cli, negative_coordinates_need_no_special_care) {
    for (const std::string from : {"--from -1,3,2", "--from=-1,3,2", "--from -.5,3,2", "--from -1e0,3,-2"}) {
        const Outcome fall = run("sweep " + floor_ + " " + from + " --to -1,-2,-2 --shape sphere:0.5");
        EXPECT_EQ(fall.code, 0) << from << fall.err;
        EXPECT_TEXT(fall.out, "Hit at t = 0.5");
    }
}

TEST_F(Cli, words_name_the_feature_and_the_surface) {
    const Outcome wall = run("sweep " + floor_ + " --shape ellipsoid:0.4,0.9,0.4 --from 0,1,0.5 --to 9,1,0.5");
    ASSERT_EQ(wall.code, 0) << wall.err;
    EXPECT_TEXT(wall.out, "after 4.6 m");
    EXPECT_TEXT(wall.out, "face");
    EXPECT_TEXT(wall.out, "brick");
}

TEST_F(Cli, a_start_inside_hints_at_overlap) {
    const Outcome inside = run("sweep " + floor_ + " --shape sphere:0.5 --from 1,0.2,2 --to 1,-2,2");
    EXPECT_TEXT(inside.out, "Hit at t = 0");
    EXPECT_TEXT(inside.out, "surefoot overlap");
}

TEST_F(Cli, one_sided_walls_let_through_from_behind) {
    const std::string behind = "sweep " + floor_ + " --shape sphere:0.5 --from 8,2,0 --to 1,2,0 --json";
    EXPECT_TRUE(json::parse(run(behind).out)["hit"].get<bool>());
    EXPECT_FALSE(json::parse(run(behind + " --one-sided").out)["hit"].get<bool>());
}

TEST_F(Cli, a_turned_box_reaches_farther) {
    // A quarter turn about z lays the tall box on its side: it meets the wall with its half height of 2 m.
    const std::string box = "sweep " + floor_ + " --shape box:0.5,2,0.5 --from 0,2.5,0 --to 4,2.5,0 --json";
    EXPECT_FALSE(json::parse(run(box).out)["hit"].get<bool>());
    const json turned = json::parse(run(box + " --rotate 1,0,0,1").out);
    EXPECT_NEAR(turned["t"].get<double>(), 0.75, 1e-9);
}

TEST_F(Cli, a_trace_says_why) {
    const Outcome why = run("sweep " + floor_ + " --shape sphere:0.5 --from 1,3,2 --to 1,-2,2 --trace");
    EXPECT_EQ(why.code, 0);
    EXPECT_TEXT(why.out, "Why:");
    EXPECT_TEXT(why.out, "enters");
}

TEST_F(Cli, overlap_lists_what_is_touched_and_the_way_out) {
    const Outcome stuck = run("overlap " + floor_ + " --shape sphere:0.5 --at 4.75,0.25,-3 --json");
    ASSERT_EQ(stuck.code, 0) << stuck.err;
    const json answer = json::parse(stuck.out);
    EXPECT_TRUE(answer["touching"].get<bool>());
    ASSERT_GE(answer["overlaps"].size(), 2U);
    for (const json& overlap : answer["overlaps"]) EXPECT_NEAR(overlap["depth"].get<double>(), 0.25, 1e-9);
    const Outcome clear = run("overlap " + floor_ + " --shape sphere:0.5 --at 0,2,0");
    EXPECT_EQ(clear.code, 0);
    EXPECT_TEXT(clear.out, "Touches nothing.");
}

TEST_F(Cli, a_ray_meets_the_wall) {
    const Outcome sight = run("ray " + floor_ + " --from 1,1,3 --to 9,1,3 --json");
    ASSERT_EQ(sight.code, 0) << sight.err;
    const json answer = json::parse(sight.out);
    EXPECT_NEAR(answer["t"].get<double>(), 0.5, 1e-12);
    EXPECT_EQ(answer["normal"][0].get<double>(), -1);
    EXPECT_TEXT(run("ray " + floor_ + " --from 1,1,3 --to 1,2,3").out, "No hit");
}

TEST_F(Cli, a_jump_lands_where_its_parabola_meets_the_floor) {
    // From 0.5 m above the floor's contact height at 5 m/s upwards under 10 m/s2: back down after (5 + sqrt(35)) / 10
    // s.
    const Outcome jump = run("march " + floor_ +
                             " --shape sphere:0.5 --from 0,1,0 --velocity 0,5,0 --gravity 0,-10,0 --duration 2"
                             " --steps 2000 --json");
    ASSERT_EQ(jump.code, 0) << jump.err;
    const json answer = json::parse(jump.out);
    EXPECT_NEAR(2 * answer["t"].get<double>(), 1.0916079783, 1e-3);
    EXPECT_NEAR(answer["position"][1].get<double>(), 0.5, 1e-6);
}

TEST_F(Cli, an_unguarded_march_tunnels_and_a_guarded_one_does_not) {
    const std::string shot = "march " + floor_ +
                             " --shape sphere:0.05 --from 0,1,0.3 --velocity 400,0,0 --gravity 0,0,0"
                             " --duration 0.02 --steps 4 --json";
    EXPECT_TRUE(json::parse(run(shot).out)["hit"].get<bool>());
    EXPECT_FALSE(json::parse(run(shot + " --unguarded").out)["hit"].get<bool>());
}

TEST_F(Cli, a_path_from_a_file_is_followed_point_by_point) {
    const std::string path = write("route.csv", "x,y,z\n0,2,0\n# a comment\n\n2,2,0\n2,2,1\n8,2,1\n");
    const Outcome walk = run("march " + floor_ + " --shape sphere:0.5 --path " + path + " --json");
    ASSERT_EQ(walk.code, 0) << walk.err;
    const json answer = json::parse(walk.out);
    EXPECT_EQ(answer["step"], 2);
    EXPECT_NEAR(answer["position"][0].get<double>(), 4.5, 1e-9);
    EXPECT_NEAR(answer["t"].get<double>(), (2 + 2.5 / 6) / 3, 1e-9);
}

TEST_F(Cli, a_path_with_a_bad_line_names_it) {
    const std::string path = write("route.csv", "0,2,0\n2,2,oops\n");
    const Outcome walk = run("march " + floor_ + " --shape sphere:0.5 --path " + path);
    EXPECT_EQ(walk.code, 3);
    EXPECT_TEXT(walk.err, "line 2");
    EXPECT_TEXT(walk.err, "oops");
}

TEST_F(Cli, info_counts_what_is_there) {
    const Outcome text = run("info " + floor_);
    EXPECT_EQ(text.code, 0);
    EXPECT_TEXT(text.out, "brick");
    const json info = json::parse(run("info " + floor_ + " --json").out);
    EXPECT_EQ(info["triangles"], 4);
    EXPECT_EQ(info["vertices"], 8);
    EXPECT_EQ(info["degenerate"], 0);
    EXPECT_EQ(info["bounds"]["max"], json::parse("[10,4,10]"));
    EXPECT_EQ(info["area"].get<double>(), 480);
    ASSERT_EQ(info["surfaces"].size(), 2U);
    EXPECT_EQ(info["surfaces"][1]["name"], "brick");
    EXPECT_EQ(info["surfaces"][1]["triangles"], 2);
}

TEST_F(Cli, an_export_reads_back_to_the_same_floats_and_ids) {
    // Decimals that are no floats, and numbers at both ends of what a level holds.
    const std::string odd = write("odd.obj",
                                  "v 0.1 0.2 0.3\nv 1e-30 16777217 -0\nv 3.14159274 -2.7182817 1e8\nv 0.1 0.2 0.3\n"
                                  "f 1 2 3\nf 3 2 4\nf 2 1 3\n");
    const std::string once = (folder_ / "once.obj").string();
    const std::string twice = (folder_ / "twice.obj").string();
    ASSERT_EQ(run("export " + odd + " -o " + once).code, 0);
    ASSERT_EQ(run("export " + once + " -o " + twice).code, 0);
    EXPECT_EQ(read_text(once), read_text(twice));
    const std::vector<std::string> lines = lines_of(read_text(once));
    ASSERT_EQ(lines.size(), 6U);
    EXPECT_EQ(lines[0], "v 0.1 0.2 0.3");
    EXPECT_EQ(lines[1], "v 1e-30 16777216 0") << "a zero has no sign";
    EXPECT_EQ(lines[2], "v 3.1415927 -2.7182817 1e+08");
    EXPECT_EQ(lines[3], "f 1 2 3");
    EXPECT_EQ(lines[4], "f 3 2 1");
    EXPECT_EQ(lines[5], "f 2 1 3");
}

TEST_F(Cli, mistakes_are_answered_with_what_to_write_instead) {
    struct Mistake {
        std::string arguments;
        int code;
        std::string words;
    };
    const std::string way = " --from 0,1,0 --to 0,2,0";
    const std::vector<Mistake> mistakes{
        {"", 2, "subcommand"},
        {"swep", 2, "sweep"},
        {"sweep " + floor_ + way + " --shape elipsoid:1,1,1", 2, "did you mean 'ellipsoid'"},
        {"sweep " + floor_ + way + " --shape cube:1", 2, "cylinder:r,half_height"},
        {"sweep " + floor_ + way + " --shape box:1,1", 2, "box:hx,hy,hz"},
        {"sweep " + floor_ + way + " --shape sphere:0", 2, "1e-6"},
        {"sweep " + floor_ + way + " --shape sphere:nan", 2, "1e-6"},
        {"sweep " + floor_ + way + " --shape sphere:1 --rotate 0,0,0,0", 2, "1,0,0,0"},
        {"sweep " + floor_ + " --from 0,1 --to 0,2,0 --shape sphere:1", 2, "x,y,z"},
        {"sweep " + floor_ + " --from 0,1,x --to 0,2,0 --shape sphere:1", 2, "'x' is not a number"},
        {"sweep " + floor_ + " --from 0,1,2e9 --to 0,2,0 --shape sphere:1", 2, "1e9"},
        {"sweep " + floor_ + way, 2, "--shape"},
        {"sweep " + floor_ + way + " --shape sphere:1 --batch -", 2, "--batch"},
        {"sweep " + floor_ + way + " --shpe sphere:1", 2, "--shape"},
        {"sweep " + (folder_ / "flor.obj").string() + way + " --shape sphere:1", 3, "floor.obj"},
        {"sweep " + floor_ + " --batch " + (folder_ / "none.jsonl").string(), 3, "none.jsonl"},
        {"march " + floor_ + " --shape sphere:1", 2, "--velocity"},
        {"export " + floor_ + " -o " + (folder_ / "none" / "out.obj").string(), 3, "folder"},
        {"tour " + floor_ + " --size big", 2, "1280x800"},
        {"tour " + floor_ + " --shape cone:1,2", 2, "ellipsoid"},
    };
    for (const Mistake& mistake : mistakes) {
        const Outcome outcome = run(mistake.arguments);
        EXPECT_EQ(outcome.code, mistake.code) << mistake.arguments;
        EXPECT_TEXT(outcome.err, mistake.words);
        EXPECT_EQ(outcome.out, "") << mistake.arguments;
    }
}

TEST_F(Cli, a_full_disk_is_no_success) {
    if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "there is no /dev/full here";
    const int status = std::system(("'" SUREFOOT_PROGRAM "' info '" + floor_ + "' >/dev/full 2>/dev/null").c_str());
    EXPECT_EQ(WEXITSTATUS(status), 3);
}
