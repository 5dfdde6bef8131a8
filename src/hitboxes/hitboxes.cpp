#include <surefoot/hitboxes.hpp>

#include "hitboxes/part_query.hpp"
#include "ieee_guard.hpp"
#include "limits.hpp"
#include "sweep/query.hpp"

namespace surefoot {
inline namespace v0 {

using namespace internal;

namespace {

bool is_valid(const HitboxQuery& query) noexcept {
    return query.begin >= 0 && query.begin <= query.end && query.end <= 1 && query.turn_gap > 0;
}

bool is_before(const PartHit& a, const PartHit& b) noexcept {
    return a.t != b.t ? a.t < b.t : a.number < b.number;
}

// Does the way of the point, as the body's place sees it, come within `reach`?
bool comes_near(const Vec& from, const Vec& to, double reach) noexcept {
    const Vec along = to - from;
    const double square = dot(along, along);
    const double t = square > 0 ? smaller(1, larger(0, -dot(from, along) / square)) : 0;
    const Vec nearest = from + along * t;
    const double rounding = 0x1p-40 * (largest(from) + largest(to));
    return dot(nearest, nearest) <= (reach + rounding) * (reach + rounding);
}

}  // namespace

Hitboxes::Hitboxes(std::span<const HitPart> parts, const Pose& start, const Pose& end) noexcept
    : parts_(parts), start_(start), end_(end) {
    const IeeeGuard guard;
    valid_ = is_valid(start) && is_valid(end);
    for (const HitPart& part : parts) {
        valid_ = valid_ && is_valid(part.volume) && is_valid(part.start) && is_valid(part.end);
        if (!valid_) return;
        // On a straight way a point is never farther than at the farther end.
        const double away = larger(length(to_vec(part.start.position)), length(to_vec(part.end.position)));
        radius_ = larger(radius_, (away + size_of(part.volume.shape)) * (1 + 0x1p-40));
    }
}

template <typename Ask>
std::optional<PartHit> Hitboxes::first(double size, const Motion& motion, const HitboxQuery& query,
                                       const Ask& ask) const noexcept {
    if (!valid_ || !is_valid(query) || !is_valid_point(motion.from) || !is_valid_point(motion.to)) {
        PartHit refused;
        refused.status = HitStatus::invalid;
        return refused;
    }
    const Vec begin = mix(to_vec(start_.position), to_vec(end_.position), query.begin);
    const Vec end = mix(to_vec(start_.position), to_vec(end_.position), query.end);
    const double reach = radius_ + size + query.turn_gap;
    if (!comes_near(to_vec(motion.from) - begin, to_vec(motion.to) - end, reach)) return std::nullopt;
    std::optional<PartHit> first;
    for (const HitPart& part : parts_) {
        const std::optional<PartHit> hit = ask(part);
        if (hit && (!first || is_before(*hit, *first))) first = hit;
    }
    return first;
}

std::optional<PartHit> Hitboxes::ray(const Motion& motion, const HitboxQuery& query) const noexcept {
    const IeeeGuard guard;
    return first(0, motion, query,
                 [&](const HitPart& part) noexcept { return PartQuery(part, start_, end_, motion, query, 0).ray(); });
}

std::optional<PartHit> Hitboxes::sweep(const Volume& volume, const Motion& motion,
                                       const HitboxQuery& query) const noexcept {
    const IeeeGuard guard;
    if (!is_valid(volume)) {
        PartHit refused;
        refused.status = HitStatus::invalid;
        return refused;
    }
    const double size = size_of(volume.shape);
    const double turning = std::holds_alternative<Sphere>(volume.shape) ? 0 : size;
    return first(size, motion, query, [&](const HitPart& part) noexcept {
        return PartQuery(part, start_, end_, motion, query, turning).sweep(volume);
    });
}

}  // namespace v0
}  // namespace surefoot
