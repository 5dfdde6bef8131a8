// One tick of a character, or a part of a long one: what all its stages share. The stages lie in files of their own.
#pragma once

#include <surefoot/character.hpp>

#include "character/carry.hpp"
#include "character/ground.hpp"
#include "character/neighbours.hpp"
#include "character/slide.hpp"
#include "character/surroundings.hpp"

namespace surefoot::internal {

/// A wall is what rises or hangs over by no more than this, as its normal's part along `up`.
inline constexpr double wall_rises_at_most = 0.35;

/// Ground that looks less than this along `up` is a ramp.
inline constexpr double ramp_rises_at_most = 0.99;

struct TickArguments {
    const World& world;
    const CharacterSettings& settings;
    const CharacterInput& input;
    double tick;    ///< all of the world's tick [s]
    TickPart part;  ///< what is done of it here
    const CharacterState& state;
    std::span<const Neighbour> neighbours;
    StepTrace* trace;
    const CharacterHooks& hooks;
};

struct Tick {
    /// Requires: valid arguments.
    explicit Tick(const TickArguments& arguments) noexcept;

    const CharacterSettings& settings;
    const CharacterInput& input;
    const CharacterHooks& hooks;
    double whole;   ///< all of the world's tick [s]
    TickPart part;  ///< the part of it that is done here
    double dt;      ///< how long that is [s]
    Vec up;         ///< unit
    Vec wish;       ///< what is asked for, across `up` [m/s]
    Body body;
    Neighbours neighbours;
    Gait gait{};
    Surroundings surroundings;
    CharacterState state;  ///< what it was, until it is told what it is
    CharacterEvents events{};
    CharacterContacts contacts{};
    Vec position;
    Vec velocity;
    Ground ground{};
    bool standing = false;

    [[nodiscard]] Vec level(const Vec& v) const noexcept { return v - up * dot(v, up); }
    [[nodiscard]] const World& world() const noexcept { return surroundings.world(); }

    void say(CharacterEvent event) noexcept { events.set |= static_cast<std::uint32_t>(event); }
    void tell(StepRecord record) const noexcept;
    void tell(StepAct act, const Ground& about, double value = 0) const noexcept;

    /// Goes along what is met, without ground under it; the velocity follows.
    void glide(const Vec& way, const Vec& velocity_after) noexcept;
    /// What was in the way, if it is more than ground.
    void tell_obstacle(const Obstacle& obstacle) noexcept;
};

/// The stages, in this order. Each begins where the one before it ended.
void remember_buttons(Tick& tick) noexcept;
void ride(Tick& tick) noexcept;         ///< what moves takes it along
void look_around(Tick& tick) noexcept;  ///< one gather for all questions, if the tick is short enough
void get_out(Tick& tick) noexcept;      ///< of what it is too close to
void change_form(Tick& tick) noexcept;  ///< crouches, stands up, takes the body of its situation
void part(Tick& tick) noexcept;         ///< from neighbours that overlap it
void stand(Tick& tick) noexcept;        ///< is there ground?
void leap(Tick& tick) noexcept;         ///< jumps, jumps off walls, dashes
void go_on_foot(Tick& tick, double seconds) noexcept;
void fall(Tick& tick, double seconds) noexcept;
void move_freely(Tick& tick) noexcept;               ///< swims, flies, or goes as the user says
[[nodiscard]] bool hold_ledge(Tick& tick) noexcept;  ///< grabs, hangs, climbs, vaults, where there is an edge
void drop_ledge(Tick& tick) noexcept;                ///< that it holds, if it holds one
[[nodiscard]] bool climb(Tick& tick) noexcept;       ///< on a ladder, if there is one
void land(Tick& tick, double upward_speed) noexcept;

/// What it takes along from ground that moved.
[[nodiscard]] Vec left_behind(const Tick& tick) noexcept;
/// How fast a body moves where it is touched.
[[nodiscard]] Vec velocity_at(const Tick& tick, std::uint32_t body, const Vec& point) noexcept;

/// All of them. Requires: valid arguments.
[[nodiscard]] StepResult tick_once(const TickArguments& arguments) noexcept;

}  // namespace surefoot::internal
