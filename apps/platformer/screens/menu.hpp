/// What stands on a screen, as data: no layout, no drawing.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace surefoot::platformer {

enum class ScreenId : std::uint8_t {
    title,
    levels,
    level,
    options,
    bindings,
    help,
    credits,
    pause,
    win,
    lose,
    replay_end,
    quit,
    getting_ready,  ///< what was chosen takes a moment
    form,
    trouble,  ///< something that was asked for cannot be had, and why
    count,
};

/// What an entry does when it is chosen.
enum class Act : std::uint8_t {
    none,
    go_on,   ///< plays the first level that is not won yet
    levels,  ///< the screen of this name, and so on
    options,
    bindings,
    help,
    credits,
    ask_quit,
    quit,
    back,
    open_level,   ///< `index` of the levels
    open_broken,  ///< `index` of the files that are none
    start,
    race,
    watch,
    next,
    resume,
    retry,
    restart,
    leave,
    set,   ///< `index` of the table of settings
    bind,  ///< `index` of the actions, and `place`
    reset_settings,
    reset_bindings,
    field,    ///< `index` of the form's
    submit,   ///< the form is filled in, and
    dismiss,  ///< it is not
};

struct Entry {
    enum class Kind : std::uint8_t { button, card, toggle, slider, choice, binding, line, heading, text };

    Kind kind = Kind::button;
    std::string label{};
    std::string value{};  ///< of a setting or a binding
    std::string hint{};   ///< a sentence about it, shown while it is in focus
    Act act = Act::none;
    std::size_t index = 0;
    std::size_t place = 0;
    double share = 0;  ///< of a slider [0 to 1]; of a toggle 0 or 1
    bool enabled = true;
    int row = 0;
    int column = 0;

    /// Entries that are not enabled are reached too: their hint says why.
    [[nodiscard]] bool can_focus() const { return kind != Kind::heading && kind != Kind::text; }
    [[nodiscard]] bool is_adjusted() const {
        return kind == Kind::toggle || kind == Kind::slider || kind == Kind::choice || kind == Kind::line;
    }
};

struct Menu {
    ScreenId id = ScreenId::title;
    std::string title{};
    std::string subtitle{};
    std::vector<Entry> entries{};
    int columns = 1;
};

enum class Medal : std::uint8_t { none, bronze, silver, gold };

/// A level on the level select.
struct LevelCard {
    std::string id{};
    std::string title{};
    std::string idea{};
    std::optional<double> best{};  ///< [s]
    double gold = 0;               ///< at most so long [s]
    double silver = 0;
    double bronze = 0;
    Medal medal = Medal::none;
    int stars = 0;
    int stars_all = 3;
    int coins = 0;  ///< the most so far
    int coins_all = 0;
    bool locked = false;
    std::string locked_why{};    ///< "Win Rope Bridge first."
    bool secret = false;         ///< while it is locked, nobody is told its name
    bool own = false;            ///< the player's own, and no part of the campaign
    bool has_recording = false;  ///< of the best run
};

/// A file among the levels that is none.
struct BrokenLevel {
    std::string name{};  ///< of the file
    std::string why{};
};

struct WinResult {
    double seconds = 0;
    std::optional<double> best_before{};
    Medal medal = Medal::none;
    int coins = 0;
    int coins_all = 0;
    int stars = 0;
    int stars_all = 3;
    int deaths = 0;
};

struct LoseResult {
    std::string why{};      ///< "You fell out of the level."
    std::string section{};  ///< where the checkpoint is; empty for the beginning
    double seconds = 0;
    bool can_retry = true;  ///< from the checkpoint; else there is only the beginning
};

/// "1:23.45".
[[nodiscard]] std::string time_text(double seconds);

[[nodiscard]] std::string_view label_of(Medal medal);

}  // namespace surefoot::platformer
