/// A character in a level, moved by `step` in ticks of one length, and the last seconds of it: time can go slowly,
/// stand, go tick by tick and go back. It draws nothing.
#pragma once

#include <optional>
#include <vector>

#include <surefoot/capture_session.hpp>
#include <surefoot/capture_step.hpp>
#include <surefoot/character.hpp>
#include <surefoot/fixed_step.hpp>
#include <surefoot/mesh.hpp>
#include <surefoot/world.hpp>

namespace surefoot::playground {

/// A step that was made, with all that was said about it.
struct ToldStep {
    CharacterInput input{};
    CharacterState before{};
    StepResult result{};
    std::vector<StepRecord> records;
    std::size_t dropped = 0;  ///< how many more records there were
};

class Walker {
public:
    static constexpr double tick = 1.0 / 60;              ///< [s]
    static constexpr std::size_t most_ticks = 20 * 60;    ///< that are remembered
    static constexpr std::size_t most_records = 1 << 12;  ///< of one step

    explicit Walker(const Mesh& mesh);

    Walker(const Walker&) = delete;
    Walker& operator=(const Walker&) = delete;

    /// Puts the feet on the ground at `place`, or above it where something is in the way, with no past. False if there
    /// is no room.
    bool put(const dvec3& place);

    /// Begins at this state, with no past.
    void put(const CharacterState& state);

    /// Lets `seconds` pass, at `speed`; true while time passes. `ask` is asked for the input of each tick.
    template <typename Ask>
    bool pass(double seconds, const Ask& ask) {
        if (paused) return false;
        clock_.add(seconds * speed);
        while (clock_.due()) make_tick(ask());
        return true;
    }

    /// One tick, though time may stand. In the past, it is the tick that was made then.
    void make_tick(const CharacterInput& input);

    // The past: 0 is the oldest state that is remembered, `ticks()` the present.
    [[nodiscard]] std::size_t ticks() const { return ring_.size(); }
    [[nodiscard]] std::size_t looks_at() const { return looks_at_.value_or(ticks()); }

    /// Looks at a state of the past, and time stands; or at the present.
    void look_at(std::size_t when);

    /// Forgets what came after the state that is looked at, which becomes the present.
    void go_on_from_here();

    /// The state that is looked at.
    [[nodiscard]] const CharacterState& state() const;

    /// Where the body is drawn: between the last two ticks, `waiting` seconds after time passed last.
    [[nodiscard]] dvec3 drawn_position(double waiting) const;

    /// The step that led to the state that is looked at, made again with a trace; null where the past begins.
    [[nodiscard]] const ToldStep* told() const;

    /// The last step up to the state that is looked at in which something was in the way.
    struct Stop {
        const ToldStep* step = nullptr;  ///< null if there was none
        double ago = 0;                  ///< [s]
    };
    [[nodiscard]] Stop last_stop() const;

    /// Why it went as it did, in words.
    [[nodiscard]] std::vector<StepSentence> why(const ToldStep& step) const;

    /// The step that led to the state that is looked at, to be saved; none where the past begins.
    [[nodiscard]] std::optional<StepCapture> moment() const;

    /// All that is remembered, to be played again.
    [[nodiscard]] Session session() const;

    /// Where the body was, from the oldest state to the present.
    [[nodiscard]] std::vector<dvec3> trail() const;

    /// Where the inputs that came after the state that is looked at lead with settings that were changed since: a place
    /// a tick, from that state on. Empty while nothing was changed.
    [[nodiscard]] const std::vector<dvec3>& what_if() const;

    [[nodiscard]] const World& world() const { return world_; }
    [[nodiscard]] const CharacterSettings& settings() const { return settings_; }
    [[nodiscard]] const std::vector<SurfaceRule>& surfaces() const { return surfaces_; }

    /// Those of the steps that are remembered.
    [[nodiscard]] const CharacterSettings& settings_of_past() const { return past_settings_; }

    /// From the next tick on; it begins a new past, for a past has one set of settings. The feet stay where they are
    /// when the body becomes another.
    void change(const CharacterSettings& settings);
    void change(const std::vector<SurfaceRule>& surfaces);

    /// How often they were changed.
    [[nodiscard]] std::uint64_t changes() const { return changes_; }

    bool paused = false;
    double speed = 1;  ///< of time

private:
    [[nodiscard]] ToldStep tell(std::size_t when) const;
    void begin_past();
    void touch();

    World world_;
    CharacterSettings settings_{};
    std::vector<SurfaceRule> surfaces_;
    std::uint64_t changes_ = 0;
    bool is_changed_ = true;  // since the past began
    CharacterState before_{};
    CharacterState now_{};
    FixedStep clock_{.step = tick};

    std::vector<RingTick> room_;
    StepRing ring_;
    std::vector<char> stops_;  // one a tick, by how many were made before it, in a ring of the same length
    std::uint64_t made_ = 0;
    CharacterSettings past_settings_{};
    std::vector<SurfaceRule> past_surfaces_;
    std::optional<std::size_t> looks_at_;

    // What was told last, until something changes.
    mutable std::optional<ToldStep> told_;
    mutable std::optional<ToldStep> stop_;
    mutable std::size_t stop_tick_ = 0;
    mutable std::optional<std::vector<dvec3>> what_if_;
};

/// How far the lowest point of an upright body is below its reference point [m].
[[nodiscard]] double foot_of(const Shape& shape);

/// The body that a character has in this form.
[[nodiscard]] const Volume& body_of(const CharacterSettings& settings, CharacterForm form);

/// Was something in the way?
[[nodiscard]] bool is_stop(const CharacterEvents& events);

}  // namespace surefoot::playground
