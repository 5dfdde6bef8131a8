#include "character/neighbours.hpp"

#include <surefoot/pair.hpp>

#include "character/alike.hpp"
#include "character/body.hpp"
#include "sweep/query.hpp"
#include "world/ask.hpp"

namespace surefoot::internal {

namespace {

// Rounds of getting out of each in turn.
constexpr int most_turns = 16;

}  // namespace

Neighbours::Neighbours(const Body& body, double skin, std::span<const Neighbour> given) noexcept
    : body_(body),
      skin_(skin),
      given_(given),
      count_(given.size() < most_neighbours ? given.size() : most_neighbours) {}

// The shortest way that gets out of all, found by going out of each in turn. Between opposite ones there is none, and
// going out of each in turn goes to and fro for ever; the middle of that is taken.
Vec Neighbours::way_out_of(std::span<const Push> pushes, double enough) noexcept {
    Vec way;
    Vec middle;
    for (int turn = 0; turn < most_turns; ++turn) {
        double moves = 0;
        Vec sum;
        for (const Push& push : pushes) {
            const double missing = push.depth - dot(push.normal, way);
            if (missing <= enough) continue;
            way = way + push.normal * missing;
            sum = sum + way;
            ++moves;
        }
        if (moves == 0) return way;
        middle = sum / moves;
    }
    return middle;
}

std::optional<Neighbours::Met> Neighbours::meet(std::size_t index, const Vec& from, const Vec& motion, const Vec& place,
                                                const Vec& its_motion) const noexcept {
    const Volume& its = given_[index].volume;
    if (const auto alike = AlikeEllipsoids::of(body_.volume, its, skin_)) {
        const auto met = alike->sweep(from - place, motion - its_motion);
        if (!met) return std::nullopt;
        return Met{met->t, met->normal, place + its_motion * met->t + met->point};
    }
    const Vec start = from + body_.shift;
    const auto hit = pair_sweep(body_.kept_off, {to_dvec3(start), to_dvec3(start + motion)}, its,
                                {to_dvec3(place), to_dvec3(place + its_motion)});
    if (!hit) return std::nullopt;
    return Met{hit->t, to_vec(hit->normal), to_vec(hit->point), hit->status, hit->started_inside};
}

std::optional<Neighbours::Push> Neighbours::overlap(std::size_t index, const Vec& position, double by) const noexcept {
    const Volume& its = given_[index].volume;
    if (const auto alike = AlikeEllipsoids::of(body_.volume, its, by)) {
        const auto found = alike->overlap(position - places_[index]);
        if (!found) return std::nullopt;
        return Push{found->normal, found->depth};
    }
    const GrownVolume kept = grown(body_.volume, by);
    const auto found = pair_overlap(kept.volume, to_dvec3(position + kept.shift), its, to_dvec3(places_[index]));
    if (!found || found->status != HitStatus::ok) return std::nullopt;
    return Push{to_vec(found->normal), found->depth};
}

bool Neighbours::is_near(std::size_t index, const Vec& place, const Box3& box) const noexcept {
    const Vec size = Vec{1, 1, 1} * sizes_[index];
    return box.meets({place - size, place + size});
}

void Neighbours::place(const World& world, const Vec& position, const Vec& velocity, double tick,
                       const TickPart& part) noexcept {
    placed_ = true;
    const double size = size_of(body_.volume.shape);
    wider_ = skin_ * (1 + size / smallest_of(body_.volume.shape));
    size_ = larger(size + wider_, size_of(body_.kept_off.shape) + length(body_.shift));
    comes_.reset();
    const Vec way = velocity * (tick * (part.end - part.begin));
    for (std::size_t i = 0; i < count_; ++i) {
        const Neighbour& neighbour = given_[i];
        sizes_[i] = size_of(neighbour.volume.shape) * (1 + 0x1p-40);
        dvec3 place = neighbour.position;
        const BodyHandle carrier = neighbour.is_carried ? world.find(neighbour.carrier) : BodyHandle{};
        if (moves(world, carrier)) place = world.carried(carrier, place, 0, part.end);
        places_[i] = to_vec(place);
        const Vec goes = to_vec(neighbour.velocity) * tick;
        if (neighbour.firmness != Firmness::hard || dot(goes, position - places_[i]) <= 0) continue;
        const Vec from = places_[i] + goes * part.begin;
        const Vec to = places_[i] + goes * part.end;
        // Far apart is the common case.
        const double reach = sizes_[i] + size_ + length(way) + length(goes);
        const Vec between = position - places_[i];
        if (dot(between, between) > reach * reach) continue;
        const auto met = meet(i, position, way, from, to - from);
        if (!met || met->status != HitStatus::ok || met->started_inside) continue;
        meetings_[i] = from + (to - from) * met->t;
        comes_.set(i);
    }
}

template <typename Visit>
void Neighbours::each_hit(const Vec& from, const Vec& motion, const Visit& visit) const noexcept {
    if (!placed_) return;
    const Box3 around = body_.around(from, motion, wider_);
    for (std::size_t i = 0; i < count_; ++i) {
        if (given_[i].firmness != Firmness::hard) continue;
        const auto ask = [&](const Vec& place) noexcept {
            if (!is_near(i, place, around)) return;
            if (const auto met = meet(i, from, motion, place, {})) visit(i, *met);
        };
        ask(places_[i]);
        if (comes_[i]) ask(meetings_[i]);
    }
}

void Neighbours::sweep(const Vec& from, const Vec& motion, Touches& touches) const noexcept {
    each_hit(from, motion, [&](std::size_t index, const Met& met) noexcept {
        touches.add({met.t, met.point, met.normal, index, Feature::face, met.status, true});
    });
}

double Neighbours::first(const Vec& from, const Vec& motion, double limit) const noexcept {
    double t = limit;
    each_hit(from, motion, [&](std::size_t, const Met& met) noexcept { t = smaller(t, met.t); });
    return t;
}

Neighbours::Parting Neighbours::way_apart(const Vec& position, double farthest, double softly) const noexcept {
    Parting parting;
    std::array<Push, most_neighbours> pushes;
    std::size_t count = 0;
    for (std::size_t i = 0; i < count_; ++i) {
        const Vec between = position - places_[i];
        const double reach = sizes_[i] + size_;
        if (dot(between, between) > reach * reach) continue;
        const bool is_soft = given_[i].firmness == Firmness::soft;
        const auto push = overlap(i, position, is_soft ? 0 : 0.5 * skin_);
        if (!push) continue;
        const double share = 0.5 * (push->depth + 0.5 * skin_);
        pushes[count++] = {push->normal, is_soft ? smaller(share, softly) : share};
        if (push->depth <= parting.depth) continue;
        parting.depth = push->depth;
        parting.id = given_[i].id;
    }
    parting.way = way_out_of({pushes.data(), count}, 1e-9 * skin_);
    const double distance = length(parting.way);
    if (distance > farthest) parting.way = parting.way * (farthest / distance);
    return parting;
}

}  // namespace surefoot::internal
