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
    const Race race(run, "");
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
    const Race race(scene_named("stairs-up").runs.front(), "broken-tick-step");
    ASSERT_TRUE(race.other());
    EXPECT_LT(race.gap_at(race.begin()), 0.01);
    EXPECT_GT(race.gap_at(race.end()), 0.2);
}

TEST(Race, a_mover_that_is_not_there_says_so) {
    const Race race(scene_named("floor-seams").runs.front(), "nobody");
    ASSERT_TRUE(race.other());
    EXPECT_NE(race.other()->outing.failure.find("no such mover"), std::string::npos);
    EXPECT_EQ(race.other()->position_at(1), race.run().start);
}

TEST(Measuring, one_run_after_the_other_measures_what_the_course_does) {
    const course::Scene& scene = scene_named("stairs-up");
    Measuring measuring(scene, "broken-tick-step");
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
