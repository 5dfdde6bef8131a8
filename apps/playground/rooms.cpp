// Which rooms there are. A new one is a line here.
#include <algorithm>
#include <array>

#include "playground/debugger_room/room.hpp"
#include "playground/room.hpp"
#include "playground/walk/walk.hpp"

namespace surefoot::playground {

std::span<const RoomCard> rooms() {
    static const std::array cards{
        RoomCard{"debugger", "Debugger",
                 "One question, taken by the hand: move START, END or a corner, and see what stops the motion.",
                 make_debugger},
        RoomCard{"walk", "Walk",
                 "Any level: look at its tree, its edges and its faults, measure it, throw shapes at it.", make_walk}};
    return cards;
}

const RoomCard* find_room(std::string_view id) {
    const auto all = rooms();
    const auto found = std::find_if(all.begin(), all.end(), [&](const RoomCard& card) { return card.id == id; });
    return found == all.end() ? nullptr : &*found;
}

}  // namespace surefoot::playground
