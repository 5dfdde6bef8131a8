/// What a character can do: one plain struct, each field with its unit, its range and what follows from it.
#pragma once

#include <cstdint>
#include <optional>
#include <type_traits>

#include <surefoot/character_neighbour.hpp>
#include <surefoot/character_surface.hpp>
#include <surefoot/math.hpp>
#include <surefoot/shapes.hpp>

namespace [[gnu::visibility("default")]] surefoot {
inline namespace v0 {

/// What a character does with the rest of a move that something stopped.
enum class Response : std::uint8_t {
    slide,  ///< goes on along what it met
    stop,   ///< stays where it met it
};

/// How the speed that was asked for is meant on a slope.
enum class SlopeSpeed : std::uint8_t {
    level,  ///< seen from above: going up a slope covers as much of the map as going along the flat
    along,  ///< along the ground: the steeper, the less of the map is covered
};

/// Every default is for a grown person in metres. Numbers outside the stated ranges are no error: a step with such
/// settings leaves the state as it was and says `invalid` in its events.
struct CharacterSettings {
    /// The body that meets the world, about its reference point [see shapes.hpp]. Its orientation is relative to `up`:
    /// with `up` = +Y it is the orientation in the world.
    Volume volume = Ellipsoid{{0.4, 0.9, 0.4}};

    /// Other bodies for other situations; where there is none it is `volume`. The feet stay where they are when the
    /// body changes, and it changes only where there is room for the new one.
    std::optional<Volume> crouched{};  ///< while `crouch` is held
    std::optional<Volume> in_air{};    ///< while nothing carries it
    std::optional<Volume> on_ramp{};   ///< on ground that is not level
    std::optional<Volume> on_ledge{};  ///< while it hangs on an edge or climbs over it

    /// How far from everything the body is kept, along the normal of what it meets [m, 1e-6 to a quarter of the
    /// smallest dimension]. It is what rounding and badly cut floors are lost in: bumps of less than half of it are not
    /// felt. Too small for the level's vertex noise: seams come back. Large: a visible gap.
    double skin = 0.01;

    /// The steepest ground to walk and to stand on, from level [degrees, 0 to 89]. On anything steeper a character
    /// slides down, and cannot climb it by walking, jumping or wedging.
    double slope_limit_deg = 50;

    /// The highest step that is walked up without a jump [m, >= 0]; 0 switches steps off.
    double step_up = 0.4;

    /// How far ahead of what blocks it a step must offer ground [m, > 0]. It is a length and not a share of the
    /// tick's motion, so that what can be climbed does not depend on the frame rate. Small: ever narrower ledges count
    /// as steps. Large: spiral stairs get refused.
    double step_depth = 0.15;

    /// How far the ground may drop away under a walking character before it counts as leaving it [m, >= 0]. Within it
    /// feet stay on stairs, crests and lifts that go down; 0: every bump is a jump.
    double snap_down = 0.4;

    /// How far from the body's axis ground may hold it by an edge [m, >= 0]. Farther out it slips off. Walking on to
    /// an edge is not limited by this.
    double perch_distance = 0.2;

    /// On the edge of a floor a rounded body sinks as it rolls off: an ellipsoid's dip. With flat feet it keeps the
    /// floor's height until the edge is farther out than `perch_distance`, as a cylinder would, and then steps down or
    /// falls.
    bool flat_foot = false;

    /// How others meet this one. It decides nothing about how this one meets them.
    Firmness firmness = Firmness::hard;

    Response response = Response::slide;
    SlopeSpeed slope_speed = SlopeSpeed::level;

    double gravity = 20;           ///< against `up` [m/s^2, >= 0]. Twice the Earth's feels right in most games
    double terminal_speed = 60;    ///< the fastest fall [m/s, >= 0]
    double acceleration = 60;      ///< towards the wish, on the ground [m/s^2, >= 0]
    double braking = 60;           ///< when the wish is slower than the character, on the ground [m/s^2, >= 0]
    double air_acceleration = 15;  ///< towards the wish, in the air [m/s^2, >= 0]
    double jump_height = 1.2;      ///< how high the reference point rises in a full jump [m, >= 0]
    double jump_cut = 2.5;         ///< gravity is this many times as strong while rising with `jump` let go [>= 1]
    double coyote_time = 0.1;      ///< how long after leaving the ground a jump still counts as from there [s, >= 0]
    double jump_buffer = 0.1;      ///< how long before landing a press of `jump` is remembered [s, >= 0]
    bool keeps_ground_velocity = true;  ///< takes the velocity of a lift or a train along when it leaves it
    std::uint32_t air_jumps = 0;        ///< jumps that need no ground, until the next landing

    double wall_slide_speed = 0;     ///< the fastest fall while pressed against a wall [m/s, >= 0]; 0: no wall holds it
    double wall_jump_speed = 0;      ///< away from the wall, in a jump off it [m/s, >= 0]; 0: there are none
    double wall_coyote_time = 0.12;  ///< how long after the wall was touched a jump is still off it [s, >= 0]
    double dash_speed = 0;           ///< in the direction of the wish, without gravity [m/s, >= 0]; 0: there is none
    double dash_time = 0.2;          ///< how long a dash is [s, >= 0]
    double dash_pause = 0.4;         ///< how long after one the next may begin [s, >= 0]
    double swim_acceleration = 12;   ///< towards the wish, under water [m/s^2, >= 0]
    double sink_speed = 0.3;         ///< downwards, under water without a wish [m/s]; below 0: it floats up
    double fly_acceleration = 40;    ///< towards the wish, flying freely [m/s^2, >= 0]
    double ladder_speed = 2.5;       ///< up surfaces that are ladders, while pressed against them [m/s, >= 0]; 0: none

    double ledge_reach = 0;     ///< how far ahead of the body hands reach for an edge [m, >= 0]; 0: it holds none
    double hands_height = 1.7;  ///< from the feet up to the hands that hold an edge [m, > 0]
    double climb_speed = 3;     ///< up over an edge [m/s, > 0]
    double shimmy_speed = 1.2;  ///< along it [m/s, >= 0]
    double vault_height = 0;    ///< what is at most so high is climbed by a press of jump [m, >= 0]; 0: nothing is

    /// What the level's surfaces do; without a table all of it is firm ground.
    SurfaceRules surfaces{};

    /// The longest time that is moved in one go [s, 0.01 to 60]; a longer tick is done in equal parts.
    double longest_tick = 0.1;
};

static_assert(std::is_trivially_copyable_v<CharacterSettings>);

/// Is every number within its range?
[[nodiscard]] bool is_valid(const CharacterSettings& settings) noexcept;

}  // namespace v0
}  // namespace surefoot
