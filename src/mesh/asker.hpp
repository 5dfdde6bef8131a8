// From the triangles that a search finds to the exact question of each: what all queries of a mesh share.
#pragma once

#include <algorithm>
#include <optional>
#include <span>

#include <surefoot/mesh.hpp>

#include "kernels/mesh_search.hpp"
#include "limits.hpp"
#include "query/answers.hpp"
#include "query/reach.hpp"
#include "rounded.hpp"
#include "sweep/sweep.hpp"
#include "tree/scalar_search.hpp"

namespace surefoot::internal {

/// Every coordinate that takes part in a query on a mesh is at most this.
inline double magnitude_in(const MeshView& view, const Motion& motion) noexcept {
    return larger(magnitude_of(motion), magnitude_of(view.bounds));
}

inline void count_triangle(QueryWork& work, std::uint32_t id) noexcept {
    ++work.triangles;
    if (work.log != nullptr) work.log->push({.triangle = id, .kind = SearchStep::Kind::triangle});
}

inline void count_node(QueryWork& work, const WideNode& node, double enters) noexcept {
    ++work.nodes;
    if (work.log == nullptr) return;
    const Box3 box = box_of_node(node);
    work.log->push({.box = {to_dvec3(box.min), to_dvec3(box.max)}, .enters = enters});
}

/// Asks triangles one at a time, in whatever order they come. Query has
///     void ask(const LeafBlock&, std::uint32_t slot, std::uint32_t id)    the exact question
///     double limit() const                                                 what begins later cannot matter
/// and, if it matters to none of them which comes first,
///     static constexpr bool wants_all() { return true; }
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

    /// The SIMD search. `run` is one of search_region, search_along, search_boxes.
    bool ask_found(MeshSearch& search, void (*run)(MeshSearch&) noexcept) noexcept {
        listen_to(search);
        run(search);
        return has_done(search);
    }

    /// Before and after a search that somebody else runs.
    void listen_to(MeshSearch& search) noexcept {
        search.context = this;
        search.take = [](void* context, std::span<Candidate> candidates) noexcept {
            return static_cast<Asker*>(context)->take(candidates);
        };
    }
    bool has_done(const MeshSearch& search) noexcept {
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
        if constexpr (requires { requires Query::wants_all(); }) {
            for (const Candidate& candidate : candidates) ask_place(candidate.place);
            return float_at_least(query_.limit());
        }
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

/// A motion that is short beside the shape asks everything around it at once; a long one goes along it.
inline bool is_short(const Motion& motion, const Box3& extent) noexcept {
    return largest(to_vec(motion.to) - to_vec(motion.from)) <= 2 * largest(extent.max - extent.min);
}

inline std::optional<Hit> with_surface(const MeshView& view, const FirstHit& first) noexcept {
    std::optional<Hit> hit = first.get();
    if (hit) hit->surface = view.surface(hit->triangle);
    return hit;
}

}  // namespace surefoot::internal
