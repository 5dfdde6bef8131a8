// A new panel is a line here.
#include "playground/debugger_room/panels.hpp"

#include "playground/debugger_room/panels_lessons.hpp"
#include "playground/debugger_room/panels_maths.hpp"

namespace surefoot::playground {

std::vector<std::unique_ptr<Panel>> make_panels() {
    std::vector<std::unique_ptr<Panel>> panels;
    panels.push_back(make_mathematics_panel());
    panels.push_back(make_strategies_panel());
    panels.push_back(make_search_panel());
    panels.push_back(make_step_panel());
    panels.push_back(make_side_by_side_panel());
    panels.push_back(make_voxels_panel());
    return panels;
}

}  // namespace surefoot::playground
