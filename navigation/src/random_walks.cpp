#include "random_walks.hpp"

#include <atomic>
#include <mutex>

#include "threads.hpp"

namespace surefoot::navigation {

std::vector<RandomWalk> random_walks(const World& world, const CharacterSettings& settings, const NavigationMesh& mesh,
                                     const WalkOptions& options, int threads, std::size_t count, std::uint64_t seed,
                                     const NavigationProgress& progress) {
    constexpr std::size_t most_nodes = 16384;
    std::vector<RandomWalk> walks(count);
    {
        const NavigationQuery query(mesh, most_nodes, NavigationDoors::open);
        for (RandomWalk& walk : walks) {
            const auto from = query.random(seed++);
            const auto to = query.random(seed++);
            if (!from || !to) return {};
            walk.from = *from;
            walk.to = *to;
        }
    }
    std::atomic<std::size_t> next = 0;
    std::mutex telling;
    std::size_t done = 0;
    const auto work = [&] {
        const NavigationQuery query(mesh, most_nodes, NavigationDoors::open);
        for (std::size_t i = next++; i < walks.size(); i = next++) {
            walks[i].report = walk_path(world, settings, query, walks[i].from.position, walks[i].to.position, options);
            const std::lock_guard lock(telling);
            progress(++done, walks.size());
        }
    };
    on_threads(threads, walks.size(), work);
    return walks;
}

}  // namespace surefoot::navigation
