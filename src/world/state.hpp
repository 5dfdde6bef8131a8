// What a world holds, and the way from a query to the bodies that it may meet.
#pragma once

#include <vector>

#include <surefoot/world.hpp>

#include "world/body.hpp"
#include "world/top_tree.hpp"

namespace surefoot {
inline namespace v0 {

struct [[gnu::visibility("hidden")]] World::State {
    Slab<internal::WorldBody> bodies;
    internal::TopTree tree;
    std::vector<internal::WorldBody*> by_id;  // in the order of their numbers

    /// Where the body with this number is in `by_id`, or would be.
    [[nodiscard]] std::size_t place_of(std::uint32_t id) const noexcept;
    [[nodiscard]] internal::WorldBody* with_id(std::uint32_t id) const noexcept;
    /// The lowest number that no body has.
    [[nodiscard]] std::uint32_t free_id() const noexcept;
    void place(internal::WorldBody & body, const Pose& start, const Pose& end) noexcept;
    template <typename Source>
    Expected<BodyHandle> add(const Source& source, Placement placement);

    /// Calls `ask(body, key)` for the bodies of the query whose `key(box)` is at most `limit()`, or, by brute force,
    /// for all of the query's bodies.
    template <typename Key, typename Limit, typename Ask>
    void visit(const WorldQuery& query, const Key& key, const Limit& limit, const Ask& ask) const noexcept {
        const auto ask_if_meant = [&](const internal::WorldBody& body) {
            if ((body.layers & query.layers) == 0 || !query.bodies(body.id)) return;
            ask(body, key(body.box()));
        };
        if (query.search == Search::brute_force) {
            for (const internal::WorldBody* body : by_id) ask_if_meant(*body);
        } else {
            tree.visit(key, limit, ask_if_meant, [&] {
                if (query.work != nullptr) ++query.work->nodes;
            });
        }
    }
};

}  // namespace v0
}  // namespace surefoot
