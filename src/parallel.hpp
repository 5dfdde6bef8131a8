// Work that is shared between threads, which live as long as it takes.
#pragma once

#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

#include "ieee_guard.hpp"

namespace surefoot::internal {

/// Runs `work()` on up to `threads` threads at once, the caller's being one, and waits for all of them.
template <typename Work>
void on_threads(int threads, const Work& work) {
    std::vector<std::thread> others;
    for (int i = 1; i < threads; ++i) {
        others.emplace_back([&work] {
            const IeeeGuard guard;
            work();
        });
    }
    work();
    for (std::thread& other : others) other.join();
}

/// Calls work(i) for every i in [0, count), each once, in any order.
template <typename Work>
void in_parallel(std::size_t count, int threads, const Work& work) {
    std::atomic<std::size_t> next{0};
    const auto most = static_cast<std::size_t>(threads);
    on_threads(static_cast<int>(count < most ? count : most), [&] {
        for (std::size_t i = next++; i < count; i = next++) work(i);
    });
}

/// Calls work(begin, end) for all of [0, count), cut into pieces that do not depend on the threads.
template <typename Work>
void in_pieces(std::size_t count, int threads, const Work& work) {
    constexpr std::size_t piece = 16384;
    in_parallel((count + piece - 1) / piece, threads, [&](std::size_t i) {
        const std::size_t begin = i * piece;
        work(begin, count - begin < piece ? count : begin + piece);
    });
}

}  // namespace surefoot::internal
