// Which rooms there are. A new one is a line here.
#include <algorithm>
#include <array>

#include "playground/course_room/room.hpp"
#include "playground/debugger_room/room.hpp"
#include "playground/platformer_room.hpp"
#include "playground/room.hpp"
#include "playground/walk/walk.hpp"

namespace surefoot::playground {

std::span<const RoomCard> rooms() {
    static const std::array cards{
        RoomCard{"platformer", "Platformer", "A game to finish: run, jump, dash and climb through its levels.",
                 make_platformer},
        RoomCard{"debugger", "Debugger",
                 "One question, taken by the hand: move START, END or a corner, and see what stops the motion.",
                 make_debugger},
        RoomCard{"walk", "Walk",
                 "Any level: walk through it, ask why you stopped, look at its tree and its faults, measure it.",
                 make_walk},
        RoomCard{"course", "Course", "The movement course: watch any scene, ours beside the ghost of another mover.",
                 make_course}};
    return cards;
}

const RoomCard* find_room(std::string_view id) {
    const auto all = rooms();
    const auto found = std::find_if(all.begin(), all.end(), [&](const RoomCard& card) { return card.id == id; });
    return found == all.end() ? nullptr : &*found;
}

}  // namespace surefoot::playground
