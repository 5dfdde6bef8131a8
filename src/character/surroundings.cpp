#include "character/surroundings.hpp"

#include "character/body.hpp"
#include "character/neighbours.hpp"
#include "sweep/sweep.hpp"

namespace surefoot::internal {

namespace {

bool is_before(const Touch& a, const Touch& b) noexcept {
    return a.t != b.t ? a.t < b.t : a.index < b.index;
}

// Is all of the body in front of the triangle's plane, but for the slack?
bool comes_from_front(const Volume& volume, const Vec& place, const Triangle& triangle, double slack) noexcept {
    const Vec a = to_vec(triangle.a);
    const Vec across = cross(to_vec(triangle.b) - a, to_vec(triangle.c) - a);
    const double size = length(across);
    if (!(size > 0)) return false;
    const Vec normal = across / size;
    return dot(normal, place - a) - reach_along(volume, -normal) >= -slack;
}

// What a box is grown by before it may say that nothing is there, as a share of the numbers in it.
constexpr double margin = 1e-9;

}  // namespace

void Touches::add(const Touch& touch) noexcept {
    std::size_t place = count_;
    while (place > 0 && is_before(touch, touches_[place - 1])) --place;
    if (place == most) return;
    if (count_ < most) ++count_;
    for (std::size_t i = count_ - 1; i > place; --i) touches_[i] = touches_[i - 1];
    touches_[place] = touch;
}

Named Surroundings::name_of(const Touch& touch) const noexcept {
    if (touch.is_neighbour) return {neighbours_.id(touch.index), 0};
    return {triangles_[touch.index].body, triangles_[touch.index].id};
}

bool Surroundings::cover(const Vec& min, const Vec& max) noexcept {
    const auto inside = [&] {
        return covered_.min.x <= min.x && covered_.min.y <= min.y && covered_.min.z <= min.z &&
               max.x <= covered_.max.x && max.y <= covered_.max.y && max.z <= covered_.max.z;
    };
    if (inside()) return true;
    const std::size_t count = world_.gather({to_dvec3(min), to_dvec3(max)}, triangles_.all(), query_);
    if (count > most) {
        count_ = 0;
        separated_ = nullptr;
        covered_ = {{1, 1, 1}, {-1, -1, -1}};
        return false;
    }
    count_ = count;
    separated_ = nullptr;
    covered_ = {min, max};
    for (std::size_t i = 0; i < count_; ++i) {
        const Vec a = to_vec(triangles_[i].triangle.a);
        const Vec b = to_vec(triangles_[i].triangle.b);
        const Vec c = to_vec(triangles_[i].triangle.c);
        boxes_[i] = {
            {smaller(a.x, smaller(b.x, c.x)), smaller(a.y, smaller(b.y, c.y)), smaller(a.z, smaller(b.z, c.z))},
            {larger(a.x, larger(b.x, c.x)), larger(a.y, larger(b.y, c.y)), larger(a.z, larger(b.z, c.z))}};
    }
    return true;
}

void Surroundings::sweep(const Volume& volume, const Vec& shift, const Vec& below, const Vec& above, const Vec& from,
                         const Vec& motion, Touches& touches) const noexcept {
    touches.clear();
    const Vec to = from + motion;
    const double hair = margin * (1 + largest(from) + largest(to) + largest(above) + largest(below));
    const Vec low =
        Vec{smaller(from.x, to.x), smaller(from.y, to.y), smaller(from.z, to.z)} + below - Vec{hair, hair, hair};
    const Vec high =
        Vec{larger(from.x, to.x), larger(from.y, to.y), larger(from.z, to.z)} + above + Vec{hair, hair, hair};
    const Motion asked{to_dvec3(from + shift), to_dvec3(to + shift)};
    for (std::size_t i = 0; i < count_; ++i) {
        if (boxes_[i].meets(low, high)) ask(i, volume, asked, touches);
    }
}

void Surroundings::sweep(const Body& body, const Vec& from, const Vec& motion, Touches& touches) noexcept {
    touches.clear();
    separate(body, from);
    const Vec to = from + motion;
    const Vec begins = from - separated_at_;
    const Vec ends = to - separated_at_;
    const Motion asked{to_dvec3(from + body.shift), to_dvec3(to + body.shift)};
    for (std::size_t i = 0; i < count_; ++i) {
        const Separation& apart = separations_[i];
        if (apart.gap + dot(apart.normal, begins) > hair_ && apart.gap + dot(apart.normal, ends) > hair_) continue;
        ask(i, body.kept_off, asked, touches);
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
    double largest_number = largest(position);
    for (std::size_t i = 0; i < count_; ++i) {
        separations_[i] = separation_of(body.kept_off.shape, body.frame, position + body.shift, triangles_[i].triangle);
        largest_number = larger(largest_number, larger(largest(boxes_[i].min), largest(boxes_[i].max)));
    }
    hair_ = margin * 0x1p-10 * (largest_number + largest(body.above - body.below));
}

}  // namespace surefoot::internal
