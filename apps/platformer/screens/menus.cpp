// What stands on each of the screens.
#include <algorithm>
#include <array>
#include <fmt/format.h>

#include "platformer/screens/screens.hpp"
#include "platformer/screens/settings_rows.hpp"

namespace surefoot::platformer {
namespace {

using Kind = Entry::Kind;

/// Fills a menu from above to below.
class Writer {
public:
    explicit Writer(Menu& menu) : menu_(menu) {}

    Entry& button(std::string label, Act act, bool enabled = true, std::string hint = {}) {
        return add({.label = std::move(label), .hint = std::move(hint), .act = act, .enabled = enabled});
    }
    void heading(std::string label) { add({.kind = Kind::heading, .label = std::move(label)}); }
    void text(std::string label, std::string value = {}) {
        add({.kind = Kind::text, .label = std::move(label), .value = std::move(value)});
    }
    Entry& add(Entry entry, int column = 0) {
        if (column == 0) ++row_;
        entry.row = row_;
        entry.column = column;
        menu_.entries.push_back(std::move(entry));
        return menu_.entries.back();
    }

private:
    Menu& menu_;
    int row_ = -1;
};

void write_bindings(Writer& to, const Bindings& bindings) {
    constexpr std::array<const char*, Bindings::places> heads{"Keyboard and mouse", "", "Gamepad", ""};
    for (std::size_t place = 0; place < Bindings::places; ++place)
        to.add({.kind = Kind::heading, .label = heads[place]}, static_cast<int>(place));
    for (std::size_t i = 0; i < action_count; ++i) {
        const auto action = static_cast<Action>(i);
        // What goes without a binding stands where there is none, so that nobody takes the stick for idle.
        const auto value = [&](std::size_t place) {
            const Device device = place < 2 ? Device::keyboard : Device::gamepad;
            const bool is_bare = !bindings[action][place] && !bindings[action][place ^ 1U];
            const bool is_first = place % 2 == 0;
            return is_bare && is_first ? std::string(Bindings::always(action, device))
                                       : name_of(bindings[action][place]);
        };
        for (std::size_t place = 0; place < Bindings::places; ++place)
            to.add({.kind = Kind::binding,
                    .label = std::string(label_of(action)),
                    .value = value(place),
                    .hint = place < 2 ? "Choose, then press a key or a mouse button. Delete empties it."
                                      : "Choose, then press a button of the gamepad. X empties it.",
                    .act = Act::bind,
                    .index = i,
                    .place = place},
                   static_cast<int>(place));
    }
    to.button("As they were in the beginning", Act::reset_bindings);
    to.button("Back", Act::back);
}

void write_help(Writer& to, const Bindings& bindings, Device device) {
    const auto key = [&](Action action) { return name_of(bindings.first(action, device)); };
    const bool pad = device == Device::gamepad;
    to.text("Run",
            pad ? "Left stick"
                : key(Action::forward) + " " + key(Action::left) + " " + key(Action::back) + " " + key(Action::right));
    std::string look(Bindings::always(Action::look_left, device));
    for (const Action action : {Action::look_left, Action::look_right, Action::look_up, Action::look_down})
        if (const std::string name = key(action); !name.empty())
            look += (action == Action::look_left ? ", or " : " ") + name;
    to.text("Look around", look);
    to.text("Jump: the longer held, the higher", key(Action::jump));
    to.text("Once more in the air, or off a wall", key(Action::jump));
    to.text("Climb a ledge that you hang from", pad ? "Left stick up" : key(Action::forward));
    to.text("Dash, on the ground or in the air", key(Action::dash));
    to.text("Crouch; slide when running; dive", key(Action::crouch));
    to.text("Back to the last flag; it costs nothing", key(Action::retry));
    to.text("Pause", key(Action::pause));
    to.text("Enemies", "Jump on them, or keep away");
    to.text("Hearts", "Falls and enemies cost one");
    to.text("Keys", "Open the door of their letter");
    to.text("Stars", "12 open the secret level");
    to.button("Change the keys", Act::bindings);
    to.button("Back", Act::back);
}

/// In lines that fit on a page: at blanks where there are some.
void write_wrapped(Writer& to, std::string_view words) {
    constexpr std::size_t widest = 76;  // letters
    while (!words.empty()) {
        std::size_t end = std::min(words.size(), widest);
        if (end < words.size())
            if (const std::size_t blank = words.rfind(' ', end); blank != std::string_view::npos && blank > 0)
                end = blank;
        // A letter of several bytes is not cut.
        while (end < words.size() && (static_cast<unsigned char>(words[end]) & 0xC0U) == 0x80U) ++end;
        to.text(std::string(words.substr(0, end)));
        words.remove_prefix(end);
        words.remove_prefix(std::min(words.find_first_not_of(' '), words.size()));
    }
}

std::string level_name(const LevelCard& card) {
    return card.locked && card.secret ? "?" : card.title;
}

void write_form(Writer& to, const Form& form) {
    for (const std::string& words : form.words) to.text(words);
    for (std::size_t i = 0; i < form.fields.size(); ++i) {
        const FormField& field = form.fields[i];
        const Kind kind = field.kind == FormField::Kind::line     ? Kind::line
                          : field.kind == FormField::Kind::choice ? Kind::choice
                                                                  : Kind::toggle;
        to.add({.kind = kind,
                .label = field.label,
                .value = field.value(),
                .hint = field.hint,
                .act = Act::field,
                .index = i,
                .share = field.agreed ? 1.0 : 0.0});
    }
    std::string missing;
    for (const FormField& field : form.fields)
        if (missing.empty() && field.required && !field.is_answered()) missing = "Still open: " + field.label;
    to.button(form.done, Act::submit, form.is_complete(), missing);
    to.button(form.dismiss, Act::dismiss);
}

}  // namespace

std::string time_text(double seconds) {
    const auto hundredths = static_cast<long long>(std::clamp(seconds, 0.0, 1e6) * 100 + 0.5);
    return fmt::format("{}:{:02}.{:02}", hundredths / 6000, hundredths / 100 % 60, hundredths % 100);
}

std::string_view label_of(Medal medal) {
    switch (medal) {
        case Medal::bronze:
            return "Bronze";
        case Medal::silver:
            return "Silver";
        case Medal::gold:
            return "Gold";
        case Medal::none:
            break;
    }
    return "No medal";
}

Menu Screens::menu() const {
    Menu menu{.id = top()};
    Writer to(menu);
    const LevelCard* const card = level_ < levels_.size() ? &levels_[level_] : nullptr;
    const bool has_ghost = card != nullptr && card->has_recording;
    const std::string why_no_ghost = has_ghost ? "" : "Win this level first: the best run is kept.";
    switch (menu.id) {
        case ScreenId::title: {
            menu.title = "Surefoot";
            menu.subtitle = "The ground under your feet";
            const std::size_t next = next_to_play();
            if (next < levels_.size()) {
                const bool begun = std::any_of(levels_.begin(), levels_.end(), [](const auto& l) { return l.best; });
                to.button((begun ? "Continue: " : "Play: ") + levels_[next].title, Act::go_on);
            } else {
                to.button("Play", Act::go_on, false, "No levels were found.");
            }
            to.button("Levels", Act::levels);
            to.button("Options", Act::options);
            to.button("How to play", Act::help);
            to.button("Credits", Act::credits);
            to.button("Quit", Act::ask_quit);
            break;
        }
        case ScreenId::levels: {
            menu.title = "Levels";
            int stars = 0;
            for (const LevelCard& level : levels_) stars += level.stars;
            menu.subtitle =
                levels_.empty() ? "No levels were found." : fmt::format("{} {}", stars, stars == 1 ? "star" : "stars");
            menu.columns = layout_.size().x < 700 ? 2 : 3;
            int column = 0;
            for (std::size_t i = 0; i < levels_.size(); ++i) {
                const LevelCard& level = levels_[i];
                if (level.own && (i == 0 || !levels_[i - 1].own)) {
                    to.heading("Your own levels");
                    column = 0;
                }
                to.add({.kind = Kind::card,
                        .label = level_name(level),
                        .hint = level.locked ? level.locked_why : level.idea,
                        .act = Act::open_level,
                        .index = i,
                        .enabled = !level.locked},
                       column++ % menu.columns);
            }
            for (std::size_t i = 0; i < broken_.size(); ++i)
                to.button(broken_[i].name + " cannot be played", Act::open_broken, true, "Choose it to read why.")
                    .index = i;
            to.button("Back", Act::back);
            break;
        }
        case ScreenId::level:
            menu.title = card != nullptr ? card->title : "";
            menu.subtitle = card != nullptr ? card->idea : "";
            to.button("Play", Act::start);
            to.button("Race the ghost of the best run", Act::race, has_ghost, why_no_ghost);
            to.button("Watch the best run", Act::watch, has_ghost, why_no_ghost);
            to.button("Back", Act::back);
            break;
        case ScreenId::options: {
            menu.title = "Options";
            menu.subtitle = remark_;
            to.button("Keys and buttons", Act::bindings);
            const auto rows = setting_rows();
            for (std::size_t i = 0; i < rows.size(); ++i) {
                if (!rows[i].heading.empty()) to.heading(std::string(rows[i].heading));
                Entry entry = entry_of(rows[i], settings_);
                entry.index = i;
                to.add(std::move(entry));
            }
            to.button("As it was in the beginning", Act::reset_settings, true, "Everything on this page.");
            to.button("Back", Act::back);
            break;
        }
        case ScreenId::bindings:
            menu.title = "Keys and buttons";
            menu.subtitle = "Escape and Start always pause";
            menu.columns = static_cast<int>(Bindings::places);
            write_bindings(to, settings_.bindings);
            break;
        case ScreenId::help:
            menu.title = "How to play";
            menu.subtitle = "Reach the beam of light. Flags on the way are checkpoints.";
            write_help(to, settings_.bindings, device_);
            break;
        case ScreenId::credits:
            menu.title = "Credits";
            to.text("Surefoot", "exact sweeps for player movement");
            to.text("Levels, sounds and music", "made by scripts that come with them");
            to.text("Path finding", "Recast and Detour");
            to.text("Windows and letters", "GLFW, stb, DejaVu");
            to.text("Licence and notices", "LICENSE, NOTICE");
            to.button("Back", Act::back);
            break;
        case ScreenId::pause:
            menu.title = "Pause";
            menu.subtitle = card != nullptr ? card->title : "";
            to.button("Go on", Act::resume);
            if (!watching_) to.button("Back to the last flag", Act::retry);
            to.button("From the beginning", Act::restart);
            to.button("Options", Act::options);
            if (!watching_) to.button("How to play", Act::help);
            to.button("Back to the levels", Act::leave);
            break;
        case ScreenId::win: {
            menu.title = "You made it!";
            menu.subtitle = card != nullptr ? card->title : "";
            const std::size_t next = level_ + 1;
            if (next < levels_.size() && !levels_[next].locked && levels_[next].own == card->own)
                to.button("Next: " + levels_[next].title, Act::next);
            to.button("Once more", Act::restart);
            to.button("Race the ghost of the best run", Act::race, has_ghost, why_no_ghost);
            to.button("Watch the best run", Act::watch, has_ghost, why_no_ghost);
            to.button("Back to the levels", Act::leave);
            break;
        }
        case ScreenId::lose:
            menu.title = "Not this time";
            menu.subtitle = lose_.why;
            if (lose_.can_retry)
                to.button(lose_.section.empty() ? "Try again" : "Try again from " + lose_.section, Act::retry);
            to.button("From the beginning", Act::restart);
            to.button("Back to the levels", Act::leave);
            break;
        case ScreenId::replay_end:
            menu.title = "That was the best run";
            menu.subtitle = card != nullptr ? card->title : "";
            to.button("Watch it again", Act::restart);
            to.button("Race its ghost", Act::race, has_ghost, why_no_ghost);
            to.button("Back to the levels", Act::leave);
            break;
        case ScreenId::quit:
            menu.title = "Leave the game?";
            to.button("Stay", Act::back);
            to.button("Leave", Act::quit);
            break;
        case ScreenId::getting_ready:
            menu.title = "Getting ready";
            menu.subtitle = card != nullptr ? card->title : "";
            to.text("Enemies look for their ways. This happens once.");
            to.button("Back to the levels", Act::leave);
            break;
        case ScreenId::trouble:
            menu.title = trouble_.name;
            write_wrapped(to, trouble_.why);
            to.button("Back", Act::back);
            break;
        case ScreenId::form:
            menu.title = form_.title;
            menu.subtitle = form_.subtitle;
            write_form(to, form_);
            break;
        case ScreenId::count:
            break;
    }
    return menu;
}

std::size_t Screens::next_to_play() const {
    const auto open = [](const LevelCard& level) { return !level.locked && !level.best; };
    const auto next = std::find_if(levels_.begin(), levels_.end(), open);
    if (next != levels_.end()) return static_cast<std::size_t>(next - levels_.begin());
    const auto any = std::find_if(levels_.begin(), levels_.end(), [](const LevelCard& level) { return !level.locked; });
    return static_cast<std::size_t>(any - levels_.begin());
}

}  // namespace surefoot::platformer
