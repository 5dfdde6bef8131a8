// The course, to be watched.
#include <cmath>
#include <gtest/gtest.h>

#include "course/catalogue.hpp"
#include "playground/course_room/race.hpp"
#include "small_app.hpp"

namespace surefoot::playground {
namespace {

const course::Scene& scene_named(const std::string& name) {
    static const course::Scenes all = course::all_scenes();
    for (const course::Scene& scene : all)
        if (scene.name == name) return scene;
    throw std::runtime_error(name);
}

TEST(Race, the_body_is_where_the_mover_was_and_between_two_ticks_in_between) {
    const course::Run& run = scene_named("stairs-up").runs.front();
    const Race race(run, {});
    const auto mover = course::make_mover("ours");
    const course::Outing outing = course::walk_run(run, *mover);
    ASSERT_GT(outing.spots.size(), 60U);
    EXPECT_EQ(race.begin(), outing.spots.front().time);
    EXPECT_EQ(race.end(), outing.last().time);
    for (std::size_t i = 0; i < outing.spots.size(); ++i) {
        const course::Spot& spot = outing.spots[i];
        EXPECT_EQ(race.ours().spot_at(spot.time).position, spot.position) << i;
        const dvec3 here = race.ours().position_at(spot.time);
        EXPECT_NEAR(here.x, spot.position.x, 1e-9);
    }
    const course::Spot& a = outing.spots[50];
    const course::Spot& b = outing.spots[51];
    ASSERT_NE(a.position.x, b.position.x);
    EXPECT_NEAR(race.ours().position_at((a.time + b.time) / 2).x, (a.position.x + b.position.x) / 2, 1e-9);
    EXPECT_EQ(race.ours().position_at(race.end() + 9), outing.last().position);
    EXPECT_EQ(race.gap_at(1), 0) << "it walks alone";
}

TEST(Race, a_broken_mover_is_left_behind_on_stairs) {
    const Race race(scene_named("stairs-up").runs.front(), {.mover = "broken-tick-step"});
    ASSERT_TRUE(race.other());
    EXPECT_LT(race.gap_at(race.begin()), 0.01);
    EXPECT_GT(race.gap_at(race.end()), 0.2);
}

TEST(Race, a_mover_that_is_not_there_says_so) {
    const Race race(scene_named("floor-seams").runs.front(), {.mover = "nobody"});
    ASSERT_TRUE(race.other());
    EXPECT_NE(race.other()->outing.failure.find("no such mover"), std::string::npos);
    EXPECT_EQ(race.other()->position_at(1), race.run().start);
}

TEST(Race, a_program_that_speaks_the_line_protocol_walks_as_ours_does) {
    // A rival that goes by its name alone, and not by its command, would not be found.
    const Race race(scene_named("stairs-up").runs.front(), {.command = SUREFOOT_COURSE_MOVER});
    ASSERT_TRUE(race.other());
    EXPECT_EQ(race.other()->outing.failure, "");
    EXPECT_EQ(race.gap_at(race.end()), 0) << "the example asks the same step";
}

TEST(Race, what_is_wrong_with_a_program_is_told_in_words) {
    const course::Run& run = scene_named("floor-seams").runs.front();
    const auto failure_of = [&](const char* command) {
        return Race(run, {.command = command}).other()->outing.failure;
    };
    EXPECT_EQ(failure_of("/none/such 2> /dev/null"), "the program has ended: the shell could not start it");
    EXPECT_EQ(failure_of("exit 3"), "the program has ended, with exit code 3");
    EXPECT_EQ(failure_of("kill -9 $$"), "the program has ended: by signal 9");
    EXPECT_NE(failure_of("echo hello; cat > /dev/null").find("said 'hello'"), std::string::npos);
    const std::string dies =
        "read line; echo surefoot-course 1; while read line; do case $line in go) echo ready;; "
        "tick*) n=$((n+1)); [ $n -gt 20 ] && exit 4; echo at 0 1 0 1;; esac; done";
    const Race race(run, {.command = dies});
    EXPECT_EQ(race.other()->outing.failure, "the program has ended, with exit code 4");
    EXPECT_EQ(race.other()->outing.spots.size(), 21U) << "what it walked is shown";
}

TEST(CourseRoom, a_program_is_typed_into_the_panel_or_given_on_the_command_line) {
    const auto app = open("course");
    const auto play = [&](const std::string& script) {
        app->play(*view::parse_script(script, "test"));
        for (int i = 0; i < 400 && app->frame(); ++i) {
        }
        EXPECT_EQ(app->failure(), "");
        return app->picture();
    };
    const auto alone = play("wait 40\nkey P\nwait 3\nquit");
    const auto beside = play("click \"Program\"\ntext exit 3\nclick \"Walk the program\"\nwait 40\nquit");
    EXPECT_NE(alone.colours(1U << 20), beside.colours(1U << 20));

    std::string out = testing::TempDir() + "course_ghost.png";
    const std::string command =
        SUREFOOT_PLAYGROUND " --room course --headless --frames 5 --size 640x400 --screenshot '" + out + "' ";
    EXPECT_EQ(std::system((command + "--scene stairs-up --ghost-exec '" SUREFOOT_COURSE_MOVER "'").c_str()), 0);
    EXPECT_NE(std::system((command + "--scene nowhere 2> /dev/null").c_str()), 0);
}

TEST(Measuring, one_run_after_the_other_measures_what_the_course_does) {
    const course::Scene& scene = scene_named("stairs-up");
    Measuring measuring(scene, {.mover = "broken-tick-step"});
    std::size_t calls = 1;
    while (measuring.go_on()) ++calls;
    EXPECT_EQ(calls, scene.runs.size());
    ASSERT_TRUE(measuring.is_done());
    const auto mover = course::make_mover("broken-tick-step");
    const course::Score whole = course::run_scene(scene, *mover);
    EXPECT_FALSE(whole.passes());
    ASSERT_EQ(measuring.score().marks.size(), whole.marks.size());
    for (std::size_t i = 0; i < whole.marks.size(); ++i) {
        EXPECT_EQ(measuring.score().marks[i].worst.value, whole.marks[i].worst.value);
        EXPECT_EQ(measuring.score().marks[i].worst.where, whole.marks[i].worst.where);
    }
}

TEST(CourseRoom, every_scene_can_be_watched) {
    const auto app = open("course");
    const std::size_t scenes = course::all_scenes().size();
    const auto play = [&](const std::string& script) {
        app->play(*view::parse_script(script, "test"));
        for (int i = 0; i < 400 && app->frame(); ++i) {
        }
        EXPECT_EQ(app->failure(), "");
    };
    for (std::size_t i = 0; i < scenes; ++i) play("key N\nwait 1\nquit");
    play("click \"Ghost\"\nclick \"broken-seams\"\nwait 20\nquit");
    EXPECT_EQ(app->room(), "course");
    EXPECT_GT(app->picture().colours(), 500U);
}

}  // namespace
}  // namespace surefoot::playground
