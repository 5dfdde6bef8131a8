/// A room of the playground: something to look at and to play with. docs/playground.md tells how to write one.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "playground/level_loader.hpp"
#include "playground/navigation/overlay.hpp"
#include "view/camera.hpp"
#include "view/chooser.hpp"
#include "view/display.hpp"
#include "view/file_browser.hpp"
#include "view/help.hpp"
#include "view/input.hpp"
#include "view/renderer.hpp"
#include "view/settings.hpp"
#include "view/toasts.hpp"

namespace surefoot::playground {

/// What the house lends to the room that is open. It outlives every room.
struct Stage {
    view::Display& display;
    view::Renderer& renderer;
    view::Settings& settings;
    view::Toasts& toasts;
    view::FileBrowser& browser;
    view::Chooser& chooser;
    LevelLoader& levels;
    NavigationOverlay& navigation;  ///< a room with ground gives its `ui` a place in a panel
    bool headless = false;          ///< no user is there: nothing of the machine's but what was asked for
    std::string level{};            ///< from the command line; empty if none was named
    std::string scene{};            ///< of the course, likewise
    std::string ghost_command{};    ///< a program that walks it beside ours, likewise
    int beat = 0;                   ///< of the platformer's level: seen as its picture is taken; 0: none
    bool bot = false;               ///< it plays, where there is a game
    double watch_from = 0;          ///< into a recording that is watched [s]
    std::string session{};          ///< the folder of an afternoon with people; empty: nobody is tested
    bool is_only_room = false;      ///< of a program of its own, whose window and settings are the room's
    bool has_size = false;          ///< of the window, from the command line
    std::string program{};          ///< its name, before what is told to a terminal
    std::string settings_file{};    ///< of that program, from the command line; empty: the usual one
    std::string remark{};           ///< about the machine, for its user; empty: none
    double waiting = 0;             ///< time that has passed since the room's last tick [s, less than a tick]

    // What these call back belongs to the room that is open: once that is left, `done` is never called.

    /// Shows the dialog and loads what the user chooses; `done` is called when it is there.
    void browse_for_level(const LevelLoader::Done& done);

    /// Loads a level; one that fails is told to the user and `done` is not called. Of a .pk3 with several maps, the
    /// user is asked which.
    void open_level(const std::string& path, const LevelLoader::Done& done);

    /// Is a dialog open, so that what is behind it has to wait?
    [[nodiscard]] bool has_dialog() const { return browser.is_open() || chooser.is_open(); }
    void close_dialogs();

    /// Forgets what was to be called back, and closes the dialogs: for the house, when the room is gone.
    void forget_pending();
};

class Room {
public:
    Room() = default;
    Room(const Room&) = delete;
    Room& operator=(const Room&) = delete;
    virtual ~Room() = default;

    /// The room is shown from now on; `stage` stays good.
    virtual void enter(Stage& stage) = 0;
    virtual void leave() {}

    /// What the widgets did not take. True if it was of use, so that nobody else takes it.
    virtual bool event(const view::InputEvent& event) = 0;

    /// A tick of 1/60 s; true while something moves, and so has to be drawn again.
    virtual bool update(double dt) = 0;

    /// From where the room is seen.
    [[nodiscard]] virtual view::Camera camera() const = 0;

    /// Everything in the world. `renderer.view()` says from where and how large.
    virtual void draw(view::Renderer& renderer) = 0;

    /// What lies flat over the world and under the panels; drawn at once, into this framebuffer object.
    virtual void draw_over(unsigned /*framebuffer*/) {}

    /// For scripts, where the room draws what is to be clicked: the place of the thing with this label [window units],
    /// and which there are.
    [[nodiscard]] virtual std::optional<view::dvec2> place_of(std::string_view /*label*/) const { return std::nullopt; }
    [[nodiscard]] virtual std::vector<std::string> labels() const { return {}; }

    /// Why what the command line asked for cannot be had; empty: it can. Nobody waits for it where no user is.
    [[nodiscard]] virtual std::string failure() const { return {}; }

    /// What the room keeps when the program ends. Fails with `write_failed`.
    [[nodiscard]] virtual Expected<void> keep() { return {}; }

    /// Has it come to the moment of this name? For scripts that wait for one.
    [[nodiscard]] virtual bool has_come_to(std::string_view /*moment*/) const { return false; }

    /// The user has had enough of the program.
    [[nodiscard]] virtual bool wants_quit() const { return false; }

    /// Panels, with the widgets of view/widgets.hpp or Dear ImGui's.
    virtual void ui() = 0;

    /// Is there something between the eye and this place? Labels there are drawn faintly.
    [[nodiscard]] virtual bool hides(const dvec3& /*place*/) const { return false; }

    /// What one walks on here, for the navigation overlay; null for nothing. Asked every tick: to be kept, not made
    /// anew.
    [[nodiscard]] virtual NavigationGroundPointer ground() const { return nullptr; }

    /// The keys that are the room's own.
    [[nodiscard]] virtual std::span<const view::KeyHelp> help() const { return {}; }
};

/// How a room stands on the start screen.
struct RoomCard {
    std::string_view id;  ///< for --room
    std::string_view name;
    std::string_view blurb;  ///< one sentence
    std::function<std::unique_ptr<Room>()> make;
};

/// All rooms, in the order of the start screen.
[[nodiscard]] std::span<const RoomCard> rooms();

/// The room with this id, or null.
[[nodiscard]] const RoomCard* find_room(std::string_view id);

}  // namespace surefoot::playground
