/// The record of one step: what a character tried, what it met, what it decided, and by which rule and number.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

#include <surefoot/hit.hpp>
#include <surefoot/math.hpp>

namespace [[gnu::visibility("default")]] surefoot {
inline namespace v0 {

/// What a record tells.
enum class StepAct : std::uint8_t {
    carried,         ///< moving bodies took it along or pushed it, by `motion`
    recovered,       ///< it was too close to something, and was moved out by `motion`
    wants,           ///< the motion of this tick, before anything is met
    pass,            ///< one pass of sliding begins at `position`, by `motion`
    touch,           ///< a triangle was met after `value` of the pass [0, 1]
    obeyed,          ///< the plane of the touch is obeyed from now on
    passed_over,     ///< the touch is not in the way: the surface there does not face the motion
    seam,            ///< the touch is on an inner edge; the plane is that of the face that covers it
    wall,            ///< the plane is steeper than the slope limit: on foot it counts as a wall too
    gave_up_rising,  ///< a steep plane would have lifted it: that part of the wish is dropped
    rested,          ///< nothing is left of the wish along all planes
    step_tried,      ///< looks for a step over what blocks it
    step_refused,    ///< and there is none: see `rule`
    stepped_up,      ///< and walked up by `value` [m]
    ground,          ///< stands on this
    no_ground,       ///< nothing to stand on: see `rule`
    snapped_down,    ///< followed the ground down by `value` [m]
    jumped,          ///< with `value` upwards [m/s]
    landed,          ///< with `value` downwards [m/s]
    left_ground,     ///< see `rule`
    jump_refused,    ///< asked for in the air: see `rule`
    changed_form,    ///< took another of its bodies; the position moved up by `value` [m]
    form_refused,    ///< there is no room for it
    ledge_wall,      ///< a ball looked for a wall along `motion`, and met one after `value` of it, or none: 1
    ledge_edge,     ///< a column was let down behind it by `motion`, and met the top after `value` of it, or nothing: 1
    ledge_refused,  ///< see `rule`
    crushed,
    stuck,
    overflow,       ///< more triangles or planes than there is room for
    parted,         ///< neighbours overlapped it, and it was moved out by `motion`; the one with the id `body` was the
                    ///< deepest in it, and was to be left by `value` [m]
    met_neighbour,  ///< the neighbour with the id `body` was met after `value` of the pass, and is obeyed from now on
};

/// The rule that decided, where one did; `value` was held against `limit`.
enum class StepRule : std::uint8_t {
    none,
    slope_limit,     ///< the surface is too steep: its normal's part along `up` is `value`, and `limit` is the least
    step_height,     ///< what is ahead is `value` higher, and `limit` is allowed [m]
    head_room,       ///< there is room for `value` above it, and the step would need `limit` [m]
    no_advance,      ///< raised by the step height it still gets no farther than `value`; `limit` is needed [m]
    not_higher,      ///< ground ahead is no higher than here
    snap_distance,   ///< the ground is `value` below, 0 if there is none near, and `limit` is followed [m]
    perch_distance,  ///< what holds it is `value` from its axis, and `limit` is allowed [m]
    slippery,        ///< the surface's rule says that nobody stands on it
    steps_off,       ///< steps are switched off; what is ahead is `value` higher, 0 if it is not known [m]
    coyote_time,     ///< it is `value` since it was on ground, and `limit` is allowed [s]
};

/// One line of the story.
struct StepRecord {
    dvec3 position{0, 0, 0};  ///< of the character at that moment [m]
    dvec3 motion{0, 0, 0};    ///< see the act [m]
    dvec3 point{0, 0, 0};     ///< of the touch [m]
    dvec3 normal{0, 0, 0};    ///< of the plane, unit, towards the character
    double value = 0;         ///< see the act and the rule
    double limit = 0;         ///< see the rule
    std::uint32_t triangle = 0;
    std::uint32_t body = 0;
    StepAct act = StepAct::pass;
    StepRule rule = StepRule::none;
    Feature feature = Feature::face;  ///< of the triangle that was touched
    std::uint8_t reserved[5] = {};
};

static_assert(std::is_trivially_copyable_v<StepRecord> && sizeof(StepRecord) == 128);

/// Writes records into the caller's memory until it is full, and counts the ones that found no room.
class StepTrace {
public:
    explicit StepTrace(std::span<StepRecord> room) noexcept : room_(room) {}

    void push(const StepRecord& record) noexcept {
        if (count_ < room_.size()) room_[count_] = record;
        ++count_;
    }

    /// In the order in which things happened.
    [[nodiscard]] std::span<const StepRecord> records() const noexcept {
        return room_.first(count_ < room_.size() ? count_ : room_.size());
    }

    /// How many records found no room.
    [[nodiscard]] std::size_t dropped() const noexcept { return count_ < room_.size() ? 0 : count_ - room_.size(); }

    void clear() noexcept { count_ = 0; }

private:
    std::span<StepRecord> room_;
    std::size_t count_ = 0;
};

}  // namespace v0
}  // namespace surefoot
