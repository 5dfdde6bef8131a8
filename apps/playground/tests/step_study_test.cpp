// "Why did I stop?" in the debugger: a saved step, its lines, and the same step with other settings.
#include "debugger/step_study.hpp"

#include <cstring>
#include <filesystem>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <string>

#include "character_words.hpp"
#include "debugger/saved_step.hpp"
#include "debugger/step_words.hpp"

namespace surefoot::debugger {
namespace {

constexpr double kerb = 0.46;  // higher than a step may be by default [m]

/// A floor, and a kerb across x at 2; triangles as they are typed.
std::vector<Triangle> street() {
    const dvec3 a(-4, 0, -4), b(-4, 0, 4), c(2, 0, 4), d(2, 0, -4);
    const dvec3 e(2, kerb, 4), f(2, kerb, -4), g(6, kerb, 4), h(6, kerb, -4);
    return {{a, b, c}, {a, c, d}, {d, c, e}, {d, e, f}, {f, e, g}, {f, g, h}};
}

/// Somebody who has walked into the kerb, saved in the tick in which it is asked why.
StepCapture before_the_kerb(const Arena& arena) {
    CharacterSettings settings;
    settings.volume = Cylinder{.radius = 0.35, .half_height = 0.9};
    const CharacterInput input{.wish = {3, 0, 0.6}};
    CharacterState state;
    state.position = {0, 1, 0};
    for (int i = 0; i < 60; ++i) state = step(arena.world(), settings, input, 1.0 / 60, state).state;
    return capture_step(arena.world(), settings, input, 1.0 / 60, state);
}

StepCapture before_the_kerb() {
    return before_the_kerb(Arena(street()));
}

const Dial& dial(const std::string& label) {
    for (const Dial& one : dials())
        if (one.label == label) return one;
    ADD_FAILURE() << label;
    return dials().front();
}

bool tells(const std::vector<StepSentence>& sentences, const std::string& words) {
    for (const StepSentence& sentence : sentences)
        if (sentence.text.find(words) != std::string::npos) return true;
    return false;
}

bool same_records(const std::vector<StepRecord>& a, const std::vector<StepRecord>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(StepRecord)) == 0;
}

TEST(StepStudy, of_a_saved_step_has_its_story_and_its_reasons) {
    const StepCapture saved = before_the_kerb();
    const StepStudy study(saved);
    EXPECT_TRUE(study.recorded().result.state == saved.after);
    EXPECT_TRUE(same_records(study.recorded().records, saved.records));
    EXPECT_TRUE(tells(study.why(), "triangle 2"));
    EXPECT_TRUE(tells(study.why(), "0.46 m higher, and step_up is 0.4"));
}

TEST(StepStudy, with_nothing_edited_is_the_same_to_the_last_bit) {
    const StepCapture saved = before_the_kerb();
    const StepStudy study(saved);
    EXPECT_FALSE(study.is_edited());
    EXPECT_TRUE(study.again().result.state == saved.after);
    EXPECT_TRUE(same_records(study.again().records, saved.records));
    EXPECT_EQ(study.difference(), "The same, to the last bit.");
}

TEST(StepStudy, makes_the_step_again_as_step_itself_would_with_the_edited_setting) {
    const Arena arena(street());
    const StepCapture saved = before_the_kerb(arena);
    StepStudy study(saved);
    study.set(dial("Step up"), 0.5);
    EXPECT_TRUE(study.is_edited());
    CharacterSettings settings = saved.settings;
    settings.step_up = 0.5;
    const StepResult by_hand = step(arena.world(), settings, saved.input, saved.dt, saved.before);
    EXPECT_TRUE(study.again().result.state == by_hand.state);
    EXPECT_EQ(study.again().result.events.set, by_hand.events.set);
    EXPECT_NEAR(study.again().result.state.position.y - saved.before.position.y, kerb, 1e-6) << "it is up there";
    EXPECT_TRUE(study.recorded().result.state == saved.after) << "the recorded one stays what it was";
    study.reset();
    EXPECT_FALSE(study.is_edited());
    EXPECT_TRUE(study.again().result.state == saved.after);
}

TEST(StepStudy, says_what_the_edited_setting_changes) {
    StepStudy study(before_the_kerb());
    study.set(dial("Step up"), 0.5);
    const std::string difference = study.difference();
    EXPECT_NE(difference.find("0.46 m higher"), std::string::npos) << difference;
    EXPECT_NE(difference.find("Now: stepped up."), std::string::npos) << difference;
    EXPECT_NE(difference.find("\"no step: 0.46 m higher, allowed are 0.4 m\" then, \"stepped up by 0.46 m\" now"),
              std::string::npos)
        << difference;
    // A number that decides nothing here.
    study.reset();
    study.set(dial("Gravity"), 30);
    EXPECT_TRUE(study.is_edited());
    EXPECT_EQ(study.difference(), "The same, to the last bit.");
}

TEST(StepStudy, of_a_live_step_asks_the_whole_world_again) {
    const Arena arena(street());
    const StepCapture saved = before_the_kerb(arena);
    StepStudy study(arena, recorded_step(saved));
    EXPECT_EQ(study.difference(), "The same, to the last bit.");
    study.set(dial("Step up"), 0.5);
    EXPECT_TRUE(study.again().result.events.has(CharacterEvent::stepped_up));
    EXPECT_TRUE(replay(study.capture()).is_same()) << "what is kept is the step as it was made";
    EXPECT_TRUE(study.capture().after == saved.after);
}

TEST(StepStudy, turns_the_grip_of_the_ground_and_the_response) {
    StepCapture saved = before_the_kerb();
    saved.before.position.x -= 1;
    saved.before.velocity = {0, 0, 0};
    StepStudy study(saved);
    const double firm = study.again().result.state.velocity.x;
    EXPECT_EQ(study.grip(), 1);
    study.set_grip(0.05);
    EXPECT_TRUE(study.is_edited());
    EXPECT_LT(study.again().result.state.velocity.x, 0.1 * firm) << "as on ice";
    study.reset();
    EXPECT_EQ(study.again().result.state.velocity.x, firm);
    study.set_response(Response::stop);
    EXPECT_TRUE(study.is_edited());
}

TEST(StepStudy, refuses_settings_that_cannot_be_in_words) {
    StepStudy study(before_the_kerb());
    study.set(dial("Skin"), 0.1);
    EXPECT_TRUE(study.again().result.events.has(CharacterEvent::invalid));
    EXPECT_TRUE(tells(study.why_again(), "skin, 0.1, is out of its range"));
}

TEST(StepStudy, has_dials_with_every_default_in_their_reach) {
    for (const Dial& one : dials()) {
        EXPECT_GE(CharacterSettings{}.*one.field, one.low) << one.label;
        EXPECT_LE(CharacterSettings{}.*one.field, one.high) << one.label;
    }
}

TEST(StepStudy, finds_the_triangle_that_a_line_names) {
    const StepCapture saved = before_the_kerb();
    const StepStudy study(saved);
    std::size_t named = 0;
    for (const StepRecord& record : study.recorded().records) {
        const auto triangle = study.triangle_of(record);
        EXPECT_EQ(triangle.has_value(), names_triangle(record)) << title_of(record);
        if (!triangle) continue;
        ++named;
        EXPECT_EQ(triangle->a, street()[record.triangle].a);
    }
    EXPECT_GT(named, 3U);
}

TEST(StepWords, tell_every_line_with_its_number_and_lay_it_in_what_it_is_part_of) {
    const StepCapture saved = before_the_kerb();
    const std::vector<int> depths = depths_of(saved.records);
    ASSERT_EQ(depths.size(), saved.records.size());
    bool looked = false;
    for (std::size_t i = 0; i < depths.size(); ++i) {
        const StepRecord& record = saved.records[i];
        EXPECT_NE(title_of(record), "unknown");
        EXPECT_NE(meaning_of(record), "") << title_of(record);
        if (record.act == StepAct::touch) {
            EXPECT_EQ(depths[i], looked ? 2 : 1) << i;
        }
        if (record.act == StepAct::step_tried) looked = true;
        if (record.act == StepAct::step_refused) {
            looked = false;
            EXPECT_EQ(depths[i], 0);
            EXPECT_EQ(title_of(record), "no step: 0.46 m higher, allowed are 0.4 m");
            EXPECT_NE(numbers_of(record).find("of      triangle 4 of body 0"), std::string::npos) << numbers_of(record);
        }
    }
    EXPECT_EQ(title_of({.value = 0.5, .triangle = 7, .act = StepAct::touch, .feature = Feature::edge}),
              "touch: an edge of triangle 7, after 50 %");
}

TEST(StepWords, have_a_title_for_every_act_and_a_name_for_every_event) {
    for (int act = 0; act <= static_cast<int>(StepAct::met_neighbour); ++act)
        EXPECT_NE(title_of({.act = static_cast<StepAct>(act)}), "unknown") << act;
    EXPECT_EQ(tools::events_text({}), "none");
    EXPECT_EQ(tools::events_text({.set = static_cast<std::uint32_t>(CharacterEvent::met_neighbour)}),
              "met a neighbour");
    EXPECT_EQ(tools::events_text({.set = static_cast<std::uint32_t>(CharacterEvent::blocked) |
                                         static_cast<std::uint32_t>(CharacterEvent::stepped_up)}),
              "stepped up, blocked");
}

TEST(SavedStep, becomes_a_question_from_where_it_stands_to_where_it_wanted_to_be) {
    const StepCapture saved = before_the_kerb();
    const auto opened = step_from_text(capture_text(saved), "here");
    ASSERT_TRUE(opened) << opened.error().text;
    EXPECT_EQ(opened->differs, "");
    EXPECT_EQ(opened->question.motion.from, saved.before.position);
    EXPECT_EQ(opened->question.shape, ShapeName::cylinder);
    EXPECT_EQ(opened->question.sizes.cylinder.radius, 0.35);
    EXPECT_EQ(opened->question.triangles.size(), saved.triangles.size());
    const dvec3 way = opened->question.motion.to - opened->question.motion.from;
    EXPECT_GT(way.x, 0);
    EXPECT_GT(glm::length(way), glm::length(saved.after.position - saved.before.position)) << "it wanted more";
}

TEST(SavedStep, of_other_bits_and_of_no_step_is_told) {
    StepCapture wrong = before_the_kerb();
    wrong.after.position.x += 1e-9;
    const auto opened = step_from_text(capture_text(wrong), "here");
    ASSERT_TRUE(opened);
    EXPECT_NE(opened->differs.find("position"), std::string::npos) << opened->differs;
    EXPECT_NE(verdict_text(*opened).find("another"), std::string::npos);
    EXPECT_FALSE(step_from_text("{}", "here"));
    EXPECT_FALSE(open_step((std::filesystem::path(testing::TempDir()) / "no-such-step.json").string()));
}

TEST(SavedStep, that_asks_for_what_cannot_be_is_shown_and_told) {
    StepCapture wrong = before_the_kerb();
    wrong.input.up = {0, 0, 0};
    const auto opened = step_from_text(capture_text(wrong), "here");
    ASSERT_TRUE(opened) << opened.error().text;
    EXPECT_NE(opened->differs, "") << "this build refuses it";
    EXPECT_TRUE(is_valid(opened->question.volume()));
    const StepStudy study(opened->capture);
    EXPECT_TRUE(study.again().result.events.has(CharacterEvent::invalid));
    EXPECT_TRUE(tells(study.why_again(), "Nothing was moved"));
    EXPECT_EQ(study.difference().find("nan"), std::string::npos) << study.difference();
}

TEST(SavedStep, of_a_body_that_moves_stands_where_the_tick_begins) {
    StepCapture saved = before_the_kerb();
    for (CapturedBody& body : saved.bodies) {
        body.start.position = {0, 0, 5};
        body.end.position = {0, 1, 5};
    }
    const auto opened = step_from_text(capture_text(saved), "here");
    ASSERT_TRUE(opened) << opened.error().text;
    EXPECT_EQ(opened->question.triangles[0].a, street()[0].a + dvec3(0, 0, 5));
    EXPECT_NE(opened->remark, "");
    EXPECT_EQ(triangle_at_start(saved, 0, 0)->a, street()[0].a + dvec3(0, 0, 5));
    EXPECT_FALSE(triangle_at_start(saved, 0, 1000));
}

}  // namespace
}  // namespace surefoot::debugger
