/// A character: settings + input + state -> `step` -> state + events.
///
/// `step` is a pure function. What it returns depends on its arguments alone, it allocates nothing, and it gives the
/// same bits on every machine; so a state can be kept, sent, compared and stepped again. Any number of threads may step
/// characters in one world, as long as nobody changes the world.
///
/// How a body is moved, in one place: docs/movement.md.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

#include <surefoot/character_hooks.hpp>
#include <surefoot/character_neighbour.hpp>
#include <surefoot/character_settings.hpp>
#include <surefoot/character_trace.hpp>
#include <surefoot/hit.hpp>
#include <surefoot/math.hpp>
#include <surefoot/world.hpp>

namespace [[gnu::visibility("default")]] surefoot {
inline namespace v0 {

/// How a character moves.
enum class CharacterMode : std::uint8_t {
    walk,  ///< on its feet, or falling
    swim,  ///< in all directions, sinking slowly: you say when it is under water
    fly,   ///< in all directions, without gravity, still meeting everything
    own,   ///< as your own rule says: CharacterHooks::move
};

/// Which of its bodies a character has.
enum class CharacterForm : std::uint8_t { standing, crouched, in_air, on_ramp, on_ledge };

/// What the player, or whoever steers, asks for in one tick.
struct CharacterInput {
    dvec3 wish{0, 0, 0};     ///< the velocity that is wanted [m/s]; its part along `up` is ignored where feet walk
    dvec3 impulse{0, 0, 0};  ///< added to the velocity at the start of the tick: a blast, a jump pad [m/s]
    dvec3 up{0, 1, 0};       ///< against gravity; any length but zero. It may change from tick to tick
    bool jump = false;       ///< the button is held
    bool crouch = false;     ///< the button is held; on a ladder: down
    bool dash = false;       ///< the button is held
    CharacterMode mode = CharacterMode::walk;
};

static_assert(std::is_trivially_copyable_v<CharacterInput>);

/// What carries a character.
enum class Footing : std::uint8_t {
    air,     ///< nothing
    ground,  ///< something that is not too steep
    steep,   ///< something that is: it slides
    ledge,   ///< it hangs on an edge, by its hands
};

/// What its hands do.
enum class Hold : std::uint8_t {
    none,
    hanging,
    climbing,  ///< up over the edge
};

/// A time that is longer than anything a step asks for [s].
inline constexpr double long_ago = 1e9;

/// For how long a state counts the time since something happened, if no setting asks for longer [s]. What is longer ago
/// is `long_ago`, so that a character at rest comes to have the same bits for ever.
inline constexpr double remembered_for = 10;

/// All that a character is between two ticks: plain, without padding, comparable.
struct CharacterState {
    dvec3 position{0, 0, 0};             ///< of the reference point [m]
    dvec3 velocity{0, 0, 0};             ///< its own: relative to what carries it, in the air to the world [m/s]
    dvec3 ground_normal{0, 0, 0};        ///< of what carries it, in the world; zero in the air
    dvec3 ground_velocity{0, 0, 0};      ///< how fast that moves where it is stood on [m/s]
    double since_ground = long_ago;      ///< time since it was last on ground [s]
    double since_jump_press = long_ago;  ///< time since `jump` was pressed and not yet answered [s]
    double since_wall = long_ago;        ///< time since it touched a wall [s]
    double since_dash = long_ago;        ///< time since its last dash began [s]
    dvec3 wall_normal{0, 0, 0};          ///< of that wall, or of the one under the edge that it holds
    dvec3 ledge_point{0, 0, 0};          ///< of the edge that it holds [m]
    double since_hold = long_ago;        ///< time since it let go of an edge [s]
    std::uint32_t ground_body = 0;       ///< what carries it
    std::uint32_t ground_triangle = 0;
    std::uint32_t ground_surface = 0;
    std::uint32_t air_jumps_left = 0;
    Footing footing = Footing::air;
    std::uint8_t jump_held = 0;   ///< 1 if `jump` was held in the last tick
    std::uint8_t is_jumping = 0;  ///< 1 while rising from a jump
    std::uint8_t dash_held = 0;   ///< 1 if `dash` was held in the last tick
    CharacterForm form = CharacterForm::standing;
    Hold hold = Hold::none;
    std::uint8_t reserved[2] = {};  ///< zero

    friend bool operator==(const CharacterState&, const CharacterState&) = default;
};

static_assert(std::is_trivially_copyable_v<CharacterState> && sizeof(CharacterState) == 208);

/// A number for a state: equal states have equal ones, on every machine. Each field counts, 0 and -0 as the same;
/// `reserved` does not.
[[nodiscard]] std::uint64_t hash(const CharacterState& state) noexcept;

/// What happened in one tick: a set of these.
enum class CharacterEvent : std::uint32_t {
    jumped = 1U << 0,        ///< left the ground by a jump, or jumped in the air
    landed = 1U << 1,        ///< came to stand on ground
    left_ground = 1U << 2,   ///< ground was there and is not any more
    stepped_up = 1U << 3,    ///< walked up a step
    snapped_down = 1U << 4,  ///< followed the ground downwards by more than its slope
    blocked = 1U << 5,       ///< did not get where it wanted: something was in the way
    hit_ceiling = 1U << 6,   ///< something from above
    crushed = 1U << 7,       ///< no room is left between things that move
    stuck = 1U << 8,         ///< begins inside of something, and there is no way out
    recovered = 1U << 9,     ///< began too close to something or inside of it, and was moved out
    sub_stepped = 1U << 10,  ///< the tick was longer than `longest_tick` and was done in parts
    overflow = 1U << 11,     ///< more triangles or contacts than there is room for: the move ended early
    pushed = 1U << 12,       ///< something that moves came against it
    dashed = 1U << 13,       ///< began a dash
    climbing = 1U << 14,     ///< is on a ladder
    grabbed_ledge = 1U << 17,
    dropped_ledge = 1U << 18,
    climbed_ledge = 1U << 19,
    vaulted = 1U << 20,        ///< climbs over something by a press of jump
    no_room = 1U << 15,        ///< would stand up or change its body, but there is no room
    invalid = 1U << 16,        ///< something in the arguments is out of its range: the state is unchanged
    met_neighbour = 1U << 21,  ///< with `blocked`: what blocked it the most is a neighbour, `blocked_body` its id
};

/// The events of one tick, and what belongs to them.
struct CharacterEvents {
    std::uint32_t set = 0;           ///< of `CharacterEvent`
    double landing_speed = 0;        ///< how fast it came down, along the ground's normal [m/s]; 0 unless `landed`
    dvec3 blocked_by{0, 0, 0};       ///< the normal of what blocked it the most; zero if nothing did
    std::uint32_t blocked_body = 0;  ///< of the world; with `met_neighbour` the id of a neighbour
    std::uint32_t blocked_triangle = 0;

    [[nodiscard]] bool has(CharacterEvent event) const noexcept {
        return (set & static_cast<std::uint32_t>(event)) != 0;
    }
};

/// Something of the world that a character pressed against in one tick.
struct CharacterContact {
    dvec3 point{0, 0, 0};   ///< [m]
    dvec3 normal{0, 0, 0};  ///< unit, towards the character
    /// What to give to the body at `point`, for each kilogram of the character [m/s]: against what is in the way, the
    /// velocity along the normal that it took, measured from the body's own; on ground, the weight of one tick.
    dvec3 impulse{0, 0, 0};
    std::uint32_t body = 0;
    std::uint32_t triangle = 0;
};

/// For dynamic bodies of your own physics: times the character's mass these are the impulses to apply to them. What
/// stands still needs none. Neighbours are not among them.
struct CharacterContacts {
    std::array<CharacterContact, 4> all{};
    std::uint32_t count = 0;

    [[nodiscard]] std::span<const CharacterContact> get() const noexcept { return {all.data(), count}; }
};

struct StepResult {
    CharacterState state;
    CharacterEvents events;
    CharacterContacts contacts{};
};

/// Moves a character by one tick.
///
/// `dt` is the time that passes [s, > 0 and at most 60]; anything else, and any number that is not finite, leaves the
/// state as it was, with the event `invalid`. The world's moving bodies go from their poses at the start of its tick to
/// those at the end. `neighbours` are the others near by, as they all were before anybody took this step; the result
/// does not go deeper into any of the hard ones than it began. `trace` is told what was tried, met and decided; a step
/// without one pays nothing for it. `hooks` are rules of your own; the result depends on what they answer, too.
[[nodiscard]] StepResult step(const World& world, const CharacterSettings& settings, const CharacterInput& input,
                              double dt, const CharacterState& state, std::span<const Neighbour> neighbours = {},
                              StepTrace* trace = nullptr, const CharacterHooks& hooks = {}) noexcept;

/// Many characters at once. What there is one of each for has as many as `before`.
struct Characters {
    std::span<const CharacterSettings> settings;  ///< one each, or a single one for all
    std::span<const CharacterInput> inputs;       ///< one each, or a single one for all
    std::span<const CharacterState> before;       ///< when the tick begins
    std::span<CharacterState> after;              ///< when it ends: the answers; may be the memory of `before`
    std::span<CharacterEvents> events{};          ///< one each, or none
    std::span<CharacterContacts> contacts{};      ///< what each pressed against: one each, or none
    std::span<const std::uint32_t> ids{};         ///< for `crowd`: one each, or none, and then they are counted
};

/// Some of many, by their places in the spans.
struct StepRange {
    std::size_t begin = 0;
    std::size_t end = ~std::size_t{0};  ///< one after the last; what is beyond the spans does not count
};

/// Steps each of the characters in `range` by itself, as `step` without neighbours does; see crowd.hpp for those that
/// meet. Threads may share the work: give each a range of its own and the same spans. How it is cut changes no bit.
/// Requires: spans of fitting sizes; asserts otherwise, and with asserts off does nothing.
void step_all(const World& world, const Characters& characters, double dt, StepRange range = {}) noexcept;

/// How the others see a character.
[[nodiscard]] Neighbour neighbour_of(const CharacterSettings& settings, const CharacterInput& input,
                                     const CharacterState& state, std::uint32_t id = 0) noexcept;

/// Can the body be here without touching anything?
[[nodiscard]] bool fits(const World& world, const CharacterSettings& settings, const dvec3& position,
                        const dvec3& up = {0, 1, 0}) noexcept;

}  // namespace v0
}  // namespace surefoot
