// The bounds. A point that goes straight as z(t) while a frame R(t) turns at a rate of at most w that changes by at
// most v has in that frame the place R^T z, with |(R^T z)'| <= w |z| + |z'| and |(R^T z)''| <= (w^2 + v) |z| + 2 w
// |z'|. Twice, for the body and for the part on it. Over a piece of length 1/n a path leaves its chord by an eighth of
// its second derivative over n^2. For the mix of unit quaternions a and b, C = |b - a|: w = 2 C / m and v = 2 C C^2 /
// m^2, where m is the least of |q|^2, for the half angle's rate is at most C / |q|^2 and that of |q|^2 at most C^2.
#include "hitboxes/part_query.hpp"

#include <cmath>

#include <surefoot/pair.hpp>

#include "hitboxes/ray_shape.hpp"
#include "sweep/query.hpp"
#include "world/grown.hpp"

namespace surefoot::internal {

namespace {

struct Rate {
    double speed = 0;   // [rad]
    double change = 0;  // [rad]
};

// `share` of the tick is the time that the rates are for.
Rate rate_of(const Turn& turn, double share) noexcept {
    if (!turn.turns()) return {};
    const Quat change = turn.at(1) - turn.at(0);
    const double chord = std::sqrt(dot(change, change));
    const double least = larger(0.5, (1 - chord) * absolute(1 - chord));
    return {2 * chord / least * share, 2 * chord * chord * chord / (least * least) * share * share};
}

// Bounds on how a point moves.
struct Path {
    double distance;  // from the origin
    double speed;
    double bend;
};

Path seen_from(const Path& path, const Rate& rate) noexcept {
    return {path.distance, rate.speed * path.distance + path.speed,
            (rate.speed * rate.speed + rate.change) * path.distance + 2 * rate.speed * path.speed + path.bend};
}

double least_distance(const Vec& from, const Vec& to) noexcept {
    const Vec along = to - from;
    const double square = dot(along, along);
    const double t = square > 0 ? smaller(1, larger(0, -dot(from, along) / square)) : 0;
    return length(from + along * t);
}

}  // namespace

PartQuery::PartQuery(const HitPart& part, const Pose& start, const Pose& end, const Motion& motion,
                     const HitboxQuery& query, double size) noexcept
    : part_(part),
      body_start_(to_vec(start.position)),
      body_end_(to_vec(end.position)),
      body_turn_(start.orientation, end.orientation),
      part_turn_(part.start.orientation, part.end.orientation),
      from_(to_vec(motion.from)),
      to_(to_vec(motion.to)),
      query_(query) {
    const double share = query.end - query.begin;
    if (share == 0 || (!body_turn_.turns() && !part_turn_.turns())) return;
    const Vec from = from_ - mix(body_start_, body_end_, query.begin);
    const Vec to = to_ - mix(body_start_, body_end_, query.end);
    const Vec begin = mix(to_vec(part.start.position), to_vec(part.end.position), query.begin);
    const Vec arrive = mix(to_vec(part.start.position), to_vec(part.end.position), query.end);
    const Rate body = rate_of(body_turn_, share);
    const Rate own = rate_of(part_turn_, share);
    Path path = seen_from({larger(length(from), length(to)), length(to - from), 0}, body);
    path.distance += larger(length(begin), length(arrive));
    path.speed += length(arrive - begin);
    path = seen_from(path, own);
    const double roll = size * (body.speed + own.speed);
    for (; pieces_ <= most_pieces; pieces_ *= 2) {
        const double n = pieces_;
        margin_ = path.bend / (8 * n * n) + roll / (2 * n);
        if (margin_ + grown(part.volume.shape, margin_).overhang <= query.turn_gap) return;
    }
}

Stance PartQuery::stance_at(double t) const noexcept {
    const double time = query_.begin + (query_.end - query_.begin) * t;
    const Stance body(mix(body_start_, body_end_, time), body_turn_.at(time));
    const Vec place = mix(to_vec(part_.start.position), to_vec(part_.end.position), time);
    return {body.to_world(place), product(body_turn_.at(time), part_turn_.at(time))};
}

Vec PartQuery::place_at(double t) const noexcept {
    return stance_at(t).to_body(mix(from_, to_, t)).point;
}

std::optional<PartHit> PartQuery::overflow() const noexcept {
    PartHit hit;
    hit.number = part_.number;
    hit.status = HitStatus::overflow;
    return hit;
}

PartHit PartQuery::to_world(double t, const Vec& point, const Vec& normal, bool inside) const noexcept {
    const Stance stance = stance_at(t);
    PartHit hit;
    hit.t = t;
    hit.point = to_dvec3(stance.to_world(point));
    hit.number = part_.number;
    hit.started_inside = inside;
    const Vec turned = stance.direction_to_world(normal);
    const double size = length(turned);
    if (size > 0) hit.normal = to_dvec3(turned / size);
    return hit;
}

// `ask(from, to, piece)` answers for one chord, its times still those of the chord.
template <typename Ask>
std::optional<PartHit> PartQuery::first(const Ask& ask) const noexcept {
    if (pieces_ > most_pieces) return overflow();
    Vec from = place_at(0);
    for (std::uint32_t piece = 0; piece < pieces_; ++piece) {
        const Vec to = place_at(time_of(piece + 1));
        if (const auto hit = ask(from, to, piece)) return hit;
        from = to;
    }
    return std::nullopt;
}

std::optional<PartHit> PartQuery::ray() const noexcept {
    const Frame frame(part_.volume.orientation);
    const GrownShape around = grown(part_.volume.shape, margin_);
    const Vec raised{0, around.drop, 0};
    return first([&](const Vec& from, const Vec& to, std::uint32_t piece) noexcept -> std::optional<PartHit> {
        const Vec start = frame.to_local(from) + raised;
        const Vec along = frame.to_local(to - from);
        const auto touch = ray_shape(around.shape, start, along);
        if (!touch) return std::nullopt;
        const double t = smaller(1, (piece + touch->t) / pieces_);
        const Vec normal = touch->inside ? -along : touch->normal;
        const Vec point = start + along * touch->t - raised;
        return to_world(t, frame.to_world(point), frame.to_world(normal), touch->inside && piece == 0);
    });
}

std::optional<PartHit> PartQuery::sweep(const Volume& volume) const noexcept {
    const GrownShape around = grown(part_.volume.shape, margin_);
    const Volume grown_part(around.shape, part_.volume.orientation);
    const Vec lowered = Frame(part_.volume.orientation).to_world({0, -around.drop, 0});
    const double reach = (size_of(volume.shape) + size_of(around.shape) + around.drop) * (1 + 0x1p-20);
    return first([&](const Vec& from, const Vec& to, std::uint32_t piece) noexcept -> std::optional<PartHit> {
        if (least_distance(from, to) > reach) return std::nullopt;
        const Stance half_way = stance_at((piece + 0.5) / pieces_);
        const Volume moved(volume.shape, half_way.orientation_in_body(volume.orientation));
        const double begin = time_of(piece);
        // What overlaps when a piece begins has come in by turning, or was inside from the start.
        if (const auto in = pair_overlap(moved, to_dvec3(from), grown_part, to_dvec3(lowered))) {
            if (in->status != HitStatus::ok) return overflow();
            return to_world(begin, to_vec(in->point), to_vec(in->normal), piece == 0);
        }
        const auto hit = pair_sweep(moved, {to_dvec3(from), to_dvec3(to)}, grown_part, to_dvec3(lowered));
        if (!hit) return std::nullopt;
        if (hit->status != HitStatus::ok) return overflow();
        return to_world(smaller(1, (piece + hit->t) / pieces_), to_vec(hit->point), to_vec(hit->normal), false);
    });
}

}  // namespace surefoot::internal
