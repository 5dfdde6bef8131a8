// What a fuzz target leaves behind when something goes wrong.
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <gtest/gtest.h>
#include <optional>
#include <string>

#include "fuzz/bytes.hpp"

namespace surefoot {
namespace {

namespace fs = std::filesystem;

const Triangle ground{{-4, 0, -4}, {0, 0, 4}, {4, 0, -4}};
const Volume ball{Sphere{0.5}};
const Motion fall{{0, 3, 0}, {0, -3, 0}};

class FuzzAsking : public testing::Test {
protected:
    void SetUp() override {
        testing::GTEST_FLAG(death_test_style) = "threadsafe";
        fs::remove_all(folder_);
        fs::create_directories(folder_);
        setenv("SUREFOOT_FUZZ_FINDINGS", folder_.c_str(), 1);
    }
    void TearDown() override {
        unsetenv("SUREFOOT_FUZZ_UNDER_WAY");
        fs::remove_all(folder_);
    }

    [[nodiscard]] std::optional<Capture> found() const {
        std::optional<Capture> moment;
        for (const auto& entry : fs::directory_iterator(folder_)) {
            EXPECT_FALSE(moment) << "more than one";
            auto read = read_capture(entry.path().string());
            EXPECT_TRUE(read) << read.error().text;
            if (read) moment = std::move(*read);
        }
        return moment;
    }

    // Tests run beside each other, of several builds too. A death test runs in a process of its own and looks in the
    // same folder, so the name goes by the program and the test.
    static std::string name_of_folder() {
        const std::size_t program = std::hash<std::string>{}(fs::read_symlink("/proc/self/exe").string());
        return "surefoot-" + std::to_string(program) + testing::UnitTest::GetInstance()->current_test_info()->name();
    }

    fs::path folder_ = fs::path(testing::TempDir()) / name_of_folder();
};

const auto asked = [] { return capture_sweep(ground, ball, fall); };
const auto bare = [] { return fuzz::unasked(ground, {.volume = ball, .motion = fall}); };

void break_a_promise() {
    const fuzz::Asking asking(asked, bare);
    const auto hit = sweep(ball, fall, ground);
    fuzz::require(!hit, "nothing is ever hit");
}

void never_answer() {
    const fuzz::Asking asking(asked, bare);
    std::_Exit(3);  // as a sanitizer does
}

TEST_F(FuzzAsking, a_broken_promise_leaves_the_question_with_its_answer) {
    EXPECT_DEATH(break_a_promise(), "broken promise: nothing is ever hit");
    const auto moment = found();
    ASSERT_TRUE(moment);
    EXPECT_NE(moment->note.find("nothing is ever hit"), std::string::npos);
    ASSERT_TRUE(moment->answer);
    EXPECT_TRUE(replay(*moment).is_same());
}

TEST_F(FuzzAsking, a_promise_that_is_broken_while_nothing_is_asked_leaves_nothing) {
    EXPECT_DEATH(fuzz::require(false, "no question"), "broken promise: no question");
    EXPECT_FALSE(found());
}

TEST_F(FuzzAsking, a_question_that_ends_the_program_is_left_under_way) {
    setenv("SUREFOOT_FUZZ_UNDER_WAY", (folder_ / "moment.json").c_str(), 1);
    EXPECT_EXIT(never_answer(), testing::ExitedWithCode(3), "");
    const auto moment = found();
    ASSERT_TRUE(moment);
    ASSERT_EQ(moment->triangles.size(), 1U);
    EXPECT_EQ(moment->triangles[0].triangle.c, ground.c);
    EXPECT_FALSE(moment->answer);
    const Replay again = replay(*moment);
    ASSERT_TRUE(again.answer);
    EXPECT_EQ(again.answer->t, sweep(ball, fall, ground)->t);
}

TEST_F(FuzzAsking, a_question_that_was_answered_leaves_nothing_under_way) {
    setenv("SUREFOOT_FUZZ_UNDER_WAY", (folder_ / "moment.json").c_str(), 1);
    {
        const fuzz::Asking asking(asked, bare);
        EXPECT_TRUE(found());
    }
    EXPECT_FALSE(found());
}

TEST_F(FuzzAsking, all_of_a_mesh_is_kept_with_its_numbers) {
    const vec3 corners[] = {{-9, 0, -9}, {9, 0, -9}, {9, 0, 9}, {-9, 0, 9}};
    const std::uint32_t indices[] = {0, 3, 2, 0, 2, 1};
    const std::uint32_t surfaces[] = {0, 7};
    const auto mesh = Mesh::build({.vertices = corners, .indices = indices, .surfaces = surfaces});
    ASSERT_TRUE(mesh);
    const Capture moment = fuzz::unasked(*mesh, {.volume = ball, .motion = {{2, 3, -5}, {2, -3, -5}}});
    ASSERT_EQ(moment.triangles.size(), 2U);
    EXPECT_EQ(moment.triangles[1].id, 1U);
    EXPECT_EQ(moment.triangles[1].surface, 7U);
    const Replay again = replay(moment);
    EXPECT_FALSE(difference_of(again.answer, mesh->sweep(ball, {{2, 3, -5}, {2, -3, -5}})).any());
}

}  // namespace
}  // namespace surefoot
