/// Work on the rows of a picture, or on anything else that has a number, with every processor there is.
#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <thread>
#include <vector>

namespace surefoot::tools {

/// Calls `work(row)` once for each row, from several threads; `progress(rows done)` from the calling thread now and
/// then. What `work` writes must belong to its row alone, so that the result does not depend on the threads.
template <typename Work, typename Progress>
void for_each_row(int rows, const Work& work, const Progress& progress) {
    std::atomic<int> next{0};
    std::atomic<int> done{0};
    const auto run = [&] {
        for (int row = next++; row < rows; row = next++) {
            work(row);
            ++done;
        }
    };
    std::vector<std::jthread> threads;
    for (unsigned i = 0; i < std::max(1U, std::thread::hardware_concurrency()); ++i) threads.emplace_back(run);
    while (done < rows) {
        progress(done.load());
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
}

}  // namespace surefoot::tools
