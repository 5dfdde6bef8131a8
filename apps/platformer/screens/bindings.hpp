/// Which keys, mouse buttons and buttons of a gamepad do what, and what they are called.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "view/input.hpp"

namespace surefoot::platformer {

// clang-format off
enum class Action : std::uint8_t {
    forward, back, left, right, jump, dash, crouch, look_left, look_right, look_up, look_down, retry, pause,
    count,
};
// clang-format on
inline constexpr std::size_t action_count = static_cast<std::size_t>(Action::count);

/// "Run forward", for people; "forward", for files and prompts.
[[nodiscard]] std::string_view label_of(Action action);
[[nodiscard]] std::string_view word_of(Action action);

/// What can be pressed.
struct Trigger {
    enum class Kind : std::uint8_t { none, key, mouse, pad, axis };
    Kind kind = Kind::none;
    std::uint8_t code = 0;

    Trigger() = default;
    Trigger(view::Key key) : kind(Kind::key), code(static_cast<std::uint8_t>(key)) {}  // NOLINT: a key is one
    Trigger(view::MouseButton button) : kind(Kind::mouse), code(static_cast<std::uint8_t>(button)) {}  // NOLINT
    Trigger(view::PadButton button) : kind(Kind::pad), code(static_cast<std::uint8_t>(button)) {}      // NOLINT
    Trigger(view::PadAxis axis) : kind(Kind::axis), code(static_cast<std::uint8_t>(axis)) {}           // NOLINT

    [[nodiscard]] bool operator==(const Trigger&) const = default;
    [[nodiscard]] explicit operator bool() const { return kind != Kind::none; }
    [[nodiscard]] bool is_pad() const { return kind == Kind::pad || kind == Kind::axis; }
};

/// "Space", "Left mouse", "A", "RT", "Up" of the cross; empty for none.
[[nodiscard]] std::string name_of(const Trigger& trigger);

/// "key Space", "mouse left", "pad a", "axis right_trigger", and back; none for what makes no sense.
[[nodiscard]] std::string text_of(const Trigger& trigger);
[[nodiscard]] Trigger trigger_from(std::string_view text);

/// What an event presses or lets go. The triggers of a gamepad count from half of their way.
struct Pull {
    Trigger trigger;
    bool down = true;
};
[[nodiscard]] std::optional<Pull> pull_of(const view::InputEvent& event);

enum class Device : std::uint8_t { keyboard, gamepad };

/// Whose event is this? Sticks that tremble and pointers that are pushed by a hair are nobody's.
[[nodiscard]] std::optional<Device> device_of(const view::InputEvent& event);

/// Each action has two places for keys and mouse buttons, then two for a gamepad.
struct Bindings {
    static constexpr std::size_t places = 4;
    using Row = std::array<Trigger, places>;

    std::array<Row, action_count> rows{};

    [[nodiscard]] static Bindings defaults();

    [[nodiscard]] const Row& operator[](Action action) const { return rows[static_cast<std::size_t>(action)]; }
    [[nodiscard]] Row& operator[](Action action) { return rows[static_cast<std::size_t>(action)]; }
    [[nodiscard]] bool is(Action action, const Trigger& trigger) const;

    /// The first one of this device.
    [[nodiscard]] Trigger first(Action action, Device device) const;

    /// Puts it there; whoever had it gets what was there before. Returns why not, if so: Escape and Start stay as they
    /// are, and no action is left with nothing.
    [[nodiscard]] std::optional<std::string> bind(Action action, std::size_t place, const Trigger& trigger);

    /// What always does it on this device, whatever is bound: the sticks, and Start. Empty for none.
    [[nodiscard]] static std::string_view always(Action action, Device device);

    /// Is there something for every action, on either device?
    [[nodiscard]] bool is_complete() const;

    [[nodiscard]] bool operator==(const Bindings&) const = default;
};

/// A piece of a prompt: words, or what is written on the key to press.
struct PromptPart {
    std::string text;
    bool is_key = false;

    [[nodiscard]] bool operator==(const PromptPart&) const = default;
};

/// Fills {jump}, {dash}, {crouch}, {retry}, {pause}, {move}, {camera} with the names of the device in hand; what is no
/// placeholder stays as it is.
[[nodiscard]] std::vector<PromptPart> prompt_parts(std::string_view text, const Bindings& bindings, Device device);

}  // namespace surefoot::platformer
