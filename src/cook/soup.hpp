// A level on its way through the kitchen.
#pragma once

#include <algorithm>
#include <cstdint>
#include <thread>
#include <vector>

#include <surefoot/math.hpp>

#include "ieee_guard.hpp"
#include "vec.hpp"

namespace surefoot::internal {

struct Soup {
    std::vector<Vec> vertices;
    std::vector<std::uint32_t> indices;  ///< three a triangle; corners at one place have one index

    [[nodiscard]] std::uint32_t triangle_count() const noexcept {
        return static_cast<std::uint32_t>(indices.size() / 3);
    }
    [[nodiscard]] const Vec& corner(std::uint32_t side) const noexcept { return vertices[indices[side]]; }
};

/// The sides of a triangle follow each other: see EdgeMatches.
constexpr std::uint32_t next_side(std::uint32_t side) noexcept {
    return side % 3 == 2 ? side - 2 : side + 1;
}

/// Calls work(part, begin, end) for consecutive parts of [0, count), each on a thread of its own.
template <typename Work>
void in_parts(std::size_t count, int threads, const Work& work) {
    const auto parts = static_cast<std::size_t>(threads);
    std::vector<std::thread> others;
    for (std::size_t part = 1; part < parts; ++part)
        others.emplace_back([&, part] {
            const IeeeGuard guard;
            work(part, count * part / parts, count * (part + 1) / parts);
        });
    work(std::size_t{0}, std::size_t{0}, count / parts);
    for (std::thread& other : others) other.join();
}

}  // namespace surefoot::internal
