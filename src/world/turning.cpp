// The bounds. Let the body turn as q(t) = (1 - t) a + t b with |a| = 1, C = |b - a| and m a lower bound on |q|^2. The
// half angle's rate is |a x b| / |q|^2 <= C / m, so the body turns at a rate of at most w = 2 C / m, and that rate
// changes at most by 2 C D / m^2, D the largest rate of |q|^2. A point y(t) that moves straight in the world has in the
// body's frame the place R(t)^T y(t), whose second derivative is at most (w^2 + 2 C D / m^2) |y| + 2 w |y'|, with y
// measured from the axis that the body turns about. Over a piece of length 1/n a path leaves its chord by an eighth of
// that over n^2. The volume's orientation is right half way, and at the ends it is w / (2 n) off.
#include "world/turning.hpp"

#include <surefoot/overlap.hpp>
#include <surefoot/sweep.hpp>

#include "limits.hpp"
#include "sweep/query.hpp"
#include "world/grown.hpp"

namespace surefoot::internal {

namespace {

// The axis is good to 2^-48 of its own length, whatever the angle.
constexpr double axis_rounding = 0x1p-40;

// Depths and approaches are good to a few hairs; who rides along in touch is not stopped by that.
constexpr double touch_rounding = 32;

}  // namespace

TurningSweep::TurningSweep(const WorldBody& body, const Volume* volume, const Motion& motion,
                           const WorldQuery& query) noexcept
    : body_(body), query_(query), volume_(volume) {
    begin_ = body.position_at(query.begin);
    end_ = body.position_at(query.end);
    from_ = to_vec(motion.from) - begin_;
    to_ = to_vec(motion.to) - end_;
    if (!(length(from_) <= largest_coordinate && length(to_) <= largest_coordinate)) {
        status_ = HitStatus::invalid;
        return;
    }
    const Quat first = body.orientation_at(query.begin);
    const double scale = 1 / std::sqrt(dot(first, first));
    turned_begin_ = first * scale;
    turned_end_ = body.orientation_at(query.end) * scale;

    const Quat change = turned_end_ - turned_begin_;
    const double chord = std::sqrt(dot(change, change));
    const double shortest = larger(0.5, (1 - chord) * absolute(1 - chord));
    const double rate = 2 * chord / shortest;
    const double stretch = 2 * larger(absolute(dot(turned_begin_, change)), absolute(dot(turned_end_, change)));
    const Vec axis = unit(product(change, conjugate(turned_begin_)).v);
    const auto from_axis = [&](const Vec& y) noexcept { return length(cross(axis, y)) + axis_rounding * norm1(y); };
    bend_ = (rate * rate + 2 * chord * stretch / (shortest * shortest)) * larger(from_axis(from_), from_axis(to_)) +
            2 * rate * from_axis(to_ - from_);
    hair_ = pose_rounding * larger(norm1(from_), norm1(to_));
    if (volume != nullptr) {
        const double size = size_of(volume->shape);
        const double reach = turning_reach(volume->shape, Frame(volume->orientation).to_local(axis));
        roll_ = reach > 0 ? (reach + axis_rounding * size) * rate : 0;
        hair_ += pose_rounding * size;
    }
    choose_pieces();
}

double TurningSweep::margin(double pieces) const noexcept {
    return bend_ / (8 * pieces * pieces) + roll_ / (2 * pieces) + hair_;
}

void TurningSweep::choose_pieces() noexcept {
    for (pieces_ = 1; pieces_ <= most_pieces; pieces_ *= 2) {
        const double by = margin(pieces_);
        if (volume_ != nullptr) grown_ = grown(*volume_, by);
        reserve_ = by + grown_.overhang;
        if (reserve_ <= query_.turn_gap && grown_.within_limits) return;
    }
    status_ = HitStatus::overflow;
}

Stance TurningSweep::stance_at(double t) const noexcept {
    return {mix(begin_, end_, t), mix(turned_begin_, turned_end_, t)};
}

Vec TurningSweep::place_at(double t) const noexcept {
    return stance_at(t).direction_to_body(mix(from_, to_, t));
}

// Whether no piece among these can meet anything. The box holds all their volumes, grown.
bool TurningSweep::is_clear(std::uint32_t first, std::uint32_t count) const noexcept {
    const double a = time_of(first);
    const double b = time_of(first + count);
    const Motion chord{to_dvec3(place_at(a)), to_dvec3(place_at(b))};
    const Bounds bounds = body_.source.bounds();
    const double magnitude = larger(magnitude_of(chord), magnitude_of(Box3{to_vec(bounds.min), to_vec(bounds.max)}));
    Box3 extent = extent_of_point(magnitude);
    if (volume_ != nullptr) {
        const dquat orientation = stance_at((a + b) / 2).orientation_in_body(volume_->orientation);
        extent = extent_of(Volume(volume_->shape, orientation), magnitude);
    }
    const double by = margin(static_cast<double>(pieces_) / count) + reserve_;
    const Box3 box = swept_box({extent.min - Vec{by, by, by}, extent.max + Vec{by, by, by}}, chord);
    const SourceOptions options(body_, query_);
    return body_.source.gather({to_dvec3(box.min), to_dvec3(box.max)}, {}, options.get()) == 0;
}

std::optional<Hit> TurningSweep::first(double limit) const noexcept {
    FirstHit first_hit;
    for (std::uint32_t piece = 0; piece < pieces_ && !first_hit.get() && time_of(piece) <= limit;) {
        // As many pieces at once as begin here in a tree of halves, fewer if something is near.
        std::uint32_t count = piece == 0 ? pieces_ : piece & (~piece + 1);
        bool clear = is_clear(piece, count);
        while (!clear && count > 1) {
            count /= 2;
            clear = is_clear(piece, count);
        }
        if (!clear) ask_piece(piece, first_hit);
        piece += count;
    }
    return first_hit.get();
}

void TurningSweep::ask_piece(std::uint32_t piece, FirstHit& first) const noexcept {
    const double begin = time_of(piece);
    const Vec from = place_at(begin);
    const Vec to = place_at(time_of(piece + 1));
    const SourceOptions options(body_, query_);
    const std::size_t before = query_.trace != nullptr ? query_.trace->records().size() : 0;
    std::optional<Hit> hit;
    if (volume_ == nullptr) {
        hit = body_.source.ray({to_dvec3(from), to_dvec3(to)}, options.get());
        turn_records(query_.trace, before, stance_at(begin));
    } else {
        const Stance half_way = stance_at((piece + 0.5) / pieces_);
        const dquat orientation = half_way.orientation_in_body(volume_->orientation);
        const Volume volume(grown_.volume.shape, orientation);
        const Vec shift = half_way.direction_to_body(grown_.shift);
        const Motion chord{to_dvec3(from + shift), to_dvec3(to + shift)};
        // What is in touch and approached by no more than rounding is let go, as what is approached by nothing.
        const auto is_met = [&](std::uint32_t id, std::uint32_t surface) {
            if (!options(id, surface)) return false;
            const auto met = surefoot::sweep(volume, chord, body_.source.triangle(id), {.one_sided = query_.one_sided});
            return met && (met->t > 0 || met->status != HitStatus::ok ||
                           dot(to_vec(met->normal), to - from) < -touch_rounding * hair_);
        };
        QueryOptions met_options = options.get();
        met_options.filter = TriangleFilter(is_met);
        hit = body_.source.sweep(volume, chord, met_options);
        turn_records(query_.trace, before, half_way);
        ask_what_touches(piece, volume, chord, first);
    }
    if (hit) {
        hit->t = hit->status == HitStatus::ok ? smaller(1, (piece + hit->t) / pieces_) : begin;
        first.offer(hit);
    }
    if (!first.get()) return;

    Hit found = *first.get();
    found.body = body_.id;
    found.started_inside = found.started_inside && piece == 0;
    if (found.status == HitStatus::ok) {
        const Stance stance = stance_at(found.t);
        found.point = to_dvec3(stance.to_world(to_vec(found.point)));
        found.normal = to_dvec3(unit(stance.direction_to_world(to_vec(found.normal))));
    }
    first = FirstHit{};
    first.offer(found);
}

// A sweep lets go of what it touches at its start and does not approach. But the true path is bent and the volume
// turns: what touches when the piece begins and is deeper in the volume when it ends was approached after all. The
// source shows its triangles through the filter, and is told that none of them exists.
void TurningSweep::ask_what_touches(std::uint32_t piece, const Volume& volume, const Motion& chord,
                                    FirstHit& first) const noexcept {
    struct Moment {
        Volume volume;
        dvec3 place;
    };
    const auto moment = [&](double t) noexcept {
        const GrownVolume now = grown(*volume_, hair_);
        const Stance stance = stance_at(t);
        return Moment{Volume(now.volume.shape, stance.orientation_in_body(volume_->orientation)),
                      to_dvec3(place_at(t) + stance.direction_to_body(now.shift))};
    };
    const double begin = time_of(piece);
    const Moment at_begin = moment(begin);
    const Moment at_end = moment(time_of(piece + 1));
    const SourceOptions options(body_, query_);
    const OverlapOptions sides{.one_sided = query_.one_sided};
    const auto look = [&](std::uint32_t id, std::uint32_t surface) {
        if (!options(id, surface)) return false;
        const Triangle triangle = body_.source.triangle(id);
        const auto after = overlap(at_end.volume, at_end.place, triangle, sides);
        if (!after) return false;
        const auto touch = overlap(volume, chord.from, triangle, sides);
        if (!touch) return false;
        const auto at_first = overlap(at_begin.volume, at_begin.place, triangle, sides);
        const double depth = at_first ? at_first->depth : 0;
        if (!(after->depth > depth + touch_rounding * hair_)) return false;
        Hit hit;
        hit.t = begin;
        hit.point = touch->point;
        hit.normal = touch->normal;
        hit.triangle = id;
        hit.surface = surface;
        hit.feature = touch->feature;
        hit.started_inside = at_first.has_value();
        first.offer(hit);
        return false;
    };
    QueryOptions shown = options.get();
    shown.filter = TriangleFilter(look);
    (void)body_.source.overlap(at_end.volume, at_end.place, {}, shown);
}

}  // namespace surefoot::internal
