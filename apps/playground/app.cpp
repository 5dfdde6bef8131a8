#include "playground/app.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <ctime>
#include <filesystem>
#include <fmt/format.h>
#include <imgui.h>

#include "playground/start_screen.hpp"
#include "view/gl.hpp"
#include "view/text.hpp"
#include "view/theme.hpp"
#include "view/widgets.hpp"

namespace surefoot::playground {
namespace {

volatile std::sig_atomic_t asked_to_end = 0;

constexpr double tick = 1.0 / 60;

double now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double median_of(std::vector<double>& values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// What the processors spent on this program so far, in all threads [s].
double processing() {
    return double(std::clock()) / CLOCKS_PER_SEC;
}

constexpr view::KeyHelp house_keys[] = {{"F1", "shows this"},
                                        {"F2", "the navigation mesh of the room's ground, and ways over it"},
                                        {"F11", "full screen and back"},
                                        {"Escape", "closes what is open, then goes back to the start"},
                                        {"Drop a file", "opens it as a level"}};

}  // namespace

Expected<std::unique_ptr<App>> App::open(const Options& options) {
    std::unique_ptr<App> app(new App);
    app->options_ = options;
    // The settings of a program with one room are that room's.
    const bool is_house = options.only_room.empty();
    app->settings_path_ = !is_house                   ? std::string()
                          : !options.settings.empty() ? std::filesystem::absolute(options.settings).string()
                          : options.headless          ? std::string()
                                                      : view::settings_path();
    const auto settings = view::read_settings(app->settings_path_);
    if (settings) {
        app->settings_ = *settings;
    } else {
        app->toasts_.warn(settings.error().text);
    }
    view::DisplayOptions wanted;
    wanted.title = options.title;
    wanted.size = options.size       ? *options.size
                  : options.headless ? view::ivec2(1280, 720)
                  : options.window   ? *options.window
                                     : view::ivec2(app->settings_.width, app->settings_.height);
    wanted.headless = options.headless;
    wanted.scale = options.scale;
    wanted.api = options.gl == "es" ? view::GlApi::es : options.gl == "core" ? view::GlApi::core : view::GlApi::any;
    auto display = view::Display::open(wanted);
    if (!display) return tl::unexpected(display.error());
    app->display_ = std::move(*display);
    app->renderer_ = std::make_unique<view::Renderer>();
    app->imgui_ = std::make_unique<view::ImGuiAdapter>(*app->display_);
    app->levels_ = std::make_unique<LevelLoader>(options.headless);
    app->navigation_.emplace(options.headless);
    app->navigation_->shown = options.navigation;
    app->navigation_->begin_at(options.from, options.to);
    const std::string preset = !options.preset.empty()                       ? options.preset
                               : !app->settings_.preset.empty()              ? app->settings_.preset
                               : view::gl_is_software() && !options.headless ? "software"
                                                                             : "full";
    app->renderer_->effects = preset == "software" ? view::Effects::software() : view::Effects::full();
    std::string remark;
    if (preset == "software" && !options.headless)
        remark = std::string(view::gl_is_software() ? "No graphics card was found: shadows" : "Shadows") +
                 ", smoothing and thin edges are off. --preset full turns them on.";
    if (is_house && !remark.empty()) app->toasts_.say(remark);
    app->stage_.emplace(Stage{*app->display_, *app->renderer_, app->settings_, app->toasts_, app->browser_,
                              app->chooser_, *app->levels_, *app->navigation_, options.headless, options.level,
                              options.scene, options.ghost_command});
    app->stage_->beat = options.beat;
    app->stage_->bot = options.bot;
    app->stage_->watch_from = options.watch_from;
    app->stage_->session = options.session;
    app->stage_->is_only_room = !is_house;
    app->stage_->has_size = options.size.has_value();
    app->stage_->program = options.program;
    app->stage_->settings_file = options.settings;
    app->stage_->remark = remark;
    if (!options.headless && app->settings_.full_screen) app->display_->set_full_screen(true);
    app->go_to(options.only_room.empty() ? options.room : options.only_room);
    return app;
}

App::~App() {
    if (room_) room_->leave();
}

void App::go_to(std::string_view room) {
    wanted_room_ = room;
    change_room_ = true;
}

void App::play(view::Script script) {
    quit_ = false;
    player_.emplace(
        std::move(script),
        [this](std::string_view label) {
            const auto widget = view::ui::find_item(label);
            return widget ? widget : room_->place_of(label);
        },
        [this](std::string_view moment) { return room_ && room_->has_come_to(moment); });
}

void App::fail(ExitCode code, const std::string& text) {
    if (!failure_.empty()) return;
    failure_ = text;
    code_ = code;
    quit_ = true;
}

/// All of them before the first is played, so that a mistake in the last is told at once.
bool App::read_scripts() {
    for (const std::string& path : options_.scripts) {
        auto script = view::read_script(path);
        if (!script) {
            fail(script.error().code == ErrorCode::not_found ? ExitCode::file : ExitCode::usage, script.error().text);
            return false;
        }
        scripts_.push_back(std::move(*script));
    }
    std::reverse(scripts_.begin(), scripts_.end());
    return true;
}

ExitCode App::run() {
    if (!read_scripts()) return code_;
    // Who ends a session ends it well: settings are kept.
    std::signal(SIGTERM, [](int) { asked_to_end = 1; });
    std::signal(SIGINT, [](int) { asked_to_end = 1; });
    while (frame() && asked_to_end == 0) {
    }
    if (!options_.screenshot.empty() && failure_.empty()) keep_picture(picture(), options_.screenshot);
    if (!options_.contact_sheet.empty() && failure_.empty()) keep_picture(contact_sheet(), options_.contact_sheet);
    keep_settings();
    if (const auto kept = room_->keep(); !kept) fail(ExitCode::failed, kept.error().text);
    if (options_.timing && !frame_times_.empty()) {
        const double median = median_of(frame_times_);
        fmt::print(
            "{} frames, median {:.1f} ms ({:.0f} a second), {:.1f} ms of processors, {} triangles, {} lines; {}\n",
            frame_times_.size(), median * 1e3, 1 / median, median_of(frame_processing_) * 1e3,
            renderer_->counts().triangles, renderer_->counts().lines, view::gl_description());
    }
    return code_;
}

double App::wait_time() const {
    if (options_.headless || restless_ > 0 || player_ || options_.frames) return 0;
    return 0.25;
}

bool App::frame() {
    if (change_room_) {
        change_room_ = false;
        if (room_) room_->leave();
        room_.reset();
        navigation_->set_ground(nullptr);
        stage_->forget_pending();  // what still comes would call into a room that is gone
        const RoomCard* const card = find_room(wanted_room_);
        room_id_ = card != nullptr ? std::string(card->id) : std::string();
        room_ = card != nullptr ? card->make() : make_start_screen([this](std::string_view id) { go_to(id); });
        room_->enter(*stage_);
        restless_ = 3;
    }
    if (!scripts_.empty() && (!player_ || player_->done())) {
        play(std::move(scripts_.back()));
        scripts_.pop_back();
    }
    const double start = now();
    const double before = processing();
    take_events();
    double dt = tick;
    if (!options_.headless) {
        const double time = now();
        dt = last_time_ > 0 ? std::min(time - last_time_, 0.25) : tick;
        last_time_ = time;
    }
    update(dt);
    draw();
    if (options_.timing) {
        glFinish();
        frame_times_.push_back(now() - start);
        frame_processing_.push_back(processing() - before);
    }
    keep_screenshots();
    display_->present();
    ++frame_;
    if (options_.frames && frame_ >= *options_.frames) quit_ = true;
    if (player_ && player_->done() && scripts_.empty() && options_.headless && !options_.frames) quit_ = true;
    return !quit_;
}

void App::take_events() {
    if (player_) {
        auto played = player_->next();
        if (!played) {
            std::string there = view::ui::known_items();
            for (const std::string& label : room_->labels()) there += (there.empty() ? "\"" : ", \"") + label + "\"";
            fail(ExitCode::failed, played.error().text + "; there " + (there.empty() ? "is none" : "are " + there));
            return;
        }
        events_.insert(events_.end(), played->events.begin(), played->events.end());
        screenshots_ = std::move(played->screenshots);
        if (played->resize) display_->resize(*played->resize);
        if (played->quit) quit_ = true;
    }
    display_->poll(events_, wait_time());
    if (!events_.empty()) restless_ = 3;  // widgets need a frame to see, and one to show, what happened
    const std::vector<view::InputEvent> events = std::move(events_);
    events_.clear();
    for (const view::InputEvent& event : events) house_event(event);
}

void App::house_event(const view::InputEvent& event) {
    if (std::holds_alternative<view::CloseRequest>(event)) {
        quit_ = true;
        return;
    }
    if (view::is_press(event, view::Key::f11)) {
        display_->set_full_screen(!display_->is_full_screen());
        settings_.full_screen = display_->is_full_screen();
        return;
    }
    if (!options_.only_room.empty()) {
        if (imgui_->event(event)) return;
        room_->event(event);
        return;
    }
    if (view::is_press(event, view::Key::f1)) {
        help_ = !help_;
        return;
    }
    if (view::is_press(event, view::Key::escape) && (help_ || stage_->has_dialog())) {
        if (help_) {
            help_ = false;
        } else {
            stage_->close_dialogs();
        }
        return;
    }
    if (imgui_->event(event)) return;
    if (help_ || stage_->has_dialog()) return;
    if (navigation_->event(event, {room_->camera(), display_->size()})) return;
    if (room_->event(event)) return;
    if (view::is_press(event, view::Key::escape) && !room_id_.empty()) go_to({});
}

void App::update(double dt) {
    clock_.add(dt);
    bool moves = levels_->update();
    // What lacks a hair is rounded up: a display of 60 Hz must not fall back to every other frame.
    if (clock_.waiting >= tick * 0.98 && clock_.waiting < tick) clock_.waiting = tick;
    while (clock_.due()) {
        moves = room_->update(tick) || moves;
        navigation_->set_ground(room_->ground());
        moves = navigation_->update() || moves;
        moves = toasts_.update(tick) || moves;
    }
    if (const std::string failure = room_->failure(); !failure.empty() && failure != told_failure_) {
        told_failure_ = failure;
        if (options_.headless)
            fail(ExitCode::file, failure);
        else
            fmt::print(stderr, "{}: {}\n", options_.program, failure);
    }
    stage_->waiting = clock_.waiting;
    if (room_->wants_quit()) {
        if (options_.only_room.empty()) {
            go_to({});
        } else {
            quit_ = true;
        }
    }
    if (moves) restless_ = 3;
    if (restless_ > 0) --restless_;
}

void App::draw() {
    imgui_->begin_frame(tick);
    renderer_->begin({room_->camera(), display_->size(), display_->framebuffer_size(), display_->scale()});
    room_->draw(*renderer_);
    navigation_->draw(*renderer_, clock_.waiting);
    view::draw_labels(renderer_->view(), renderer_->labels(),
                      [this](const dvec3& place) { return room_->hides(place); });
    room_->ui();
    draw_house_ui();
    imgui_->end_frame();
    is_painted_ = false;
    // Nobody sees a frame of a headless run but those that are kept, and drawing is what takes the time.
    if (!options_.headless || options_.timing) paint();
}

void App::paint() {
    if (is_painted_) return;
    is_painted_ = true;
    renderer_->end(display_->framebuffer());
    glBindFramebuffer(GL_FRAMEBUFFER, display_->framebuffer());
    glViewport(0, 0, display_->framebuffer_size().x, display_->framebuffer_size().y);
    room_->draw_over(display_->framebuffer());
    imgui_->paint();
}

void App::draw_house_ui() {
    browser_.draw();
    chooser_.draw();
    if (!levels_->loading().empty()) {
        const ImVec2 size = ImGui::GetIO().DisplaySize;
        ImGui::SetNextWindowPos({size.x / 2, size.y / 2}, ImGuiCond_Always, {0.5F, 0.5F});
        ImGui::Begin("loading", nullptr,
                     ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                         ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoInputs);
        const std::string name = std::filesystem::path(levels_->loading()).filename().string();
        ImGui::TextUnformatted(name.c_str());
        const std::optional<int> percent = levels_->percent();
        view::ui::note(percent ? fmt::format("{}, {} %, {:.0f} s", levels_->step(), *percent, levels_->seconds())
                               : fmt::format("{}, {:.0f} s", levels_->step(), levels_->seconds()));
        // Where it is not known how much is left, the bar goes to and fro.
        constexpr double round_trip = 1.6;  // [s]
        const double phase = std::fmod(levels_->seconds(), round_trip) / round_trip;
        const auto share = percent ? 0 : static_cast<float>(1 - std::abs(2 * phase - 1));
        const float wide = percent ? static_cast<float>(*percent) / 100 : 0.25F;
        const float letter = ImGui::GetFontSize();
        const ImVec2 low = ImGui::GetCursorScreenPos();
        const ImVec2 bar(letter * 16, letter * 0.4F);
        ImDrawList& list = *ImGui::GetWindowDrawList();
        list.AddRectFilled(low, {low.x + bar.x, low.y + bar.y},
                           view::packed(view::with_opacity(view::paint::paper, 0.15)));
        list.AddRectFilled({low.x + share * bar.x * 0.75F, low.y},
                           {low.x + (share * 0.75F + wide) * bar.x, low.y + bar.y}, view::packed(view::paint::accent));
        ImGui::Dummy(bar);
        ImGui::End();
    }
    toasts_.draw();
    if (!help_) return;
    std::vector<view::HelpPage> pages;
    if (!room_->help().empty()) pages.push_back({"In this room", room_->help()});
    pages.push_back({"Everywhere", house_keys});
    help_ = view::draw_help(pages, view::gl_description());
}

view::Picture App::picture() {
    paint();
    return view::read_picture(display_->framebuffer(), display_->framebuffer_size());
}

view::Picture App::contact_sheet() const {
    return view::contact_sheet(thumbnails_);
}

void App::keep_picture(const view::Picture& picture, const std::string& path) {
    const auto written = view::write_png(picture, path);
    if (!written) fail(ExitCode::failed, written.error().text);
}

void App::keep_screenshots() {
    for (const view::Screenshot& wanted : screenshots_) {
        const view::Picture now = picture();
        keep_picture(now, wanted.path);
        if (!options_.contact_sheet.empty()) thumbnails_.push_back({view::thumbnail(now), wanted.caption});
    }
    screenshots_.clear();
}

void App::keep_settings() {
    if (settings_path_.empty()) return;
    settings_.full_screen = display_->is_full_screen();  // a room may have an option for it
    if (!display_->is_full_screen() && !options_.headless && !options_.size) {
        // A window that is opened is made larger by the scale of its screen, where that counts in pixels.
        settings_.width = static_cast<int>(std::lround(display_->size().x / display_->scale()));
        settings_.height = static_cast<int>(std::lround(display_->size().y / display_->scale()));
    }
    const auto kept = view::write_settings(settings_, settings_path_);
    if (!kept) fail(ExitCode::failed, kept.error().text);
}

}  // namespace surefoot::playground
