/// Input from a file, for tests and pictures: the same events that a window would bring, frame by frame.
///
/// A line is a command, `#` begins a comment, places are in window units from the upper left:
///
///     frame 10                 waits until frame 10 (the first is 0); what follows happens there
///     wait 5                   waits five frames
///     await The stones         waits until what is shown has come to a moment that it knows by this name
///     move 640 360             moves the pointer
///     press left               presses a mouse button: left, right or middle
///     release left
///     click 640 360            moves there, presses and lets go; `click right 640 360` with another button
///     click "Label"            presses the widget with this label
///     drag 100 100 200 220 12  from one place to another in 12 frames; `drag right ...` with another button
///     wheel -2                 turns the wheel, away from the user if positive
///     key F                    presses a key and lets it go: `key Control+Shift+Z`
///     hold W                   holds a key down, and
///     unhold W                 lets it go
///     pad press A              presses a button of the gamepad: A, B, X, Y, left_bumper, start, up ..., and
///     pad release A            lets it go
///     axis left_y -1           moves a stick or a trigger: left_x, left_y, right_x, right_y, left_trigger ...
///     text 1.5                 types
///     drop level.obj           drops a file on the window
///     resize 800 600           makes the window another size
///     caption What is seen     belongs to the next screenshot, on a contact sheet
///     screenshot out.png       keeps a picture of this frame; what follows is in the next
///     quit
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <surefoot/error.hpp>

#include "view/input.hpp"

namespace surefoot::view {

struct ScriptCommand {
    enum class Kind : std::uint8_t {
        frame,
        wait,
        await,
        move,
        press,
        release,
        click,
        click_label,
        drag,
        wheel,
        key,
        hold,
        unhold,
        pad_press,
        pad_release,
        axis,
        text,
        drop,
        resize,
        caption,
        screenshot,
        quit,
    };
    Kind kind = Kind::wait;
    int line = 0;
    int count = 0;  ///< frames
    MouseButton button = MouseButton::left;
    dvec2 from{0, 0};
    dvec2 to{0, 0};
    Key key = Key::none;
    PadButton pad = PadButton::a;
    PadAxis axis = PadAxis::left_x;
    Modifiers held{};
    std::string text;
};

struct Script {
    std::string name;
    std::vector<ScriptCommand> commands;
};

/// Fails with `invalid` for a line that makes no sense; the text begins with "name:line: ".
[[nodiscard]] Expected<Script> parse_script(std::string_view text, const std::string& name);
[[nodiscard]] Expected<Script> read_script(const std::string& path);

/// A picture that a script asks for.
struct Screenshot {
    std::string path;
    std::string caption;  ///< may be empty
};

/// Plays a script: one call a frame.
class ScriptPlayer {
public:
    /// Where the widget with a label is, if there is one.
    using FindLabel = std::function<std::optional<dvec2>(std::string_view label)>;

    /// Has what is shown come to the moment of this name?
    using HasCome = std::function<bool(std::string_view moment)>;

    ScriptPlayer(Script script, FindLabel find, HasCome has_come = {});

    /// What one frame holds.
    struct Frame {
        std::vector<InputEvent> events;
        std::vector<Screenshot> screenshots;  ///< to be kept of this frame, once it is drawn
        std::optional<ivec2> resize;
        bool quit = false;
    };

    /// Fails with `not_found` for a label that has not appeared for a second, or a moment that has not come for three
    /// minutes; the text names file and line.
    [[nodiscard]] Expected<Frame> next();

    /// Has everything happened?
    [[nodiscard]] bool done() const { return at_ >= script_.commands.size(); }

private:
    [[nodiscard]] bool step(const ScriptCommand& command, Frame& frame);
    void move_to(const dvec2& at, Frame& frame);
    void press(MouseButton button, bool down, Frame& frame);
    void strike(const ScriptCommand& command, bool down, bool up, Frame& frame);

    Script script_;
    FindLabel find_;
    HasCome has_come_;
    std::size_t at_ = 0;
    int frame_ = -1;
    int spent_ = 0;  // frames on the command at hand
    int label_wait_ = 0;
    std::string caption_;
    dvec2 pointer_{0, 0};
    Modifiers held_{};
};

}  // namespace surefoot::view
