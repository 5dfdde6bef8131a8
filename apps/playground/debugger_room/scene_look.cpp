// Which parts of the scene are shown.
#include <imgui.h>

#include "playground/debugger_room/scene.hpp"
#include "view/widgets.hpp"

namespace surefoot::playground {

void look_ui(SceneLook& look) {
    namespace ui = view::ui;
    if (!ui::section("Show", false)) return;
    const auto pair = [](const char* first, bool& a, const char* second, bool& b) {
        ui::checkbox(first, a);
        ImGui::SameLine(ImGui::GetFontSize() * 8);
        ui::checkbox(second, b);
    };
    pair("Show START", look.start, "Show END", look.end);
    pair("Show HIT", look.hit, "Show RESULT", look.result);
    pair("Contact", look.contact, "Ways", look.ways);
    ui::checkbox("Labels", look.labels);
}

}  // namespace surefoot::playground
