#include <fmt/format.h>
#include <imgui.h>

#include "playground/debugger_room/panels_lessons.hpp"
#include "playground/debugger_room/voxel_play.hpp"
#include "playground/debugger_room/voxel_view.hpp"
#include "view/widgets.hpp"

namespace surefoot::playground {

namespace {

namespace ui = view::ui;

class VoxelsPanel final : public Panel {
public:
    [[nodiscard]] std::string_view name() const override { return "Voxels"; }
    void changed(const Inquiry& /*inquiry*/) override {}
    bool update(double dt, Inquiry& /*inquiry*/) override { return play_.update(dt); }
    void draw(view::Renderer& renderer, const Inquiry& /*inquiry*/) override { look_.draw(renderer, play_); }
    void ui(Inquiry& inquiry) override;
    [[nodiscard]] bool has_own_scene() const override { return true; }
    [[nodiscard]] std::vector<dvec3> scene_places() const override { return VoxelView::places(play_); }

private:
    void told(const char* title, const VoxelTale& tale) const;

    VoxelPlay play_;
    VoxelView look_;
};

void VoxelsPanel::told(const char* title, const VoxelTale& tale) const {
    ui::heading(title);
    if (const debugger::VoxelStep* const step = play_.step(tale)) {
        ui::wrapped(step->text);
    } else {
        ui::wrapped("Stands at START.");
    }
    if (play_.at_end()) ui::note(tale.conclusion);
}

void VoxelsPanel::ui(Inquiry& /*inquiry*/) {
    const auto stories = voxel_stories();
    for (std::size_t i = 0; i < stories.size(); ++i)
        if (ui::radio(stories[i].name, play_.chosen() == i)) play_.choose(i);
    ui::note(play_.story().about);
    if (ui::primary_button("Next")) play_.next();
    ImGui::SameLine();
    if (ui::button("Back")) play_.back();
    ImGui::SameLine();
    if (ui::button(play_.plays() ? "Pause" : "Play")) {
        if (play_.plays()) {
            play_.pause();
        } else {
            play_.play();
        }
    }
    ImGui::SameLine();
    if (ui::button("Restart")) play_.restart();
    std::string where = fmt::format("step {} of {}", play_.taken(), play_.count());
    if (play_.story().moves > 1 && play_.taken() > 0)
        where += fmt::format(", move {} of {}", play_.wrong().move_of[static_cast<std::size_t>(play_.taken() - 1)] + 1,
                             play_.story().moves);
    ui::note(where);
    told("Wrong", play_.wrong());
    told("Right", play_.right());
    ImGui::Separator();
    ui::key_colour(voxel_paint::looked_at, "cells that were looked at");
    ui::key_colour(voxel_paint::stopper, "the block that stopped it");
    ui::key_colour(voxel_paint::trap, "a block that it stands in");
    for (int axis = 0; axis < 3; ++axis) {
        if (axis > 0) ImGui::SameLine();
        ui::key_colour(colour_of_axis(axis), fmt::format("along {}", "xyz"[axis]));
    }
}

}  // namespace

std::unique_ptr<Panel> make_voxels_panel() {
    return std::make_unique<VoxelsPanel>();
}

}  // namespace surefoot::playground
