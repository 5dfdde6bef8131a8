#include "playtest/report/frame.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "made_levels.hpp"
#include "page_parts.hpp"
#include "playtest/report/exhibit.hpp"

namespace surefoot::playtest {
namespace {

constexpr FrameSize tiny{96, 54};

struct Colour {
    int red;
    int green;
    int blue;

    [[nodiscard]] int light() const { return red + green + blue; }
    [[nodiscard]] bool is_orange() const { return red > green + 40 && green > blue; }
};

Colour at(const Picture& picture, double x, double y) {
    const auto column = std::size_t(x * picture.width);
    const auto row = std::size_t(y * picture.height);
    const std::uint8_t* const pixel = &picture.rgba[4 * (row * std::size_t(picture.width) + column)];
    return {pixel[0], pixel[1], pixel[2]};
}

int orange_pixels(const Picture& picture) {
    int count = 0;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            count += at(picture, (x + 0.5) / picture.width, (y + 0.5) / picture.height).is_orange() ? 1 : 0;
    return count;
}

Picture frame_of(test::LevelMaker& maker, const game::HeroInput& input = {}) {
    const auto game = maker.start();
    test::play(*game, 0.5, input);
    return FramePainter(game->level()).paint(*game, frame_camera(*game, {}), {}, tiny);
}

TEST(Frame, has_the_sky_above_the_ground_below_and_the_hero_in_the_middle) {
    test::LevelMaker maker;
    maker.level->materials[0].colour = {0.2, 0.8, 0.2};
    const Picture picture = frame_of(maker);
    const Colour sky = at(picture, 0.1, 0.05);
    EXPECT_GT(sky.blue, sky.red);
    const Colour ground = at(picture, 0.1, 0.95);
    EXPECT_GT(ground.green, ground.red + 40);
    EXPECT_GT(ground.green, ground.blue + 40);
    EXPECT_TRUE(at(picture, 0.5, 0.5).is_orange());
}

TEST(Frame, is_the_same_each_time_it_is_drawn) {
    test::LevelMaker maker;
    const Picture once = frame_of(maker);
    EXPECT_EQ(once.rgba, frame_of(maker).rgba);
    EXPECT_NE(once.rgba, frame_of(maker, {.move_z = -1}).rgba) << "and another one after a run";
}

TEST(Frame, lets_the_hero_shine_through_what_hides_it) {
    test::LevelMaker open;
    test::LevelMaker hidden;
    // A booth so narrow that the eye is outside.
    hidden.box({-1.5, 0, 0.6}, {1.5, 4, 0.8});
    hidden.box({-1.5, 1.7, -1.5}, {1.5, 1.9, 0.8});
    const int seen = orange_pixels(frame_of(open));
    EXPECT_GT(seen, 30);
    EXPECT_GT(orange_pixels(frame_of(hidden)), seen / 5);
}

TEST(Frame, has_shadows) {
    test::LevelMaker maker;
    const Colour lit = at(frame_of(maker), 0.1, 0.8);
    maker.box({-20, 9, -20}, {20, 9.5, 20});
    const Colour dark = at(frame_of(maker), 0.1, 0.8);
    EXPECT_LT(dark.light(), lit.light() - 60);
}

TEST(Frame, looks_where_the_player_looks) {
    test::LevelMaker maker;
    const auto game = maker.start();
    test::play(*game, 0.5);
    const FrameCamera west = frame_camera(*game, {.look_yaw_deg = 90, .look_pitch_deg = -30});
    EXPECT_LT(west.forward.x, -0.8);
    EXPECT_NEAR(west.forward.y, -0.5, 1e-6);
    EXPECT_GT(west.eye.x, game->feet().x + 3);
}

TEST(Frame, is_seen_from_before_the_wall_that_is_behind_the_hero) {
    test::LevelMaker maker;
    maker.box({-9, 0, 3}, {9, 6, 4});
    const auto game = maker.start();
    test::play(*game, 0.5);
    EXPECT_LT(frame_camera(*game, {}).eye.z, 3);
}

TEST(Frame, is_seen_from_above_in_a_shaft) {
    const auto game = *game::Game::start(test::pit());
    test::play(*game, 0.5);
    const FrameCamera camera = frame_camera(*game, {});
    EXPECT_GT(camera.eye.y, game->feet().y + 5);
    EXPECT_LT(std::abs(camera.eye.z), 0.5);
}

// Off the edge of the floor and into the deep; then again from the spawn.
game::Recording fall_off(const std::shared_ptr<const game::Level>& level, double run_for, std::uint32_t from = 0) {
    auto game = *game::Game::start(level, {.checkpoint = from});
    game::Recorder recorder(*level, "walker", from);
    for (int tick = 0; tick < 360; ++tick) {
        game::HeroInput input;
        input.move_z = tick < int(run_for * 60) ? -1 : 0;
        game->tick(input);
        recorder.tick(input, *game);
    }
    return recorder.recording();
}

TEST(Exhibit, of_a_fall_shows_largest_where_it_began) {
    test::LevelMaker maker;
    maker.clear();
    maker.box({-6, -1, -6}, {6, 0, 6});
    const auto level = maker.finish();
    const game::Recording recording = fall_off(level, 1.5);
    const auto told = replay(level, recording);
    ASSERT_TRUE(told);
    ASSERT_GE(told->incidents.size(), 1U);
    const auto made = exhibits_of(level, recording, {&told->incidents.front(), 1}, FramePainter(*level));
    ASSERT_TRUE(made) << made.error().text;
    const Exhibit& exhibit = made->front();
    ASSERT_EQ(exhibit.stills.size(), 3U);
    EXPECT_EQ(exhibit.moment, 0U);
    EXPECT_GT(exhibit.stills[0].picture.width, exhibit.stills[1].picture.width);
    EXPECT_LT(exhibit.stills[0].tick, exhibit.stills[1].tick);
    EXPECT_LT(exhibit.stills[2].tick, told->incidents.front().tick);
    // The clip ends just before the hero is put back.
    ASSERT_FALSE(exhibit.clip.feet.empty());
    EXPECT_LT(exhibit.clip.feet.back().y, -5);
    EXPECT_EQ(exhibit.clip.looks.size(), exhibit.clip.feet.size());
}

TEST(Exhibit, of_a_run_that_began_at_a_checkpoint_is_of_what_happened_there) {
    test::LevelMaker maker;
    maker.clear();
    maker.box({-6, -1, -6}, {6, 0, 6});
    maker.box({34, -1, -6}, {46, 0, 6});
    maker.level->checkpoints.push_back({.feet = {40, 0, 0}, .facing = {0, 0, -1}, .section = "there", .order = 1});
    const auto level = maker.finish();
    const game::Recording recording = fall_off(level, 1.5, 1);
    const auto told = replay(level, recording);
    ASSERT_TRUE(told);
    ASSERT_GE(told->incidents.size(), 1U);
    const auto made = exhibits_of(level, recording, {&told->incidents.front(), 1}, FramePainter(*level));
    ASSERT_TRUE(made) << made.error().text;
    ASSERT_FALSE(made->front().clip.feet.empty());
    EXPECT_NEAR(made->front().clip.feet.back().x, 40, 0.5);
    EXPECT_LT(made->front().clip.feet.back().y, -5);
}

TEST(Exhibit, tells_of_what_moves_near_by_and_of_nothing_far_away) {
    test::LevelMaker maker;
    maker.body(game::BodyKind::platform, {4, 1, 0}, {1, 0.2, 1}).route = {.stops = {{0, 0, 0}, {0, 0, 4}}};
    maker.body(game::BodyKind::platform, {400, 1, 0}, {1, 0.2, 1}).route = {.stops = {{0, 0, 0}, {0, 0, 4}}};
    const auto level = maker.finish();
    const game::Recording recording = fall_off(level, 0.2);
    const Incident incident{.kind = Incident::Kind::stuck, .tick = 300, .place = {0, 0, 0}};
    const auto made = exhibits_of(level, recording, {&incident, 1}, FramePainter(*level));
    ASSERT_TRUE(made);
    const Clip& clip = made->front().clip;
    ASSERT_EQ(clip.movers.size(), 1U);
    EXPECT_NEAR(clip.movers[0].half.y, 0.2, 1e-6);
    ASSERT_EQ(clip.movers[0].places.size(), clip.feet.size());
    EXPECT_NE(clip.movers[0].places.front(), clip.movers[0].places.back());
    EXPECT_EQ(made->front().moment, 2U);
    EXPECT_EQ(made->front().stills.back().tick, 299U);
}

TEST(Picture, is_a_png_that_others_read) {
    Picture picture(3, 2);
    for (std::size_t i = 0; i < picture.rgba.size(); ++i) picture.rgba[i] = std::uint8_t(i % 4 == 3 ? 255 : i * 9);
    const test::Decoded opaque = test::decoded(png(picture));
    EXPECT_EQ(opaque.width, 3);
    EXPECT_EQ(opaque.height, 2);
    EXPECT_EQ(opaque.colours, 6U);
    picture.rgba[3] = 7;
    EXPECT_EQ(test::decoded(png(picture)).width, 3);
    EXPECT_EQ(test::bytes_of_base64(base64("any bytes")), "any bytes");
    EXPECT_EQ(test::bytes_of_base64(base64("ten bytes.")), "ten bytes.");
}

}  // namespace
}  // namespace surefoot::playtest
