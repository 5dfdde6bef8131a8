#include "debugger/history.hpp"

#include <gtest/gtest.h>

#include "debugger/worlds.hpp"

namespace surefoot::debugger {
namespace {

TEST(History, goes_back_and_forth_over_every_kind_of_edit) {
    History history(default_question(WorldKind::fold));
    const Edit edits[] = {MoveStart{{1, 2, 3}},
                          MoveEnd{{-1, -2, -3}},
                          MoveCorner{.triangle = 1, .corner = 1, .to = {-5, 0, 0}},
                          ChooseShape{ShapeName::cone},
                          Resize{Box{{1, 2, 3}}},
                          Turn{dquat(1, 1, 0, 0)},
                          ChooseSides{true},
                          Replace{default_question(WorldKind::wedge)}};
    std::vector<Question> seen{history.now()};
    for (const Edit& edit : edits) {
        history.apply(edit);
        EXPECT_FALSE(history.now() == seen.back()) << title_of(edit);
        EXPECT_EQ(history.undo_title(), title_of(edit));
        seen.push_back(history.now());
    }
    for (std::size_t i = seen.size() - 1; i > 0; --i) {
        ASSERT_TRUE(history.undo());
        EXPECT_TRUE(history.now() == seen[i - 1]);
    }
    EXPECT_FALSE(history.undo());
    for (std::size_t i = 1; i < seen.size(); ++i) {
        ASSERT_TRUE(history.redo());
        EXPECT_TRUE(history.now() == seen[i]);
    }
    EXPECT_FALSE(history.redo());
}

TEST(History, takes_a_drag_as_one_step) {
    History history(default_question(WorldKind::triangle));
    const Question before = history.now();
    history.apply(MoveStart{{0, 5, 0}});
    history.begin_drag();
    for (int i = 0; i < 50; ++i) history.apply(MoveStart{{0.1 * i, 6, 0}});
    history.end_drag();
    EXPECT_EQ(history.now().motion.from, dvec3(0.1 * 49, 6, 0));
    ASSERT_TRUE(history.undo());
    EXPECT_EQ(history.now().motion.from, dvec3(0, 5, 0)) << "what was before the drag is a step of its own";
    ASSERT_TRUE(history.undo());
    EXPECT_TRUE(history.now() == before);
}

TEST(History, keeps_two_drags_and_two_things_apart) {
    History history(default_question(WorldKind::triangle));
    for (int drag = 0; drag < 2; ++drag) {
        history.begin_drag();
        history.apply(MoveEnd{{drag + 1.0, 0, 0}});
        history.apply(MoveEnd{{drag + 1.5, 0, 0}});
        history.end_drag();
    }
    ASSERT_TRUE(history.undo());
    EXPECT_EQ(history.now().motion.to, dvec3(1.5, 0, 0));
    history.begin_drag();
    history.apply(MoveCorner{.corner = 0, .to = {1, 1, 1}});
    history.apply(MoveCorner{.corner = 1, .to = {2, 2, 2}});
    history.end_drag();
    ASSERT_TRUE(history.undo());
    EXPECT_EQ(history.now().triangles[0].a, dvec3(1, 1, 1));
    EXPECT_EQ(history.now().triangles[0].b, dvec3(0, 0, 10));
}

TEST(History, forgets_what_was_undone_when_something_new_is_done) {
    History history(default_question(WorldKind::triangle));
    history.apply(MoveStart{{1, 1, 1}});
    ASSERT_TRUE(history.undo());
    EXPECT_EQ(history.redo_title(), "move START");
    history.apply(MoveStart{history.now().motion.from});
    EXPECT_EQ(history.redo_title(), "move START") << "what changes nothing is no step";
    history.apply(ChooseSides{true});
    EXPECT_FALSE(history.redo());
}

TEST(History, moves_corners_at_one_place_together_unless_told_otherwise) {
    const Question fold = default_question(WorldKind::fold);
    const Question together = edited(fold, MoveCorner{.triangle = 0, .corner = 1, .to = {-4, 5, 5}});
    EXPECT_EQ(together.triangles[0].b, dvec3(-4, 5, 5));
    EXPECT_EQ(together.triangles[1].c, dvec3(-4, 5, 5));
    const Question alone = edited(fold, MoveCorner{.triangle = 0, .corner = 1, .to = {-4, 5, 5}, .alone = true});
    EXPECT_EQ(alone.triangles[0].b, dvec3(-4, 5, 5));
    EXPECT_EQ(alone.triangles[1].c, dvec3(-4, 3, 5));
    EXPECT_TRUE(edited(fold, MoveCorner{.triangle = 9, .corner = 0, .to = {}}) == fold);
}

TEST(History, forgets_the_oldest_steps) {
    History history(default_question(WorldKind::triangle));
    for (std::size_t i = 0; i < History::most_steps + 5; ++i) history.apply(MoveStart{{static_cast<double>(i), 0, 0}});
    std::size_t steps = 0;
    while (history.undo()) ++steps;
    EXPECT_EQ(steps, History::most_steps);
    EXPECT_EQ(history.now().motion.from, dvec3(4, 0, 0));
}

}  // namespace
}  // namespace surefoot::debugger
