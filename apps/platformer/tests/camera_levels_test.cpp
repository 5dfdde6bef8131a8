// The camera through every level of the game, behind the bot that knows its way and behind one who tries everything.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <gtest/gtest.h>
#include <memory>

#include "camera_watch.hpp"
#include "game/game.hpp"
#include "platformer/play/followed.hpp"
#include "playtest/bots/explorer.hpp"
#include "playtest/bots/navigator.hpp"

namespace surefoot::platformer::tests {
namespace {

CameraTarget target(const game::Game& game) {
    const dvec3& facing = game.hero().facing;
    return followed(game, std::atan2(facing.x, facing.z));
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
        state = camera({scene, target(game), before, hint_at(*level, game.hero().body.position)});
        watch.tick(scene, target(game), before, state);
    }
    return watch;
}

/// What is wrong with these is more than the game's own camera may have wrong; empty: nothing.
std::string wrong_with(const CameraWatch::Found& f) {
    std::string wrong;
    const auto bound = [&](const char* what, double is, double most) {
        if (is > most) wrong += std::string(wrong.empty() ? "" : ", ") + what;
    };
    bound("inside", f.inside, 0);
    bound("outside", f.share(f.outside), 0.006);
    bound("hidden", f.share(f.hidden), 0.11);
    bound("hidden for long", f.hidden_for, 75);
    bound("unseen", f.share(f.unseen), 0.015);
    bound("near", f.share(f.near), 0.012);
    bound("cuts", f.share(f.cuts), 0.004);
    return wrong;
}

std::shared_ptr<const game::Level> level_of(const std::string& file) {
    auto read = game::read_level(file);
    EXPECT_TRUE(read) << read.error().text;
    return read ? std::make_shared<const game::Level>(std::move(*read)) : nullptr;
}

CameraWatch::Found on_the_way(const std::string& file, const Camera& camera, const std::string& name) {
    const auto level = level_of(file);
    if (!level) return {};
    const auto atlas = playtest::Atlas::make(level);
    EXPECT_TRUE(atlas) << atlas.error().text;
    if (!atlas) return {};
    auto bot = playtest::Navigator::make(*atlas, {.seed = 1});
    EXPECT_TRUE(bot) << bot.error().text;
    if (!bot) return {};
    const CameraWatch watch = watched(level, **bot, 150, camera);
    CameraWatch::print(level->id + name, watch.found());
    return watch.found();
}

class CameraOnLevel : public testing::TestWithParam<std::string> {};

TEST_P(CameraOnLevel, keeps_who_goes_to_the_goal_in_sight) {
    EXPECT_EQ(wrong_with(on_the_way(GetParam(), the_games_own, "")), "");
}

TEST_P(CameraOnLevel, keeps_who_tries_everything_in_sight) {
    const auto level = level_of(GetParam());
    ASSERT_NE(level, nullptr);
    CameraWatch::Found all;
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        playtest::Explorer bot(seed);
        all.add(watched(level, bot, 60, the_games_own).found());
    }
    CameraWatch::print(level->id + ", explored", all);
    EXPECT_EQ(wrong_with(all), "");
}

struct Worse {
    const char* name;
    Camera camera;
    const char* wrong;  ///< at least this
};

class WorseCamera : public testing::TestWithParam<Worse> {};

TEST_P(WorseCamera, is_told_from_the_games_own) {
    const std::string file = std::string(SUREFOOT_LEVELS_DIR) + "/platformer/the-shaft.glb";
    const std::string wrong = wrong_with(on_the_way(file, GetParam().camera, std::string(", ") + GetParam().name));
    EXPECT_NE(wrong.find(GetParam().wrong), std::string::npos) << wrong;
}

CameraState goes_through_walls(const Tick& tick) {
    CameraState state = the_games_own(tick);
    const dvec3 look{std::sin(state.yaw) * 0.95, -0.3, std::cos(state.yaw) * 0.95};
    state.eye = state.look_at - look * 5.6;
    state.forward = look;
    return state;
}

CameraState never_looks_elsewhere(const Tick& tick) {
    CameraState before = tick.before;
    before.rise = before.seek = before.steer = 0;
    CameraState state = the_games_own({tick.scene, tick.target, before, tick.hint});
    state.yaw = before.yaw;
    return state;
}

CameraState knows_no_hurry(const Tick& tick) {
    return camera_behind(tick.scene, tick.target, {}, the_games_own(tick).yaw);
}

CameraState opens_no_door(const Tick& tick) {
    CameraState state = the_games_own(tick);
    state.door = 0;
    return state;
}

CameraState looks_straight_ahead(const Tick& tick) {
    CameraState state = the_games_own(tick);
    state.forward = {std::sin(state.yaw) * std::cos(state.pitch), -std::sin(state.pitch),
                     std::cos(state.yaw) * std::cos(state.pitch)};
    return state;
}

INSTANTIATE_TEST_SUITE_P(That, WorseCamera,
                         testing::Values(Worse{"goes_through_walls", goes_through_walls, "inside"},
                                         Worse{"never_looks_elsewhere", never_looks_elsewhere, "near"},
                                         Worse{"knows_no_hurry", knows_no_hurry, "cuts"},
                                         Worse{"opens_no_door", opens_no_door, "unseen"},
                                         Worse{"looks_straight_ahead", looks_straight_ahead, "outside"}),
                         [](const auto& given) { return given.param.name; });

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
