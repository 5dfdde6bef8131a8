#include "tiles.hpp"

#include <atomic>
#include <mutex>
#include <new>
#include <optional>

#include "threads.hpp"

namespace surefoot::navigation {
namespace {

Expected<TileMesh> one_tile(const World& world, const CharacterSettings& settings, const NavigationOptions& options,
                            const Plan& plan, int x, int z) {
    try {
        return build_tile(ground_of_tile(world, settings, options, plan, x, z), options.regions, plan, x, z);
    } catch (const std::bad_alloc&) {
        return tl::unexpected(Error{.code = ErrorCode::out_of_memory, .text = "navigation: out of memory", .file = {}});
    }
}

}  // namespace

Expected<std::vector<TileMesh>> build_tiles(const World& world, const CharacterSettings& settings,
                                            const NavigationOptions& options, const Plan& plan,
                                            std::span<const std::pair<int, int>> places) {
    std::vector<std::optional<Expected<TileMesh>>> built(places.size());
    std::atomic<std::size_t> next = 0;
    std::atomic<bool> failed = false;
    std::mutex telling;
    std::size_t done = 0;
    const auto work = [&] {
        for (std::size_t i = next++; i < places.size() && !failed; i = next++) {
            built[i] = one_tile(world, settings, options, plan, places[i].first, places[i].second);
            if (!built[i]->has_value()) failed = true;
            const std::lock_guard lock(telling);
            options.progress(++done, places.size());
        }
    };
    on_threads(options.threads, places.size(), work);

    std::vector<TileMesh> tiles;
    for (std::optional<Expected<TileMesh>>& tile : built) {
        if (tile && !tile->has_value()) return tl::unexpected(tile->error());
    }
    for (std::optional<Expected<TileMesh>>& tile : built) tiles.push_back(*std::move(*tile));
    return tiles;
}

}  // namespace surefoot::navigation
