// Memory and objects are two things: take the one, then make the other in it. Explained in docs/memory.md.
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <string>

#include "check.hpp"

namespace {

int doors_alive = 0;

// [door]
struct Door {
    std::string material;
    double open = 0;

    explicit Door(std::string made_of) : material(std::move(made_of)) { ++doors_alive; }
    Door(const Door&) = delete;
    Door& operator=(const Door&) = delete;
    ~Door() { --doors_alive; }
};
// [/door]

void one_door() {
    // [one]
    alignas(Door) std::byte room[sizeof(Door)];  // memory, and no door: no constructor has run

    Door* door = ::new (static_cast<void*>(room)) Door("oak");  // a door is born, in memory that was there
    door->open = 0.5;

    door->~Door();  // the door dies: its string gives back what it held. The memory stays, and is ours again

    door = ::new (static_cast<void*>(room)) Door("steel");  // so another door can live at the same address
    // [/one]
    check(static_cast<void*>(door) == static_cast<void*>(room), "placement new builds at the address it is given");
    check(door->material == "steel" && door->open == 0, "the second tenant finds nothing of the first");
    check(doors_alive == 1, "one door is alive: the first was destroyed by hand");
    door->~Door();
    check(doors_alive == 0, "after the last destructor no door is alive");
}

void a_row_of_doors() {
    // [row]
    constexpr std::size_t room_for = 8;
    void* const memory = ::operator new (room_for * sizeof(Door), std::align_val_t{alignof(Door)});
    Door* const doors = static_cast<Door*>(memory);  // where doors may come to stand

    std::size_t count = 0;
    for (const char* wood : {"oak", "ash", "elm"}) std::construct_at(doors + count++, wood);

    std::destroy_n(doors, count);  // exactly as many as were made
    ::operator delete (memory, std::align_val_t{alignof(Door)});
    // [/row]
    check(count == 3 && doors_alive == 0, "three doors were made in room for eight, and three were destroyed");
}

void alignment() {
    // [aligned]
    const auto is_aligned = [](const void* address, std::size_t alignment) {
        return reinterpret_cast<std::uintptr_t>(address) % alignment == 0;
    };

    std::array<std::byte, 3 * sizeof(Door)> buffer{};  // aligned for bytes: that is, not at all
    void* place = buffer.data() + 1;
    std::size_t space = buffer.size() - 1;
    place = std::align(alignof(Door), sizeof(Door), place, space);  // the next good address, or null if none fits
    // [/aligned]
    check(place != nullptr && is_aligned(place, alignof(Door)), "std::align finds the next address that is fit");
    check(space >= sizeof(Door), "and says how much room is left from there");
    Door* const door = ::new (place) Door("glass");
    door->~Door();
}

}  // namespace

int main() {
    one_door();
    a_row_of_doors();
    alignment();
}
