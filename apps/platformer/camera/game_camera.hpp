/// The camera of a game: behind whom it follows, never inside of anything, steady on stairs, ahead where one runs.
/// A state that is advanced tick by tick, as a character is; nothing is hidden in it.
#pragma once

#include <array>
#include <optional>

#include <surefoot/character.hpp>
#include <surefoot/world.hpp>

#include "view/camera.hpp"

namespace surefoot::platformer {

/// What there is to be in the way.
struct CameraScene {
    CameraScene(const World& all) : world(all) {}  // most have nothing but a world
    CameraScene(const World& all, const World* leaves, SurfaceRules rules)
        : world(all), decor(leaves), surfaces(rules) {}

    const World& world;            ///< what is solid
    const World* decor = nullptr;  ///< what is drawn and lets all through; the eye would rather see past it
    SurfaceRules surfaces{};       ///< one-way ones let the eye through, as they do the hero
};

struct CameraSettings {
    double distance = 5.6;        ///< from whom it follows, where there is room [m]
    double pitch = 0.30;          ///< how high it likes to stand [rad]
    double field_of_view = 1.0;   ///< of the picture's height [rad]
    double auto_turn = 1.7;       ///< how fast it comes behind one who runs; 0: never [rad/s]
    double patience = 0.7;        ///< for how long it stays as the player turned it [s]
    bool reduced_motion = false;  ///< the field of view stays as it is, and nothing looks ahead
};

/// How a camera likes to stand in some part of a level.
struct CameraHint {
    double yaw = 0;       ///< as that of a state [rad]
    double pitch = 0.3;   ///< [rad]
    double distance = 6;  ///< [m]
};

/// What the player does with it in one tick.
struct CameraInput {
    double turn_left = 0;  ///< [rad]
    double turn_up = 0;    ///< the eye goes up [rad]
    bool behind = false;   ///< goes behind the hero at once, smoothly
};

/// Whom it follows.
struct CameraTarget {
    dvec3 position{0, 0, 0};   ///< of the volume's reference point [m]
    dvec3 velocity{0, 0, 0};   ///< in the world [m/s]
    dvec3 carried{0, 0, 0};    ///< the part of it that is of what carries it [m/s]
    double anchor = 0.35;      ///< over the reference point: where in the volume there is room for the ball [m]
    double half_height = 0.8;  ///< [m]
    double facing = 0;         ///< as that of a hero's pose [rad]
    bool on_ground = false;    ///< or held by an edge, a ladder, the water
    bool dashes = false;
};

[[nodiscard]] CameraTarget target_of(const CharacterState& state, const CharacterSettings& settings, double facing,
                                     bool floats = false);

struct CameraState {
    dvec3 eye{0, 0, 0};          ///< [m]
    dvec3 look_at{0, 0, 0};      ///< what it would like in the middle of the picture [m]
    dvec3 forward{0, 0, 1};      ///< which way it looks, unit
    double yaw = 0;              ///< which way it looks about up, as a hero's facing [rad]
    double pitch = 0.30;         ///< how high the eye stands [rad]
    double dip = 0;              ///< how much more it looks down, at an edge [rad]
    double rise = 0;             ///< how much higher it stands where it is close [rad]
    double height = 0;           ///< of what it looks at: locked to the ground in jumps [m]
    double height_speed = 0;     ///< [m/s]
    double floor = 0;            ///< where that height is on its way to [m]
    dvec3 ahead{0, 0, 0};        ///< how far in front of the hero it looks [m]
    double distance = 5.6;       ///< that is wished [m]
    double narrow = 0;           ///< 1 in the narrowest corridor [0 to 1]
    double share = 1;            ///< of that distance, for want of room [0 to 1]
    bool seeks = false;          ///< a direction from which it sees better than from the usual one
    bool has_goal = false;       ///< and has found one:
    double goal_yaw = 0;         ///< [rad]
    double goal_pitch = 0;       ///< [rad]
    double seek = 0;             ///< how fast it turns towards that one [rad/s]
    double steer = 0;            ///< out of the way of what is about to come between, to the left [-1 to 1]
    double since_turn = 1e9;     ///< since the player turned it [s]
    double widened = 0;          ///< of the field of view [rad]
    double field_of_view = 1.0;  ///< [rad]
    double hidden = 0;           ///< for how long something has been between it and the hero [s]
    /// Where the hero's head was, a stride apart, the latest first: a way through any gap that the hero came through
    /// [m].
    std::array<dvec3, 12> trail{};
    dvec3 head{0, 0, 0};        ///< where it is [m]
    dvec3 target{0, 0, 0};      ///< where the hero was [m]
    double head_height = 1.15;  ///< over the hero's feet: where the eye starts from [m]
    double veiled = 0;          ///< for how long most of the hero has been behind something that is drawn [s]
    double behind = 0;          ///< for how long the line to the head has led through something solid [s]
    double strict = 0;          ///< for so long nothing is slight enough to be looked through [s]
    double door = 0;            ///< how far what is between them is to be drawn as a screen door [0 to 1]
    bool in_leaves = false;     ///< something of the decor is within `leaves_reach` of the eye
    double opacity = 1;         ///< of a hero who is so near that it would fill the picture [0 to 1]
};

/// What of the decor is as near to the eye is in the way [m].
inline constexpr double leaves_reach = 1.0;

/// Looks at the hero from behind, at once.
[[nodiscard]] CameraState camera_behind(const CameraScene& scene, const CameraTarget& target,
                                        const CameraSettings& settings, double yaw);

/// On by one tick of `dt` seconds. Guarantees, as long as there is room for the ball of the eye in the hero's own
/// volume: nothing of the world is within `eye_radius` of the eye. Relative to the hero it moves by at most 26 m/s.
/// Where a hero goes behind a corner at its side that is too slow to keep it in sight; then something is between them
/// for up to 0.4 s, and if the eye has not come round the corner by then, it cuts to where it sees the hero. `query`
/// says which bodies there are for it.
[[nodiscard]] CameraState advance(const CameraState& state, const CameraScene& scene, const CameraTarget& target,
                                  const CameraSettings& settings, const CameraInput& input,
                                  const std::optional<CameraHint>& hint, double dt);

/// What is drawn `blend` of the way between two ticks.
[[nodiscard]] view::Camera camera_between(const CameraState& before, const CameraState& after, double blend);

}  // namespace surefoot::platformer
