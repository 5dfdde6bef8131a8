#include "playground/platformer_room.hpp"

#include <array>
#include <cstdlib>
#include <filesystem>
#include <fmt/format.h>

#include "platformer/play/pilot.hpp"
#include "platformer/play/theatre.hpp"

namespace surefoot::playground {
namespace {

namespace fs = std::filesystem;

constexpr double tick = 1.0 / 60;

// The levels that came with the program: named by the environment, where the program was installed, or where it was
// built.
std::string own_levels() {
    if (const char* const named = std::getenv("SUREFOOT_PLATFORMER_LEVELS"); named != nullptr && *named != '\0')
        return named;
    std::error_code error;
    const fs::path here = fs::read_symlink("/proc/self/exe", error).parent_path();
    const fs::path installed = here / SUREFOOT_BIN_TO_LEVELS;
    if (!error && fs::is_directory(installed, error)) return installed.lexically_normal().string();
    return SUREFOOT_OWN_LEVELS;
}

class PlatformerRoom final : public Room {
public:
    void enter(Stage& stage) override {
        stage_ = &stage;
        platformer::TheatreOptions options =
            stage.headless ? platformer::TheatreOptions{} : platformer::usual_theatre();
        options.headless = stage.headless;
        options.background = !stage.headless;
        options.beat = stage.beat;
        options.session = stage.session;
        options.remark = stage.remark;
        if (stage.is_only_room && !stage.settings_file.empty())
            options.settings = fs::absolute(stage.settings_file).string();
        options.keeps_window = stage.is_only_room && !stage.has_size && !stage.headless;
        if (stage.bot) options.pilot = platformer::bot_pilot();
        options.pilot_goes_on = !stage.headless;  // where a script looks, what is won stays in sight
        options.level_folders.insert(options.level_folders.begin(), own_levels());
        if (!stage.level.empty()) {
            const fs::path level(stage.level);
            const bool is_recording = level.extension() == ".run";
            if (is_recording) options.watch = stage.level;
            options.watch_from = stage.watch_from;
            if (!is_recording) options.level = level.stem().string();
            // A name without an ending is one of the levels that are there.
            if (!is_recording && level.has_extension()) options.level_file = fs::absolute(level).string();
        }
        theatre_ = std::make_unique<platformer::Theatre>(stage.display, stage.renderer, std::move(options));
        sky_ = stage.renderer.sky;
    }

    void leave() override {
        stage_->renderer.sky = sky_;
        if (!stage_->headless && stage_->display.is_pointer_captured()) stage_->display.capture_pointer(false);
        theatre_.reset();
    }

    bool event(const view::InputEvent& event) override { return theatre_->event(event); }

    bool update(double) override {
        theatre_->tick();
        for (const std::string& notice : theatre_->take_notices())
            fmt::print(stderr, "{}: {}\n", stage_->program, notice);
        return true;
    }

    [[nodiscard]] view::Camera camera() const override { return theatre_->camera(stage_->waiting / tick); }
    void draw(view::Renderer&) override { theatre_->draw(stage_->waiting / tick); }
    void draw_over(unsigned framebuffer) override { theatre_->draw_over(framebuffer); }
    void ui() override {}
    [[nodiscard]] std::optional<view::dvec2> place_of(std::string_view label) const override {
        return theatre_->place_of(label);
    }
    [[nodiscard]] std::vector<std::string> labels() const override { return theatre_->labels(); }
    [[nodiscard]] std::string failure() const override { return theatre_->failure(); }
    [[nodiscard]] Expected<void> keep() override { return theatre_->keep(); }
    /// Sections of the level by name, and "won" and "lost".
    [[nodiscard]] bool has_come_to(std::string_view moment) const override {
        const platformer::Run* const run = theatre_->run();
        if (run == nullptr) return false;
        const game::Game& game = run->game();
        if (moment == "won") return game.outcome() == game::Outcome::won;
        if (moment == "lost") return game.outcome() == game::Outcome::lost;
        return game.level().checkpoints[game.checkpoint()].section == moment;
    }
    [[nodiscard]] bool wants_quit() const override { return theatre_->wants_quit(); }

private:
    Stage* stage_ = nullptr;
    view::Sky sky_{};
    std::unique_ptr<platformer::Theatre> theatre_;
};

}  // namespace

std::unique_ptr<Room> make_platformer() {
    return std::make_unique<PlatformerRoom>();
}

}  // namespace surefoot::playground
