// Every query of a mesh is: which triangles may matter, the exact answer of each, and one of many. Only the first part
// knows the tree, and may take it wider than need be.
#include <algorithm>

#include <surefoot/mesh.hpp>
#include <surefoot/ray.hpp>

#include "ieee_guard.hpp"
#include "kernels/mesh_search.hpp"
#include "limits.hpp"
#include "mesh/asker.hpp"
#include "mesh/data.hpp"
#include "query/answers.hpp"
#include "query/reach.hpp"
#include "sweep/sweep.hpp"
#include "tree/scalar_search.hpp"

namespace surefoot {
inline namespace v0 {

using namespace internal;

namespace {

struct FirstRay {
    const MeshView& view;
    const Motion& motion;
    const QueryOptions& options;
    FirstHit first{};

    void ask(const LeafBlock& block, std::uint32_t slot, std::uint32_t id) noexcept {
        auto hit = surefoot::ray(motion, view.triangle(block, slot), {.one_sided = options.one_sided});
        if (hit) hit->triangle = id;
        first.offer(hit);
    }
    [[nodiscard]] double limit() const noexcept { return first.limit(); }
};

// Any hit will do: the first one found ends the search.
template <typename First>
struct Any {
    First query;

    void ask(const LeafBlock& block, std::uint32_t slot, std::uint32_t id) noexcept {
        if (!query.first.get()) query.ask(block, slot, id);
    }
    [[nodiscard]] double limit() const noexcept { return query.first.get() ? -1 : 1; }
};

template <typename Query>
bool ask_moving(const MeshView& view, MeshSearch search, bool in_one_go, const QueryOptions& options,
                Query& query) noexcept {
    Asker<Query> asker(view, options, query);
    switch (options.search) {
        case Search::brute_force:
            asker.ask_all();
            return true;
        case Search::scalar_tree:
            return asker.ask_measured(BoxSweep(search.motion, search.extent));
        case Search::tree:
            break;
    }
    return asker.ask_found(search, in_one_go ? search_region : search_along);
}

template <typename Query>
bool ask_sweep(const MeshView& view, const Volume& volume, const Motion& motion, const QueryOptions& options,
               Query& query) noexcept {
    const Box3 extent = extent_of(volume, magnitude_in(view, motion));
    return ask_moving(view, make_search(view, volume, motion, extent), is_short(motion, extent), options, query);
}

template <typename Query>
bool ask_ray(const MeshView& view, const Motion& motion, const QueryOptions& options, Query& query) noexcept {
    const Box3 extent = extent_of_point(magnitude_in(view, motion));
    return ask_moving(view, make_point_search(view, motion, extent), false, options, query);
}

}  // namespace

std::optional<Hit> Mesh::sweep(const Volume& volume, const Motion& motion, const QueryOptions& options) const noexcept {
    const IeeeGuard guard;
    if (!is_valid_query(volume, motion)) return blocked(HitStatus::invalid);
    FirstSweep query{data_->view, volume, motion, options};
    if (!ask_sweep(data_->view, volume, motion, options, query)) return blocked(HitStatus::overflow);
    return with_surface(data_->view, query.first);
}

bool Mesh::sweep_any(const Volume& volume, const Motion& motion, const QueryOptions& options) const noexcept {
    const IeeeGuard guard;
    if (!is_valid_query(volume, motion)) return true;
    Any<FirstSweep> query{{data_->view, volume, motion, options}};
    return !ask_sweep(data_->view, volume, motion, options, query) || query.query.first.get().has_value();
}

std::optional<Hit> Mesh::ray(const Motion& motion, const QueryOptions& options) const noexcept {
    const IeeeGuard guard;
    if (!is_valid_point(motion.from) || !is_valid_point(motion.to)) return blocked(HitStatus::invalid);
    FirstRay query{data_->view, motion, options};
    if (!ask_ray(data_->view, motion, options, query)) return blocked(HitStatus::overflow);
    return with_surface(data_->view, query.first);
}

bool Mesh::ray_any(const Motion& motion, const QueryOptions& options) const noexcept {
    const IeeeGuard guard;
    if (!is_valid_point(motion.from) || !is_valid_point(motion.to)) return true;
    Any<FirstRay> query{{data_->view, motion, options}};
    return !ask_ray(data_->view, motion, options, query) || query.query.first.get().has_value();
}

std::size_t Mesh::overlap(const Volume& volume, const dvec3& position, std::span<Overlap> found,
                          const QueryOptions& options) const noexcept {
    const IeeeGuard guard;
    const auto block = [&](HitStatus status) {
        if (!found.empty()) {
            found[0] = Overlap{};
            found[0].status = status;
        }
        return std::size_t{1};
    };
    const Motion standing{position, position};
    if (!is_valid_query(volume, standing)) return block(HitStatus::invalid);
    struct AllOverlaps {
        const MeshView& view;
        const Volume& volume;
        const dvec3& position;
        bool one_sided;
        OverlapsInOrder overlaps;

        void ask(const LeafBlock& leaf, std::uint32_t slot, std::uint32_t id) noexcept {
            auto overlap = surefoot::overlap(volume, position, view.triangle(leaf, slot), {.one_sided = one_sided});
            if (!overlap) return;
            overlap->triangle = id;
            overlap->surface = view.surface(id);
            overlaps.add(*overlap);
        }
        [[nodiscard]] static double limit() noexcept { return 1; }
    } query{data_->view, volume, position, options.one_sided, OverlapsInOrder(found)};
    const Box3 extent = extent_of(volume, magnitude_in(data_->view, standing));
    if (!ask_moving(data_->view, make_search(data_->view, volume, standing, extent), true, options, query)) {
        return block(HitStatus::overflow);
    }
    return query.overlaps.count();
}

std::optional<NearestPoint> Mesh::nearest(const dvec3& point, double farthest,
                                          const QueryOptions& options) const noexcept {
    const IeeeGuard guard;
    if (!is_valid_point(point) || !(farthest >= 0)) return NearestPoint{.point = {}, .status = HitStatus::invalid};
    struct Nearest {
        const MeshView& view;
        NearestOfAll nearest;
        double margin;

        void ask(const LeafBlock& block, std::uint32_t slot, std::uint32_t) noexcept {
            nearest.offer(view.source_triangle(block, slot));
        }
        [[nodiscard]] double limit() const noexcept { return nearest.limit() + margin; }
    } query{data_->view, NearestOfAll(point, farthest),
            extent_of_point(larger(largest(to_vec(point)), internal::magnitude_of(data_->view.bounds))).max.x};
    Asker<Nearest> asker(data_->view, options, query);
    if (options.search == Search::brute_force) {
        asker.ask_all();
    } else if (!asker.ask_measured(BoxDistance(point))) {
        return NearestPoint{.point = {}, .status = HitStatus::overflow};
    }
    return query.nearest.get();
}

std::size_t Mesh::gather(const Bounds& near, std::span<SourceTriangle> found,
                         const QueryOptions& options) const noexcept {
    const IeeeGuard guard;
    struct Gathered {
        const MeshView& view;
        Box3 box;
        std::span<SourceTriangle> found;
        std::size_t count = 0;

        [[nodiscard]] static constexpr bool wants_all() noexcept { return true; }

        void ask(const LeafBlock& block, std::uint32_t slot, std::uint32_t) noexcept {
            const SourceTriangle triangle = view.source_triangle(block, slot);
            if (!box.meets(box_of(triangle.triangle))) return;
            if (count < found.size()) found[count] = triangle;
            ++count;
        }
        [[nodiscard]] static double limit() noexcept { return 1; }
    } query{data_->view, {to_vec(near.min), to_vec(near.max)}, found};
    MeshSearch search;
    search.view = &data_->view;
    search.region = query.box;
    search.extent = query.box;  // about the world's origin, where a motion of nothing stands
    Asker<Gathered> asker(data_->view, options, query);
    if (options.search == Search::brute_force) {
        asker.ask_all();
    } else if (options.search == Search::scalar_tree) {
        asker.ask_measured(BoxSweep(search.motion, search.extent));
    } else {
        asker.ask_found(search, search_boxes);
    }
    sort_gathered(found.first(std::min(query.count, found.size())));
    return query.count;
}

}  // namespace v0
}  // namespace surefoot
