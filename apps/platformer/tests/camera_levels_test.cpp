// The camera through every level of the game, behind the bot that knows its way.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <gtest/gtest.h>
#include <memory>

#include "camera_watch.hpp"
#include "game/game.hpp"
#include "playtest/navigator.hpp"

namespace surefoot::platformer::tests {
namespace {

std::vector<std::string> level_files() {
    return game::levels_in(std::string(SUREFOOT_LEVELS_DIR) + "/platformer");
}

CameraTarget target(const game::Game& game) {
    const dvec3& facing = game.hero().facing;
    return target_of(game.hero().body, game.settings(), std::atan2(facing.x, facing.z), game.hero().in_water);
}

std::optional<CameraHint> hint(const game::Game& game) {
    constexpr double degree = 3.14159265358979323846 / 180;
    for (const game::CameraHint& hint : game.level().cameras)
        if (hint.zone.holds(game.hero().body.position))
            return CameraHint{(hint.yaw_deg + 180) * degree, hint.pitch_deg * degree, hint.distance};
    return std::nullopt;
}

class CameraOnLevel : public testing::TestWithParam<std::string> {};

TEST_P(CameraOnLevel, keeps_the_hero_in_sight) {
    auto read = game::read_level(GetParam());
    ASSERT_TRUE(read) << read.error().text;
    const auto level = std::make_shared<const game::Level>(std::move(*read));
    const auto atlas = playtest::Atlas::make(level);
    ASSERT_TRUE(atlas) << atlas.error().text;
    auto bot = playtest::Navigator::make(*atlas, {.seed = 1});
    ASSERT_TRUE(bot) << bot.error().text;
    auto started = game::Game::start(level);
    ASSERT_TRUE(started) << started.error().text;
    game::Game& game = **started;
    World decor;
    ASSERT_TRUE(level->decor.triangle_count() == 0 || decor.add(level->decor));
    const CameraSettings settings;
    const CameraScene scene(game.world(), &decor, game.settings().surfaces);
    CameraState camera = camera_behind(scene, target(game), settings,
                                       std::atan2(game.hero().facing.x, game.hero().facing.z));
    CameraWatch watch;
    const bool tells = std::getenv("TELL") != nullptr;
    bool was_hidden = false;
    while (game.outcome() != game::Outcome::won && (*bot)->gave_up().empty() && game.seconds() < 150) {
        if (game.outcome() == game::Outcome::lost) game.retry();
        game.tick((*bot)->decide(game));
        const CameraState before = camera;
        camera = advance(before, scene, target(game), settings, {}, hint(game), game::tick_seconds);
        watch.tick(scene, target(game), before, camera);
        if (tells && game.ticks() % 120 == 0)
            std::printf("   %7.2f yaw %.2f pitch %.2f rise %.2f seeks %d goal %.2f %.2f veiled %.2f share %.2f\n", game.seconds(), camera.yaw, camera.pitch, camera.rise, camera.seeks, camera.goal_yaw, camera.goal_pitch, camera.veiled, camera.share);
        if (tells && watch.is_hidden() != was_hidden) {
            was_hidden = watch.is_hidden();
            std::printf("   %7.2f %s\n", game.seconds(), was_hidden ? "hidden" : "seen");
        }
    }
    watch.print(level->id);
}

std::string name_of_level(const testing::TestParamInfo<std::string>& info) {
    std::string name = std::filesystem::path(info.param).stem().string();
    std::ranges::replace(name, '-', '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Of, CameraOnLevel, testing::ValuesIn(level_files()), name_of_level);

}  // namespace
}  // namespace surefoot::platformer::tests
