// Every query of a mesh is: which triangles may matter, the exact answer of each, and one of many. Only the first part
// knows the tree, and may take it wider than need be.
#include <algorithm>

#include <surefoot/mesh.hpp>
#include <surefoot/ray.hpp>

#include "ieee_guard.hpp"
#include "kernels/mesh_search.hpp"
#include "limits.hpp"
#include "mesh/data.hpp"
#include "query/answers.hpp"
#include "query/reach.hpp"
#include "rounded.hpp"
#include "sweep/sweep.hpp"
#include "tree/scalar_search.hpp"

namespace surefoot {
inline namespace v0 {

using namespace internal;

namespace {

// Every coordinate that takes part in a query on a mesh is at most this.
double magnitude_in(const MeshView& view, const Motion& motion) noexcept {
    return larger(internal::magnitude_of(motion), internal::magnitude_of(view.bounds));
}

void count_triangle(QueryWork& work, std::uint32_t id) noexcept {
    ++work.triangles;
    if (work.log != nullptr) work.log->push({.triangle = id, .kind = SearchStep::Kind::triangle});
}

void count_node(QueryWork& work, const WideNode& node, double enters) noexcept {
    ++work.nodes;
    if (work.log == nullptr) return;
    const Box3 box = box_of_node(node);
    work.log->push({.box = {to_dvec3(box.min), to_dvec3(box.max)}, .enters = enters});
}

// Asks triangles one at a time, in whatever order they come. Query has
//     void ask(const LeafBlock&, std::uint32_t slot, std::uint32_t id)    the exact question
//     double limit() const                                                 what begins later cannot matter
template <typename Query>
class Asker {
public:
    Asker(const MeshView& view, const QueryOptions& options, Query& query) noexcept
        : view_(view), options_(options), query_(query) {}

    void ask(const LeafBlock& block, std::uint32_t slot) noexcept {
        const std::uint32_t id = block.ids()[slot];
        if (view_.is_hidden(id)) return;
        if (options_.filter && !options_.filter(id, view_.surface(id))) return;
        if (options_.work != nullptr) count_triangle(*options_.work, id);
        query_.ask(block, slot, id);
    }

    void ask_place(std::uint32_t place) noexcept {
        const LeafBlock block = view_.leaf(place >> 3);
        if ((place & 7) < block.count) ask(block, place & 7);
    }

    void ask_all() noexcept {
        for (const std::uint32_t place : view_.places) ask_place(place);
    }

    // The SIMD search. `run` is one of search_region, search_along, search_boxes.
    bool ask_found(MeshSearch search, void (*run)(MeshSearch&) noexcept) noexcept {
        search.context = this;
        search.take = [](void* context, std::span<Candidate> candidates) noexcept {
            return static_cast<Asker*>(context)->take(candidates);
        };
        run(search);
        if (options_.work != nullptr) options_.work->nodes += search.nodes;
        return !search.overflowed;
    }

    // The scalar search: the same leaves or fewer, one box at a time.
    template <typename Measure>
    bool ask_measured(const Measure& measure) noexcept {
        return search_by(
            view_, measure,
            [&](std::uint32_t word) {
                const LeafBlock block = view_.leaf(word);
                for (std::uint32_t slot = 0; slot < block.count; ++slot) ask(block, slot);
            },
            [&] { return query_.limit(); },
            [&](const WideNode& node, double enters) {
                if (options_.work != nullptr) count_node(*options_.work, node, enters);
            });
    }

private:
    // The earliest first; what could only come after a hit is never asked.
    float take(std::span<Candidate> candidates) noexcept {
        while (!candidates.empty()) {
            const auto next = std::min_element(candidates.begin(), candidates.end(),
                                               [](const Candidate& a, const Candidate& b) { return a.t < b.t; });
            if (static_cast<double>(next->t) > query_.limit()) break;
            ask_place(next->place);
            *next = candidates.back();
            candidates = candidates.first(candidates.size() - 1);
        }
        return float_at_least(query_.limit());
    }

    const MeshView& view_;
    const QueryOptions& options_;
    Query& query_;
};

struct FirstSweep {
    const MeshView& view;
    const Volume& volume;
    const Motion& motion;
    const QueryOptions& options;
    FirstHit first{};

    void ask(const LeafBlock& block, std::uint32_t slot, std::uint32_t id) noexcept {
        const Triangle triangle = view.triangle(block, slot);
        if (!is_valid_triangle(triangle)) {
            Hit hit = blocked(HitStatus::invalid);
            hit.triangle = id;
            first.offer(hit);
            return;
        }
        first.offer(sweep_triangle(volume, motion, triangle, id, options.one_sided,
                                   options.trace == nullptr ? first.limit() : 1, options.trace));
    }
    [[nodiscard]] double limit() const noexcept { return first.limit(); }
};

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

// A motion that is short beside the shape asks everything around it at once; a long one goes along it.
bool is_short(const Motion& motion, const Box3& extent) noexcept {
    return largest(to_vec(motion.to) - to_vec(motion.from)) <= 2 * largest(extent.max - extent.min);
}

template <typename Query>
bool ask_moving(const MeshView& view, const MeshSearch& search, bool in_one_go, const QueryOptions& options,
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

std::optional<Hit> with_surface(const MeshView& view, const FirstHit& first) noexcept {
    std::optional<Hit> hit = first.get();
    if (hit) hit->surface = view.surface(hit->triangle);
    return hit;
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
