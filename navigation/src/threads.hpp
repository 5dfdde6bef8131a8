// The same work on several threads at once.
#pragma once

#include <cstddef>
#include <thread>
#include <vector>

namespace surefoot::navigation {

/// Calls `work()` on so many threads, this one among them, but on no more than there are `pieces` of work, and comes
/// back when every call has: what they write is whole then.
template <typename Work>
void on_threads(int threads, std::size_t pieces, const Work& work) {
    std::vector<std::jthread> helpers;
    for (int i = 1; i < threads && static_cast<std::size_t>(i) < pieces; ++i) helpers.emplace_back([&work] { work(); });
    work();
}

}  // namespace surefoot::navigation
