#include "platformer/play/theatre.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <glm/common.hpp>
#include <utility>

#include "platformer/play/hud_of.hpp"
#include "platformer/screens/arrange.hpp"
#include "platformer/screens/draw_screens.hpp"

namespace surefoot::platformer {
namespace {

constexpr double degree = 3.14159265358979323846 / 180;

view::Camera looking(const dvec3& eye, const dvec3& at, double field_of_view) {
    const dvec3 way = at - eye;
    const double length = std::sqrt(way.x * way.x + way.y * way.y + way.z * way.z);
    return {.eye = eye, .forward = length > 0 ? way / length : dvec3{0, 0, -1}, .field_of_view = field_of_view};
}

}  // namespace

TheatreOptions usual_theatre() {
    namespace fs = std::filesystem;
    TheatreOptions options;
    options.settings = game_settings_path();
    if (!options.settings.empty()) {
        const fs::path folder = fs::path(options.settings).parent_path();
        options.progress = (folder / "platformer-progress.json").string();
        options.recordings = (folder / "platformer-runs").string();
        options.level_folders.push_back((folder / "levels").string());
    }
    return options;
}

Theatre::Theatre(view::Display& display, view::Renderer& renderer, TheatreOptions options)
    : display_(display),
      renderer_(renderer),
      options_(std::move(options)),
      speaker_(options_.headless ? sound::Output::nothing : sound::Output::device),
      ears_(speaker_),
      canvas_(letters_) {
    GameSettings settings;
    if (auto read = read_game_settings(options_.settings))
        settings = *read;
    else
        note(read.error().text);
    if (auto read = game::read_progress(options_.progress))
        progress_ = *read;
    else
        note(read.error().text);
    if (display_.is_full_screen()) settings.full_screen = true;
    screens_ = Screens(settings);
    screens_.set_remark(options_.remark);
    use_settings();
    follow_window();
    screens_.open_title();
    speaker_.music(sound::Piece::calm);
    if (!options_.session.empty()) {
        session_.emplace(options_.session);
        screens_.ask(PlaySession::start_form());
    }
    library_.open(options_.level_folders, options_.level_file, !options_.background);
    if (library_.is_ready()) levels_are_there();
}

Theatre::~Theatre() {
    if (run_) keep_run();
}

void Theatre::show_cards() {
    std::vector<BrokenLevel> broken;
    for (const Library::Broken& one : library_.broken())
        broken.push_back({std::filesystem::path(one.file).filename().string(), one.why});
    screens_.set_levels(library_.cards(progress_, options_.recordings), std::move(broken));
}

void Theatre::levels_are_there() {
    show_cards();
    begin_named_level();
    if (library_.levels().empty()) {
        note("There are no levels. Where .glb files are to be put, docs/levels.md tells.");
        return;
    }
    if (!run_ && !preparation_.is_asked()) {
        show_backdrop();
        warm_next_level();
    }
}

/// The level of the command line, once; who is tested fills in the form first.
void Theatre::begin_named_level() {
    if (!library_.is_ready() || (session_ && !session_->has_begun())) return;
    if (!options_.watch.empty() && watched_level_.empty()) {
        const auto recording = game::read_recording(options_.watch);
        watched_level_ = recording ? recording->level : std::string("?");
        is_named_ = true;
        if (!recording) {
            trouble("This recording cannot be watched", recording.error().text);
        } else {
            screens_.begin_level(watched_level_, true);
            begin(watched_level_, Command::Kind::watch);
        }
        return;
    }
    if (options_.level.empty()) return;
    const std::string id = std::exchange(options_.level, {});
    is_named_ = true;
    for (const Library::Broken& broken : library_.broken())
        if (broken.file == options_.level_file) return trouble("This level cannot be played", broken.why);
    screens_.begin_level(id);
    begin(id, Command::Kind::start);
}

void Theatre::show_backdrop() {
    // Enemies who jump would take their time, and nobody looks at them here.
    const auto quick = std::ranges::find_if(library_.levels(), [](const auto& level) { return !has_jumpers(*level); });
    if (backdrop_ || quick == library_.levels().end()) return;
    if (auto behind = Run::prepare({.level = *quick})) backdrop_ = Run::start(std::move(*behind));
}

void Theatre::warm_next_level() {
    const std::size_t next = screens_.next_to_play();
    if (!options_.background || next >= screens_.levels().size()) return;
    if (const auto level = library_.find(screens_.levels()[next].id)) preparation_.warm(level);
}

bool Theatre::event(const view::InputEvent& event) {
    if (view::is_press(event, view::Key::f3)) {
        shows_volume_ = !shows_volume_;
        return true;
    }
    // A press belongs to the window as it is now, and not as it was when it was drawn last.
    if (std::holds_alternative<view::Resize>(event)) lay_out();
    if (pull_of(event)) idle_ = 0;
    if (session_ && session_->has_begun() && session_event(event)) return true;
    if (screens_.event(event)) return true;
    return screens_.is_playing() && controls_.event(event, screens_.settings().bindings);
}

void Theatre::use_settings() {
    const GameSettings& settings = screens_.settings();
    camera_settings_.field_of_view = settings.field_of_view * degree;
    camera_settings_.reduced_motion = settings.reduced_motion;
    if (run_) run_->set_colours(settings.colours);
    speaker_.set_volumes({.master = settings.volume, .effects = settings.effects, .music = settings.music});
    if (settings.full_screen != display_.is_full_screen()) display_.set_full_screen(settings.full_screen);
}

/// F11 is the window's: the option says what it did.
void Theatre::follow_window() {
    if (display_.is_full_screen() == screens_.settings().full_screen) return;
    screens_.set_full_screen(display_.is_full_screen());
    obey({Command::Kind::keep, {}});
}

void Theatre::begin(const std::string& id, Command::Kind how) {
    const auto level = library_.find(id);
    if (!level) {
        std::string there;
        for (const auto& one : library_.levels()) there += (there.empty() ? "" : ", ") + one->id;
        return trouble("There is no level '" + id + "'",
                       "There is no level '" + id + "'; there are: " + (there.empty() ? "none" : there) + ".");
    }
    Run::Plan plan{.level = level, .pilot = options_.pilot};
    if (how == Command::Kind::race || how == Command::Kind::watch) {
        const bool is_named = how == Command::Kind::watch && id == watched_level_;
        auto recording = game::read_recording(is_named ? options_.watch : best_run_path(options_.recordings, id));
        if (!recording) return trouble("This recording cannot be watched", recording.error().text);
        if (recording->level_hash != level->hash)
            return trouble("This recording cannot be watched",
                           "The level " + level->title + " has changed since that run, so it cannot be played again.");
        if (how == Command::Kind::race) {
            plan.ghost = std::move(*recording);
        } else {
            plan.watched = std::make_shared<const game::Recording>(std::move(*recording));
            if (is_named) plan.watched_from = options_.watch_from;
        }
    }
    // What is there in a moment is not announced.
    preparation_.ask(std::move(plan), options_.background ? 0.1 : 1e6);
    take_prepared();
    if (preparation_.is_asked()) screens_.show_getting_ready();
}

void Theatre::take_prepared() {
    if (auto made = preparation_.take()) play(std::move(*made));
}

void Theatre::play(Expected<Run::Prepared> prepared) {
    if (!prepared) return trouble("This level cannot be begun", prepared.error().text);
    if (const std::size_t beats = prepared->plan.level->beats.size(); std::size_t(options_.beat) > beats)
        return trouble("There is no such beat",
                       fmt::format("There is no beat {} in {}: it has {}.", std::exchange(options_.beat, 0),
                                   prepared->plan.level->id, beats));
    is_named_ = false;
    tries_ = 0;
    run_ = Run::start(std::move(*prepared));
    run_->set_colours(screens_.settings().colours);
    const game::Level& level = run_->game().level();
    plan_ = plan_of(level);
    ortho_.set_picture(plan_->picture);
    backdrop_.reset();
    controls_.release();
    screens_.show_ready();
    shown_end_ = false;
    kept_ = false;
    idle_ = 0;
    over_for_ = 0;
    if (session_ && !run_->is_watched()) session_->begin_run(level);
    speaker_.music(level.music == "lively" ? sound::Piece::lively : sound::Piece::calm);
}

/// Nothing is played any more.
void Theatre::close_run() {
    preparation_.forget();
    if (run_) keep_run();
    run_.reset();
    speaker_.music(sound::Piece::calm);
    show_cards();
    show_backdrop();
    warm_next_level();
}

void Theatre::obey(const Command& command) {
    switch (command.kind) {
        case Command::Kind::start:
        case Command::Kind::race:
        case Command::Kind::watch:
            if (run_) keep_run();
            begin(command.level, command.kind);
            break;
        case Command::Kind::restart:
            if (run_) {
                const std::string id = run_->game().level().id;
                keep_run();
                begin(id, run_->is_watched() ? Command::Kind::watch
                          : run_->ghost()    ? Command::Kind::race
                                             : Command::Kind::start);
            }
            break;
        case Command::Kind::resume:
            controls_.release();
            break;
        case Command::Kind::retry:
            if (run_) run_->retry();
            controls_.release();
            shown_end_ = false;
            over_for_ = 0;
            break;
        case Command::Kind::leave:
            close_run();
            break;
        case Command::Kind::settings:
            use_settings();
            break;
        case Command::Kind::keep:
            if (!options_.settings.empty()) {
                const auto kept = write_game_settings(screens_.settings(), options_.settings);
                settings_kept_ = kept.has_value();
                note_wrong(kept);
            }
            break;
        case Command::Kind::quit:
            if (!session_ || !session_->has_begun() || !screens_.ask(PlaySession::end_form())) quit_ = true;
            break;
        case Command::Kind::answered:
            take_answers();
            break;
        case Command::Kind::dismissed:
            // Without the start form there is no session; without the other ones there is nothing to keep.
            if (screens_.form().id != "note") quit_ = true;
            break;
    }
}

void Theatre::obey_all() {
    while (const auto command = screens_.take()) obey(*command);
}

void Theatre::lay_out() {
    // A window that is put away has no size.
    const view::ivec2 pixels = glm::max(display_.framebuffer_size(), view::ivec2(1));
    screens_.set_layout({.framebuffer = pixels,
                         .user_scale = screens_.settings().ui_scale,
                         .per_window_unit = double(pixels.y) / std::max(display_.size().y, 1)});
}

void Theatre::tick() {
    seconds_ += game::tick_seconds;
    if (library_.update()) levels_are_there();
    lay_out();
    screens_.tick(game::tick_seconds);
    obey_all();
    follow_window();
    if (!screens_.is_playing() && screens_.top() == ScreenId::getting_ready) take_prepared();
    if (std::string notice = speaker_.take_notice(); !notice.empty() && !options_.headless) note(notice);
    show_notices();
    go_on_by_itself();
    const bool plays = run_ != nullptr && screens_.is_playing();
    speaker_.pause(run_ != nullptr && !screens_.is_playing());
    if (!options_.headless && display_.is_pointer_captured() != plays) display_.capture_pointer(plays);
    if (plays) tick_run();
}

const game::Beat* Theatre::beat() const {
    if (options_.beat <= 0 || !run_) return nullptr;
    const auto& beats = run_->game().level().beats;
    return std::size_t(options_.beat) <= beats.size() ? &beats[std::size_t(options_.beat) - 1] : nullptr;
}

view::Camera Theatre::camera(double blend) const {
    if (const game::Beat* const seen = beat()) return looking(seen->eye, seen->look, camera_settings_.field_of_view);
    if (run_) return run_->camera_at(screens_.is_playing() ? blend : 1);
    if (!backdrop_) return {};
    // Slowly about where the hero waits.
    const double angle = seconds_ * 0.12;
    const dvec3 middle = backdrop_->game().hero().body.position;
    const dvec3 eye = middle + dvec3{9 * std::sin(angle), 4.5, 9 * std::cos(angle)};
    // The hero stands beside the menu and not behind it.
    const view::dvec2 window(display_.size());
    const double half = 9 * std::tan(camera_settings_.field_of_view / 2) * window.x / std::max(window.y, 1.0);
    const dvec3 right{std::cos(angle), 0, -std::sin(angle)};
    return looking(eye, middle + dvec3{0, 0.8, 0} - right * (0.5 * half), camera_settings_.field_of_view);
}

void Theatre::draw(double blend) {
    seen_ = camera(blend);
    const double share = screens_.is_playing() ? blend : 1;
    if (run_)
        run_->draw(renderer_, share, shows_volume_);
    else if (backdrop_)
        backdrop_->draw(renderer_, share, false);
}

void Theatre::draw_over(unsigned framebuffer) {
    if (beat() != nullptr) return;
    letters_.next_frame();
    canvas_.begin(screens_.layout());
    const GameSettings& settings = screens_.settings();
    if (run_ && screens_.is_playing()) {
        HudView hud = hud_of(*run_, screens_, seen_, display_.size());
        hud.mark = mark_;
        if (hud.prompt.empty() && hint_left_ > 0)
            hud.prompt = prompt_parts(hint_, screens_.settings().bindings, screens_.device());
        draw_hud(canvas_, hud, plan_ ? &*plan_ : nullptr,
                 {.colours = settings.colours,
                  .reduced_motion = settings.reduced_motion,
                  .timer = settings.timer,
                  .minimap = settings.minimap});
    }
    if (!screens_.is_playing()) draw_screens(canvas_, screens_, seconds_);
    ortho_.draw(canvas_, framebuffer);
}

std::vector<std::string> Theatre::take_notices() {
    return std::exchange(notices_, {});
}

}  // namespace surefoot::platformer
