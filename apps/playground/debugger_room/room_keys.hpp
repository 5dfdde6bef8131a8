/// What F1 tells of the Debugger.
#pragma once

#include "view/help.hpp"

namespace surefoot::playground {

inline constexpr view::KeyHelp room_keys[] = {
    {"Drag START or END", "moves it in the plane that faces you"},
    {"Drag a corner", "moves it, and all corners that are at its place"},
    {"Click one of them", "shows arrows, each along an axis, and handles on its box"},
    {"Drag a handle", "moves in the plane of that face of the box"},
    {"Shift", "snaps to the grid while dragging"},
    {"Drag elsewhere", "turns the camera; right drag moves it, the wheel zooms"},
    {"F", "shows all of it"},
    {"Control+Z", "undo; with Shift redo"},
    {"Control+C  Control+V", "copy and paste of the question as JSON"},
    {"Control+S", "saves this moment"},
    {"Control+O", "opens a level or a saved moment"},
    {"Space", "lets the motion run"},
    {"H", "hides the panels"}};

}  // namespace surefoot::playground
