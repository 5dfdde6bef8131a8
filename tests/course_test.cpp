// The movement course itself: its scenes, its measures, its broken movers and its line protocol.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <set>

#include "course/catalogue.hpp"
#include "course/measures.hpp"
#include "course/mover.hpp"
#include "course/protocol.hpp"
#include "course/runner.hpp"

namespace surefoot::course {
namespace {

// Goes where it is told and meets nothing.
class Ghost final : public Mover {
public:
    explicit Ghost(dvec3 extra = {0, 0, 0}) : extra_(extra) {}
    void load(const Run& run) override { position_ = run.start; }
    Answer tick(const Input& input, double dt, std::span<const Pose>) override {
        position_ = position_ + input.wish * dt + extra_;
        return {position_, true};
    }

private:
    dvec3 position_{0, 0, 0};
    dvec3 extra_;
};

Run plain_run(const dvec3& wish) {
    Run run;
    run.name = "plain";
    run.settings = hero();
    run.level = level_of(Triangles().floor({-20, 0, -20}, {20, 0, 20}));
    run.start = {0, standing(run.settings) + 0.01, 0};
    run.script = walk(wish);
    run.seconds = 1;
    return run;
}

TEST(CourseScenes, have_names_runs_bars_and_reasons_of_their_own) {
    std::set<std::string> names;
    for (const Scene& scene : all_scenes()) {
        EXPECT_TRUE(names.insert(scene.name).second) << scene.name;
        EXPECT_FALSE(scene.title.empty()) << scene.name;
        EXPECT_FALSE(scene.bars.empty()) << scene.name;
        std::set<std::string> runs;
        for (const course::Run& run : scene.runs) {
            EXPECT_TRUE(runs.insert(run.name).second) << scene.name << ": " << run.name;
            EXPECT_TRUE(is_valid(run.settings)) << scene.name << ": " << run.name;
        }
        EXPECT_FALSE(runs.empty()) << scene.name;
        for (const Bar& bar : scene.bars) EXPECT_GT(bar.reason.size(), 20U) << scene.name << ": " << bar.what;
    }
    EXPECT_GE(names.size(), 54U);
}

// Made once.
const Scenes& scenes() {
    static const Scenes made = all_scenes();
    return made;
}

// By number, so that each scene is a test of its own.
class CourseScene : public testing::TestWithParam<std::size_t> {};

TEST_P(CourseScene, is_failed_by_the_broken_mover_that_it_is_about) {
    const Scene& scene = scenes()[GetParam()];
    ASSERT_FALSE(scene.catches.empty()) << scene.name;
    const auto mover = make_mover(scene.catches.front());
    ASSERT_TRUE(mover) << scene.catches.front();
    EXPECT_FALSE(run_scene(scene, *mover).passes()) << scene.name << " by " << scene.catches.front();
}

TEST_P(CourseScene, is_cleared_by_ours) {
    const Scene& scene = scenes()[GetParam()];
    const auto mover = make_mover("ours");
    const Score score = run_scene(scene, *mover);
    EXPECT_EQ(score.failure, "");
    for (const Mark& mark : score.marks)
        EXPECT_TRUE(mark.passes()) << scene.name << ", " << mark.worst.where << ": " << mark.bar->what << ' '
                                   << mark.worst.value << ", at most " << mark.bar->most;
}

INSTANTIATE_TEST_SUITE_P(Course, CourseScene, testing::Range(std::size_t{0}, scenes().size()), [](const auto& chosen) {
    std::string name = scenes()[chosen.param].name;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
});

TEST(CourseScenes, catch_every_broken_mover_somewhere) {
    std::set<std::string> caught;
    for (const Scene& scene : scenes()) caught.insert(scene.catches.begin(), scene.catches.end());
    for (const MoverName& mover : movers())
        EXPECT_EQ(caught.contains(std::string(mover.name)), mover.is_broken) << mover.name;
}

TEST(CourseMeasures, tell_a_way_without_faults_from_one_with) {
    const course::Run run = plain_run({3, 0, 0});
    Ghost good;
    const Outing straight = walk_run(run, good);
    EXPECT_LT(speed_error(straight), 1e-9);
    EXPECT_LT(drift(straight), 1e-9);
    EXPECT_EQ(height_change(straight), 0);
    EXPECT_EQ(airborne(straight), 0);
    EXPECT_EQ(depth(straight), 0);
    EXPECT_NEAR(gone(straight, {1, 0, 0}), 3, 1e-9);
    Ghost bad(dvec3{0, -0.001, 0.01});
    const Outing crooked = walk_run(run, bad);
    EXPECT_GT(drift(crooked), 0.1);
    EXPECT_NEAR(height_change(crooked), 0.06, 1e-9);
    EXPECT_NEAR(depth(crooked), 0.08, 0.01);
}

TEST(CourseMeasures, take_what_is_no_number_as_the_worst) {
    Worst worst;
    worst.take(5, "five");
    worst.take(std::nan(""), "none");
    worst.take(7, "seven");
    EXPECT_TRUE(std::isnan(worst.value));
    EXPECT_EQ(worst.where, "none");
    const Bar bar{"what", "m", 10, "a reason", {}};
    EXPECT_FALSE((Mark{&bar, worst}.passes()));
    Ghost lost(dvec3{std::nan(""), 0, 0});
    const course::Run run = plain_run({3, 0, 0});
    const Outing outing = walk_run(run, lost);
    EXPECT_TRUE(std::isnan(speed_error(outing)));
    EXPECT_FALSE(depth(outing) <= 1e9);
}

TEST(CourseMeasures, know_inside_from_outside_of_a_closed_level) {
    course::Run run = plain_run({3, 0, 0});
    run.level = level_of(Triangles().room({-2, 0, -2}, {2, 3, 2}).block({1, 0.1, -1}, {1.5, 2, 1}));
    Ghost ghost;
    run.seconds = 0.2;
    EXPECT_LT(outside(walk_run(run, ghost)), 1e-6);
    run.seconds = 0.4;
    EXPECT_NEAR(outside(walk_run(run, ghost)), 1, 1e-6) << "in the block";
    run.script = walk({-3, 0, 0});
    run.seconds = 1;
    EXPECT_NEAR(outside(walk_run(run, ghost)), 1, 1e-6) << "beyond the wall";
}

TEST(CourseMeasures, want_zero_motion_from_the_second_tick_on) {
    course::Run run = plain_run({3, 0, 0});
    Ghost ghost;
    EXPECT_TRUE(std::isinf(motion_once_stopped(walk_run(run, ghost)))) << "it never stopped";
    run.script = [](double time, const Spot&) { return Input{{time < 0.5 ? 3.0 : 0.0, 0, 0}}; };
    EXPECT_EQ(unrest(walk_run(run, ghost), 0.4), 0);
    EXPECT_GT(unrest(walk_run(run, ghost), 0.6), 0);
}

TEST(CourseMeasures, compare_rates_where_both_end_a_tick) {
    std::vector<course::Run> runs{plain_run({3, 0, 0}), plain_run({3, 0, 0})};
    runs[1].rate = 240;
    Ghost ghost;
    std::vector<Outing> outings{walk_run(runs[0], ghost), walk_run(runs[1], ghost)};
    const auto none = [](const course::Run&) { return 0.0; };
    EXPECT_LT(divergence(none)(outings).value, 1e-9);
    Ghost slow(dvec3{-0.001, 0, 0});
    outings[0] = walk_run(runs[0], slow);
    EXPECT_NEAR(divergence(none)(outings).value, 0.03 + 0.06, 1e-3) << "half a second of settling and one of walking";
}

TEST(CourseLevels, move_their_bodies_and_keep_their_ways) {
    Level level;
    level.add(Triangles().block({-1, -1, -1}, {1, 0, 1}), {}, [](double time) {
        return Pose{.position = {0, 2 * time, 0}};
    });
    LevelWorld world(level);
    world.move_to(0.5);
    const auto hit = world.world().ray({{0, 5, 0}, {0, -5, 0}}, {.begin = 1, .end = 1});
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->point.y, 1, 1e-9);
}

TEST(CourseProtocol, says_a_run_in_lines_that_read_back) {
    course::Run run = plain_run({3, 0, 0});
    const std::string text = protocol::text_of(run);
    EXPECT_TRUE(text.starts_with("run plain\nset radius 0.4\nset half_height 0.5\nset skin 0.01\n")) << text;
    EXPECT_NE(text.find("body 0 6 2 0 0 0 1 0 0 0\nv -20 0 -20\n"), text.npos) << text;
    EXPECT_TRUE(text.ends_with("start 0 0.91 0\ngo\n")) << text;
    EXPECT_EQ(protocol::text_of(*run.level, {{3, 0, 0}, true}, 0.25, poses_at(*run.level, 0)), "tick 0.25 3 0 0 1\n");
}

TEST(CourseProtocol, reads_an_answer_and_nothing_else) {
    const auto answer = protocol::answer_of("at 1 -2.5 3e-1 1");
    ASSERT_TRUE(answer);
    EXPECT_EQ(answer->position, (dvec3{1, -2.5, 0.3}));
    EXPECT_TRUE(answer->grounded);
    EXPECT_TRUE(std::isnan(protocol::answer_of("at nan 0 0 0")->position.x));
    for (const char* line : {"", "at", "at 1 2 3", "at 1 2 3 2", "at 1 2 3 1 4", "1 2 3 1", "at x 2 3 1"})
        EXPECT_FALSE(protocol::answer_of(line)) << line;
}

class CourseProgram : public testing::Test {
protected:
    static std::vector<Spot> walk_by(Mover& mover, const course::Run& run) {
        const Outing outing = walk_run(run, mover);
        EXPECT_EQ(outing.failure, "");
        return outing.spots;
    }
};

TEST_F(CourseProgram, that_speaks_the_protocol_gets_the_score_that_it_would_get_inside) {
    const auto inside = make_mover("ours");
    const auto outside_mover = make_external_mover(COURSE_MOVER);
    for (const Scene& scene : scenes()) {
        if (scene.name != "lift" && scene.name != "stairs-spiral" && scene.name != "turntable") continue;
        for (const course::Run& run : scene.runs) {
            const auto ours = walk_by(*inside, run);
            const auto theirs = walk_by(*outside_mover, run);
            ASSERT_EQ(ours.size(), theirs.size());
            for (std::size_t i = 0; i < ours.size(); ++i)
                ASSERT_EQ(ours[i].position, theirs[i].position) << scene.name << ", " << run.name << ", tick " << i;
        }
    }
}

TEST_F(CourseProgram, that_ends_or_talks_nonsense_is_named) {
    try {
        (void)make_external_mover("true");
        FAIL() << "it has ended";
    } catch (const MoverFailure& failure) {
        EXPECT_EQ(failure.text, "the program has ended");
    }
    try {
        (void)make_external_mover("echo hello; cat > /dev/null");
        FAIL() << "it does not greet";
    } catch (const MoverFailure& failure) {
        EXPECT_NE(failure.text.find("said 'hello'"), std::string::npos) << failure.text;
    }
    const auto silent = make_external_mover("echo surefoot-course 1; echo ready; echo at 0 0 0 2; cat > /dev/null");
    const course::Run run = plain_run({1, 0, 0});
    const Outing outing = walk_run(run, *silent);
    EXPECT_NE(outing.failure.find("'at X Y Z GROUNDED' was expected"), std::string::npos) << outing.failure;
}

}  // namespace
}  // namespace surefoot::course
