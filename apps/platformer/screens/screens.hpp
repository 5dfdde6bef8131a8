/// The screens about the game: a stack of them, moved by events, without drawing and without a clock of its own. The
/// program hands over every event, does what `take` says, and shows `menu`. It is a value: copied, it goes another way.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "platformer/screens/form.hpp"
#include "platformer/screens/game_settings.hpp"
#include "platformer/screens/menu.hpp"
#include "view/canvas.hpp"

namespace surefoot::platformer {

/// What the program has to do.
struct Command {
    enum class Kind : std::uint8_t {
        start,     ///< play `level` from its beginning
        race,      ///< the same, with the ghost of the best run
        watch,     ///< play the recording of the best run of `level`
        resume,    ///< go on
        retry,     ///< from the checkpoint
        restart,   ///< what is played, from its beginning
        leave,     ///< what is played is over
        settings,  ///< they have changed: use them
        keep,      ///< write them to their file
        quit,
        answered,   ///< `form` is filled in
        dismissed,  ///< it was left as it was
    };
    Kind kind = Kind::resume;
    std::string level;

    [[nodiscard]] bool operator==(const Command&) const = default;
};

class Screens {
public:
    explicit Screens(GameSettings settings = {});

    /// On the level select, in this order: those of the campaign, then the player's own; and at its end, quietly, the
    /// files that are none.
    void set_levels(std::vector<LevelCard> levels, std::vector<BrokenLevel> broken = {});
    /// What is in focus stays in sight.
    void set_layout(const view::Layout& layout);
    /// A sentence about the machine, on the options screen.
    void set_remark(std::string remark) { remark_ = std::move(remark); }

    /// True if it was the screens': the game must not see it.
    bool event(const view::InputEvent& event);

    /// For sticks that are held, and for what waits only so long.
    void tick(double seconds);

    /// Nothing is over the game, or over the recording that is watched.
    [[nodiscard]] bool is_playing() const { return stack_.empty(); }
    [[nodiscard]] bool is_watching() const { return watching_; }

    /// The beginning; whatever was played is over.
    void open_title();
    void pause();
    /// They come when keys are being pressed: for a moment, and until hands have rested, nothing is chosen there.
    void show_win(const WinResult& result);
    void show_lose(const LoseResult& result);
    void show_replay_end();

    /// A level is played from now on that was not chosen here, as from the command line.
    void begin_level(const std::string& id, bool watching = false);

    /// What was chosen takes a moment; and it is there, so that nothing is over the game any more.
    void show_getting_ready();
    void show_ready();

    /// Lays a form over whatever is there; false if one is there already.
    bool ask(Form form);
    [[nodiscard]] const Form& form() const { return form_; }

    /// Over the screen that is there: what was asked for cannot be had. It stays until it is dismissed.
    void show_trouble(std::string title, std::string why);

    /// The window was made so by another hand than the option's.
    void set_full_screen(bool full) { settings_.full_screen = full; }
    void set_window_size(const view::ivec2& size);

    /// As if the entry that does this were chosen; nothing if the screen on top has none.
    void choose(Act act);

    /// The next thing to do, once.
    [[nodiscard]] std::optional<Command> take();

    /// Requires: not playing.
    [[nodiscard]] ScreenId top() const { return stack_.back().id; }
    [[nodiscard]] Menu menu() const;
    [[nodiscard]] std::size_t focus() const { return stack_.back().focus; }
    [[nodiscard]] double scroll() const { return stack_.back().scroll; }

    [[nodiscard]] const GameSettings& settings() const { return settings_; }
    [[nodiscard]] Device device() const { return device_; }
    [[nodiscard]] const std::vector<LevelCard>& levels() const { return levels_; }
    [[nodiscard]] std::size_t next_to_play() const;             ///< of them; their number if there is none
    [[nodiscard]] std::size_t level() const { return level_; }  ///< that is looked at or played
    [[nodiscard]] const WinResult& won() const { return win_; }
    [[nodiscard]] const LoseResult& lost() const { return lose_; }
    [[nodiscard]] const view::Layout& layout() const { return layout_; }

    /// Is this binding waiting for its key?
    [[nodiscard]] bool is_capturing() const { return capture_.has_value(); }
    /// What went otherwise than asked, for a few seconds; else empty.
    [[nodiscard]] const std::string& notice() const { return notice_; }
    void say(std::string notice);

private:
    enum class Intent : std::uint8_t { none, up, down, leftwards, rightwards, accept, back, clear, next, previous };
    struct Open {
        ScreenId id = ScreenId::title;
        std::size_t focus = 0;
        double scroll = 0;
    };
    struct Capture {
        Action action = Action::jump;
        std::size_t place = 0;
        double left = 0;  // [s]
    };

    void push(ScreenId id);
    void pop();
    void put_focus(std::size_t at);
    void show_focus(const Menu& menu);
    void obey(Intent intent);
    void move_rows(const Menu& menu, int direction);
    void move_within(const Menu& menu, int direction, bool whole);
    void change(const Entry& entry, int direction);
    void choose(const Entry& entry);
    void back();
    void leave();
    void play(Command::Kind kind, std::size_t level);
    bool capture(const view::InputEvent& event);
    bool typing(const view::InputEvent& event);
    [[nodiscard]] bool is_too_soon(const view::InputEvent& event);
    void guard_hands();
    void fill_in(const Entry& entry);
    void end_form(Command::Kind how);
    void pointer(const view::InputEvent& event);
    [[nodiscard]] Intent intent_of(const view::InputEvent& event);
    [[nodiscard]] Intent stick_intent();

    GameSettings settings_;
    std::vector<LevelCard> levels_;
    std::vector<BrokenLevel> broken_;
    BrokenLevel trouble_;  // its title, and why
    std::string remark_;
    std::vector<Open> stack_;
    std::vector<Command> commands_;
    view::Layout layout_{};
    Device device_ = Device::keyboard;
    std::size_t level_ = 0;
    bool watching_ = false;
    WinResult win_{};
    LoseResult lose_{};
    Form form_;
    std::optional<Capture> capture_;
    std::optional<std::size_t> dragged_;  // a slider in the mouse's hand
    double guard_left_ = 0;               // [s] until anything is chosen on a screen that came by itself
    view::dvec2 stick_{0, 0};
    Intent stick_way_ = Intent::none;
    double stick_wait_ = 0;  // [s] until it moves again
    std::string notice_;
    double notice_left_ = 0;
};

}  // namespace surefoot::platformer
