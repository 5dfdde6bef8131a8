// The camera through every level of the game, behind the bot that knows its way and behind one who tries everything.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <gtest/gtest.h>
#include <memory>

#include "camera_watch.hpp"
#include "game/game.hpp"
#include "playtest/explorer.hpp"
#include "playtest/navigator.hpp"

namespace surefoot::platformer::tests {
namespace {

constexpr double degree = 3.14159265358979323846 / 180;

CameraTarget target(const game::Game& game) {
    const dvec3& facing = game.hero().facing;
    return target_of(game.hero().body, game.settings(), std::atan2(facing.x, facing.z), game.hero().in_water);
}

std::optional<CameraHint> hint(const game::Game& game) {
    for (const game::CameraHint& hint : game.level().cameras)
        if (hint.zone.holds(game.hero().body.position))
            return CameraHint{(hint.yaw_deg + 180) * degree, hint.pitch_deg * degree, hint.distance};
    return std::nullopt;
}

struct Tick {
    const CameraScene& scene;
    const CameraTarget& target;
    const CameraState& before;
    const std::optional<CameraHint>& hint;
};

/// One tick of a camera: the game's own, or one that lacks something.
using Camera = std::function<CameraState(const Tick&)>;

CameraState the_games_own(const Tick& tick) {
    return advance(tick.before, tick.scene, tick.target, {}, {}, tick.hint, game::tick_seconds);
}

/// Plays until it is won, until the bot gives up, or for so long.
CameraWatch watched(const std::shared_ptr<const game::Level>& level, playtest::Bot& bot, double seconds,
                    const Camera& camera) {
    CameraWatch watch;
    auto started = game::Game::start(level);
    World decor;
    const bool is_there = started && (level->decor.triangle_count() == 0 || decor.add(level->decor));
    EXPECT_TRUE(is_there);
    if (!is_there) return watch;
    game::Game& game = **started;
    const CameraScene scene(game.world(), &decor, game.settings().surfaces);
    CameraState state = camera_behind(scene, target(game), {}, target(game).facing);
    while (game.outcome() != game::Outcome::won && bot.gave_up().empty() && game.seconds() < seconds) {
        if (game.outcome() == game::Outcome::lost) game.retry();
        game.tick(bot.decide(game));
        const CameraState before = state;
        state = camera({scene, target(game), before, hint(game)});
        watch.tick(scene, target(game), before, state);
    }
    return watch;
}

class CameraOnLevel : public testing::TestWithParam<std::string> {
protected:
    void SetUp() override {
        auto read = game::read_level(GetParam());
        ASSERT_TRUE(read) << read.error().text;
        level_ = std::make_shared<const game::Level>(std::move(*read));
    }

    std::shared_ptr<const game::Level> level_;
};

TEST_P(CameraOnLevel, keeps_who_goes_to_the_goal_in_sight) {
    const auto atlas = playtest::Atlas::make(level_);
    ASSERT_TRUE(atlas) << atlas.error().text;
    auto bot = playtest::Navigator::make(*atlas, {.seed = 1});
    ASSERT_TRUE(bot) << bot.error().text;
    const CameraWatch watch = watched(level_, **bot, 150, the_games_own);
    watch.print(level_->id);
}

TEST_P(CameraOnLevel, keeps_who_tries_everything_in_sight) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        playtest::Explorer bot(seed);
        const CameraWatch watch = watched(level_, bot, 60, the_games_own);
        watch.print(level_->id + " explored");
    }
}

std::string name_of_level(const testing::TestParamInfo<std::string>& info) {
    std::string name = std::filesystem::path(info.param).stem().string();
    std::ranges::replace(name, '-', '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Of, CameraOnLevel,
                         testing::ValuesIn(game::levels_in(std::string(SUREFOOT_LEVELS_DIR) + "/platformer")),
                         name_of_level);

}  // namespace
}  // namespace surefoot::platformer::tests
