// Moments on a whole level: a few triangles of many answer as all of them do.
#include <algorithm>
#include <array>
#include <gtest/gtest.h>

#include <surefoot/import.hpp>
#include <surefoot/surefoot.hpp>

#include "world_things.hpp"

namespace surefoot {
namespace {

using namespace tests;

TEST(CaptureOfALevel, answers_as_the_level_with_the_gathered_triangles_alone) {
    const auto level = import_level(SUREFOOT_LEVELS_DIR "/training-ground.glb");
    ASSERT_TRUE(level.has_value()) << level.error().text;
    const auto mesh =
        Mesh::build({.vertices = level->vertices, .indices = level->indices, .surfaces = level->surfaces});
    ASSERT_TRUE(mesh.has_value()) << mesh.error().text;
    World world;
    ASSERT_TRUE(world.add(*mesh, {.pose = {{100, 3, -7}, dquat(1, 0, 0.25, 0)}, .body = 6}).has_value());

    SplitMix random(23);
    int hits = 0;
    std::size_t most = 0;
    for (int i = 0; i < 4000; ++i) {
        const Volume volume(every_shape[static_cast<std::size_t>(i) % 6],
                            i % 2 == 0 ? dquat(1, 0, 0, 0) : random.turn());
        const dvec3 from(random.in(-48, 48), random.in(-1, 8), random.in(-40, 40));
        const double length = i % 10 == 0 ? 60 : i % 3 == 0 ? 5 : 0.2;
        const Motion motion{from, from + random.point(length)};
        const QueryOptions options{.one_sided = i % 4 == 0};
        const Capture capture = capture_sweep(*mesh, volume, motion, options);
        ASSERT_TRUE(same_bits(capture.answer, mesh->sweep(volume, motion, options)));
        const auto read = parse_capture(capture_text(capture));
        ASSERT_TRUE(read.has_value()) << read.error().text;
        ASSERT_TRUE(replay(*read).is_same()) << capture_text(capture);
        hits += capture.answer ? 1 : 0;
        most = std::max(most, capture.triangles.size());

        const Motion there{motion.from + dvec3(100, 3, -7), motion.to + dvec3(100, 3, -7)};
        const Capture placed = capture_sweep(world, volume, there);
        ASSERT_TRUE(same_bits(placed.answer, world.sweep(volume, there)));
        ASSERT_TRUE(replay(placed).is_same()) << capture_text(placed);
    }
    EXPECT_GT(hits, 600);
    EXPECT_LT(hits, 3500);
    EXPECT_LT(most, mesh->triangle_count() / 10);
}

}  // namespace
}  // namespace surefoot
