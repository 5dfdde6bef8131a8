// The nearest of many, in an order that depends on what they are and not on when they were offered.
#pragma once

#include <cstddef>
#include <span>

#include <surefoot/character_neighbour.hpp>

#include "vec.hpp"

namespace surefoot::internal {

class NearestFirst {
public:
    NearestFirst(const Vec& from, std::span<Neighbour> room) noexcept : from_(from), room_(room) {}

    void offer(const Neighbour& neighbour) noexcept;

    [[nodiscard]] std::span<Neighbour> found() const noexcept {
        return room_.first(count_ < room_.size() ? count_ : room_.size());
    }
    /// How many were offered.
    [[nodiscard]] std::size_t count() const noexcept { return count_; }

private:
    [[nodiscard]] bool is_before(const Neighbour& a, const Neighbour& b) const noexcept;

    Vec from_;
    std::span<Neighbour> room_;
    std::size_t count_ = 0;
};

}  // namespace surefoot::internal
