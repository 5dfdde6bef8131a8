#include <cmath>
#include <utility>

#include "view/script.hpp"

namespace surefoot::view {
namespace {

using Kind = ScriptCommand::Kind;

constexpr int patience = 60;             // frames that a label may take to appear
constexpr int long_patience = 60 * 180;  // and a moment to come

}  // namespace

ScriptPlayer::ScriptPlayer(Script script, FindLabel find, HasCome has_come)
    : script_(std::move(script)), find_(std::move(find)), has_come_(std::move(has_come)) {}

void ScriptPlayer::move_to(const dvec2& at, Frame& frame) {
    frame.events.emplace_back(PointerMove{at, at - pointer_, held_});
    pointer_ = at;
}

void ScriptPlayer::press(MouseButton button, bool down, Frame& frame) {
    frame.events.emplace_back(ButtonPress{button, down, pointer_, held_});
}

void ScriptPlayer::strike(const ScriptCommand& command, bool down, bool up, Frame& frame) {
    const Modifiers held{command.held.shift || held_.shift, command.held.control || held_.control,
                         command.held.alt || held_.alt};
    const auto hold = [&](Key key, bool& now) {
        if (command.key == key && (down || up) && down != up) now = down;
    };
    hold(Key::shift, held_.shift);
    hold(Key::control, held_.control);
    hold(Key::alt, held_.alt);
    if (down) frame.events.emplace_back(KeyPress{command.key, true, false, held});
    if (up) frame.events.emplace_back(KeyPress{command.key, false, false, held});
}

/// Does a frame's worth of a command; true when the next command may begin in the same frame.
bool ScriptPlayer::step(const ScriptCommand& c, Frame& frame) {
    const int spent = spent_++;
    switch (c.kind) {
        case Kind::frame:
            return frame_ >= c.count;
        case Kind::wait:
            return spent >= c.count;
        case Kind::await:
            return has_come_ && has_come_(c.text);
        case Kind::move:
            move_to(c.to, frame);
            return true;
        case Kind::press:
            press(c.button, true, frame);
            return true;
        case Kind::release:
            press(c.button, false, frame);
            return true;
        case Kind::click:
        case Kind::click_label:
            // A widget learns in one frame that the pointer is over it, and in the next that it is pressed.
            if (spent == 0) move_to(c.to, frame);
            if (spent == 2) press(c.button, true, frame);
            if (spent == 3) press(c.button, false, frame);
            return spent >= 4;
        case Kind::drag:
            if (spent == 0) move_to(c.from, frame);
            if (spent == 2) press(c.button, true, frame);
            if (spent > 2 && spent <= 2 + c.count)
                move_to(c.from + (c.to - c.from) * (double(spent - 2) / c.count), frame);
            if (spent == 3 + c.count) press(c.button, false, frame);
            return spent >= 4 + c.count;
        case Kind::wheel:
            frame.events.emplace_back(WheelTurn{c.to, pointer_, held_});
            return true;
        case Kind::key:
            // Two frames, as nobody is faster.
            if (spent == 0) strike(c, true, false, frame);
            if (spent == 1) strike(c, false, true, frame);
            return spent >= 2;
        case Kind::hold:
            strike(c, true, false, frame);
            return true;
        case Kind::unhold:
            strike(c, false, true, frame);
            return true;
        case Kind::pad_press:
        case Kind::pad_release:
            frame.events.emplace_back(GamepadButton{c.pad, c.kind == Kind::pad_press});
            return true;
        case Kind::axis:
            frame.events.emplace_back(GamepadAxis{c.axis, c.to.x});
            return true;
        case Kind::text:
            frame.events.emplace_back(TextInput{c.text});
            return true;
        case Kind::drop:
            frame.events.emplace_back(FileDrop{{c.text}});
            return true;
        case Kind::resize:
            frame.resize = ivec2(c.to);
            return true;
        case Kind::caption:
            caption_ = c.text;
            return true;
        case Kind::screenshot:
            frame.screenshots.push_back({c.text, std::exchange(caption_, {})});
            return true;
        case Kind::quit:
            frame.quit = true;
            return true;
    }
    return true;
}

Expected<ScriptPlayer::Frame> ScriptPlayer::next() {
    Frame frame;
    ++frame_;
    while (!done() && !frame.quit) {
        ScriptCommand& command = script_.commands[at_];
        if (command.kind == Kind::click_label && spent_ == 0) {
            const auto place = find_ ? find_(command.text) : std::nullopt;
            if (!place) {
                if (++label_wait_ <= patience) return frame;
                return tl::unexpected(Error{ErrorCode::not_found,
                                            script_.name + ":" + std::to_string(command.line) +
                                                ": no widget is called \"" + command.text + "\"",
                                            script_.name, 0});
            }
            command.to = *place;
        }
        if (command.kind == Kind::await && spent_ > long_patience)
            return tl::unexpected(Error{ErrorCode::not_found,
                                        script_.name + ":" + std::to_string(command.line) + ": the moment \"" +
                                            command.text + "\" does not come",
                                        script_.name, 0});
        // What waits has its frame looked at again; what does something ends with the frame that it did it in.
        if (!step(command, frame)) return frame;
        const bool pictured = command.kind == Kind::screenshot;
        ++at_;
        spent_ = 0;
        label_wait_ = 0;
        if (pictured) return frame;  // what follows must not be in the picture
    }
    return frame;
}

}  // namespace surefoot::view
