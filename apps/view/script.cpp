#include "view/script.hpp"

#include <cctype>
#include <charconv>
#include <fstream>
#include <iterator>

namespace surefoot::view {
namespace {

using Kind = ScriptCommand::Kind;

/// The words of one line: what is in quotation marks is one word, and `#` ends them.
struct Words {
    std::vector<std::string> all;
    std::string rest;  // of the line behind the first word, as it is written
    bool closed = true;
};

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && std::isspace(static_cast<unsigned char>(text.front())) != 0) text.remove_prefix(1);
    while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back())) != 0) text.remove_suffix(1);
    return text;
}

Words split(std::string_view line) {
    Words words;
    std::size_t i = 0;
    while (i < line.size()) {
        if (std::isspace(static_cast<unsigned char>(line[i])) != 0) {
            ++i;
        } else if (line[i] == '#') {
            line = line.substr(0, i);
        } else if (line[i] == '"') {
            const std::size_t close = line.find('"', i + 1);
            words.closed = close != std::string_view::npos;
            if (!words.closed) return words;
            words.all.emplace_back(line.substr(i + 1, close - i - 1));
            i = close + 1;
        } else {
            std::size_t end = i;
            while (end < line.size() && std::isspace(static_cast<unsigned char>(line[end])) == 0) ++end;
            words.all.emplace_back(line.substr(i, end - i));
            i = end;
        }
        if (words.all.size() == 1 && words.rest.empty() && i < line.size()) words.rest = trimmed(line.substr(i));
    }
    const std::size_t comment = words.rest.find(" #");
    if (comment != std::string::npos) words.rest = trimmed(std::string_view(words.rest).substr(0, comment));
    if (words.rest.size() >= 2 && words.rest.front() == '"' && words.rest.back() == '"')
        words.rest = words.rest.substr(1, words.rest.size() - 2);
    return words;
}

std::optional<double> number(const std::string& word) {
    double value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size() || !(value >= -1e6 && value <= 1e6))
        return std::nullopt;
    return value;
}

std::optional<MouseButton> button_named(const std::string& word) {
    if (word == "left") return MouseButton::left;
    if (word == "right") return MouseButton::right;
    if (word == "middle") return MouseButton::middle;
    return std::nullopt;
}

/// "Control+Shift+Z".
bool read_key(std::string_view text, ScriptCommand& command) {
    for (std::size_t plus = text.find('+'); plus != std::string_view::npos; plus = text.find('+')) {
        const Key held = key_named(text.substr(0, plus));
        if (held == Key::shift) {
            command.held.shift = true;
        } else if (held == Key::control) {
            command.held.control = true;
        } else if (held == Key::alt) {
            command.held.alt = true;
        } else {
            return false;
        }
        text.remove_prefix(plus + 1);
    }
    command.key = key_named(text);
    return command.key != Key::none;
}

/// Fills `command` from the words of its line; what is wrong with them, or an empty text.
class LineReader {
public:
    LineReader(Words words, ScriptCommand& command) : words_(std::move(words)), command_(command) {}

    std::string read() {
        if (!words_.closed) return "a quotation mark is not closed";
        const std::string& verb = words_.all[0];
        if (verb == "frame") return counted(Kind::frame, "frame NUMBER");
        if (verb == "wait") return counted(Kind::wait, "wait FRAMES");
        if (verb == "await") return words_.rest.empty() ? "write: await MOMENT" : told(Kind::await);
        if (verb == "move") return places(Kind::move, 1, false, "move X Y");
        if (verb == "press" || verb == "release") {
            command_.kind = verb == "press" ? Kind::press : Kind::release;
            const auto button = words_.all.size() == 2 ? button_named(words_.all[1]) : std::nullopt;
            if (!button) return "write: " + verb + " left, right or middle";
            command_.button = *button;
            return {};
        }
        if (verb == "click") return click();
        if (verb == "drag") return places(Kind::drag, 2, true, "drag [BUTTON] X Y X Y [FRAMES]");
        if (verb == "wheel") {
            command_.kind = Kind::wheel;
            const auto clicks = words_.all.size() == 2 ? number(words_.all[1]) : std::nullopt;
            if (!clicks) return "write: wheel CLICKS";
            command_.to.y = *clicks;
            return {};
        }
        if (verb == "key" || verb == "hold" || verb == "unhold") {
            command_.kind = verb == "key" ? Kind::key : verb == "hold" ? Kind::hold : Kind::unhold;
            if (words_.all.size() != 2 || !read_key(words_.all[1], command_))
                return "there is no such key; write: " + verb + " F, or Control+Shift+Z, F11, Left, Escape ...";
            return {};
        }
        if (verb == "pad") return pad();
        if (verb == "axis") return axis();
        if (verb == "text") return words_.rest.empty() ? "write: text WHAT IS TYPED" : told(Kind::text);
        if (verb == "drop") return words_.rest.empty() ? "write: drop FILE" : told(Kind::drop);
        if (verb == "caption") return words_.rest.empty() ? "write: caption WHAT IS SEEN" : told(Kind::caption);
        if (verb == "screenshot") return words_.rest.empty() ? "write: screenshot FILE.png" : told(Kind::screenshot);
        if (verb == "resize") {
            const std::string wrong = places(Kind::resize, 1, false, "resize WIDTH HEIGHT");
            if (wrong.empty() &&
                (command_.to.x < 1 || command_.to.y < 1 || command_.to.x > 16384 || command_.to.y > 16384))
                return "a window is 1 to 16384 wide and high";
            return wrong;
        }
        if (verb == "quit") {
            command_.kind = Kind::quit;
            return words_.all.size() == 1 ? std::string() : "quit stands alone";
        }
        return "unknown command '" + verb +
               "'; there are: frame wait move press release click drag wheel key hold unhold pad axis text drop "
               "resize caption screenshot quit";
    }

private:
    std::string told(Kind kind) {
        command_.kind = kind;
        command_.text = words_.rest;
        return {};
    }

    std::string counted(Kind kind, const char* how) {
        command_.kind = kind;
        const auto count = words_.all.size() == 2 ? number(words_.all[1]) : std::nullopt;
        if (!count || *count < 0) return std::string("write: ") + how;
        command_.count = static_cast<int>(*count);
        return {};
    }

    std::string pad() {
        const bool known = words_.all.size() == 3 && (words_.all[1] == "press" || words_.all[1] == "release");
        if (known) command_.pad = pad_button_named(words_.all[2]);
        if (!known || command_.pad == PadButton::count)
            return "write: pad press A, or pad release A; there are a b x y left_bumper right_bumper back start guide "
                   "left_thumb right_thumb up right down left";
        command_.kind = words_.all[1] == "press" ? Kind::pad_press : Kind::pad_release;
        return {};
    }

    std::string axis() {
        command_.kind = Kind::axis;
        const auto value = words_.all.size() == 3 ? number(words_.all[2]) : std::nullopt;
        if (value) command_.axis = pad_axis_named(words_.all[1]);
        if (!value || command_.axis == PadAxis::count || *value < -1 || *value > 1)
            return "write: axis left_y -1; there are left_x left_y right_x right_y left_trigger right_trigger, each "
                   "from -1 to 1";
        command_.to.x = *value;
        return {};
    }

    std::string click() {
        if (words_.all.size() == 2 && !words_.all[1].empty()) {
            command_.kind = Kind::click_label;
            command_.text = words_.all[1];
            return {};
        }
        return places(Kind::click, 1, false, "click [BUTTON] X Y, or click \"LABEL\"");
    }

    std::string places(Kind kind, std::size_t count, bool frames, const char* how) {
        command_.kind = kind;
        std::size_t next = 1;
        if (kind != Kind::move && kind != Kind::resize && words_.all.size() > 1) {
            if (const auto button = button_named(words_.all[1])) {
                command_.button = *button;
                ++next;
            }
        }
        std::vector<double> numbers;
        for (; next < words_.all.size(); ++next) {
            const auto value = number(words_.all[next]);
            if (!value) return "'" + words_.all[next] + "' is no number; write: " + how;
            numbers.push_back(*value);
        }
        const bool with_frames = frames && numbers.size() == 2 * count + 1;
        if (numbers.size() != 2 * count && !with_frames) return std::string("write: ") + how;
        command_.count = with_frames ? static_cast<int>(numbers.back()) : 10;
        if (command_.count < 1) return "a drag takes at least one frame";
        if (count == 2) command_.from = {numbers[0], numbers[1]};
        command_.to = {numbers[2 * count - 2], numbers[2 * count - 1]};
        return {};
    }

    Words words_;
    ScriptCommand& command_;
};

}  // namespace

Expected<Script> parse_script(std::string_view text, const std::string& name) {
    Script script{name, {}};
    int line = 0;
    while (!text.empty()) {
        const std::size_t end = text.find('\n');
        Words words = split(text.substr(0, end));
        text = end == std::string_view::npos ? std::string_view() : text.substr(end + 1);
        ++line;
        if (words.all.empty() && words.closed) continue;
        ScriptCommand command;
        command.line = line;
        const std::string wrong = LineReader(std::move(words), command).read();
        if (!wrong.empty())
            return tl::unexpected(Error{ErrorCode::invalid, name + ":" + std::to_string(line) + ": " + wrong, name, 0});
        script.commands.push_back(std::move(command));
    }
    return script;
}

Expected<Script> read_script(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) return tl::unexpected(Error{ErrorCode::not_found, path + ": there is no such script", path, 0});
    const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    return parse_script(text, path);
}

}  // namespace surefoot::view
