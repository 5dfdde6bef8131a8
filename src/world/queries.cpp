#include <surefoot/world.hpp>

#include "ieee_guard.hpp"
#include "limits.hpp"
#include "query/answers.hpp"
#include "query/moving_reach.hpp"
#include "query/reach.hpp"
#include "sweep/query.hpp"
#include "sweep/sweep.hpp"
#include "world/ask.hpp"
#include "world/grown.hpp"
#include "world/state.hpp"

namespace surefoot {
inline namespace v0 {

using namespace internal;

namespace {

// False for NaN too.
bool is_valid_time(const WorldQuery& query) noexcept {
    return query.begin >= 0 && query.begin <= query.end && query.end <= 1;
}

double gap_of(const WorldQuery& query) noexcept {
    return query.turn_gap > 0 ? smaller(query.turn_gap, largest_coordinate) : 0;
}

Box3 grown(const Box3& box, double by) noexcept {
    return {box.min - Vec{by, by, by}, box.max + Vec{by, by, by}};
}

// How far about its reference point anything can be that a query can meet: what rounding in a pose and the pieces of a
// turn may add is in it. (The share of a body's own distance from its origin is in the body's box.)
Box3 extent_in_world(const Volume* volume, double magnitude, const WorldQuery& query) noexcept {
    if (volume == nullptr) return grown(extent_of_point(magnitude), gap_of(query));
    const double rounding = 8 * pose_rounding * (size_of(volume->shape) + magnitude);
    const double overhang = internal::grown(volume->shape, rounding).overhang + rounding;
    return grown(extent_of(*volume, magnitude), overhang + gap_of(query));
}

// A body that could not be answered took part in the race at the time when it could first be met. If it won, the whole
// motion is blocked.
std::optional<Hit> settled(std::optional<Hit> first) noexcept {
    if (first && first->status != HitStatus::ok) first->t = 0;
    return first;
}

}  // namespace

std::optional<Hit> World::sweep(const Volume& volume, const Motion& motion, const WorldQuery& query) const noexcept {
    const IeeeGuard guard;
    if (!is_valid_query(volume, motion) || !is_valid_time(query)) return blocked(HitStatus::invalid);
    const double magnitude = larger(magnitude_of(motion), magnitude_of(state_->tree.bounds()));
    const MovingReach reach(motion, extent_in_world(&volume, magnitude, query));
    FirstHit first;
    state_->visit(
        query, [&](const Box3& box) { return reach.key(box); }, [&] { return first.limit(); },
        [&](const WorldBody& body, double entry) {
            first.offer(sweep_body(body, &volume, motion, query, first.limit(), entry));
        });
    return settled(first.get());
}

bool World::sweep_any(const Volume& volume, const Motion& motion, const WorldQuery& query) const noexcept {
    const IeeeGuard guard;
    if (!is_valid_query(volume, motion) || !is_valid_time(query)) return true;
    const double magnitude = larger(magnitude_of(motion), magnitude_of(state_->tree.bounds()));
    const MovingReach reach(motion, extent_in_world(&volume, magnitude, query));
    bool found = false;
    state_->visit(
        query, [&](const Box3& box) { return reach.key(box); }, [&] { return found ? -1.0 : 1.0; },
        [&](const WorldBody& body, double entry) {
            found = found || sweep_body_any(body, &volume, motion, query, entry);
        });
    return found;
}

std::optional<Hit> World::ray(const Motion& motion, const WorldQuery& query) const noexcept {
    const IeeeGuard guard;
    if (!is_valid_point(motion.from) || !is_valid_point(motion.to) || !is_valid_time(query)) {
        return blocked(HitStatus::invalid);
    }
    const double magnitude = larger(magnitude_of(motion), magnitude_of(state_->tree.bounds()));
    const MovingReach reach(motion, extent_in_world(nullptr, magnitude, query));
    FirstHit first;
    state_->visit(
        query, [&](const Box3& box) { return reach.key(box); }, [&] { return first.limit(); },
        [&](const WorldBody& body, double entry) {
            first.offer(sweep_body(body, nullptr, motion, query, first.limit(), entry));
        });
    return settled(first.get());
}

bool World::ray_any(const Motion& motion, const WorldQuery& query) const noexcept {
    const IeeeGuard guard;
    if (!is_valid_point(motion.from) || !is_valid_point(motion.to) || !is_valid_time(query)) return true;
    const double magnitude = larger(magnitude_of(motion), magnitude_of(state_->tree.bounds()));
    const MovingReach reach(motion, extent_in_world(nullptr, magnitude, query));
    bool found = false;
    state_->visit(
        query, [&](const Box3& box) { return reach.key(box); }, [&] { return found ? -1.0 : 1.0; },
        [&](const WorldBody& body, double entry) {
            found = found || sweep_body_any(body, nullptr, motion, query, entry);
        });
    return found;
}

std::size_t World::overlap(const Volume& volume, const dvec3& position, std::span<Overlap> found,
                           const WorldQuery& query) const noexcept {
    const IeeeGuard guard;
    const Motion standing{position, position};
    if (!is_valid_query(volume, standing) || !is_valid_time(query)) {
        if (!found.empty()) {
            found[0] = Overlap{};
            found[0].status = HitStatus::invalid;
        }
        return 1;
    }
    const double magnitude = larger(magnitude_of(standing), magnitude_of(state_->tree.bounds()));
    const MovingReach reach(standing, extent_in_world(&volume, magnitude, query));
    OverlapsInOrder overlaps(found);
    state_->visit(
        query, [&](const Box3& box) { return reach.key(box); }, [] { return 1.0; },
        [&](const WorldBody& body, double entry) {
            if (entry <= 1) overlap_body(body, volume, position, query, overlaps);
        });
    return overlaps.count();
}

std::optional<NearestPoint> World::nearest(const dvec3& point, double farthest,
                                           const WorldQuery& query) const noexcept {
    const IeeeGuard guard;
    if (!is_valid_point(point) || !(farthest >= 0) || !is_valid_time(query)) {
        return NearestPoint{.point = {}, .status = HitStatus::invalid};
    }
    const Vec place = to_vec(point);
    const Box3 all = state_->tree.bounds();
    const RoundReach reach(point, farthest, extent_of_point(larger(largest(place), magnitude_of(all))).max.x);
    std::optional<NearestPoint> nearest;
    const auto limit = [&] { return nearest ? nearest->distance : farthest; };
    const auto offer = [&](const NearestPoint& candidate) {
        if (nearest && candidate.distance > nearest->distance) return;
        if (nearest && candidate.distance == nearest->distance &&
            (candidate.body != nearest->body ? candidate.body > nearest->body
                                             : candidate.triangle > nearest->triangle)) {
            return;
        }
        nearest = candidate;
    };
    state_->visit(
        query, [&](const Box3& box) { return larger(0, reach.key(box)); }, limit,
        [&](const WorldBody& body, double at_least) {
            const Stance stance = body.stance_at(query.begin);
            const dvec3 carried = to_dvec3(stance.to_body(place).point);
            if (!is_valid_point(carried)) {
                if (at_least <= farthest) {
                    offer({.distance = at_least, .body = body.id, .status = HitStatus::invalid});
                }
                return;
            }
            const SourceOptions options(body, query);
            auto candidate = body.source.nearest(carried, limit(), options.get());
            if (!candidate) return;
            candidate->body = body.id;
            if (candidate->status == HitStatus::ok) {
                candidate->point = to_dvec3(stance.to_world(to_vec(candidate->point)));
            }
            offer(*candidate);
        });
    if (nearest && nearest->status != HitStatus::ok) nearest->distance = 0;
    return nearest;
}

std::size_t World::gather(const Bounds& near, std::span<SourceTriangle> found, const WorldQuery& query) const noexcept {
    const IeeeGuard guard;
    const Box3 box{to_vec(near.min), to_vec(near.max)};
    std::size_t count = 0;
    const double magnitude = larger(magnitude_of(box), magnitude_of(state_->tree.bounds()));
    const Box3 wide{box.min + extent_of_point(magnitude).min, box.max + extent_of_point(magnitude).max};
    state_->visit(
        query, [&](const Box3& other) { return wide.meets(other) ? 0.0 : never; }, [] { return 1.0; },
        [&](const WorldBody& body, double key) {
            if (key > 0) return;
            const std::size_t begin = count < found.size() ? count : found.size();
            count += gather_body(body, box, found.subspan(begin), query);
        });
    sort_gathered(found.first(count < found.size() ? count : found.size()));
    return count;
}

}  // namespace v0
}  // namespace surefoot
