#include "debugger/question.hpp"

#include <gtest/gtest.h>

#include "debugger/arena.hpp"
#include "debugger/question_text.hpp"
#include "debugger/worlds.hpp"
#include "query.hpp"

namespace surefoot::debugger {
namespace {

constexpr WorldKind small_worlds[] = {WorldKind::triangle, WorldKind::fold, WorldKind::wedge};

std::optional<Hit> answer(const Question& question) {
    return Arena(question.triangles).sweep(question.volume(), question.motion, question.one_sided);
}

bool says(const std::vector<Remark>& all, bool refused, const std::string& words) {
    for (const Remark& remark : all)
        if (remark.refused == refused && remark.text.find(words) != remark.text.npos) return true;
    return false;
}

TEST(Question, of_every_world_shows_something_by_default) {
    for (const WorldKind world : small_worlds) {
        const Question question = default_question(world);
        const auto hit = answer(question);
        ASSERT_TRUE(hit) << title_of(world);
        EXPECT_GT(hit->t, 0.2) << title_of(world);
        EXPECT_LT(hit->t, 0.9) << title_of(world);
        EXPECT_TRUE(remarks(question).empty()) << title_of(world);
    }
    EXPECT_EQ(answer(default_question(WorldKind::triangle))->feature, Feature::edge);
    EXPECT_EQ(answer(default_question(WorldKind::fold))->feature, Feature::edge);
    // What stops the ball in the wedge is the triangle that leans over, long before it is over the edge of the first.
    EXPECT_EQ(answer(default_question(WorldKind::wedge))->triangle, 1U);
}

TEST(Question, in_a_level_comes_down_through_its_middle) {
    const Question question = question_in_level("hall.glb", {{-10, -1, -20}, {30, 9, 20}});
    EXPECT_EQ(question.world, WorldKind::level);
    EXPECT_GT(question.motion.from.y, 9);
    EXPECT_LT(question.motion.to.y, -1);
    EXPECT_TRUE(remarks(question).empty());
}

TEST(Question, keeps_the_sizes_of_each_shape) {
    ShapeSizes sizes;
    sizes.set(Box{{1, 2, 3}});
    sizes.set(Sphere{7});
    EXPECT_EQ(std::get<Box>(sizes.get(ShapeName::box)).half_extents, dvec3(1, 2, 3));
    EXPECT_EQ(std::get<Sphere>(sizes.get(ShapeName::sphere)).radius, 7);
    for (int i = 0; i < 6; ++i) {
        const auto name = static_cast<ShapeName>(i);
        EXPECT_EQ(name_of(sizes.get(name)), name);
    }
}

TEST(Question, says_in_words_what_is_wrong) {
    Question question = default_question(WorldKind::triangle);
    question.sizes.ellipsoid.radii.x = 0;
    question.motion.from.y = 2e9;
    question.triangles[0].b.x = NAN;
    const auto all = remarks(question);
    EXPECT_TRUE(says(all, true, "between 1e-6 and 1e6 metres"));
    EXPECT_TRUE(says(all, true, "START: every coordinate"));
    EXPECT_TRUE(says(all, true, "triangle 0: every coordinate"));
}

TEST(Question, says_in_words_what_is_odd) {
    Question still = default_question(WorldKind::triangle);
    still.motion.to = still.motion.from;
    EXPECT_TRUE(says(remarks(still), false, "one place"));

    Question from_behind = default_question(WorldKind::triangle);
    std::swap(from_behind.motion.from, from_behind.motion.to);
    EXPECT_TRUE(remarks(from_behind).empty());
    from_behind.one_sided = true;
    EXPECT_TRUE(says(remarks(from_behind), false, "from behind"));
    EXPECT_FALSE(answer(from_behind));

    Question flat = default_question(WorldKind::triangle);
    flat.triangles[0].c = {0, 0, 5};
    EXPECT_TRUE(says(remarks(flat), false, "no area"));
}

TEST(Question, snaps_to_a_grid) {
    EXPECT_EQ(snapped({1.13, -0.38, 0.1}, 0.25), dvec3(1.25, -0.5, 0));
    EXPECT_EQ(snapped({1.13, -0.38, 0.1}, 0), dvec3(1.13, -0.38, 0.1));
}

TEST(QuestionText, comes_back_to_the_last_bit) {
    for (const WorldKind world : small_worlds) {
        Question question = default_question(world);
        for (int i = 0; i < 6; ++i) {
            question.shape = static_cast<ShapeName>(i);
            question.motion.from = {1.0 / 3, -2e-300, 1e8 / 7};
            question.orientation = dquat(0.7, 0.1, 1.0 / 7, -3);
            question.one_sided = i % 2 == 0;
            Question other = default_question(WorldKind::wedge);
            other.sizes = question.sizes;
            const auto read = from_line(to_line(question), other);
            ASSERT_TRUE(read) << read.error();
            EXPECT_TRUE(*read == question) << to_line(question);
        }
    }
}

TEST(QuestionText, without_its_triangles_is_a_line_of_the_command_line) {
    Question question = question_in_level("hall.glb", {{-10, -1, -20}, {30, 9, 20}});
    const auto query = tools::parse_query(to_line(question), {});
    ASSERT_TRUE(query) << query.error();
    EXPECT_EQ(query->motion.from, question.motion.from);
    EXPECT_EQ(query->motion.to, question.motion.to);
}

TEST(QuestionText, of_a_line_without_triangles_keeps_the_world) {
    const Question now = default_question(WorldKind::fold);
    const auto read = from_line(R"({"shape":{"box":[1,2,3]},"from":[0,9,0],"to":[0,-9,0]})", now);
    ASSERT_TRUE(read) << read.error();
    EXPECT_EQ(read->world, WorldKind::fold);
    EXPECT_EQ(read->triangles.size(), 2U);
    EXPECT_EQ(read->shape, ShapeName::box);
    EXPECT_EQ(read->sizes.ellipsoid.radii, now.sizes.ellipsoid.radii);
}

TEST(QuestionText, knows_our_own_worlds_from_others) {
    Question question = default_question(WorldKind::triangle);
    question.triangles[0].a.x = 1;
    const auto read = from_line(to_line(question), default_question(WorldKind::fold));
    ASSERT_TRUE(read) << read.error();
    EXPECT_EQ(read->world, WorldKind::own);
    EXPECT_EQ(from_line(to_line(default_question(WorldKind::wedge)), question)->world, WorldKind::wedge);
}

TEST(QuestionText, says_what_is_wrong_with_a_line) {
    const Question now = default_question(WorldKind::triangle);
    const auto why = [&](const char* line) {
        const auto read = from_line(line, now);
        return read ? std::string("nothing") : read.error();
    };
    const auto has = [](const std::string& text, const char* words) { return text.find(words) != text.npos; };
    EXPECT_TRUE(has(why("hello"), "not JSON"));
    EXPECT_TRUE(has(why(R"({"from":[0,0,0]})"), R"("to" is missing)"));
    EXPECT_TRUE(has(why(R"({"from":[0,0,0],"to":[0,0,1],"triangle":[]})"), R"("triangle" means nothing here)"));
    EXPECT_TRUE(has(why(R"({"from":[0,0,0],"to":[0,0,1],"triangles":[]})"), R"("triangles" must be a list)"));
    EXPECT_TRUE(has(why(R"({"from":[0,0,0],"to":[0,0,1],"triangles":[[[0,0,0],[0,0,1],[1,0]]]})"), "must be a list"));
    EXPECT_TRUE(has(why(R"({"from":[0,0,0],"to":[0,0,1],"triangles":[[[0,0,0],[0,0,1],[2e9,0,0]]]})"), "1e9 metres"));
    // Which of the two is meant is not ours to guess.
    EXPECT_NE(why(R"({"from":[0,0,0],"from":[1,0,0],"to":[0,0,1],"triangles":[[[0,0,0],[0,0,1],[1,0,0]]]})"),
              "nothing");
}

}  // namespace
}  // namespace surefoot::debugger
