#include "playground/platformer_room.hpp"

#include <array>
#include <cstdlib>
#include <filesystem>

#include "platformer/play/pilot.hpp"
#include "platformer/play/theatre.hpp"

namespace surefoot::playground {
namespace {

namespace fs = std::filesystem;

constexpr double tick = 1.0 / 60;

// The levels that came with the program: named by the environment, beside the program, or where it was built.
std::string own_levels() {
    if (const char* const named = std::getenv("SUREFOOT_PLATFORMER_LEVELS"); named != nullptr && *named != '\0')
        return named;
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
        if (stage.bot) options.pilot = platformer::bot_pilot();
        options.level_folders.insert(options.level_folders.begin(), own_levels());
        if (!stage.level.empty()) {
            const fs::path level(stage.level);
            const bool is_recording = level.extension() == ".run";
            if (is_recording) options.watch = stage.level;
            if (!is_recording) options.level = level.stem().string();
            if (!is_recording && level.has_parent_path()) options.level_folders.push_back(level.parent_path().string());
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
        for (const std::string& notice : theatre_->take_notices()) stage_->toasts.warn(notice);
        return true;
    }

    [[nodiscard]] view::Camera camera() const override { return theatre_->camera(stage_->waiting / tick); }
    void draw(view::Renderer&) override { theatre_->draw(stage_->waiting / tick); }
    void draw_over(unsigned framebuffer) override { theatre_->draw_over(framebuffer); }
    void ui() override {}
    /// Sections of the level by name, and "won" and "lost".
    [[nodiscard]] bool has_come_to(std::string_view moment) const override {
        const platformer::Run* const run = theatre_->run();
        if (run == nullptr) return false;
        const game::Game& game = run->game();
        if (moment == "won") return game.outcome() == game::Outcome::won;
        if (moment == "lost") return game.outcome() == game::Outcome::lost;
        return game.level().checkpoints[game.checkpoint()].section == moment;
    }
    [[nodiscard]] double lower_edge() const override { return theatre_->lower_edge(); }
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
