// What the tests of Slab<T> put into it.
#pragma once

#include <vector>

#include <surefoot/slab.hpp>

namespace slab_things {

using surefoot::Slab;

// Counts every birth and death, and knows its own address, so that a move behind our back is seen.
class Counted {
public:
    static inline int born = 0;
    static inline int died = 0;
    static inline int moved = 0;
    static inline std::vector<int> order_of_death;

    static void reset() {
        born = died = moved = 0;
        order_of_death.clear();
    }

    explicit Counted(int value = 0) : value_(value), self_(this) { ++born; }
    Counted(const Counted&) = delete;
    Counted& operator=(const Counted&) = delete;
    ~Counted() {
        ++died;
        if (self_ != this) ++moved;
        order_of_death.push_back(value_);
    }
    [[nodiscard]] int value() const { return value_; }

private:
    int value_;
    const Counted* self_;
};

struct Pair {
    int first;
    double second;
};

// A destructor that takes its children with it.
struct Family {
    Slab<Family>* slab = nullptr;
    Slab<Family>::Handle child{};
    ~Family() {
        if (slab != nullptr && slab->contains(child)) slab->erase(child);
    }
};

// A constructor that makes its own child.
struct Parent {
    Slab<Parent>::Handle child{};
    Parent() = default;
    explicit Parent(Slab<Parent>& slab) : child(slab.insert()) {}
};

struct Thrower {
    explicit Thrower(bool throws) {
        if (throws) throw 1;
    }
};

struct alignas(256) Wide {
    char first = 1;
};

}  // namespace slab_things
