// Every query of a triangle source, from one ability: to find the triangles near a moving box, roughly nearest first.
//
// A Finder offers
//   Box3 box()                                   the box around all of its triangles
//   find(const MovingReach&, ask, limit, work)   ask(const SourceTriangle&) for every triangle whose box the motion
//                                                meets at a time up to limit(), which falls as answers come in
//   find(const RoundReach&, ask, limit, work)    the same, by distance
//   find_all(ask)                                every triangle, by brute force
//   trusted                                      are all of its triangles within the limits of coordinates?
// Triangles beyond what is asked for do no harm, and no triangle may be handed out twice. The answers are those of
// Mesh, bit for bit, since both are the answers of single triangles put together by query/answers.hpp.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>

#include <surefoot/overlap.hpp>
#include <surefoot/query.hpp>
#include <surefoot/ray.hpp>
#include <surefoot/shapes.hpp>

#include "ieee_guard.hpp"
#include "limits.hpp"
#include "query/answers.hpp"
#include "query/apart.hpp"
#include "query/moving_reach.hpp"
#include "query/reach.hpp"
#include "sweep/sweep.hpp"

namespace surefoot::internal {

/// Hands out every triangle that may matter and that the filter lets pass. `is_apart(triangle, limit)` may throw out
/// more of them; brute force does not ask it.
template <typename Finder, typename Reach, typename Ask, typename Limit, typename IsApart>
void ask_all(const Finder& finder, const Reach& reach, const QueryOptions& options, const Ask& ask, const Limit& limit,
             const IsApart& is_apart) noexcept {
    const auto pass_on = [&](const SourceTriangle& found) noexcept {
        if (options.filter && !options.filter(found.id, found.surface)) return;
        if (options.work != nullptr) ++options.work->triangles;
        ask(found);
    };
    if (options.search == Search::brute_force) {
        finder.find_all(pass_on);
    } else {
        const auto pass_on_near = [&](const SourceTriangle& found) noexcept {
            const bool is_triangle = Finder::trusted || is_valid_triangle(found.triangle);
            if (!is_triangle || !is_apart(found.triangle, limit())) pass_on(found);
        };
        finder.find(reach, pass_on_near, limit, options.work);
    }
}
template <typename Finder, typename Reach, typename Ask, typename Limit>
void ask_all(const Finder& finder, const Reach& reach, const QueryOptions& options, const Ask& ask,
             const Limit& limit) noexcept {
    ask_all(finder, reach, options, ask, limit, [](const Triangle&, double) noexcept { return false; });
}

/// For a volume: all triangles that it meets on its way.
template <typename Finder, typename Ask, typename Limit>
void ask_all_of(const Finder& finder, const Volume& volume, const Motion& motion, const QueryOptions& options,
                const Ask& ask, const Limit& limit) noexcept {
    const double magnitude = larger(magnitude_of(motion), magnitude_of(finder.box()));
    const Box3 extent = extent_of(volume, magnitude);
    const ApartTest is_apart(volume, motion, extent, margin_of(volume, magnitude));
    ask_all(finder, MovingReach(motion, extent), options, ask, limit, is_apart);
}

template <typename Finder>
MovingReach reach_of(const Finder& finder, const Motion& motion) noexcept {
    return {motion, extent_of_point(larger(magnitude_of(motion), magnitude_of(finder.box())))};
}

inline std::optional<Hit> with_names(std::optional<Hit> hit, const SourceTriangle& found) noexcept {
    if (!hit) return hit;
    hit->triangle = found.id;
    hit->surface = found.surface;
    return hit;
}

template <typename Finder>
std::optional<Hit> sweep_found(const Volume& volume, const Motion& motion, const SourceTriangle& found,
                               const QueryOptions& options) noexcept {
    if (!Finder::trusted && !is_valid_triangle(found.triangle)) return blocked(HitStatus::invalid);
    return sweep_triangle(volume, motion, found.triangle, found.id, options.one_sided, 1, options.trace);
}

template <typename Finder>
std::optional<Hit> ask_sweep(const Finder& finder, const Volume& volume, const Motion& motion,
                             const QueryOptions& options) noexcept {
    const IeeeGuard guard;
    if (!is_valid_query(volume, motion)) return blocked(HitStatus::invalid);
    FirstHit first;
    const auto ask = [&](const SourceTriangle& found) noexcept {
        first.offer(with_names(sweep_found<Finder>(volume, motion, found, options), found));
    };
    ask_all_of(finder, volume, motion, options, ask, [&]() noexcept { return first.limit(); });
    return first.get();
}

template <typename Finder>
bool ask_sweep_any(const Finder& finder, const Volume& volume, const Motion& motion,
                   const QueryOptions& options) noexcept {
    const IeeeGuard guard;
    if (!is_valid_query(volume, motion)) return true;
    bool met = false;
    const auto ask = [&](const SourceTriangle& found) noexcept {
        met = met || sweep_found<Finder>(volume, motion, found, options);
    };
    ask_all_of(finder, volume, motion, options, ask, [&]() noexcept { return met ? -1.0 : 1.0; });
    return met;
}

template <typename Finder>
std::optional<Hit> ask_ray(const Finder& finder, const Motion& motion, const QueryOptions& options) noexcept {
    const IeeeGuard guard;
    if (!is_valid_point(motion.from) || !is_valid_point(motion.to)) return blocked(HitStatus::invalid);
    FirstHit first;
    const auto ask = [&](const SourceTriangle& found) noexcept {
        first.offer(with_names(ray(motion, found.triangle, {.one_sided = options.one_sided}), found));
    };
    ask_all(finder, reach_of(finder, motion), options, ask, [&]() noexcept { return first.limit(); });
    return first.get();
}

template <typename Finder>
bool ask_ray_any(const Finder& finder, const Motion& motion, const QueryOptions& options) noexcept {
    const IeeeGuard guard;
    if (!is_valid_point(motion.from) || !is_valid_point(motion.to)) return true;
    bool met = false;
    const auto ask = [&](const SourceTriangle& found) noexcept {
        met = met || ray(motion, found.triangle, {.one_sided = options.one_sided});
    };
    ask_all(finder, reach_of(finder, motion), options, ask, [&]() noexcept { return met ? -1.0 : 1.0; });
    return met;
}

template <typename Finder>
std::size_t ask_overlap(const Finder& finder, const Volume& volume, const dvec3& position, std::span<Overlap> room,
                        const QueryOptions& options) noexcept {
    const IeeeGuard guard;
    const Motion standing{position, position};
    if (!is_valid_query(volume, standing)) {
        if (!room.empty()) {
            room[0] = Overlap{};
            room[0].status = HitStatus::invalid;
        }
        return 1;
    }
    OverlapsInOrder overlaps(room);
    const auto ask = [&](const SourceTriangle& found) noexcept {
        auto overlap = surefoot::overlap(volume, position, found.triangle, {.one_sided = options.one_sided});
        if (!overlap) return;
        overlap->triangle = found.id;
        overlap->surface = found.surface;
        overlaps.add(*overlap);
    };
    ask_all_of(finder, volume, standing, options, ask, []() noexcept { return 1.0; });
    return overlaps.count();
}

template <typename Finder>
std::optional<NearestPoint> ask_nearest(const Finder& finder, const dvec3& point, double farthest,
                                        const QueryOptions& options) noexcept {
    const IeeeGuard guard;
    if (!is_valid_point(point) || !(farthest >= 0)) return NearestPoint{.point = {}, .status = HitStatus::invalid};
    NearestOfAll nearest(point, farthest);
    const double magnitude = larger(largest(to_vec(point)), magnitude_of(finder.box()));
    const RoundReach reach(point, smaller(farthest, 4 * largest_coordinate), extent_of_point(magnitude).max.x);
    const auto ask = [&](const SourceTriangle& found) noexcept { nearest.offer(found); };
    ask_all(finder, reach, options, ask, [&]() noexcept { return nearest.limit(); });
    return nearest.get();
}

template <typename Finder>
std::size_t ask_gather(const Finder& finder, const Bounds& near, std::span<SourceTriangle> room,
                       const QueryOptions& options) noexcept {
    const IeeeGuard guard;
    const Box3 box{to_vec(near.min), to_vec(near.max)};
    std::size_t count = 0;
    const auto ask = [&](const SourceTriangle& found) noexcept {
        if (!box.meets(box_of(found.triangle))) return;
        if (count < room.size()) room[count] = found;
        ++count;
    };
    ask_all(finder, MovingReach(Motion{}, box), options, ask, []() noexcept { return 1.0; });
    sort_gathered(room.first(std::min(count, room.size())));
    return count;
}

}  // namespace surefoot::internal
