// docs/debugger.md teaches with figures. They are those of the models, as long as these tests pass.
#include <cmath>
#include <fmt/format.h>
#include <fstream>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "debugger/gap_curve.hpp"
#include "debugger/made_step.hpp"
#include "debugger/method_table.hpp"
#include "debugger/side_by_side.hpp"
#include "debugger/strategies.hpp"
#include "debugger/voxel_lesson.hpp"
#include "debugger/worlds.hpp"

namespace surefoot::debugger {
namespace {

/// The page, with single blanks for ends of lines, so that it may be wrapped anywhere.
const std::string& page() {
    static const std::string text = [] {
        std::ifstream file(SUREFOOT_DOCS_DIR "/debugger.md");
        std::string word;
        std::string all;
        while (file >> word) all += word + ' ';
        return all;
    }();
    return text;
}

bool tells(const std::string& words) {
    return page().find(words) != std::string::npos;
}

/// As the page writes it.
std::string squared(std::string text) {
    for (std::size_t at = text.find("t^2"); at != text.npos; at = text.find("t^2")) text.replace(at, 3, "t²");
    return text;
}

TEST(Lesson, has_the_table_of_its_question) {
    const Question question = default_question(WorldKind::triangle);
    const MethodTable table = method_table(question.volume(), question.motion, question.triangles[0]);
    for (const Candidate& candidate : table.candidates) {
        const std::string row = fmt::format("| {} | `{}` |", candidate.name, squared(candidate.equation.text()));
        EXPECT_TRUE(tells(row)) << row;
        EXPECT_TRUE(tells(candidate.why)) << candidate.why;
    }
    EXPECT_TRUE(tells(table.conclusion)) << table.conclusion;
    const MethodTable late =
        method_table(question.volume(), question.motion, question.triangles[0], {.root = Root::upper});
    EXPECT_TRUE(tells(fmt::format("t = {}", short_text(*late.t))));
}

TEST(Lesson, has_the_gaps_of_its_question) {
    const Question question = default_question(WorldKind::triangle);
    const GapCurve curve = gap_curve(question.volume(), question.motion, question.triangles[0], 11);
    for (const std::size_t i : {0U, 4U, 5U, 6U, 10U}) {
        const std::string row = fmt::format("| {:.1f} | {:.3f} |", curve.samples[i].t, curve.samples[i].g);
        EXPECT_TRUE(tells(row)) << row;
    }
}

TEST(Lesson, has_the_tunnelling_of_its_question) {
    const Question question = default_question(WorldKind::triangle);
    const Arena arena(question.triangles);
    const double length = glm::length(question.motion.to - question.motion.from);
    const auto parts = touching_parts(arena, question.volume(), question.motion);
    const Tunnelling found = tunnelling(parts, length, 12);
    EXPECT_TRUE(tells(found.text)) << found.text;
    ASSERT_EQ(parts.size(), 1U);
    EXPECT_TRUE(tells(short_text(parts[0].begin) + " m to " + short_text(parts[0].end) + " m"));
    for (const int frames : {60, 15, 6, 5, 2}) {
        const Finding sampled = look_at_samples(arena, question.volume(), question.motion, step_of(12, frames));
        const std::string row = fmt::format("| {} | {} |", frames, sampled.text);
        EXPECT_TRUE(tells(row)) << row;
    }
}

TEST(Lesson, has_the_stand_off_of_each_shape) {
    for (const Contestant& contestant : contestants()) {
        std::string row = fmt::format("| {} |", contestant.name);
        for (const double degrees : {10.0, 30.0, 45.0})
            row += fmt::format(" {:.1f} |", 1000 * stand_off(contestant.shape, degrees * std::acos(-1.0) / 180));
        EXPECT_TRUE(tells(row)) << row;
    }
}

TEST(Lesson, has_the_skin_of_the_cone_s_tip_and_how_steep_its_side_is) {
    const Shape cone = contestants()[2].shape;
    EXPECT_TRUE(tells(fmt::format("the tip of this cone is {:.0f} mm off", 1000 * read_slope(cone, 0).clearance)));
    const Cone& side = std::get<Cone>(cone);
    const double degrees = std::atan2(side.height, side.radius) * 180 / std::acos(-1.0);
    EXPECT_TRUE(tells(fmt::format("its side meets an edge as a slope of {:.0f} degrees", degrees)));
}

TEST(Lesson, has_the_steps_of_the_voxels) {
    for (const VoxelMethod method : {VoxelMethod::all_from_the_start, VoxelMethod::each_from_the_last}) {
        const VoxelLesson lesson = voxel_lesson(corner_scene(), method);
        for (const VoxelStep& step : lesson.steps) EXPECT_TRUE(tells(step.text)) << step.text;
        EXPECT_TRUE(tells(lesson.conclusion)) << lesson.conclusion;
    }
}

}  // namespace
}  // namespace surefoot::debugger
