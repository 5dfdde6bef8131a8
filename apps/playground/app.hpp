/// The house: one window, one stream of input, one room at a time.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <surefoot/error.hpp>
#include <surefoot/fixed_step.hpp>

#include "playground/options.hpp"
#include "playground/room.hpp"
#include "view/contact_sheet.hpp"
#include "view/imgui_adapter.hpp"
#include "view/picture.hpp"
#include "view/script.hpp"

namespace surefoot::playground {

class App {
public:
    /// Opens the display. Fails with `unsupported` where there is none.
    [[nodiscard]] static Expected<std::unique_ptr<App>> open(const Options& options);
    ~App();

    /// Until the user or the script has had enough.
    [[nodiscard]] ExitCode run();

    /// One frame; false when it was the last. A browser calls this, too.
    bool frame();

    /// Enters a room, or the start screen if there is none of that name.
    void go_to(std::string_view room);

    /// For tests: as if the window had brought it.
    void push(const view::InputEvent& event) { events_.push_back(event); }
    void play(view::Script script);

    /// All pictures that scripts asked for so far, small, with their captions.
    [[nodiscard]] view::Picture contact_sheet() const;

    [[nodiscard]] const std::string& room() const { return room_id_; }
    [[nodiscard]] Stage& stage() { return *stage_; }
    [[nodiscard]] Room& current() { return *room_; }
    [[nodiscard]] view::Picture picture();

    /// The first thing that went wrong, and what to end with.
    [[nodiscard]] const std::string& failure() const { return failure_; }

private:
    App() = default;
    void take_events();
    void house_event(const view::InputEvent& event);
    void update(double dt);
    void draw();
    void paint();
    void draw_house_ui();
    void fail(ExitCode code, const std::string& text);
    void keep_settings();
    [[nodiscard]] bool read_scripts();
    void keep_picture(const view::Picture& picture, const std::string& path);
    void keep_screenshots();
    [[nodiscard]] double wait_time() const;

    // In the order in which they need each other.
    Options options_;
    std::string settings_path_;
    view::Settings settings_;
    std::unique_ptr<view::Display> display_;
    std::unique_ptr<view::Renderer> renderer_;
    std::unique_ptr<view::ImGuiAdapter> imgui_;
    view::Toasts toasts_;
    view::FileBrowser browser_;
    view::Chooser chooser_;
    std::unique_ptr<LevelLoader> levels_;
    std::optional<NavigationOverlay> navigation_;
    std::optional<Stage> stage_;
    std::unique_ptr<Room> room_;
    std::string room_id_;
    std::string wanted_room_;
    bool change_room_ = false;

    std::optional<view::ScriptPlayer> player_;
    std::vector<view::InputEvent> events_;
    std::vector<view::Script> scripts_;  // to be played after the one at hand
    std::vector<view::Screenshot> screenshots_;
    std::vector<view::CaptionedPicture> thumbnails_;
    int frame_ = 0;
    int restless_ = 3;                                     // frames to be drawn before waiting for input
    FixedStep clock_{.step = 1.0 / 60, .most = 4.0 / 60};  // a slow machine goes slower rather than ever farther behind
    double last_time_ = 0;
    bool help_ = false;
    bool is_painted_ = true;  // is the frame that was collected last in the framebuffer?
    bool quit_ = false;
    std::string failure_;
    std::string told_failure_;  // of the room
    ExitCode code_ = ExitCode::ok;
    std::vector<double> frame_times_;       // [s]
    std::vector<double> frame_processing_;  // of all threads together [s]
};

}  // namespace surefoot::playground
