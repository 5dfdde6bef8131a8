#include "world/ask.hpp"

#include "limits.hpp"
#include "sweep/query.hpp"
#include "sweep/sweep.hpp"
#include "world/grown.hpp"
#include "world/turning.hpp"

namespace surefoot::internal {

namespace {

bool turns_during(const WorldBody& body, const WorldQuery& query) noexcept {
    return body.turns() && query.begin < query.end;
}

// The hit of a body that does not turn, in the world.
Hit brought_back(Hit hit, const WorldBody& body, const WorldQuery& query) noexcept {
    hit.body = body.id;
    if (hit.status != HitStatus::ok) return hit;
    const Vec place = mix(body.position_at(query.begin), body.position_at(query.end), hit.t);
    const Stance stance(place, body.orientation_at(query.begin));
    hit.point = to_dvec3(stance.to_world(to_vec(hit.point)));
    if (!stance.is_upright()) hit.normal = to_dvec3(unit(stance.direction_to_world(to_vec(hit.normal))));
    return hit;
}

}  // namespace

GrownVolume grown(const Volume& volume, double by) noexcept {
    const GrownShape grown_shape = grown(volume.shape, by);
    GrownVolume result{Volume(grown_shape.shape, volume.orientation), {}, grown_shape.overhang, true};
    if (grown_shape.drop > 0) {
        result.shift = Frame(volume.orientation).to_world({0, -grown_shape.drop, 0});
    }
    result.within_limits = is_valid(result.volume);
    return result;
}

CarriedQuery carried(const Volume& volume, const Motion& motion, const Stance& at_begin,
                     const Stance& at_end) noexcept {
    const CarriedPoint from = at_begin.to_body(to_vec(motion.from));
    const CarriedPoint to = at_end.to_body(to_vec(motion.to));
    CarriedQuery result{volume, {to_dvec3(from.point), to_dvec3(to.point)}, true};
    result.within_limits = is_valid_point(result.motion.from) && is_valid_point(result.motion.to);
    if (from.exact && to.exact) return result;
    result.volume.orientation = at_begin.orientation_in_body(volume.orientation);
    const double by = pose_rounding * (larger(norm1(from.point), norm1(to.point)) + size_of(volume.shape));
    const GrownVolume larger_volume = grown(result.volume, by);
    // A volume at the very limit of what is allowed has no room to grow.
    if (!larger_volume.within_limits) return result;
    result.volume = larger_volume.volume;
    result.motion = {to_dvec3(from.point + larger_volume.shift), to_dvec3(to.point + larger_volume.shift)};
    return result;
}

Hit refused(HitStatus status, const WorldBody& body, double entry) noexcept {
    Hit hit = blocked(status);
    hit.body = body.id;
    hit.t = entry;
    return hit;
}

void turn_records(Trace* trace, std::size_t before, const Stance& stance) noexcept {
    if (trace == nullptr || stance.is_upright()) return;
    const std::span<TraceRecord> records = trace->records();
    for (std::size_t i = before; i < records.size(); ++i) {
        records[i].normal = to_dvec3(stance.direction_to_world(to_vec(records[i].normal)));
    }
}

std::optional<Hit> sweep_body(const WorldBody& body, const Volume* volume, const Motion& motion,
                              const WorldQuery& query, double limit, double entry) noexcept {
    const auto refuse = [&](HitStatus status) noexcept -> std::optional<Hit> {
        return entry <= 1 ? std::optional(refused(status, body, entry)) : std::nullopt;
    };
    if (turns_during(body, query)) {
        const TurningSweep sweep(body, volume, motion, query);
        return sweep.status() == HitStatus::ok ? sweep.first(limit) : refuse(sweep.status());
    }
    const Stance begin = body.stance_at(query.begin);
    const CarriedQuery question = carried(volume != nullptr ? *volume : Volume{}, motion, begin,
                                          Stance(body.position_at(query.end), body.orientation_at(query.begin)));
    if (!question.within_limits) return refuse(HitStatus::invalid);
    const SourceOptions options(body, query);
    const std::size_t before = query.trace != nullptr ? query.trace->records().size() : 0;
    std::optional<Hit> hit = volume != nullptr ? body.source.sweep(question.volume, question.motion, options.get())
                                               : body.source.ray(question.motion, options.get());
    turn_records(query.trace, before, begin);
    if (hit) hit = brought_back(*hit, body, query);
    return hit;
}

bool sweep_body_any(const WorldBody& body, const Volume* volume, const Motion& motion, const WorldQuery& query,
                    double entry) noexcept {
    if (query.trace != nullptr || turns_during(body, query)) {
        return sweep_body(body, volume, motion, query, 1, entry).has_value();
    }
    const CarriedQuery question = carried(volume != nullptr ? *volume : Volume{}, motion, body.stance_at(query.begin),
                                          Stance(body.position_at(query.end), body.orientation_at(query.begin)));
    if (!question.within_limits) return entry <= 1;
    const SourceOptions options(body, query);
    return volume != nullptr ? body.source.sweep_any(question.volume, question.motion, options.get())
                             : body.source.ray_any(question.motion, options.get());
}

void overlap_body(const WorldBody& body, const Volume& volume, const dvec3& position, const WorldQuery& query,
                  OverlapsInOrder& overlaps) noexcept {
    const Stance stance = body.stance_at(query.begin);
    const CarriedQuery question = carried(volume, {position, position}, stance, stance);
    if (!question.within_limits) {
        Overlap refusal;
        refusal.status = HitStatus::invalid;
        refusal.body = body.id;
        overlaps.add(refusal);
        return;
    }
    // A source lists what it finds in the order of its ids, so what did not fit is what comes after the last that did.
    constexpr std::size_t batch = 24;
    Overlap room[batch];
    const SourceOptions mine(body, query);
    std::uint32_t done_up_to = 0;
    bool some_done = false;
    const auto after_those = [&](std::uint32_t triangle, std::uint32_t surface) {
        return !(some_done && triangle <= done_up_to) && mine(triangle, surface);
    };
    std::size_t count = 0;
    do {
        QueryOptions options = mine.get();
        if (some_done) options.filter = TriangleFilter(after_those);
        count = body.source.overlap(question.volume, question.motion.from, room, options);
        for (std::size_t i = 0; i < count && i < batch; ++i) {
            Overlap& found = room[i];
            found.body = body.id;
            found.point = to_dvec3(stance.to_world(to_vec(found.point)));
            if (!stance.is_upright() && found.status == HitStatus::ok) {
                found.normal = to_dvec3(unit(stance.direction_to_world(to_vec(found.normal))));
            }
            overlaps.add(found);
        }
        // A source that hands out what it was told to leave out would never end.
        if (count > batch && some_done && room[batch - 1].triangle <= done_up_to) return;
        done_up_to = room[batch - 1].triangle;
        some_done = true;
    } while (count > batch);
}

std::size_t gather_body(const WorldBody& body, const Box3& near, std::span<SourceTriangle> found,
                        const WorldQuery& query) noexcept {
    const Stance stance = body.stance_at(query.begin);
    const SourceOptions mine(body, query);
    if (stance.is_identity()) {
        const std::size_t count = body.source.gather({to_dvec3(near.min), to_dvec3(near.max)}, found, mine.get());
        for (SourceTriangle& triangle : found.first(count < found.size() ? count : found.size())) {
            triangle.body = body.id;
        }
        return count;
    }
    const auto placed = [&](const dvec3& point) noexcept { return to_dvec3(stance.to_world(to_vec(point))); };
    CarriedPoint corner = stance.to_body(near.min);
    Box3 seen{corner.point, corner.point};
    bool exact = corner.exact;
    for (int i = 1; i < 8; ++i) {
        corner = stance.to_body({(i & 1) != 0 ? near.max.x : near.min.x, (i & 2) != 0 ? near.max.y : near.min.y,
                                 (i & 4) != 0 ? near.max.z : near.min.z});
        seen.include(corner.point);
        exact = exact && corner.exact;
    }
    const double rounding = exact ? 0 : pose_rounding * (magnitude_of(seen) + magnitude_of(near));
    const Vec margin{rounding, rounding, rounding};
    const std::size_t count =
        body.source.gather({to_dvec3(seen.min - margin), to_dvec3(seen.max + margin)}, found, mine.get());
    for (std::size_t i = 0; i < count && i < found.size(); ++i) {
        const Triangle own = found[i].triangle;
        found[i].triangle = {placed(own.a), placed(own.b), placed(own.c)};
        found[i].body = body.id;
    }
    return count;
}

}  // namespace surefoot::internal
