#include "world_things.hpp"

namespace surefoot {
namespace {

using namespace tests;

bool same_bits(const Pose& a, const Pose& b) {
    return tests::same_bits(a.position, b.position) && tests::same_bits(a.orientation.w, b.orientation.w) &&
           tests::same_bits(a.orientation.x, b.orientation.x) && tests::same_bits(a.orientation.y, b.orientation.y) &&
           tests::same_bits(a.orientation.z, b.orientation.z);
}

struct Moving {
    World world;
    std::vector<BodyHandle> handles;
    SplitMix random{91};

    Moving() {
        for (std::uint32_t i = 0; i < 20; ++i) {
            const auto added = world.add(soup(300 + i, 10, 2).mesh(),
                                         {.pose = any_pose(random, 6), .body = 5 * i, .layers = i % 4 == 0 ? 2u : 1u});
            EXPECT_TRUE(added);
            handles.push_back(*added);
        }
    }
    void tick() {
        world.begin_tick();
        for (const BodyHandle handle : handles) {
            if (random.in(0, 1) < 0.5) {
                EXPECT_TRUE(world.move(handle, any_pose(random, 6)));
            }
        }
    }
    std::vector<Hit> answers() const {
        SplitMix questions(92);
        std::vector<Hit> hits;
        for (int i = 0; i < 60; ++i) {
            const Volume volume(every_shape[static_cast<std::size_t>(i) % 6], questions.turn());
            const auto hit = world.sweep(volume, {questions.point(8), questions.point(8)}, {.turn_gap = 0.1});
            hits.push_back(hit.value_or(Hit{}));
        }
        return hits;
    }
};

TEST(WorldSnapshot, going_back_gives_the_same_answers_to_the_last_bit) {
    Moving moving;
    moving.tick();
    std::array<BodyPose, 20> saved;
    ASSERT_EQ(moving.world.save_poses(saved), saved.size());
    const std::vector<Hit> before = moving.answers();

    for (int i = 0; i < 5; ++i) moving.tick();
    const std::vector<Hit> later = moving.answers();
    ASSERT_TRUE(moving.world.restore_poses(saved));
    const std::vector<Hit> after = moving.answers();
    std::array<BodyPose, 20> again;
    EXPECT_EQ(moving.world.save_poses(again), again.size());
    int changed = 0;
    for (std::size_t i = 0; i < before.size(); ++i) {
        EXPECT_TRUE(tests::same_bits(before[i], after[i]));
        changed += !tests::same_bits(before[i], later[i]);
    }
    EXPECT_GT(changed, 10) << "the ticks between changed too little to prove anything";
    for (std::size_t i = 0; i < saved.size(); ++i) {
        EXPECT_EQ(saved[i].body, 5 * i);
        EXPECT_TRUE(same_bits(saved[i].start, again[i].start));
        EXPECT_TRUE(same_bits(saved[i].end, again[i].end));
    }
}

TEST(WorldSnapshot, one_of_some_layers_holds_their_bodies_only) {
    Moving moving;
    std::array<BodyPose, 3> room;
    EXPECT_EQ(moving.world.save_poses(room, 2), 5u);  // there are more than found room
    EXPECT_EQ(room[1].body, 20u);
    std::array<BodyPose, 5> all;
    ASSERT_EQ(moving.world.save_poses(all, 2), 5u);
    moving.tick();
    const Pose other = moving.world.poses(moving.handles[1]).end;
    ASSERT_TRUE(moving.world.restore_poses(all));
    EXPECT_TRUE(same_bits(moving.world.poses(moving.handles[1]).end, other));
    EXPECT_TRUE(same_bits(moving.world.poses(moving.handles[4]).end, all[1].end));
}

TEST(WorldSnapshot, is_refused_as_a_whole_by_a_world_that_misses_one_of_its_bodies) {
    Moving moving;
    std::array<BodyPose, 20> saved;
    ASSERT_EQ(moving.world.save_poses(saved), saved.size());
    moving.tick();
    ASSERT_TRUE(moving.world.remove(moving.handles[7]));
#ifndef NDEBUG
    EXPECT_DEATH((void)moving.world.restore_poses(saved), "not in this world");
#else
    const Pose first = moving.world.poses(moving.handles[0]).end;
    EXPECT_FALSE(moving.world.restore_poses(saved));
    EXPECT_TRUE(same_bits(moving.world.poses(moving.handles[0]).end, first));
#endif
}

}  // namespace
}  // namespace surefoot
