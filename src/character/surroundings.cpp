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
    const std::size_t count = world_.gather({to_dvec3(box.min), to_dvec3(box.max)}, triangles_.all(), query_);
    const bool fits = count <= most;
    count_ = fits ? count : 0;
    covered_ = fits ? box : nothing;
    separated_ = nullptr;
    for (std::size_t i = 0; i < count_; ++i) {
        boxes_[i] = box_of(triangles_[i].triangle);
    }
    return fits;
}

void Surroundings::cover_as_well(const Box3& box) noexcept {
    if (covers(box)) return;
    Box3 both = box;
    if (count_ > 0 && covered_.meets(box)) both.include(covered_);
    (void)cover(both);
}

void Surroundings::sweep(const Volume& volume, const Vec& shift, const Box3& extent, const Vec& from, const Vec& motion,
                         Touches& touches) const noexcept {
    const Vec to = from + motion;
    const double hair = margin * (1 + largest(from) + largest(to) + largest(extent.max) + largest(extent.min));
    const Vec wide{hair, hair, hair};
    const Box3 box = swept_box({extent.min - wide, extent.max + wide}, {to_dvec3(from), to_dvec3(to)});
    const Motion asked{to_dvec3(from + shift), to_dvec3(to + shift)};
    touches.begin(*this, volume, asked);
    for (std::size_t i = 0; i < count_; ++i) {
        if (boxes_[i].meets(box)) ask(i, volume, asked, touches);
    }
}

void Surroundings::sweep(const Body& body, const Vec& from, const Vec& motion, Touches& touches) noexcept {
    separate(body, from);
    const Vec to = from + motion;
    const Vec begins = from - separated_at_;
    const Vec ends = to - separated_at_;
    touches.begin(*this, body.kept_off, {to_dvec3(from + body.shift), to_dvec3(to + body.shift)});
    const double unsure = hair_ / hair_share;
    const double along = along_tolerance * length(motion);
    for (std::size_t i = 0; i < count_; ++i) {
        const Separation& apart = separations_[i];
        const double first = apart.gap + dot(apart.normal, begins);
        const double last = apart.gap + dot(apart.normal, ends);
        if (first > hair_ && last > hair_) continue;
        if (first > -hair_ && last > first - along) continue;
        touches.put_off(i, first > unsure ? (first - unsure) / (first - last) : 0);
    }
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
    hair_ = margin * hair_share * (largest_number + body.size());
}

}  // namespace surefoot::internal
