#include "character/surroundings.hpp"

#include "character/neighbours.hpp"
#include "sweep/sweep.hpp"

namespace surefoot::internal {

namespace {

// Is all of the body in front of the triangle's plane, but for the slack?
bool comes_from_front(const Volume& volume, const Vec& place, const Triangle& triangle, double slack) noexcept {
    const Vec a = to_vec(triangle.a);
    const Vec across = cross(to_vec(triangle.b) - a, to_vec(triangle.c) - a);
    const double size = length(across);
    if (!(size > 0)) return false;
    const Vec normal = across / size;
    return dot(normal, place - a) - reach_along(volume, -normal) >= -slack;
}

bool is_inside(const Box3& box, const Box3& outer) noexcept {
    return outer.min.x <= box.min.x && outer.min.y <= box.min.y && outer.min.z <= box.min.z &&
           box.max.x <= outer.max.x && box.max.y <= outer.max.y && box.max.z <= outer.max.z;
}

// What a box is grown by before it may say that nothing is there, as a share of the numbers in it.
constexpr double margin = 1e-9;

// A plane between is surer by this.
constexpr double hair_share = 0x1p-10;

// The share of a motion before which the plane keeps the triangle apart, less what it takes to come nearer by `unsure`;
// beyond 1 if it does for all of it. Gaps below `hair` may be rounding, and a motion that comes nearer by no more than
// `along` goes along the plane [m].
inline double earliest_touch(const Separation& apart, const Vec& begins, const Vec& ends, double along, double hair,
                             double unsure) noexcept {
    const double first = apart.gap + dot(apart.normal, begins);
    const double last = apart.gap + dot(apart.normal, ends);
    if (first > hair && last > hair) return 2;
    if (first > -hair && last > first - along) return 2;
    return first > unsure ? (first - unsure) / (first - last) : 0;
}

}  // namespace

Named Surroundings::name_of(const Touch& touch) const noexcept {
    if (touch.is_neighbour) return {neighbours_.id(touch.index), 0};
    return {triangles_[touch.index].body, triangles_[touch.index].id};
}

bool Surroundings::covers(const Box3& box) const noexcept {
    return is_inside(box, covered_);
}

bool Surroundings::cover(const Box3& box) noexcept {
    if (covers(box)) return true;
    const std::size_t count = list(box);
    are_many_ = count > most && count <= most_in_reach;
    return count <= most_in_reach;
}

bool Surroundings::cover_if_few(const Box3& box) noexcept {
    return covers(box) || list(box) <= most;
}

std::size_t Surroundings::list(const Box3& box) noexcept {
    const std::size_t count = world_.gather({to_dvec3(box.min), to_dvec3(box.max)}, triangles_.all(), query_);
    const bool fits = count <= most;
    are_many_ = false;
    count_ = fits ? count : 0;
    covered_ = fits ? box : nothing;
    separated_ = nullptr;
    for (std::size_t i = 0; i < count_; ++i) {
        boxes_[i] = box_of(triangles_[i].triangle);
    }
    return count;
}

void Surroundings::cover_as_well(const Box3& box) noexcept {
    if (covers(box)) return;
    Box3 both = box;
    if (count_ > 0 && covered_.meets(box)) both.include(covered_);
    (void)cover_if_few(both);
}

void Surroundings::sweep(const Volume& volume, const Vec& shift, const Box3& extent, const Vec& from, const Vec& motion,
                         Touches& touches) noexcept {
    const Vec to = from + motion;
    const double hair = margin * (1 + largest(from) + largest(to) + largest(extent.max) + largest(extent.min));
    const Vec wide{hair, hair, hair};
    const Box3 box = swept_box({extent.min - wide, extent.max + wide}, {to_dvec3(from), to_dvec3(to)});
    const Motion asked{to_dvec3(from + shift), to_dvec3(to + shift)};
    touches.begin(*this, volume, asked);
    if (are_many_) {
        const auto ask_it = [&](const SourceTriangle& triangle) { ask_one_of_many(triangle, volume, asked, touches); };
        return each_of_many(world_, query_, box, ask_it);
    }
    for (std::size_t i = 0; i < count_; ++i) {
        if (boxes_[i].meets(box)) ask(i, volume, asked, touches);
    }
}

void Surroundings::sweep(const Body& body, const Vec& from, const Vec& motion, Touches& touches,
                         Wanted wanted) noexcept {
    if (are_many_) return sweep_many(body, from, motion, touches, wanted);
    separate(body, from);
    const Vec to = from + motion;
    const Vec begins = from - separated_at_;
    const Vec ends = to - separated_at_;
    touches.begin(*this, body.kept_off, {to_dvec3(from + body.shift), to_dvec3(to + body.shift)});
    const double along = along_tolerance * length(motion);
    const double unsure = hair_ / hair_share;
    for (std::size_t i = 0; i < count_; ++i) {
        const double earliest = earliest_touch(separations_[i], begins, ends, along, hair_, unsure);
        if (earliest <= 1) touches.put_off(i, earliest);
    }
}

void Surroundings::sweep_many(const Body& body, const Vec& from, const Vec& motion, Touches& touches,
                              Wanted wanted) noexcept {
    const Vec to = from + motion;
    const Motion asked{to_dvec3(from + body.shift), to_dvec3(to + body.shift)};
    touches.begin(*this, body.kept_off, asked);
    const Separator separator(body.kept_off.shape, body.frame, from + body.shift);
    const double along = along_tolerance * length(motion);
    const double margin_of_box = margin * (1 + largest(from) + largest(to) + body.size());
    each_of_many(world_, query_, body.around(from, motion, margin_of_box),
                 [&](const SourceTriangle& triangle) noexcept {
                     const double hair = hair_of(body, larger(largest(from), magnitude_of(box_of(triangle.triangle))));
                     const double earliest = earliest_touch(separator.from(triangle.triangle), {}, motion, along, hair,
                                                            wanted == Wanted::some ? -hair : hair / hair_share);
                     if (wanted == Wanted::some ? earliest < touches.latest() : earliest <= touches.latest())
                         ask_one_of_many(triangle, body.kept_off, asked, touches);
                 });
}

void Surroundings::ask_one_of_many(const SourceTriangle& triangle, const Volume& volume, const Motion& motion,
                                   Touches& touches) noexcept {
    static_assert(most > Touches::most);
    const std::size_t place = touches.spare_index();
    triangles_[place] = triangle;
    ask(place, volume, motion, touches);
}

void Surroundings::ask(std::size_t i, const Volume& volume, const Motion& motion, Touches& touches) const noexcept {
    const bool one_way = rules_[triangles_[i].surface].one_way;
    if (one_way && !comes_from_front(volume, to_vec(motion.from), triangles_[i].triangle, slack_)) return;
    const auto hit = sweep_triangle(volume, motion, triangles_[i].triangle, triangles_[i].id,
                                    query_.one_sided || one_way, 1, nullptr, StartSign::rounded);
    if (!hit) return;
    touches.add({hit->t, to_vec(hit->point), to_vec(hit->normal), i, hit->feature, hit->status});
}

void Surroundings::separate(const Body& body, const Vec& position) noexcept {
    if (separated_ == &body) return;
    separated_ = &body;
    separated_at_ = position;
    const Separator separator(body.kept_off.shape, body.frame, position + body.shift);
    double largest_number = largest(position);
    for (std::size_t i = 0; i < count_; ++i) {
        separations_[i] = separator.from(triangles_[i].triangle);
        largest_number = larger(largest_number, magnitude_of(boxes_[i]));
    }
    hair_ = hair_of(body, largest_number);
}

double Surroundings::hair_of(const Body& body, double largest_number) noexcept {
    return margin * hair_share * (largest_number + body.size());
}

}  // namespace surefoot::internal
