// The platformer's own levels can be played: each is read, and its places hold whom they are for.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <set>

#include "game/campaign.hpp"
#include "game/game.hpp"

namespace surefoot::game {
namespace {

double flat_distance(const dvec3& a, const dvec3& b) {
    return std::sqrt((a.x - b.x) * (a.x - b.x) + (a.z - b.z) * (a.z - b.z));
}

class PlatformerLevel : public testing::TestWithParam<std::string> {
protected:
    void SetUp() override {
        auto read = read_level(GetParam());
        ASSERT_TRUE(read.has_value()) << read.error().text;
        level = std::make_shared<Level>(std::move(*read));
    }

    /// The same level, begun elsewhere, and nobody about: finding ways for enemies takes seconds.
    std::unique_ptr<Game> start_at(const dvec3& feet) const {
        auto elsewhere = std::make_shared<Level>(*level);
        elsewhere->enemies.clear();
        elsewhere->checkpoints.front().feet = feet;
        auto game = Game::start(std::move(elsewhere));
        EXPECT_TRUE(game.has_value()) << game.error().text;
        return std::move(*game);
    }

    std::shared_ptr<Level> level;
};

TEST_P(PlatformerLevel, tells_what_it_is) {
    EXPECT_FALSE(level->title.empty());
    EXPECT_FALSE(level->idea.empty());
    EXPECT_EQ(level->count(PickupKind::star), 3);
    EXPECT_GE(level->count(PickupKind::coin), 30);
    EXPECT_GE(level->beats.size(), 6u);
    EXPECT_GE(level->checkpoints.size(), 4u);
    EXPECT_LE(level->ground.triangle_count() + level->decor.triangle_count(), 12'000u);
}

TEST_P(PlatformerLevel, has_something_that_shines_and_ground_with_a_drawing_on_it) {
    EXPECT_TRUE(std::ranges::any_of(level->materials, [](const Material& m) { return m.glow >= 0.5; }));
    EXPECT_TRUE(std::ranges::any_of(level->materials, [](const Material& m) { return m.drawing == Drawing::patches; }));
}

TEST_P(PlatformerLevel, has_medals_for_a_first_run_of_two_to_six_minutes) {
    EXPECT_GE(level->medals.gold, 60);
    EXPECT_GE(level->medals.bronze, 180);
    EXPECT_LE(level->medals.bronze, 420);
}

TEST_P(PlatformerLevel, lets_the_hero_stand_at_the_start_unharmed) {
    const auto game = start_at(level->checkpoints.front().feet);
    for (int tick = 0; tick < 240; ++tick) game->tick({});
    EXPECT_EQ(game->outcome(), Outcome::playing);
    EXPECT_EQ(game->hero().health, most_health);
    EXPECT_EQ(game->hero().body.footing, Footing::ground);
    EXPECT_LT(flat_distance(game->feet(), level->checkpoints.front().feet), 0.05);
}

TEST_P(PlatformerLevel, holds_who_comes_back_to_a_checkpoint) {
    for (const Checkpoint& checkpoint : level->checkpoints) {
        const auto game = start_at(checkpoint.feet);
        for (int tick = 0; tick < 90; ++tick) game->tick({});
        EXPECT_EQ(game->hero().body.footing, Footing::ground) << checkpoint.section;
        EXPECT_NEAR(game->feet().y, checkpoint.feet.y, 0.1) << checkpoint.section;
        EXPECT_EQ(game->hero().health, most_health) << checkpoint.section;
        EXPECT_EQ(game->deaths(), 0u) << checkpoint.section;
    }
}

TEST_P(PlatformerLevel, is_won_at_its_goal) {
    const auto game = start_at(level->goal);
    for (int tick = 0; tick < 30; ++tick) game->tick({});
    EXPECT_EQ(game->outcome(), Outcome::won);
}

TEST_P(PlatformerLevel, keeps_its_enemies_and_they_leave_alone_who_stands_at_the_start) {
    auto game = Game::start(level);
    ASSERT_TRUE(game.has_value()) << game.error().text;
    for (int tick = 0; tick < 20 * 60; ++tick) (*game)->tick({});
    EXPECT_EQ((*game)->hero().health, most_health);
    EXPECT_EQ((*game)->enemies().size(), level->enemies.size());
    for (const Enemy& enemy : (*game)->enemies())
        EXPECT_LT(std::abs(enemy.body.position.y - level->enemies[enemy.plan].feet.y), 3) << "it has fallen";
}

TEST_P(PlatformerLevel, has_platforms_that_come_within_reach_of_their_ways) {
    for (const Way& way : level->ways) {
        if (way.how != Manoeuvre::ride) continue;
        const auto body = std::ranges::find(level->bodies, way.by, &BodyPlan::name);
        ASSERT_NE(body, level->bodies.end());
        const Bounds box = body->mesh.bounds();
        const auto reach = [&](const dvec3& place) {
            double nearest = 1e9;
            for (const dvec3& stop : body->route.stops) {
                const dvec3 off = place - body->origin - stop;
                const double x = std::max({box.min.x - off.x, off.x - box.max.x, 0.0});
                const double z = std::max({box.min.z - off.z, off.z - box.max.z, 0.0});
                if (std::abs(off.y - box.max.y) < 1.3) nearest = std::min(nearest, std::sqrt(x * x + z * z));
            }
            return nearest;
        };
        EXPECT_LT(reach(way.from), 3.4) << way.by;
        EXPECT_LT(reach(way.to), 3.4) << way.by;
    }
}

std::string name_of_test(const testing::TestParamInfo<std::string>& info) {
    std::string name = info.param.substr(info.param.rfind('/') + 1);
    name.resize(name.size() - 4);
    std::ranges::replace(name, '-', '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(all, PlatformerLevel, testing::ValuesIn(levels_in(SUREFOOT_LEVELS_DIR "/platformer")),
                         name_of_test);

TEST(PlatformerLevels, are_six_in_order_and_a_secret_one) {
    std::set<int> orders;
    std::map<int, std::string> campaign;
    int secrets = 0;
    for (const std::string& path : levels_in(SUREFOOT_LEVELS_DIR "/platformer")) {
        const auto level = read_level(path);
        ASSERT_TRUE(level.has_value()) << level.error().text;
        EXPECT_TRUE(orders.insert(level->order).second) << path;
        campaign[level->order] = level->id;
        secrets += level->secret ? 1 : 0;
        EXPECT_EQ(level->stars_needed, level->secret ? 12 : 0) << path;
    }
    EXPECT_EQ(orders, (std::set<int>{1, 2, 3, 4, 5, 6, 7}));
    EXPECT_EQ(secrets, 1);
    std::vector<std::string> in_order;
    for (const auto& [order, id] : campaign) in_order.push_back(id);
    EXPECT_EQ(campaign_in(SUREFOOT_LEVELS_DIR "/platformer"), in_order);
}

}  // namespace
}  // namespace surefoot::game
