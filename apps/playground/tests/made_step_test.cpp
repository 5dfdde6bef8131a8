// A question as one step of a character: the RESULT of the Debugger.
#include "debugger/made_step.hpp"

#include <cstring>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <string>

#include "debugger/arena.hpp"
#include "debugger/worlds.hpp"

namespace surefoot::debugger {
namespace {

template <typename T>
bool same_bits(const T& a, const T& b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

MadeStep made(const Question& question) {
    return make_step(Arena(question.triangles).world(), order_of(question));
}

const StepRecord* first(const MadeStep& step, StepAct act) {
    for (const StepRecord& record : step.records)
        if (record.act == act) return &record;
    return nullptr;
}

/// A wall across x at 5, met at 45 degrees.
Question at_a_wall() {
    Question question;
    question.world = WorldKind::own;
    question.triangles = {{{5, -9, -50}, {5, 9, -50}, {5, 0, 50}}};
    question.shape = ShapeName::sphere;
    question.sizes.sphere.radius = 0.5;
    question.motion = {{0, 0, 0}, {8, 0, 8}};
    return question;
}

TEST(QuestionAsStep, wants_the_very_way_from_start_to_end) {
    for (const dvec3& way : {dvec3(-3, -8, 1), dvec3(0.1, 0.2, 0.3), dvec3(1e-7, 0, -3e4), dvec3(1.0 / 3, 1e-300, 7)}) {
        Question question;
        question.motion = {{0.7, 1e4 / 3, -2}, dvec3(0.7, 1e4 / 3, -2) + way};
        const MadeStep step = made(question);
        const StepRecord* const wants = first(step, StepAct::wants);
        ASSERT_NE(wants, nullptr);
        EXPECT_TRUE(same_bits(wants->motion, question.motion.to - question.motion.from));
        EXPECT_TRUE(
            same_bits(step.result.state.position, question.motion.from + (question.motion.to - question.motion.from)));
    }
}

TEST(QuestionAsStep, is_the_step_called_by_hand) {
    for (const WorldKind world : {WorldKind::triangle, WorldKind::fold, WorldKind::wedge}) {
        const Question question = default_question(world);
        const Arena arena(question.triangles);
        const dvec3 way = question.motion.to - question.motion.from;
        CharacterSettings settings;
        settings.volume = question.volume();
        settings.longest_tick = 1;
        CharacterState state;
        state.position = question.motion.from;
        state.velocity = way;
        const StepResult by_hand = step(arena.world(), settings, {.wish = way, .mode = CharacterMode::fly}, 1, state);
        const MadeStep step = make_step(arena.world(), order_of(question));
        EXPECT_TRUE(same_bits(step.result.state, by_hand.state)) << title_of(world);
        EXPECT_EQ(step.result.events.set, by_hand.events.set) << title_of(world);
        EXPECT_NE(step.result.state.position, question.motion.to) << title_of(world) << " is where it is stopped";
        EXPECT_NE(first(step, StepAct::obeyed), nullptr) << "and has its story";
    }
}

TEST(QuestionAsStep, stops_a_skin_short_of_a_wall_and_slides_along_it) {
    const Question question = at_a_wall();
    const dvec3 rests = made(question).result.state.position;
    EXPECT_NEAR(rests.x, 4.5 - skin_of(question.volume().shape), 1e-9);
    EXPECT_NEAR(rests.z, 8, 1e-9);
}

TEST(QuestionAsStep, goes_nowhere_into_a_corner) {
    Question question = at_a_wall();
    question.triangles.push_back({{-50, -9, 5}, {50, -9, 5}, {0, 9, 5}});
    question.motion = {{4, 0, 4}, {7, 0, 6}};
    const MadeStep step = made(question);
    EXPECT_NEAR(step.result.state.position.x, 4.49, 1e-9);
    EXPECT_NEAR(step.result.state.position.z, 4.49, 1e-9);
    EXPECT_NE(first(step, StepAct::rested), nullptr);
}

TEST(QuestionAsStep, is_whole_for_the_smallest_of_shapes_and_refused_where_there_is_none) {
    Question question = at_a_wall();
    question.sizes.sphere.radius = 1e-3;
    EXPECT_FALSE(made(question).result.events.has(CharacterEvent::invalid));
    question.sizes.sphere.radius = 0;
    const MadeStep step = made(question);
    EXPECT_TRUE(step.result.events.has(CharacterEvent::invalid));
    EXPECT_EQ(step.result.state.position, question.motion.from);
}

TEST(QuestionAsStep, is_saved_and_recorded_with_the_same_story) {
    const Question question = at_a_wall();
    const Arena arena(question.triangles);
    const StepOrder order = order_of(question);
    const StepCapture saved = capture_step(arena.world(), order.settings, order.input, order.dt, order.before);
    const MadeStep recorded = recorded_step(saved);
    const MadeStep step = make_step(arena.world(), order);
    EXPECT_TRUE(same_bits(recorded.result.state, step.result.state));
    ASSERT_EQ(recorded.records.size(), step.records.size());
    EXPECT_EQ(explain_text(recorded.story()), explain_text(step.story()));
    EXPECT_TRUE(replay(saved).is_same());
}

TEST(QuestionAsStep, meets_the_doubles_of_its_triangles_and_not_floats) {
    Question question = at_a_wall();
    const double wall = 5 + 1e-12;
    for (dvec3* corner : {&question.triangles[0].a, &question.triangles[0].b, &question.triangles[0].c})
        corner->x = wall;
    EXPECT_NE(made(question).result.state.position.x, made(at_a_wall()).result.state.position.x);
}

}  // namespace
}  // namespace surefoot::debugger
