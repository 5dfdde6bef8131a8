/// The platformer as a whole: screens, a run, its picture and its sound. A program or a room hands it events and ticks
/// and lends it a picture to draw on.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "game/progress.hpp"
#include "platformer/hud/hud.hpp"
#include "platformer/play/ears.hpp"
#include "platformer/play/library.hpp"
#include "platformer/play/play_session.hpp"
#include "platformer/play/preparation.hpp"
#include "platformer/play/run.hpp"
#include "platformer/screens/controls.hpp"
#include "platformer/screens/screens.hpp"
#include "platformer/sound/speaker.hpp"
#include "view/display.hpp"
#include "view/letters.hpp"
#include "view/ortho_pass.hpp"
#include "view/renderer.hpp"

namespace surefoot::platformer {

struct TheatreOptions {
    std::vector<std::string> level_folders;  ///< where the .glb files are
    std::string level;                       ///< begins at once, by id; empty: the title
    std::string level_file{};                ///< of one more level, beside those of the folders
    std::string watch{};                     ///< a recording's file, to be watched at once
    double watch_from = 0;                   ///< into it [s]
    std::string settings;                    ///< its file; empty: nothing is kept
    std::string progress;                    ///< likewise
    std::string recordings;                  ///< its folder; likewise
    std::string session;                     ///< the folder of an afternoon with people; empty: nobody is tested
    bool headless = false;                   ///< no device for sound, no pointer to be caught
    bool background = false;                 ///< levels are read and made ready beside the drawing, not at once
    int beat = 0;                            ///< of the level: seen as its picture is taken; 0: it is played
    bool keeps_window = false;               ///< its size is one of the settings
    std::string remark{};                    ///< about the machine, for the options screen
    Pilot pilot{};                           ///< plays instead of the player; tries again by itself
    bool pilot_goes_on = false;              ///< to the next level, too
};

/// Where the user's files are; all empty if the environment names no folder.
[[nodiscard]] TheatreOptions usual_theatre();

class Theatre {
public:
    Theatre(view::Display& display, view::Renderer& renderer, TheatreOptions options);
    ~Theatre();

    /// True if it was of use.
    bool event(const view::InputEvent& event);

    /// One tick of `game::tick_seconds`.
    void tick();

    /// `blend` of the way between the last two ticks.
    [[nodiscard]] view::Camera camera(double blend) const;
    void draw(double blend);
    void draw_over(unsigned framebuffer);

    /// The player has had enough.
    [[nodiscard]] bool wants_quit() const { return quit_; }

    /// What was told to the player, once: for a log. They are shown on the screens, one after the other.
    [[nodiscard]] std::vector<std::string> take_notices();

    /// Why what the options asked for at once cannot be had: the level, the recording, the beat. Else empty.
    [[nodiscard]] const std::string& failure() const { return failure_; }

    /// For scripts: where the entry with this label is to be clicked [window units], and which there are.
    [[nodiscard]] std::optional<view::dvec2> place_of(std::string_view label) const;
    [[nodiscard]] std::vector<std::string> labels() const;

    /// What is kept at the end of the program. Fails with `write_failed`.
    [[nodiscard]] Expected<void> keep();

    [[nodiscard]] const Screens& screens() const { return screens_; }
    [[nodiscard]] const Run* run() const { return run_.get(); }
    [[nodiscard]] const Library& library() const { return library_; }
    [[nodiscard]] const game::Progress& progress() const { return progress_; }
    /// What the game teaches at the moment, as a prompt; empty: nothing.
    [[nodiscard]] std::string_view hint() const { return hint_left_ > 0 ? hint_ : std::string_view(); }
    [[nodiscard]] const PlaySession* session() const { return session_ ? &*session_ : nullptr; }

private:
    void obey(const Command& command);
    void obey_all();
    void begin(const std::string& level, Command::Kind how);
    void take_prepared();
    void play(Expected<Run::Prepared> prepared);
    void close_run();
    void end_of_run();
    void keep_run();
    void use_settings();
    void tick_run();
    void show_cards();
    void levels_are_there();
    void begin_named_level();
    void show_backdrop();
    void warm_next_level();
    void lay_out();
    void follow_window();
    bool session_event(const view::InputEvent& event);
    void take_answers();
    void note_wrong(const Expected<void>& kept);
    void trouble(const std::string& title, const std::string& why);
    void merge_progress();
    void show_notices();
    void go_on_by_itself();
    void teach();
    [[nodiscard]] const game::Beat* beat() const;
    void note(const std::string& text);

    view::Display& display_;
    view::Renderer& renderer_;
    TheatreOptions options_;
    Library library_;
    game::Progress progress_;
    Screens screens_;
    Controls controls_;
    sound::Speaker speaker_;
    Ears ears_;
    std::optional<PlaySession> session_;
    Preparation preparation_;
    std::unique_ptr<Run> run_;
    std::unique_ptr<Run> backdrop_;  // behind the title: nobody plays it
    CameraSettings camera_settings_{};
    view::Letters letters_;
    view::Canvas canvas_;
    view::OrthoPass ortho_;
    std::optional<Plan> plan_;  // of the level that is played
    view::Camera seen_{};       // from where the last frame was
    std::vector<std::string> notices_;
    std::vector<std::string> unsaid_;  // of the notices: they wait for a screen, so that nothing covers the game
    std::string mark_;                 // over the game, for a moment
    double mark_left_ = 0;             // [s]
    std::string hint_;                 // of the game itself, where the level has none
    double hint_left_ = 0;             // [s]
    std::string failure_;
    bool is_named_ = false;      // what begins is what the options asked for
    std::string watched_level_;  // of the recording that was named
    double seconds_ = 0;
    double over_for_ = 0;     // since the run was won or lost [s]
    bool shown_end_ = false;  // of the run: the screen that says so was opened
    double idle_ = 0;         // since anybody touched the screen after a run of the pilot's [s]
    int tries_ = 0;           // of the pilot
    bool kept_ = false;       // it is in the progress
    bool settings_kept_ = true;
    bool shows_volume_ = false;
    bool quit_ = false;
};

}  // namespace surefoot::platformer
