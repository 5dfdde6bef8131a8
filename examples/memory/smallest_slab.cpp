// The smallest slab that works: the idea of surefoot::Slab without its growth, its iteration and its care for
// constructors that call back. Explained in docs/memory.md.
#include <cstddef>
#include <cstdint>
#include <new>
#include <string>
#include <utility>

#include <surefoot/slab.hpp>

#include "check.hpp"

namespace {

// [smallest]
struct SmallHandle {
    std::uint32_t index = 0;
    std::uint32_t generation = 0;
};

template <typename T, std::uint32_t room_for>
class SmallestSlab {
public:
    SmallestSlab() = default;
    SmallestSlab(const SmallestSlab&) = delete;
    SmallestSlab& operator=(const SmallestSlab&) = delete;
    ~SmallestSlab() {
        for (Slot& slot : slots_)
            if (slot.generation % 2 == 1) object(slot)->~T();
    }

    template <typename... Arguments>
    SmallHandle insert(Arguments&&... arguments) {
        std::uint32_t index = free_;  // the slot freed last, else the next one never used
        if (index != none) {
            free_ = slots_[index].next_free;
        } else if (used_ < room_for) {
            index = used_++;
        } else {
            return {};
        }
        ::new (static_cast<void*>(slots_[index].room)) T(std::forward<Arguments>(arguments)...);
        return {index, ++slots_[index].generation};  // odd: taken
    }

    T* get(SmallHandle handle) {
        const bool alive = handle.generation % 2 == 1 && slots_[handle.index].generation == handle.generation;
        return alive ? object(slots_[handle.index]) : nullptr;
    }

    void erase(SmallHandle handle) {
        Slot& slot = slots_[handle.index];
        ++slot.generation;  // even: empty. Every handle to this tenant is dead from here on
        object(slot)->~T();
        slot.next_free = std::exchange(free_, handle.index);
    }

private:
    static constexpr std::uint32_t none = room_for;
    struct Slot {
        alignas(T) std::byte room[sizeof(T)];
        std::uint32_t generation = 0;
        std::uint32_t next_free = none;
    };

    static T* object(Slot& slot) { return std::launder(reinterpret_cast<T*>(slot.room)); }

    Slot slots_[room_for];
    std::uint32_t used_ = 0;
    std::uint32_t free_ = none;
};
// [/smallest]

void the_smallest() {
    SmallestSlab<std::string, 2> slab;
    const SmallHandle first = slab.insert("first");
    const SmallHandle second = slab.insert("second");
    check(*slab.get(first) == "first" && *slab.get(second) == "second", "each handle finds its own object");
    check(slab.insert("third").generation == 0, "a full slab gives the handle of nothing");
    slab.erase(first);
    check(slab.get(first) == nullptr, "the handle of a dead object gives null");
    const SmallHandle third = slab.insert("third");
    check(third.index == first.index, "the slot has a new tenant");
    check(slab.get(first) == nullptr && *slab.get(third) == "third", "which the old handle does not find");
}

void the_real_one() {
    // [real]
    surefoot::Slab<std::string> names(2);  // room for two, taken now
    const auto hero = names.insert("hero");
    const auto crate = names.insert("crate");

    if (!names.insert("lift")) {  // full: it says so and does not grow behind your back
        (void)names.reserve(3);   // growing is asked for; no object moves
    }
    const auto lift = names.insert("lift");

    names.erase(crate);
    const std::string* gone = names.get(crate);  // null, now and for ever

    for (const std::string& name : names) std::puts(name.c_str());  // hero, lift: always in slot order
    // [/real]
    check(gone == nullptr && names.size() == 2 && names[hero] == "hero" && names[lift] == "lift",
          "surefoot::Slab does the same, grows when asked and never moves an object");
}

}  // namespace

int main() {
    the_smallest();
    the_real_one();
}
